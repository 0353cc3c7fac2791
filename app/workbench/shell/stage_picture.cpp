#include "app/workbench/shell/stage_picture.h"

namespace tactus::workbench {
namespace {

void line(QPainterPath& path, double x1, double y1, double x2, double y2) {
  path.moveTo(x1, y1);
  path.lineTo(x2, y2);
}

// A form with three answers.
QPainterPath form() {
  QPainterPath path;
  path.addRoundedRect(QRectF(5, 3, 14, 18), 2, 2);
  for (const double y : {8.0, 12.0, 16.0}) {
    path.addEllipse(QPointF(8.5, y), 0.7, 0.7);
    line(path, 11, y, 16, y);
  }
  return path;
}

// A curve between two axes.
QPainterPath curve() {
  QPainterPath path;
  line(path, 4, 4, 4, 20);
  line(path, 4, 20, 20, 20);
  path.moveTo(6.5, 17);
  path.cubicTo(11, 17, 10, 7, 14, 7);
  path.cubicTo(16.5, 7, 16.5, 11, 20, 11);
  return path;
}

// Three sliders.
QPainterPath sliders() {
  QPainterPath path;
  const double knobs[] = {15, 8, 12};
  double x = 6;
  for (const double y : knobs) {
    line(path, x, 4, x, y - 2);
    path.addEllipse(QPointF(x, y), 2, 2);
    line(path, x, y + 2, x, 20);
    x += 6;
  }
  return path;
}

// Two opinions and what they share.
QPainterPath circles() {
  QPainterPath path;
  path.addEllipse(QPointF(9, 12), 5.5, 5.5);
  path.addEllipse(QPointF(15, 12), 5.5, 5.5);
  return path;
}

// An arrow out of a box.
QPainterPath box() {
  QPainterPath path;
  path.moveTo(8, 11);
  path.lineTo(4, 11);
  path.lineTo(4, 20);
  path.lineTo(20, 20);
  path.lineTo(20, 11);
  path.lineTo(16, 11);
  line(path, 12, 15, 12, 4);
  path.moveTo(8.5, 7.5);
  path.lineTo(12, 4);
  path.lineTo(15.5, 7.5);
  return path;
}

}  // namespace

QPainterPath stagePicture(Stage stage) {
  switch (stage) {
    case Stage::kCollect:
      return form();
    case Stage::kUnderstand:
      return curve();
    case Stage::kTune:
      return sliders();
    case Stage::kAgree:
      return circles();
    case Stage::kDeliver:
      return box();
  }
  return {};
}

}  // namespace tactus::workbench
