#include "app/workbench/understand/curves/curve_plot.h"

#include <QMenu>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/figures/colors.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/plot/axis_zoom.h"
#include "app/workbench/plot/landmark_marks.h"
#include "app/workbench/plot/plot_marks.h"
#include "app/workbench/plot/plot_style.h"
#include "app/workbench/plot/term_marks.h"
#include "app/workbench/understand/curves/curves_panel.h"

namespace tactus::workbench {
namespace {

constexpr int kLabelRows = 2;
constexpr double kSameForce = 0.002;  // of the output; a line is wider
constexpr double kDash = 5;           // widths of a line
constexpr int kLow = 300;             // px: below this height the name of the x axis stands in the heading alone

QPen linePen(std::size_t graph, const std::vector<std::size_t>& numbers, bool fast) {
  QPen pen = graph == CurvePlot::kMeanGraph ? QPen(theme::mean(), 4) : expertPen(numbers[graph - 1], numbers.size());
  if (fast) pen.setWidthF(1);
  return pen;
}

// Lines on each other take turns: one shows where the others have their gaps.
void interleave(QPen& pen, const Coincidence& place) {
  // The lowest one stays whole.
  if (place.member == 0) return;
  pen.setDashPattern({kDash, kDash * static_cast<double>(place.of - 1)});
  pen.setDashOffset(-kDash * static_cast<double>(place.member));
  pen.setCapStyle(Qt::FlatCap);
}

constexpr auto kMeanLayer = "mean";
constexpr double kHalo = 1.5;  // px on each side

/// The line of the mean: over all others, with a halo that sets it off from them.
class MeanGraph : public QCPGraph {
 public:
  using QCPGraph::QCPGraph;

