#include "app/workbench/labs/speed/cluster_page.h"

#include <QCoreApplication>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QString>
#include <array>
#include <cstddef>
#include <limits>
#include <qcustomplot.h>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/refresh.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/buttons.h"
#include "app/workbench/kit/cards.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/labs/data/settings_price.h"
#include "app/workbench/labs/speed/speed_clusters.h"
#include "app/workbench/labs/speed/speed_lab.h"
#include "app/workbench/plot/plot_marks.h"
#include "app/workbench/plot/plot_menu.h"
#include "app/workbench/plot/plot_style.h"
#include "app/workbench/plot/term_marks.h"

namespace tactus::workbench {
namespace {

constexpr int kWordRows = 1;
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
  makeColumn(this, {plot_});
  setMinimumHeight(120);
  setAccessibleName(tr("Speed terms of each participant and their average"));
  labels_ = new TermLabels(*plot_, kWordRows);
  corners_ = new VertexPick(*plot_, tr("Click: where does this corner come from?"));
  connect(corners_, &VertexPick::picked, this, &SpeedTermPlot::vertexAsked);
  plot_->axisRect()->setAutoMargins(QCP::msBottom | QCP::msLeft);
  plot_->axisRect()->setVisible(false);  // until there is something to show
  plot_->axisRect()->setMargins(QMargins(0, labels_->height(), 2 * theme::kGrid, 0));
}

bool SpeedTermPlot::show(const SpeedResult& result, const std::vector<fuzzy::Term>& former) {
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
  bool others = false;
  if (!result.averaged.empty()) {
    others = addGhosts(*plot_, result.speed, result.speed.terms, former, result.speed.min, result.speed.max);
    if (others) legend_.push_back({tr("Before the change"), ghostPen(theme::ink())});
    addLine(result.averaged, result.speed.max, QPen(theme::ink(), 3), tr("Terms of the model"));
    addIntervals(result);
    labels_->setTerms(result.speed, result.speed.terms);
  } else {
    labels_->setTerms(result.speed, {});
  }
  corners_->setVertices(result.averaged.empty() ? std::vector<VertexPick::Vertex>() : innerCorners(result.speed));
  redraw(*plot_);
  return others;
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

// The heading of a participant's plot in the speed lab: the name in the participant's color, and how much data it
// shows.

/// `S1`; says `simulated` where the data are.
QString subjectName(const SpeedSubject& subject);
/// `S1 · 5 312 of 6 004 samples`, with the same.
QString subjectTitle(const SpeedSubject& subject);

namespace {

struct SubjectTitle {
  Q_DECLARE_TR_FUNCTIONS(SubjectTitle)
};

}  // namespace

QString subjectName(const SpeedSubject& subject) {
  const QString who = text(subject.speeds.participant);
  return subject.speeds.simulated ? SubjectTitle::tr("%1 (simulated)").arg(who) : who;
}

QString subjectTitle(const SpeedSubject& subject) {
  const QString who = subjectName(subject);
  if (subject.speeds.kept == subject.speeds.samples) {
    return SubjectTitle::tr("%1 · %2 samples").arg(who).arg(subject.speeds.samples);
  }
  return SubjectTitle::tr("%1 · %2 of %3 samples").arg(who).arg(subject.speeds.kept).arg(subject.speeds.samples);
}

namespace {

constexpr int kCurvePoints = 160;
constexpr double kFoot = 0.06;  // where the intervals lie
constexpr double kTop = 1.28;   // above the lines there is room for their names
constexpr std::array<Qt::PenStyle, 3> kDashes = {Qt::SolidLine, Qt::DashLine, Qt::DashDotLine};

QColor lineOf(const fuzzy::Variable& speed, std::size_t cluster) {
  return cluster < speed.terms.size() ? termLine(speed, speed.terms, cluster) : theme::mutedInk();
}

}  // namespace

ClusterPlot::ClusterPlot(QWidget* parent)
    : QWidget(parent), title_(new ElidedLabel(this)), warnings_(new QLabel(this)), plot_(makePlot(this)) {
  title_->setFont(theme::headingFont());
  warnings_->setTextFormat(Qt::PlainText);
  warnings_->setFont(theme::smallFont());
  setInk(*warnings_, theme::warningInk());
  makeColumn(this, {makeRow({{title_, 1}, warnings_}), {plot_, 1}}, 2);
  setMinimumSize(200, 130);
  fuzzy::Variable membership;
  membership.min = 0;
  membership.max = 1;
  styleAxis(*plot_->xAxis, membership);
  styleAxis(*plot_->yAxis, membership);
  plot_->yAxis->setRange(0, kTop);
  auto ticker = QSharedPointer<QCPAxisTickerFixed>::create();
  ticker->setTickStep(0.5);
  plot_->yAxis->setTicker(ticker);
  plot_->xAxis->grid()->setVisible(false);
  plot_->axisRect()->setMinimumMargins(QMargins(0, theme::kGrid / 2, 2 * theme::kGrid, 0));
}

void ClusterPlot::show(const SpeedSubject& subject, const fuzzy::Variable& speed, std::size_t number,
                       const std::vector<elicitation::Interval>& intervals) {
  const elicitation::ParticipantSpeeds& speeds = subject.speeds;
  heading_ = subjectTitle(subject);
  title_->setFullText(heading_, subjectName(subject));
  setInk(*title_, theme::readableText(theme::expert(number)));
  const int warnings = static_cast<int>(speeds.diagnostics.warnings.size());
  warnings_->setVisible(warnings > 0 || !subject.failure.empty());
  warnings_->setText(subject.failure.empty() ? tr("▲ %n warning(s)", nullptr, warnings) : tr("▲ no clusters"));
  QStringList lines;
  if (!subject.failure.empty()) lines << text(subject.failure);
  for (const std::string& warning : speeds.diagnostics.warnings) lines << text(warning);
  warnings_->setToolTip(lines.join(QLatin1Char('\n')));
  setAccessibleName(tr("Clusters of %1").arg(text(speeds.participant)));

  plot_->clearPlottables();
  plot_->clearItems();
  fuzzy::Variable axis;
  axis.min = 0;
  axis.max = subject.end_mm_s;
  styleAxis(*plot_->xAxis, axis);
  plot_->xAxis->setLabel(tr("Speed (mm/s)"));
  plot_->xAxis->grid()->setVisible(false);
  addHistogram(subject);
  addCentres(subject, speed, intervals);
  redraw(*plot_);
}

void ClusterPlot::addHistogram(const SpeedSubject& subject) {
  QColor fill = theme::mutedInk();
  fill.setAlphaF(0.22F);
  QVector<double> x;
  QVector<double> height;
  const double width_mm_s = subject.end_mm_s / static_cast<double>(std::max<std::size_t>(1, subject.histogram.size()));
  for (std::size_t i = 0; i < subject.histogram.size(); ++i) {
    for (const std::size_t edge : {i, i + 1}) {
      x << static_cast<double>(edge) * width_mm_s;
      height << subject.histogram[i];
    }
  }
  QCPGraph& bars = addShape(*plot_, Qt::transparent, 0, 0);
  bars.setPen(Qt::NoPen);
  bars.setBrush(theme::onCard(fill));
  bars.setData(x, height, true);
}

void ClusterPlot::addCentres(const SpeedSubject& subject, const fuzzy::Variable& speed,
                             const std::vector<elicitation::Interval>& intervals) {
  const std::vector<double>& centres = subject.speeds.centres;
  if (centres.empty()) return;
  std::vector<QVector<double>> memberships(centres.size());
  QVector<double> x;
  std::vector<double> at(centres.size());
  for (int i = 0; i <= kCurvePoints; ++i) {
    x << subject.end_mm_s * i / kCurvePoints;
    elicitation::fcmMemberships(x.back(), centres, subject.speeds.m, at);
    for (std::size_t k = 0; k < centres.size(); ++k) memberships[k] << at[k];
  }
  for (std::size_t k = 0; k < centres.size(); ++k) {
    const QColor color = lineOf(speed, k);
    QCPGraph& curve = addShape(*plot_, color, 2, 0);
    curve.setPen(QPen(color, 2, kDashes[k % kDashes.size()]));
    curve.setData(x, memberships[k], true);
    QCPGraph& rule = addShape(*plot_, color, 1, 0);
    rule.setPen(QPen(color, 1, Qt::DotLine));
    rule.setData({centres[k], centres[k]}, {0.0, 1.0}, true);
    if (centres.size() == speed.terms.size()) {
      auto* name = new QCPItemText(plot_);
      name->setText(labelOf(speed.terms[k]));
      name->setFont(theme::smallFont());
      name->setColor(theme::readableText(color));
      name->setPositionAlignment(Qt::AlignHCenter | Qt::AlignBottom);
      name->position->setCoords(centres[k], 1);
    }
    if (k >= intervals.size()) continue;
    QCPGraph& interval = addShape(*plot_, theme::ink(), 2, 0);
    interval.setData({intervals[k].low, intervals[k].high}, {kFoot, kFoot}, true);
    interval.setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, theme::ink(), 4));
  }
}

