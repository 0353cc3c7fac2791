#include <QFontMetricsF>
#include <algorithm>
#include <limits>
#include <utility>

#include "app/workbench/base/theme.h"
#include "app/workbench/plot/plot_canvas.h"
#include "app/workbench/plot/plot_style.h"
#include "app/workbench/understand/curves/curve_plot.h"
#include "app/workbench/understand/curves/curves_panel.h"

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

namespace {

constexpr auto kUnder = "under the curves";
constexpr auto kOver = "over the curves";
constexpr std::size_t kMostGhosts = 9;  // the mean and eight experts: more dashes than that say nothing

QVector<double> column(const std::vector<double>& values) { return {values.begin(), values.end()}; }

}  // namespace

QVector<double> withGaps(std::span<const fuzzy::Evaluation> curve) {
  QVector<double> forces;
  forces.reserve(static_cast<qsizetype>(curve.size()));
  for (const fuzzy::Evaluation& point : curve) {
    forces << (point.fired ? point.force_n : std::numeric_limits<double>::quiet_NaN());
  }
  return forces;
}

/// The handle of a pulled line with what one edit reaches, and the band that a line should lie in.
class PullLayer : public QCPLayerable {
 public:
  explicit PullLayer(QCustomPlot& plot) : QCPLayerable(&plot, QLatin1String(kOver)) {}

  void set(const PullMarks& marks, const QColor& color) {
    handle_ = marks.handle;
    band_ = marks.band;
    pins_ = marks.pins;
    color_ = color;
    setVisible(handle_ || band_ || !pins_.empty());
  }

 protected:
  void applyDefaultAntialiasingHint(QCPPainter* painter) const override { painter->setAntialiasing(true); }
  void draw(QCPPainter* painter) override {
    painter->setClipRect(mParentPlot->axisRect()->rect());
    if (band_) drawBand(*painter);
    for (const PullMarks::Pin& pin : pins_) drawPin(*painter, pin);
    if (handle_) drawHandle(*painter);
  }

 private:
  QPointF pixelOf(double x, double force_n) const {
    return {mParentPlot->xAxis->coordToPixel(x), mParentPlot->yAxis->coordToPixel(force_n)};
  }