 protected:
  void draw(QCPPainter* painter) override {
    const QPen own = pen();
    if (own.widthF() > 1) {
      setPen(QPen(theme::card(), own.widthF() + 2 * kHalo));
      QCPGraph::draw(painter);
      setPen(own);
    }
    QCPGraph::draw(painter);
  }
};

void addLine(QCustomPlot& plot, const QString& name) {
  QCPGraph* graph =
      plot.graphCount() == CurvePlot::kMeanGraph ? new MeanGraph(plot.xAxis, plot.yAxis) : plot.addGraph();
  if (plot.graphCount() == CurvePlot::kMeanGraph + 1) graph->setLayer(QLatin1String(kMeanLayer));
  graph->setName(name);
  graph->setAdaptiveSampling(false);
}

}  // namespace

CurvePlot::CurvePlot(ShownRanges& ranges, QWidget* parent)
    : QWidget(parent), plot_(makePlot(this)), zoom_(new AxisZoom(*plot_, ranges)) {
  connect(zoom_, &AxisZoom::menuOpens, this, [this](QMenu* menu, QPointF place) {
    menu->addSeparator();
    menu->addAction(tr("Where does the force here come from?"), this,
                    [this, x = plot_->xAxis->pixelToCoord(place.x())] { emit originAsked(x); });
    const auto pin = pinAt(place.x());
    const double x = pin.value_or(placeOf(x_, plot_->xAxis->pixelToCoord(place.x())));
    menu->addAction(pin ? tr("Take the pin away") : tr("Pin the force here"), this, [this, x] { emit pinAsked(x); });
  });
  makeColumn(this, {plot_});
  setMinimumSize(360, 160);
  setAccessibleName(tr("Force curves"));
  setFocusPolicy(Qt::StrongFocus);

  plot_->addLayer(QLatin1String(kMeanLayer), plot_->layer(QStringLiteral("main")), QCustomPlot::limAbove);
  bands_ = new TermBands(*plot_);
  silence_ = new SilenceMarks(*plot_);
  labels_ = new TermLabels(*plot_, kLabelRows);
  landmarks_ = new LandmarkMarks(*plot_, LandmarkMarks::Place::kInside);
  cursor_ = new ReadingCursor(*plot_);
  simulators_ = new SimulatorMarks(*plot_);
  overlays_ = std::make_unique<CurveOverlays>(*plot_);
  plot_->axisRect()->setAutoMargins(QCP::msLeft | QCP::msBottom);
  plot_->axisRect()->setMargins(QMargins(0, labels_->height(), 2 * theme::kGrid, 0));

  connect(plot_, &QCustomPlot::mouseMove, this, &CurvePlot::onMouse);
  connect(plot_, &QCustomPlot::mousePress, this, [this](QMouseEvent* event) {
    if (!beginPull(*event)) onMouse(event);
  });
  connect(plot_, &QCustomPlot::mouseRelease, this, [this] {
    if (std::exchange(drag_, Drag::kNone) != Drag::kNone) emit pullReleased();
  });
  connect(zoom_, &AxisZoom::shiftClicked, this, [this](QPointF place) {
    if (plot_->axisRect()->rect().contains(place.toPoint())) {
      emit marked(placeOf(x_, plot_->xAxis->pixelToCoord(place.x())));
    }
  });
}

CurvePlot::~CurvePlot() = default;

void CurvePlot::setAxes(const fuzzy::Variable& x, const fuzzy::Variable& output,
                        const std::vector<fuzzy::Expert>& experts) {
  x_ = x;
  output_ = output;
  styleAxis(*plot_->xAxis, x);
  styleAxis(*plot_->yAxis, output);
  // Forces are read by round numbers; the end of their universe is none.
  plot_->yAxis->setTicker(QSharedPointer<QCPAxisTicker>::create());
  zoom_->setInputs(x);
  nameAxis(height() >= kLow);
  plot_->yAxis->setLabel(axisText(output));
  plot_->xAxis->grid()->setVisible(false);
  overlays_->clear();
  plot_->clearGraphs();
  weights_.clear();
  numbers_ = figures::expertNumbers(experts);
  addLine(*plot_, tr("Mean"));
  for (const fuzzy::Expert& expert : experts) {
    addLine(*plot_, labelOf(expert));
    weights_.push_back(expert.weight);
  }
  coincidences_.clear();
  styleLines();
  everyone_silent_.clear();
  silent_.clear();
}

void CurvePlot::setTerms(const fuzzy::Variable& x, const std::vector<fuzzy::Term>& terms,
                         std::span<const fuzzy::TubeEvent> events) {
  landmarks_->setVariable(x, events);
  silence_->setFoot(landmarks_->height());
  setToolTip(landmarks_->explanation());
  bands_->setTerms(x, terms);
  labels_->setTerms(x, terms);
  redraw(*plot_);
}

void CurvePlot::setCurves(const figures::ForceCurves& curves) {
  const QVector<double> x(curves.x.begin(), curves.x.end());
  plot_->graph(kMeanGraph)->setData(x, withGaps(curves.mean), true);
  everyone_silent_ = figures::silentIntervals(curves.x, curves.mean);
  silent_.clear();
  for (std::size_t i = 0; i < curves.experts.size(); ++i) {
    plot_->graph(static_cast<int>(i) + 1)->setData(x, withGaps(curves.experts[i]), true);
    silent_.push_back(figures::silentIntervals(curves.x, curves.experts[i]));
  }
  // The spread is one of the experts, who make way for a family.
  const SpreadShown spread = overlays_->familySize() > 0 ? SpreadShown{false, false} : spread_;
  const bool any = spread.range || spread.deviation;
  overlays_->setSpread(curves.x, any ? spreadOf(curves, weights_) : ForceSpread(), spread);
  auto together = coincidences(curves, kSameForce * (output_.max - output_.min));
  if (together != coincidences_) {
    coincidences_ = std::move(together);
    styleLines();
  }
  updateSilence();
}

void CurvePlot::setExpertShown(std::size_t expert, bool shown) {
  plot_->graph(static_cast<int>(expert) + 1)->setVisible(shown);
  updateSilence();
}

void CurvePlot::setMeanShown(bool shown) {
  plot_->graph(kMeanGraph)->setVisible(shown);
  redraw(*plot_);
}

// `   Δ +58 mm, −0.210 N`
QString CurvePlot::differenceText(const Reading& reading, double from, const fuzzy::Evaluation& left_behind) const {
  const auto signed_text = [](double change, const QString& size) {
    return (change < 0 ? QStringLiteral("−") : QStringLiteral("+")) + size;
  };
  const double way = reading.x - from;
  QString out = signed_text(way, quantityText(std::abs(way), x_.unit));
  if (reading.mean.fired && left_behind.fired) {
    const double change = reading.mean.force_n - left_behind.force_n;
    out += QStringLiteral(", ") + signed_text(change, forceText(std::abs(change), output_.unit));
  }
  return QStringLiteral("   Δ ") + out;
}

void CurvePlot::setReading(const Reading& reading, double from, const std::optional<fuzzy::Evaluation>& left_behind) {
  std::vector<ReadingCursor::Dot> dots;
  for (std::size_t i = 0; i < reading.experts.size(); ++i) {
    if (reading.experts[i].fired && shown(i + 1))
      dots.push_back({reading.experts[i].force_n, theme::expert(numbers_[i])});
  }
  if (reading.mean.fired && shown(kMeanGraph)) dots.push_back({reading.mean.force_n, theme::mean()});
  const QString force = forceText(reading.mean.force_n, output_.unit);
  const QString said = !reading.mean.fired    ? tr("no rule fires")
                       : numbers_.size() == 1 ? force
                                              : tr("mean %1").arg(force);
  QString tag = placeText(x_, reading.x) + QStringLiteral("   ") + said;
  if (left_behind) tag += differenceText(reading, from, *left_behind);
  setAccessibleDescription(tag);
  cursor_->setFrom(left_behind ? std::optional(from) : std::nullopt);
  cursor_->set(reading.x, std::move(tag), std::move(dots));
  redraw(*plot_);
}

bool CurvePlot::isMeanShown() const { return shown(kMeanGraph); }

bool CurvePlot::isExpertShown(std::size_t expert) const { return shown(expert + 1); }

void CurvePlot::setGhost(const GhostCurves* ghost, const QString& name) {
  ghost_name_ = name;
  std::vector<QPen> pens;
  for (std::size_t i = 0; i <= weights_.size(); ++i) {
    pens.push_back(shown(i) ? linePen(i, numbers_, fast_) : QPen(Qt::NoPen));
  }
  overlays_->setGhost(ghost, pens);
  redraw(*plot_);
}

void CurvePlot::setSteps(const std::vector<analysis::ForceStep>& steps) {
  std::vector<analysis::ForceStep> marked;
  for (const analysis::ForceStep& step : steps) {
    if (shown(step.expert ? *step.expert + 1 : 0)) marked.push_back(step);
  }
  steps_marked_ = marked.size();
  overlays_->setSteps(marked);
  redraw(*plot_);
}

void CurvePlot::setReferences(const std::vector<ReferenceCurve>& references) {
  overlays_->setReferences(references);
  double lowest = output_.min;
  double highest = output_.max;
  for (const ReferenceCurve& reference : references) {
    for (std::size_t i = 0; i < reference.x.size(); ++i) {
      if (reference.x[i] < x_.min || reference.x[i] > x_.max || std::isnan(reference.force_n[i])) continue;
      lowest = std::min(lowest, reference.force_n[i]);
      highest = std::max(highest, reference.force_n[i]);
    }
  }
  // To round numbers, so that the ends of the axis read well.
  const double step = std::pow(10, std::floor(std::log10(output_.max - output_.min)) - 1);
  if (lowest < output_.min) lowest = std::floor(lowest / step) * step;
  if (highest > output_.max) highest = std::ceil(highest / step) * step;
  plot_->yAxis->setRange(lowest, highest);
  redraw(*plot_);
}

void CurvePlot::setFamily(const QStringList& names) {
  overlays_->setFamily(names);
  redraw(*plot_);
}

void CurvePlot::setFamilyCurves(const FamilyCurves& curves) {
  overlays_->setFamilyCurves(curves);
  redraw(*plot_);
}

void CurvePlot::setFamilyShown(std::size_t line, bool shown) {
  overlays_->setFamilyShown(line, shown);
  redraw(*plot_);
}

bool CurvePlot::isFamilyShown(std::size_t line) const { return overlays_->isFamilyShown(line); }

LegendEntry CurvePlot::familyLine(std::size_t line) const { return overlays_->familyLine(line); }

void CurvePlot::setFast(bool fast) {
  if (fast == fast_) return;
  fast_ = fast;
  plot_->setAntialiasedElements(fast ? QCP::aeNone : QCP::aeAll);
  plot_->setNotAntialiasedElements(fast ? QCP::aeAll : QCP::aeFills);
  styleLines();
  overlays_->setFast(fast);
  redraw(*plot_);
}

void CurvePlot::styleLines() {
  for (std::size_t i = 0; i <= weights_.size(); ++i) {
    QCPGraph* line = plot_->graph(static_cast<int>(i));
    QPen pen = linePen(i, numbers_, fast_);
    if (i > 0 && i <= coincidences_.size()) interleave(pen, coincidences_[i - 1]);
    line->setPen(pen);
  }
}

LegendEntry CurvePlot::lineOf(std::optional<std::size_t> expert) const {
  const int graph = expert ? static_cast<int>(*expert) + 1 : kMeanGraph;
  return {plot_->graph(graph)->name(), linePen(static_cast<std::size_t>(graph), numbers_, false)};
}

std::vector<LegendEntry> CurvePlot::legend() const {
  std::vector<LegendEntry> entries;
  for (std::size_t i = 0; i <= weights_.size(); ++i) {
    if (shown(i)) entries.push_back(lineOf(i == 0 ? std::nullopt : std::optional(i - 1)));
  }
  const std::vector<LegendEntry> others = overlays_->legend(ghost_name_);
  entries.insert(entries.end(), others.begin(), others.end());
  return entries;
}

void CurvePlot::paintPicture(QCPPainter& painter, const QSize& size) {
  nameAxis(true);
  paintPlot(*plot_, painter, size, {cursor_, simulators_});
  nameAxis(height() >= kLow);
}

void CurvePlot::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  nameAxis(height() >= kLow);
}