void ClusterPlot::paint(QCPPainter& painter, const QSize& size) {
  painter.setFont(theme::headingFont());
  painter.setPen(theme::ink());
  const int head = painter.fontMetrics().height() + 4;
  painter.drawText(QRect(theme::kGrid, 0, size.width(), head), Qt::AlignLeft | Qt::AlignVCenter, heading_);
  painter.translate(0, head);
  paintPlot(*plot_, painter, size - QSize(0, head), {});
  painter.translate(0, -head);
}

ClusterPage::ClusterPage(SpeedLab& lab, const SettingsPrice& price, QWidget* parent)
    : QWidget(parent),
      lab_(lab),
      price_(price),
      terms_(nullptr),
      key_(new ElidedLabel(this)),
      said_(new QLabel(this)),
      waiting_(new QLabel(this)) {
  auto* clusters = new Card(this);
  setMuted(*key_);
  key_->setFullText(
      tr("gray: samples · lines: membership in each cluster · dotted: its center, 95 % interval at the foot"));
  auto* head = new QHBoxLayout;
  auto* title = new QLabel(tr("Clusters of each participant"), clusters);
  title->setFont(theme::headingFont());
  head->addWidget(title);
  head->addSpacing(theme::kGrid);
  head->addWidget(key_, 1);
  head->addWidget(new StatisticHelp({Statistic::kInterval}, clusters));
  head->addWidget(new PlotMenu(
      *this, [this] { return clusterTable(); }, clusters));
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(2 * theme::kGrid);
  grid->setVerticalSpacing(theme::kGrid);
  for (std::size_t i = 0; i < SpeedLab::kPerPage; ++i) {
    plots_.push_back(new ClusterPlot(clusters));
    grid->addWidget(plots_.back(), static_cast<int>(i / 2), static_cast<int>(i % 2));
    plots_.back()->hide();
  }
  setMuted(*waiting_);
  waiting_->setText(tr("The strokes of the study are being read and clustered…"));
  waiting_->setAlignment(Qt::AlignCenter);
  // It does not wait over the cells of the grid, which would have no space between them then.
  makeColumn(clusters, {head, {grid, 1}, {waiting_, 1}}, theme::kGrid / 2,
             {theme::kGrid + 4, theme::kGrid / 2, theme::kGrid, theme::kGrid / 2});
  makeColumn(this, {{clusters, 7}, {makeTerms(), 4}});
  auto* refresh = new Refresh(this, [this] { refreshState(); });
  connect(&lab_, &SpeedLab::resultChanged, refresh, &Refresh::request);
  connect(&lab_, &SpeedLab::pageChanged, refresh, &Refresh::request);
  connect(&price_, &SettingsPrice::changed, refresh, &Refresh::request);
  refresh->request();
}