  void drawBand(QCPPainter& painter) const {
    const QRectF box(pixelOf(band_->x.low, band_->force_n.high), pixelOf(band_->x.high, band_->force_n.low));
    fill(painter, box, color_, 0.14F);
    painter.setPen(QPen(color_, 1.5, Qt::DashLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(box);
  }

  // A nail through the line.
  void drawPin(QCPPainter& painter, const PullMarks::Pin& pin) const {
    constexpr double kHead = 5;   // px, half of the head
    constexpr double kStem = 16;  // px
    const QPointF at = pixelOf(pin.x, pin.force_n);
    const QPointF head = at - QPointF(0, kStem);
    painter.setPen(QPen(theme::ink(), 2));
    painter.drawLine(at, head);
    painter.setPen(QPen(theme::card(), 1.5));
    painter.setBrush(theme::ink());
    painter.drawEllipse(head, kHead, kHead);
    painter.drawEllipse(at, kHead * 0.6, kHead * 0.6);
  }

  void drawHandle(QCPPainter& painter) const {
    constexpr double kWide = 14;  // px, of what is reached
    constexpr double kSize = 7;   // px, half of the handle
    const QPointF to = pixelOf(handle_->x, handle_->wanted_n);
    if (handle_->reach_n) {
      const double top = pixelOf(0, handle_->reach_n->high).y();
      const double bottom = pixelOf(0, handle_->reach_n->low).y();
      fill(painter, QRectF(to.x() - kWide / 2, top, kWide, bottom - top), color_, 0.22F);
      painter.setPen(QPen(color_, 2));
      for (const double y : {top, bottom}) painter.drawLine(QPointF(to.x() - kWide, y), QPointF(to.x() + kWide, y));
    }
    if (handle_->now_n) {
      const QPointF from = pixelOf(handle_->x, *handle_->now_n);
      painter.setPen(QPen(color_, 1.5, Qt::DotLine));
      painter.drawLine(from, to);
      painter.setPen(QPen(color_, 2));
      painter.setBrush(theme::card());
      painter.drawEllipse(from, kSize * 0.6, kSize * 0.6);
    }
    painter.setPen(QPen(theme::card(), 2));
    painter.setBrush(color_);
    painter.drawPolygon(QPolygonF({to - QPointF(0, kSize + 2), to + QPointF(kSize + 2, 0), to + QPointF(0, kSize + 2),
                                   to - QPointF(kSize + 2, 0)}));
    if (handle_->says.isEmpty()) return;
    // Where there is room: at its right, else at its left.
    painter.setFont(theme::smallFont());
    const QFontMetricsF metrics(theme::smallFont());
    const double width = metrics.horizontalAdvance(handle_->says) + 8;
    const bool right = to.x() + kWide + width < mParentPlot->axisRect()->right();
    const QRectF tag(right ? to.x() + kWide : to.x() - kWide - width, to.y() - metrics.height() / 2, width,
                     metrics.height());
    fill(painter, tag, theme::card(), 0.85F);
    painter.setPen(theme::ink());
    painter.drawText(tag, Qt::AlignCenter, handle_->says);
  }

  std::optional<PullMarks::Handle> handle_;
  std::optional<PullMarks::Band> band_;
  std::vector<PullMarks::Pin> pins_;
  QColor color_;
};

void CurveOverlays::setPull(const PullMarks* pull, const QColor& color) {
  if (pull_ == nullptr) {
    if (pull == nullptr) return;
    pull_ = new PullLayer(plot_);
  }
  if (pull == nullptr || pull->curve.empty()) {
    if (pulled_ != nullptr) plot_.removeGraph(pulled_);
    pulled_ = nullptr;
  } else {
    if (pulled_ == nullptr) pulled_ = addLine(kOver);
    pulled_->setPen(QPen(color, fast_ ? 1 : 2, Qt::DashLine));
    pulled_->setData(column(pull->x), withGaps(pull->curve), true);
  }
  pull_->set(pull != nullptr ? *pull : PullMarks(), color);
}

void CurveOverlays::setFocused(bool focused) {
  if (focus_ == nullptr) {
    if (!focused) return;
    focus_ = new QCPItemRect(&plot_);
    focus_->setClipToAxisRect(false);
    for (QCPItemPosition* corner : {focus_->topLeft, focus_->bottomRight})
      corner->setType(QCPItemPosition::ptAxisRectRatio);
    focus_->topLeft->setCoords(0, 0);
    focus_->bottomRight->setCoords(1, 1);
  }
  focus_->setPen(QPen(theme::accent(), 2));
  focus_->setVisible(focused);
}

CurveOverlays::CurveOverlays(QCustomPlot& plot) : plot_(plot) {
  QCPLayer* const curves = plot_.layer(QStringLiteral("main"));
  plot_.addLayer(QLatin1String(kUnder), curves, QCustomPlot::limBelow);
  plot_.addLayer(QLatin1String(kOver), curves, QCustomPlot::limAbove);
}

QCPGraph* CurveOverlays::addLine(const char* layer) {
  QCPGraph* line = plot_.addGraph();
  line->setLayer(QLatin1String(layer));
  line->setAdaptiveSampling(false);
  return line;
}

void CurveOverlays::removeLines(std::vector<QCPGraph*>& lines) {
  for (QCPGraph* line : lines) plot_.removeGraph(line);
  lines.clear();
}

void CurveOverlays::clear() {
  for (auto* lines : {&band_, &ghosts_, &family_, &references_}) removeLines(*lines);
  if (steps_ != nullptr) plot_.removePlottable(steps_);
  steps_ = nullptr;
  setPull(nullptr, {});
}

void CurveOverlays::setSpread(const std::vector<double>& x, const ForceSpread& spread, SpreadShown shown) {
  shown_ = shown;
  if (band_.empty()) {
    for (int i = 0; i < 4; ++i) band_.push_back(addLine(kUnder));
    band_[0]->setPen(Qt::NoPen);
    band_[1]->setPen(Qt::NoPen);
    band_[1]->setChannelFillGraph(band_[0]);
    takeLook();
  }
  const std::vector<double>* const values[] = {&spread.lowest_n, &spread.highest_n, &spread.minus_sd_n,
                                               &spread.plus_sd_n};
  const QVector<double> places = column(x);
  for (std::size_t i = 0; i < band_.size(); ++i) {
    const bool visible = i < 2 ? shown.range : shown.deviation;
    band_[i]->setVisible(visible);
    if (visible) band_[i]->setData(places, column(*values[i]), true);
  }
}

void CurveOverlays::takeLook() {
  for (std::size_t i = 0; i < family_.size(); ++i) family_[i]->setPen(familyPen(i, family_.size(), fast_));
  if (steps_ != nullptr) steps_->setPen(stepLook({}).pen);
  if (band_.empty()) return;
  band_[1]->setBrush(rangeLook({}).fill);
  band_[2]->setPen(deviationLook({}).pen);
  band_[3]->setPen(deviationLook({}).pen);
}

void CurveOverlays::setFamily(const QStringList& names) {
  removeLines(family_);
  for (const QString& name : names) {
    QCPGraph* line = addLine(kOver);
    line->setName(name);
    line->setPen(familyPen(family_.size(), static_cast<std::size_t>(names.size()), fast_));
    family_.push_back(line);
  }
}

void CurveOverlays::setFamilyCurves(const FamilyCurves& curves) {
  const QVector<double> x = column(curves.x);
  for (std::size_t i = 0; i < family_.size(); ++i) family_[i]->setData(x, withGaps(curves.curves[i]), true);
}

void CurveOverlays::setFamilyShown(std::size_t line, bool shown) { family_[line]->setVisible(shown); }

LegendEntry CurveOverlays::familyLine(std::size_t line) const {
  return {family_[line]->name(), familyPen(line, family_.size())};
}

void CurveOverlays::setGhost(const GhostCurves* ghost, const std::vector<QPen>& pens) {
  const std::size_t count = ghost ? (pens.size() <= kMostGhosts ? pens.size() : 1) : 0;
  while (ghosts_.size() > count) {
    plot_.removeGraph(ghosts_.back());
    ghosts_.pop_back();
  }
  while (ghosts_.size() < count) ghosts_.push_back(addLine(kUnder));
  if (count == 0) return;
  const QVector<double> x = column(ghost->x);
  for (std::size_t i = 0; i < count; ++i) {
    const std::vector<fuzzy::Evaluation>& curve = i == 0 ? ghost->mean : ghost->experts[i - 1];
    ghosts_[i]->setVisible(pens[i].style() != Qt::NoPen && !curve.empty());
    if (!ghosts_[i]->visible()) continue;
    ghosts_[i]->setPen(ghostPen(pens[i].color(), fast_));
    ghosts_[i]->setData(x, withGaps(curve), true);
  }
}

void CurveOverlays::setReferences(const std::vector<ReferenceCurve>& references) {
  removeLines(references_);
  for (const ReferenceCurve& reference : references) {
    QCPGraph* line = addLine(kOver);
    const QPen pen = referencePen(reference.color);
    line->setName(reference.name);
    line->setPen(pen);
    line->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, pen.color(), pen.color(), 4.5));
    // Thousands of points would only be a thick line.
    constexpr std::size_t kMostDots = 60;
    line->setScatterSkip(static_cast<int>(reference.x.size() / kMostDots));
    line->setData(column(reference.x), column(reference.force_n), true);
    references_.push_back(line);
  }
}

