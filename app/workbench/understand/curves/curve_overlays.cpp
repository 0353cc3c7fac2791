#include "app/workbench/understand/curves/curve_overlays.h"

#include <algorithm>
#include <limits>

#include "app/workbench/plot/plot_style.h"

namespace tactus::workbench {
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
  if (hasSteps()) entries.push_back(stepLook(tr("Step that a hand feels")));
  for (const QCPGraph* line : references_) entries.push_back({line->name(), line->pen(), Qt::NoBrush, true});
  return entries;
}

}  // namespace tactus::workbench
