#include "app/workbench/collect/force_plot.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/collect/force_trace.h"

namespace tactus::workbench {
namespace {

constexpr double kLeastTop = 1;  // N: a small force is not blown up

}  // namespace

ForcePlot::ForcePlot(const ForceTrace& trace, QWidget* parent) : QWidget(parent), trace_(trace) {
  setAccessibleName(tr("Force of the last seconds"));
}

void ForcePlot::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(theme::smallFont());
  const QFontMetrics metrics(painter.font());
  const int left = metrics.horizontalAdvance(QStringLiteral("0.0 N")) + theme::kGrid;
  const QRectF area = QRectF(rect()).adjusted(left, theme::kGrid, -4, -metrics.height() - 4);

  double highest = kLeastTop;
  for (const ForceTrace::Point& point : trace_.points()) {
    highest = std::max({highest, point.commanded_n, point.delivered_n});
  }
  const double top = std::ceil(highest * 2 - 1e-9) / 2;  // whole halves of a newton
  const auto y = [&](double force_n) { return area.bottom() - std::clamp(force_n / top, -0.05, 1.05) * area.height(); };
  for (int tick = 0; tick <= 2; ++tick) {
    const double force_n = top * tick / 2;
    painter.setPen(QPen(theme::grid(), 1));
    painter.drawLine(QPointF(area.left(), y(force_n)), QPointF(area.right(), y(force_n)));
    painter.setPen(theme::mutedInk());
    painter.drawText(QRectF(0, y(force_n) - 10, left - theme::kGrid, 20), Qt::AlignRight | Qt::AlignVCenter,
                     numberText(force_n) + QStringLiteral(" N"));
  }
  painter.setPen(theme::mutedInk());
  painter.drawText(QRectF(area.left(), area.bottom() + 2, area.width(), metrics.height() + 2), Qt::AlignRight,
                   tr("the last %1 s").arg(ForceTrace::kSeconds));
  if (trace_.newest() == nullptr) {
    painter.drawText(area, Qt::AlignCenter, tr("No device is in use."));
    return;
  }
  const std::int64_t end_ns = trace_.newest()->time_ns;
  const auto x = [&](std::int64_t time_ns) {
    return area.right() - static_cast<double>(end_ns - time_ns) * 1e-9 / ForceTrace::kSeconds * area.width();
  };
  QPainterPath commanded;
  QPainterPath delivered;
  bool first = true;
  for (const ForceTrace::Point& point : trace_.points()) {
    const double at = x(point.time_ns);
    if (first) {
      commanded.moveTo(at, y(0));
      delivered.moveTo(at, y(point.delivered_n));
    } else {
      delivered.lineTo(at, y(point.delivered_n));
    }
    commanded.lineTo(at, y(point.commanded_n));
    first = false;
  }
  commanded.lineTo(area.right(), y(0));
  QColor band = theme::accent();
  band.setAlphaF(0.22F);
  painter.fillPath(commanded, theme::onCard(band));
  painter.setPen(QPen(theme::accent(), 2));
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(delivered);
}

}  // namespace tactus::workbench