QWidget* ClusterPage::makeTerms() {
  auto* card = new Card(this);
  terms_ = new SpeedTermPlot(card);
  setMuted(*said_);
  auto* title = new ElidedLabel(card);
  title->setFullText(tr("Terms: each participant’s and the average"), tr("Terms"));
  title->setFont(theme::headingFont());
  auto* head = makeRow({title,
                        gap(theme::kGrid),
                        {said_, 1},
                        new PlotMenu(
                            *terms_, [this] { return termTable(); }, card)},
                       kStyleGap);
  makeColumn(card, {head, {terms_, 1}}, 2, {theme::kGrid + 4, theme::kGrid / 2, theme::kGrid, theme::kGrid / 2});
  return card;
}

void ClusterPage::refreshState() {
  const auto& result = lab_.result();
  const auto [first, last] = lab_.shown();
  for (std::size_t i = 0; i < plots_.size(); ++i) plots_[i]->setVisible(first + i < last);
  waiting_->setVisible(!result);
  if (!result) return;
  const std::vector<std::size_t> numbers = subjectNumbers(*result);
  for (std::size_t i = first; i < last; ++i) {
    const bool known = result->intervals && i < result->intervals->participants.size();
    plots_[i - first]->show(*result->subjects[i], result->speed, numbers[i],
                            known ? result->intervals->participants[i].centres : std::vector<elicitation::Interval>());
  }
  const bool others = terms_->show(*result, price_.formerTerms(result->speed.id));
  if (!result->failure.empty()) {
    said_->setText(tr("Nothing is averaged: %1").arg(text(result->failure)));
  } else if (result->averaged.empty()) {
    said_->setText(tr("No terms: their number is not that of the clusters."));
  } else {
    QStringList corners;
    for (const elicitation::Ramp& ramp : result->averaged) {
      corners << numberText(ramp.p, 1) + QStringLiteral(" – ") + numberText(ramp.q, 1);
    }
    const QString ramps = tr("ramps %1 mm/s").arg(corners.join(QStringLiteral(" · ")));
    said_->setText(others ? tr("%1 · dashed: before the change").arg(ramps) : ramps);
  }
}

