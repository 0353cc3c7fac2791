#include "app/workbench/labs/depth/image_reader.h"

#include <QBuffer>
#include <QImageReader>
#include <QStringList>
#include <cmath>

#include "app/workbench/anatomy/anatomy_drawing.h"
#include "app/workbench/anatomy/anatomy.h"
#include "elicitation/depth/depth_measurement.h"

namespace tactus::workbench {
namespace {

constexpr int kMostPixels = 40'000;  // of a side: beyond that no screen helps
constexpr int kMostMegabytes = 512;  // decoded: the paper's image needs 25
constexpr double kDrawingHeightMm = 620;
constexpr double kClickMm = 15;  // between two points of the example's way

// Of either order of bytes.
bool isTiff(const QByteArray& bytes) {
  return bytes.startsWith(QByteArray("II*\0", 4)) || bytes.startsWith(QByteArray("MM\0*", 4));
}

}  // namespace

base::Result<QImage> readImage(const QByteArray& bytes, const QString& name) {
  const std::string file = name.toStdString();
  QImageReader::setAllocationLimit(kMostMegabytes);
  QByteArray held = bytes;
  QBuffer buffer(&held);
  buffer.open(QIODevice::ReadOnly);
  QImageReader reader(&buffer);
  reader.setAutoTransform(true);
  const QSize size = reader.size();
  if (size.isValid() && (size.width() > kMostPixels || size.height() > kMostPixels)) {
    return base::fail(base::ErrorCode::kLimit, file,
                      std::to_string(size.width()) + " x " + std::to_string(size.height()) + " pixels",
                      "at most " + std::to_string(kMostPixels) + " on a side");
  }
  QImage image = reader.read();
  if (image.isNull() && isTiff(bytes) && !QImageReader::supportedImageFormats().contains("tiff")) {
    return base::fail(base::ErrorCode::kSyntax, file, "a TIFF image",
                      "PNG or JPEG, or the package qt6-image-formats-plugins, with which TIFF can be read");
  }
  if (image.isNull()) {
    return base::fail(base::ErrorCode::kSyntax, file, "no image that can be read", "a PNG, JPEG or TIFF image");
  }
  return image;
}

QString imagePatterns() {
  QStringList patterns;
  for (const QByteArray& format : QImageReader::supportedImageFormats()) {
    patterns << QStringLiteral("*.") + QString::fromLatin1(format);
  }
  // TIFF is offered without its reader too: the answer names what is missing.
  for (const char* more : {"*.tif", "*.tiff", "*.dcm"}) {
    if (!patterns.contains(QLatin1String(more))) patterns << QLatin1String(more);
  }
  return patterns.join(QLatin1Char(' '));
}

ExampleImage exampleImage() {
  using namespace anatomy;
  const int height = static_cast<int>(std::lround(kDrawingHeightMm / elicitation::kVisibleHumanMmPerPx));
  const QSize size(height * 2 / 3, height);
  const QRectF frame = frameOf(Framing::kWhole, Posture::kUpright, size);
  AnatomyDrawing drawing;
  ExampleImage out{
      drawing.pixmap(Posture::kUpright, Framing::kWhole, size, 1).toImage(), frame.width() / size.width(), {}};
  const TubeWay way(0);
  const int clicks = static_cast<int>(std::ceil(way.endMm() / kClickMm));
  for (int i = 0; i <= clicks; ++i) {
    const QPointF place = (way.placeAt(way.endMm() * i / clicks) - frame.topLeft()) / out.mm_per_px;
    // As a click is: a whole pixel.
    out.path.push_back({std::round(place.x()), std::round(place.y())});
  }
  return out;
}

}  // namespace tactus::workbench
