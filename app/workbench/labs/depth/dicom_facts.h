// What a DICOM file holds, as the installed programs of DCMTK or GDCM print it.
#pragma once

#include <QString>
#include <optional>

namespace tactus::workbench {

struct DicomFacts {
  int pictures = 1;
  std::optional<double> mm_per_px;  ///< nothing without a spacing that is the same in both directions
  bool has_picture = true;
  bool ends_early = false;
  QString compression;  ///< the transfer syntax, e.g. `JPEG2000LosslessOnly`; empty if it is unknown
};

/// The facts of the file at `path`; of a file that no program prints only the defaults. Thread: any but the gui.
DicomFacts dicomFacts(const QString& path);

}  // namespace tactus::workbench