void CurveOverlays::setSteps(const std::vector<analysis::ForceStep>& steps) {
  if (steps_ == nullptr) {
    if (steps.empty()) return;
    steps_ = new QCPCurve(plot_.xAxis, plot_.yAxis);
    steps_->setLayer(QLatin1String(kOver));
    steps_->setPen(stepLook({}).pen);
  }
  steps_->setVisible(!steps.empty());
  QVector<double> order;
  QVector<double> x;
  QVector<double> y;
  const auto add = [&](double at, double force_n) {
    order << static_cast<double>(order.size());
    x << at;
    y << force_n;
  };
  for (const analysis::ForceStep& step : steps) {
    add(step.from[step.input], step.from_n);
    add(step.to[step.input], step.to_n);
    add(std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN());
  }
  steps_->setData(order, x, y, true);
}

void CurveOverlays::setFast(bool fast) {
  fast_ = fast;
  for (QCPGraph* line : ghosts_) {
    QPen pen = line->pen();
    pen.setWidthF(fast ? 1 : 1.4);
    line->setPen(pen);
  }
  for (std::size_t i = 0; i < family_.size(); ++i) family_[i]->setPen(familyPen(i, family_.size(), fast));
}

std::vector<LegendEntry> CurveOverlays::legend(const QString& ghost_name) const {
  std::vector<LegendEntry> entries;
  for (std::size_t i = 0; i < family_.size(); ++i) {
    if (isFamilyShown(i)) entries.push_back(familyLine(i));
  }
  if (!band_.empty() && shown_.range) entries.push_back(rangeLook(tr("Range of the experts")));
  if (!band_.empty() && shown_.deviation) {
    entries.push_back(deviationLook(tr("Mean ± 1 standard deviation of the experts (n − 1)")));
  }
  const auto ghost = std::find_if(ghosts_.begin(), ghosts_.end(), [](const QCPGraph* line) { return line->visible(); });
  if (ghost != ghosts_.end()) entries.push_back({ghost_name, (*ghost)->pen()});
  if (pulled_ != nullptr) entries.push_back({tr("After the edit that is looked at"), pulled_->pen()});
  if (hasSteps()) entries.push_back(stepLook(tr("Step that a hand feels")));
  for (const QCPGraph* line : references_) entries.push_back({line->name(), line->pen(), Qt::NoBrush, true});
  return entries;
}

