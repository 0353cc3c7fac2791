#include "app/workbench/participant/kit/ring.h"

#include <QPainter>

#include "app/workbench/participant/kit/colors.h"

namespace tactus::workbench::nurse {
namespace {

constexpr double kWidth = 3;
constexpr double kOffset = 2;

}  // namespace

void drawRing(QPainter& painter, const QRectF& face, double corner_radius) {
  const double out = kOffset + kWidth / 2;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colors::kInk, kWidth));
  painter.drawRoundedRect(face.adjusted(-out, -out, out, out), corner_radius + out, corner_radius + out);
}

}  // namespace tactus::workbench::nurse