QString ClusterPage::settingText() const {
  const elicitation::SpeedTermSettings& settings = lab_.settings();
  return tr("c %1 · m %2 · α %3 · trimming %4")
      .arg(lab_.clusters())
      .arg(numberText(settings.fcm.m), numberText(settings.alpha), numberText(settings.trim));
}

PlotTable ClusterPage::clusterTable() const {
  PlotTable table;
  table.file = QStringLiteral("speed-clusters");
  table.caption << tr("Clusters of insertion speeds (paper, Fig. 7)") << settingText();
  table.columns = {"participant", "cluster", "centre_mm_s", "low_mm_s", "high_mm_s"};
  const auto& result = lab_.result();
  for (std::size_t i = 0; result && i < result->subjects.size(); ++i) {
    const elicitation::ParticipantSpeeds& one = result->subjects[i]->speeds;
    if (one.simulated && i == 0) table.caption << tr("The data are simulated.");
    for (std::size_t k = 0; k < one.centres.size(); ++k) {
      std::vector<PlotTable::Cell> row = {one.participant, static_cast<double>(k + 1), one.centres[k]};
      if (result->intervals) {
        const elicitation::Interval& interval = result->intervals->participants[i].centres[k];
        row.emplace_back(interval.low);
        row.emplace_back(interval.high);
      } else {
        row.resize(table.columns.size());
      }
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

PlotTable ClusterPage::termTable() const {
  PlotTable table;
  table.file = QStringLiteral("speed-terms");
  table.caption << tr("Speed terms of each participant and their average (paper, Fig. 8)") << settingText();
  table.columns = {"participant", "ramp", "from_mm_s", "to_mm_s"};
  const auto& result = lab_.result();
  if (!result) return table;
  const auto add = [&table](const std::string& who, const std::vector<elicitation::Ramp>& ramps) {
    for (std::size_t k = 0; k < ramps.size(); ++k) {
      table.rows.push_back({who, static_cast<double>(k + 1), ramps[k].p, ramps[k].q});
    }
  };
  for (const auto& subject : result->subjects) add(subject->speeds.participant, subject->speeds.ramps);
  add("average", result->averaged);
  if (!result->subjects.empty() && result->subjects.front()->speeds.simulated) {
    table.caption << tr("The data are simulated.");
  }
  return table;
}

void ClusterPage::paintPicture(QCPPainter& painter, const QSize& size) {
  painter.fillRect(QRect(QPoint(0, 0), size), theme::card());
  const QSize cell(size.width() / 2, size.height() / 2);
  for (std::size_t i = 0; i < plots_.size(); ++i) {
    if (plots_[i]->isHidden()) continue;
    const QPoint place(i % 2 == 0 ? 0 : cell.width(), i < 2 ? 0 : cell.height());
    painter.translate(place);
    plots_[i]->paint(painter, cell);
    painter.translate(-place);
  }
}

}  // namespace tactus::workbench
