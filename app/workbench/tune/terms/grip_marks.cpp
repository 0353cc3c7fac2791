#include "app/workbench/tune/terms/grip_marks.h"

#include <QFontMetricsF>
#include <algorithm>
#include <utility>

#include "app/workbench/base/theme.h"

namespace tactus::workbench {

GripMarks::GripMarks(QCustomPlot& plot, const QString& layer) : QCPLayerable(&plot, layer), font_(theme::smallFont()) {}

void GripMarks::setHandles(std::vector<Handle> handles) { handles_ = std::move(handles); }

void GripMarks::setLines(std::vector<Line> lines) { lines_ = std::move(lines); }

void GripMarks::setTag(const QString& text, double x, double membership, bool warns) {
  tag_ = text;
  tag_x_ = x;
  tag_membership_ = membership;
  tag_warns_ = warns;
}

void GripMarks::setUniverse(double min, double max) {
  min_ = min;
  max_ = max;
}

void GripMarks::applyDefaultAntialiasingHint(QCPPainter* painter) const { painter->setAntialiasing(true); }

QPointF GripMarks::pixelOf(double x, double membership) const {
  const QCPAxisRect* area = mParentPlot->axisRect();
  return {area->axis(QCPAxis::atBottom)->coordToPixel(x), area->axis(QCPAxis::atLeft)->coordToPixel(membership)};
}

QRect GripMarks::clipRect() const { return mParentPlot->axisRect()->rect().adjusted(-10, -40, 10, 10); }

void GripMarks::draw(QCPPainter* painter) {
  const QCPAxisRect* area = mParentPlot->axisRect();
  QColor beyond = theme::border();
  beyond.setAlphaF(0.45F);
  const double first = pixelOf(min_, 0).x();
  const double last = pixelOf(max_, 0).x();
  if (first > area->left() + 1) {
    painter->fillRect(QRectF(QPointF(area->left(), area->top()), QPointF(first, area->bottom())), beyond);
  }
  if (last < area->right() - 1) {
    painter->fillRect(QRectF(QPointF(last, area->top()), QPointF(area->right(), area->bottom())), beyond);
  }

  painter->setPen(QPen(theme::accent(), 3));
  for (const Line& line : lines_) {
    painter->drawLine(QLineF(pixelOf(line.from_x, line.from_membership), pixelOf(line.to_x, line.to_membership)));
  }
  // What moves lies on top of what stays.
  for (const bool moves : {false, true}) {
    for (const Handle& handle : handles_) {
      if (handle.moves == moves) drawHandle(*painter, handle);
    }
  }
  if (!tag_.isEmpty()) drawTag(*painter);
}

void GripMarks::drawHandle(QCPPainter& painter, const Handle& handle) const {
  const QPointF at = pixelOf(handle.x, handle.membership);
  const double radius = handle.moves ? 7 : handle.large ? 6 : 3.5;
  if (handle.locked) {
    // A square with a bar reads as a bolt, also without color.
    const QRectF box(at.x() - radius, at.y() - radius, 2 * radius, 2 * radius);
    painter.setPen(QPen(handle.moves ? theme::accent() : theme::mutedInk(), 1.5));
    painter.setBrush(theme::card());
    painter.drawRect(box);
    painter.drawLine(QLineF(box.left(), at.y(), box.right(), at.y()));
    return;
  }
  painter.setPen(QPen(handle.moves ? theme::accent() : theme::card(), handle.moves ? 2 : 1.5));
  painter.setBrush(handle.moves ? QBrush(theme::card()) : QBrush(handle.color));
  painter.drawEllipse(at, radius, radius);
}

void GripMarks::drawTag(QCPPainter& painter) const {
  const QCPAxisRect* area = mParentPlot->axisRect();
  const QFontMetricsF metrics(font_);
  const QPointF at = pixelOf(tag_x_, tag_membership_);
  const double width = metrics.horizontalAdvance(tag_) + 12;
  const double height = metrics.height() + 6;
  // Beside the handle, where the hand does not cover it, and never beyond the plot.
  const double left = at.x() + 14 + width <= area->right() ? at.x() + 14 : at.x() - 14 - width;
  const double top =
      std::clamp(at.y() - height / 2, area->top() + 2.0, std::max(area->top() + 2.0, area->bottom() - height - 2));
  const QRectF tag(std::max(left, area->left() + 2.0), top, width, height);
  painter.setPen(Qt::NoPen);
  painter.setBrush(tag_warns_ ? theme::warningFill() : theme::accent());
  painter.drawRoundedRect(tag, 4, 4);
  painter.setPen(tag_warns_ ? theme::warningInk() : QColor(Qt::white));
  painter.setFont(font_);
  painter.drawText(QPointF(tag.left() + 6, tag.bottom() - 3 - metrics.descent()), tag_);
}

}  // namespace tactus::workbench
