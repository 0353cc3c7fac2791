// DICOM images through the programs that Debian has for them, DCMTK or GDCM, where they are installed.
#pragma once

#include <QByteArray>
#include <QString>
#include <optional>

#include "core/base/error.h"

namespace tactus::workbench {

/// Whether these are the bytes of a DICOM file.
bool isDicom(const QByteArray& bytes);

struct DicomImage {
  QByteArray png;                   ///< without the header, which may name the patient
  std::optional<double> mm_per_px;  ///< nothing: the file does not say, or not the same for both directions
};

/// The picture of a DICOM file by `dcmj2pnm` and its sisters, or by `gdcmconv` and `gdcmimg`; its scale by `dcmdump` or
/// `gdcmdump`. Waits for these programs. Returns an error that names the packages where none is installed, or what the
/// programs say.
/// Thread: any but that of the screen.
base::Result<DicomImage> dicomImage(const QByteArray& bytes, const QString& name);

}  // namespace tactus::workbench
