// Reads sagittal images, and draws the example.
#pragma once

#include <QByteArray>
#include <QImage>
#include <QString>
#include <vector>

#include "core/base/error.h"
#include "elicitation/depth/tube_path.h"

namespace tactus::workbench {

/// The image in `bytes`: PNG, JPEG, TIFF and what else Qt reads. Returns an error with a sentence for anything else.
/// `name`: of the file, for the error. DICOM: dicom_image.h.
base::Result<QImage> readImage(const QByteArray& bytes, const QString& name);

/// The name patterns of the images that can be read, for a file dialog.
QString imagePatterns();

/// The program's own anatomy drawing without the tube, and the way of the tube in it.
struct ExampleImage {
  QImage image;
  double mm_per_px;
  std::vector<elicitation::ImagePoint> path;
};
ExampleImage exampleImage();

}  // namespace tactus::workbench
