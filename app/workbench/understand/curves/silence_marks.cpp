#include "app/workbench/understand/curves/silence_marks.h"

#include <QFontMetricsF>
#include <algorithm>
#include <limits>
#include <utility>

#include "app/workbench/base/theme.h"
#include "app/workbench/plot/plot_canvas.h"

namespace tactus::workbench {
namespace {

constexpr std::size_t kMostLanes = 6;
constexpr double kMinWidth = 3;  // px, so that a narrow gap stays visible

// Diagonal lines, cut at the rectangle by hand: the vector formats have neither pattern brushes nor clipping.
void hatch(QCPPainter& painter, const QRectF& area, const QColor& color, double spacing) {
  painter.setPen(QPen(color, 1));
  const int lines = static_cast<int>((area.width() + area.height()) / spacing);
  for (int line = 1; line <= lines; ++line) {
    const double offset = line * spacing;
    const double x0 = area.left() + std::max(0.0, offset - area.height());
    const double x1 = area.left() + std::min(offset, area.width());
    const double y0 = area.top() + std::min(offset, area.height());
    const double y1 = area.top() + std::max(0.0, offset - area.width());
    painter.drawLine(QLineF(x0, y0, x1, y1));
  }
}

void fill(QCPPainter& painter, const QRectF& area, QColor color, float alpha) {
  color.setAlphaF(alpha);
  fillInStrips(painter, area, color);
}

}  // namespace

SilenceMarks::SilenceMarks(QCustomPlot& plot)
    : QCPLayerable(&plot, QStringLiteral("main")), font_(theme::smallFont()) {}

void SilenceMarks::set(std::vector<figures::Interval> everyone, std::vector<Lane> lanes) {
  everyone_ = std::move(everyone);
  lanes_ = std::move(lanes);
  if (lanes_.size() <= kMostLanes) return;
  Lane others{tr("others"), theme::mutedInk(), {}};
  for (std::size_t i = kMostLanes - 1; i < lanes_.size(); ++i) {
    others.intervals.insert(others.intervals.end(), lanes_[i].intervals.begin(), lanes_[i].intervals.end());
  }
  std::sort(others.intervals.begin(), others.intervals.end(),
            [](const figures::Interval& a, const figures::Interval& b) { return a.low < b.low; });
  lanes_.resize(kMostLanes - 1);
  lanes_.push_back(std::move(others));
}

void SilenceMarks::applyDefaultAntialiasingHint(QCPPainter* painter) const { painter->setAntialiasing(true); }

void SilenceMarks::draw(QCPPainter* painter) {
  painter->setFont(font_);
  for (const figures::Interval& interval : inSight(everyone_)) drawEveryone(*painter, interval);
  const double height = QFontMetricsF(font_).height();
  double bottom = mParentPlot->axisRect()->bottom() - foot_;
  for (const Lane& lane : lanes_) {
    drawLane(*painter, {lane.text, lane.color, inSight(lane.intervals)}, bottom);
    bottom -= height;
  }
}

// Their parts in the range of the axis.
std::vector<figures::Interval> SilenceMarks::inSight(const std::vector<figures::Interval>& intervals) const {
  const QCPRange shown = mParentPlot->axisRect()->axis(QCPAxis::atBottom)->range();
  std::vector<figures::Interval> out;
  for (const figures::Interval& interval : intervals) {
    if (interval.high < shown.lower || interval.low > shown.upper) continue;
    out.push_back({std::max(interval.low, shown.lower), std::min(interval.high, shown.upper)});
  }
  return out;
}

void SilenceMarks::drawEveryone(QCPPainter& painter, const figures::Interval& interval) const {
  const QCPAxisRect* area = mParentPlot->axisRect();
  const QCPAxis* axis = area->axis(QCPAxis::atBottom);
  const double left = axis->coordToPixel(interval.low);
  const QRectF box(left, area->top(), std::max(kMinWidth, axis->coordToPixel(interval.high) - left), area->height());
  fill(painter, box, theme::card(), 0.75F);
  hatch(painter, box, theme::border().darker(112), 7);

  const QString note = tr("no rule fires");
  const QFontMetricsF metrics(font_);
  const double width = metrics.horizontalAdvance(note);
  const QPointF middle = box.center() - QPointF(0, foot_ / 2);
  painter.setPen(theme::mutedInk());
  if (box.width() >= width + 2 * theme::kGrid) {
    const QRectF plate(middle.x() - width / 2 - 4, middle.y() - metrics.height() / 2, width + 8, metrics.height());
    fill(painter, plate, theme::card(), 1);
    painter.drawText(QPointF(plate.left() + 4, plate.bottom() - metrics.descent()), note);
    return;
  }
  painter.save();
  painter.translate(middle);
  painter.rotate(-90);
  fill(painter, QRectF(-width / 2 - 4, -metrics.height() / 2, width + 8, metrics.height()), theme::card(), 0.85F);
  painter.drawText(QPointF(-width / 2, metrics.height() / 2 - metrics.descent()), note);
  painter.restore();
}

void SilenceMarks::drawLane(QCPPainter& painter, const Lane& lane, double bottom) const {
  const QCPAxisRect* area = mParentPlot->axisRect();
  const QCPAxis* axis = area->axis(QCPAxis::atBottom);
  const QFontMetricsF metrics(font_);
  const QString note = tr("%1: no rule fires").arg(lane.text);
  const double note_width = metrics.horizontalAdvance(note);
  double free_from = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < lane.intervals.size(); ++i) {
    const double left = axis->coordToPixel(lane.intervals[i].low);
    const double width = std::max(kMinWidth, axis->coordToPixel(lane.intervals[i].high) - left);
    const QRectF box(left, bottom - metrics.height() + 2, width, metrics.height() - 4);
    fill(painter, box, lane.color, 0.12F);
    hatch(painter, box, lane.color, 5);

    // The note stands inside the mark, to its right or to its left, whichever is free first.
    const double next_left = i + 1 < lane.intervals.size() ? axis->coordToPixel(lane.intervals[i + 1].low)
                                                           : static_cast<double>(area->right());
    double note_left = box.right() + 4;
    if (width > note_width + 16) {
      note_left = box.center().x() - note_width / 2;
      fill(painter, QRectF(note_left - 4, box.top() - 1, note_width + 8, box.height() + 2), theme::card(), 1);
    } else if (note_left + note_width > next_left) {
      note_left = box.left() - 4 - note_width;
    }
    if (note_left < std::max<double>(free_from, area->left())) continue;
    painter.setPen(theme::readableText(lane.color));
    painter.drawText(QPointF(note_left, bottom - metrics.descent()), note);
    free_from = std::max(box.right(), note_left + note_width);
  }
}

}  // namespace tactus::workbench