void CurvePlot::nameAxis(bool named) { plot_->xAxis->setLabel(named ? axisText(x_) : QString()); }

void CurvePlot::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::PaletteChange || plot_->graphCount() == 0) return;
  styleLines();
  cursor_->takeLook();
  updateSilence();
  overlays_->takeLook();
  redraw(*plot_);
}

void CurvePlot::leaveEvent(QEvent* event) {
  emit hoverLeft();
  QWidget::leaveEvent(event);
}

void CurvePlot::setPull(const PullMarks* pull) {
  const bool has_handle = pull != nullptr && pull->handle;
  handle_ = has_handle ? std::optional(QPointF(pull->handle->x, pull->handle->wanted_n)) : std::nullopt;
  by_keys_ = by_keys_ && has_handle;
  if (has_handle) setAccessibleDescription(pull->handle->says);
  pins_.clear();
  for (std::size_t i = 0; pull != nullptr && i < pull->pins.size(); ++i) pins_.push_back(pull->pins[i].x);
  const bool mean = pull == nullptr || !pull->expert;
  overlays_->setPull(pull, mean ? theme::accent() : theme::expert(numbers_[*pull->expert]));
  redraw(*plot_);
}

void CurvePlot::setSimulators(std::vector<SimulatorMark> marks) {
  simulators_->set(std::move(marks));
  redraw(*plot_);
}

