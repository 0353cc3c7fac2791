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

/// How many pictures a DICOM file holds; 1 if no installed program says it. Waits for that program.
/// Thread: any but the gui.
int dicomPictures(const QByteArray& bytes);

/// Picture number `picture` (from 1) of a DICOM file by `dcmj2pnm` and its sisters, or by `gdcmconv` and `gdcmimg`; its
/// scale by `dcmdump` or `gdcmdump`. Waits for these programs. Returns an error in one sentence: the packages where
/// none is installed, a file without an image, one that ends too early, a compression that none of them knows. Thread:
/// any but the gui.
base::Result<DicomImage> dicomImage(const QByteArray& bytes, const QString& name, int picture = 1);

}  // namespace tactus::workbench
