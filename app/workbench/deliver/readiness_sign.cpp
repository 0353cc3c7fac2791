#include "app/workbench/deliver/readiness_sign.h"

#include <QPainter>
#include <QPainterPath>

#include "app/workbench/base/theme.h"

namespace tactus::workbench {
namespace {

constexpr int kSize = 20;  // px; the pictures are drawn on a square of this size

struct SignLook {
  QColor ink;
  QColor fill;
  QPainterPath lines;
};

QPainterPath polyline(std::initializer_list<QPointF> points) {
  QPainterPath path(*points.begin());
  for (const QPointF& point : points) path.lineTo(point);
  return path;
}

SignLook lookOf(Readiness state) {
  switch (state) {
    case Readiness::kReady:
      return {theme::accent(), theme::window(), polyline({{6, 10.5}, {9, 13.5}, {14, 7}})};
    case Readiness::kLook: {
      QPainterPath mark = polyline({{10, 5.5}, {10, 11}});
      mark.addPath(polyline({{10, 14}, {10, 14.2}}));
      return {theme::warningInk(), theme::warningFill(), mark};
    }
    case Readiness::kBlocks: {
      QPainterPath cross = polyline({{6.8, 6.8}, {13.2, 13.2}});
      cross.addPath(polyline({{13.2, 6.8}, {6.8, 13.2}}));
      return {theme::errorInk(), theme::errorFill(), cross};
    }
    case Readiness::kUnknown:
      break;
  }
  QPainterPath dots;
  for (const double x : {6.5, 10.0, 13.5}) dots.addPath(polyline({{x, 10}, {x, 10.1}}));
  return {theme::mutedInk(), theme::window(), dots};
}

}  // namespace

ReadinessSign::ReadinessSign(QWidget* parent) : QWidget(parent) {
  setFixedSize(kSize, kSize);
  setState(Readiness::kUnknown);
}

void ReadinessSign::setState(Readiness state) {
  state_ = state;
  setToolTip(readinessName(state));
  setAccessibleName(readinessName(state));
  update();
}

void ReadinessSign::paintEvent(QPaintEvent* /*event*/) {
  const SignLook look = lookOf(state_);
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(look.fill);
  painter.drawEllipse(rect());
  painter.setPen(QPen(look.ink, 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(look.lines);
}

}  // namespace tactus::workbench