QPoint CurvePlot::pixelOf(double x, double force_n) const {
  return plot_->mapTo(this, QPointF(plot_->xAxis->coordToPixel(x), plot_->yAxis->coordToPixel(force_n)).toPoint());
}

void CurvePlot::onMouse(QMouseEvent* event) {
  if (drag_ != Drag::kNone) {
    movePull(*event);
    return;
  }
  const QPoint place = event->position().toPoint();
  if (!plot_->axisRect()->rect().contains(place)) {
    emit hoverLeft();
    return;
  }
  const double x = placeOf(x_, plot_->xAxis->pixelToCoord(event->position().x()));
  const bool pulls = event->modifiers().testFlag(Qt::AltModifier) || isOnHandle(event->position());
  pulls ? plot_->setCursor(Qt::SizeVerCursor) : plot_->unsetCursor();
  if (event->buttons().testFlag(Qt::LeftButton)) emit picked(x);
  emit hovered(x);
}

void CurvePlot::updateSilence() {
  std::vector<SilenceMarks::Lane> lanes;
  // With one expert the lane would repeat what the full height says.
  for (std::size_t i = 0; silent_.size() > 1 && i < silent_.size(); ++i) {
    if (silent_[i].empty() || !shown(i + 1)) continue;
    lanes.push_back({plot_->graph(static_cast<int>(i) + 1)->name(), theme::expert(numbers_[i]), silent_[i]});
  }
  silence_->set(everyone_silent_, std::move(lanes));
  redraw(*plot_);
}

bool CurvePlot::shown(std::size_t graph) const { return plot_->graph(static_cast<int>(graph))->visible(); }

}  // namespace tactus::workbench
