#include "app/workbench/labs/speed/speed_term_plot.h"

#include <QVBoxLayout>
#include <limits>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/plot/plot_marks.h"
#include "app/workbench/plot/plot_style.h"
#include "app/workbench/plot/term_labels.h"

namespace tactus::workbench {
namespace {

constexpr int kLabelRows = 1;
constexpr std::size_t kMostLegend = 8;  // participants with a line of their own in the legend

// Those that come from strokes: the others are ends of the universe.
std::vector<VertexPick::Vertex> innerCorners(const fuzzy::Variable& speed) {
  std::vector<VertexPick::Vertex> out;
  for (std::size_t t = 0; t < speed.terms.size(); ++t) {
    const std::vector<double>& points = speed.terms[t].points;
    for (std::size_t p = 0; p < points.size(); ++p) {
      if ((t == 0 && p < 2) || (t + 1 == speed.terms.size() && p >= 2)) continue;
      out.push_back({speed.terms[t].id, p, points[p], p == 0 || p == 3 ? 0.0 : 1.0});
    }
  }
  return out;
}

}  // namespace

SpeedTermPlot::SpeedTermPlot(QWidget* parent) : QWidget(parent), plot_(makePlot(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(plot_);
  setMinimumHeight(120);
  setAccessibleName(tr("Speed terms of each participant and their average"));
  labels_ = new TermLabels(*plot_, kLabelRows);
  corners_ = new VertexPick(*plot_, tr("Click: where does this corner come from?"));
  connect(corners_, &VertexPick::picked, this, &SpeedTermPlot::vertexAsked);
  plot_->axisRect()->setAutoMargins(QCP::msBottom | QCP::msLeft);
  plot_->axisRect()->setVisible(false);  // until there is something to show
  plot_->axisRect()->setMargins(QMargins(0, labels_->height(), 2 * theme::kGrid, 0));
}

void SpeedTermPlot::show(const SpeedResult& result) {
  plot_->axisRect()->setVisible(true);
  plot_->clearPlottables();
  legend_.clear();
  styleAxis(*plot_->xAxis, result.speed);
  styleAxis(*plot_->yAxis, result.speed);
  plot_->xAxis->setLabel(axisText(result.speed));
  plot_->xAxis->grid()->setVisible(false);
  plot_->yAxis->setRange(0, 1.06);
  auto ticker = QSharedPointer<QCPAxisTickerFixed>::create();
  ticker->setTickStep(0.5);
  plot_->yAxis->setTicker(ticker);
  const std::vector<std::size_t> numbers = subjectNumbers(result);
  const bool few = result.subjects.size() <= kMostLegend;
  for (std::size_t i = 0; i < result.subjects.size(); ++i) {
    const SpeedSubject& one = *result.subjects[i];
    if (!one.failure.empty() || result.clusters != result.speed.terms.size()) continue;
    const QColor color = theme::expert(numbers[i]);
    addLine(one.speeds.ramps, result.speed.max, QPen(few ? color : fadedLine(color), few ? 1.5 : 1),
            few ? text(one.speeds.participant) : QString());
  }
  if (!result.averaged.empty()) {
    addLine(result.averaged, result.speed.max, QPen(theme::ink(), 3), tr("Terms of the model"));
    addIntervals(result);
    labels_->setTerms(result.speed, result.speed.terms);
  } else {
    labels_->setTerms(result.speed, {});
  }
  corners_->setVertices(result.averaged.empty() ? std::vector<VertexPick::Vertex>() : innerCorners(result.speed));
  redraw(*plot_);
}

void SpeedTermPlot::addLine(const std::vector<elicitation::Ramp>& ramps, double max_mm_s, const QPen& pen,
                            const QString& name) {
  constexpr double kGap = std::numeric_limits<double>::quiet_NaN();  // QCustomPlot's sign for the end of a line
  QVector<double> x;
  QVector<double> y;
  for (std::size_t term = 0; term <= ramps.size(); ++term) {
    if (term == 0) {
      x << 0;
      y << 1;
    } else {
      x << ramps[term - 1].p << ramps[term - 1].q;
      y << 0 << 1;
    }
    if (term == ramps.size()) {
      x << max_mm_s;
      y << 1;
    } else {
      x << ramps[term].p << ramps[term].q;
      y << 1 << 0;
    }
    x << x.back();
    y << kGap;
  }
  // The lines of the terms overlap, so the points are not in the order of x.
  auto* curve = new QCPCurve(plot_->xAxis, plot_->yAxis);
  curve->setPen(pen);
  curve->setData(x, y);
  if (!name.isEmpty()) legend_.push_back({name, pen});
}

void SpeedTermPlot::addIntervals(const SpeedResult& result) {
  if (!result.intervals || result.intervals->averaged.size() != result.averaged.size()) return;
  const QColor color = theme::readableLine(theme::warningInk());
  const auto add = [&](const elicitation::Interval& interval, double height) {
    QCPGraph& bar = addShape(*plot_, color, 2, 0);
    bar.setData({interval.low, interval.high}, {height, height}, true);
    bar.setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, color, 4));
  };
  for (const elicitation::RampInterval& ramp : result.intervals->averaged) {
    add(ramp.p, 1);
    add(ramp.q, 1);
  }
  legend_.push_back({tr("95 % interval of a corner"), QPen(color, 2)});
}

void SpeedTermPlot::paintPicture(QCPPainter& painter, const QSize& size) { paintPlot(*plot_, painter, size, {}); }

}  // namespace tactus::workbench