SimulatorMarks::SimulatorMarks(QCustomPlot& plot)
    : QCPLayerable(&plot, QStringLiteral("overlay")), font_(theme::smallFont()) {}

SimulatorMarks::~SimulatorMarks() = default;

void SimulatorMarks::set(std::vector<SimulatorMark> marks) { marks_ = std::move(marks); }

void SimulatorMarks::applyDefaultAntialiasingHint(QCPPainter* painter) const { painter->setAntialiasing(true); }

void SimulatorMarks::draw(QCPPainter* painter) {
  constexpr double kSize = 7;  // px from the center to a corner
  const QCPAxisRect* area = mParentPlot->axisRect();
  for (const SimulatorMark& mark : marks_) {
    if (!area->axis(QCPAxis::atBottom)->range().contains(mark.x)) continue;
    // A force beyond the axis stands at its edge.
    const double y = std::clamp(area->axis(QCPAxis::atLeft)->coordToPixel(mark.force_n), double(area->top()),
                                double(area->bottom()));
    const QPointF at(area->axis(QCPAxis::atBottom)->coordToPixel(mark.x), y);
    painter->setPen(QPen(theme::ink(), 2));
    painter->setBrush(theme::card());
    painter->drawPolygon(
        QPolygonF{at + QPointF(0, -kSize), at + QPointF(kSize, 0), at + QPointF(0, kSize), at + QPointF(-kSize, 0)});
    drawName(*painter, mark.name, at);
  }
}

void SimulatorMarks::drawName(QCPPainter& painter, const QString& name, QPointF at) const {
  constexpr double kAway = 12;  // px from the mark
  const QRect area = mParentPlot->axisRect()->rect();
  const QFontMetricsF metrics(font_);
  const QSizeF size(metrics.horizontalAdvance(name) + 12, metrics.height() + 4);
  const bool to_the_right = at.x() + kAway + size.width() <= area.right();
  const double top = std::clamp(at.y() - size.height() / 2, double(area.top()), area.bottom() - size.height());
  const QRectF tag(QPointF(to_the_right ? at.x() + kAway : at.x() - kAway - size.width(), top), size);
  painter.setPen(QPen(theme::ink(), 1));
  painter.setBrush(theme::card());
  painter.drawRoundedRect(tag, 4, 4);
  painter.setFont(font_);
  painter.drawText(QPointF(tag.left() + 6, tag.bottom() - 2 - metrics.descent()), name);
}

}  // namespace tactus::workbench
