#include "app/workbench/labs/speed/cluster_page.h"

#include <QCoreApplication>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QString>
#include <array>
#include <cstddef>
#include <limits>

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

/// The ramps between 0 and `max_mm_s` as one line a term.
ChartLine rampLine(const std::vector<elicitation::Ramp>& ramps, double max_mm_s, const QPen& pen) {
  constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
  ChartLine line{{}, {}, pen};
  for (std::size_t term = 0; term <= ramps.size(); ++term) {
    if (term == 0) {
      line.x << 0;
      line.y << 1;
    } else {
      line.x << ramps[term - 1].p << ramps[term - 1].q;
      line.y << 0 << 1;
    }
    if (term == ramps.size()) {
      line.x << max_mm_s;
      line.y << 1;
    } else {
      line.x << ramps[term].p << ramps[term].q;
      line.y << 1 << 0;
    }
    line.x << line.x.back();
    line.y << kGap;
  }
  line.is_function_of_x = false;  // the terms overlap
  return line;
}

void addIntervals(const SpeedResult& result, Chart& chart) {
  if (!result.intervals || result.intervals->averaged.size() != result.averaged.size()) return;
  const QColor color = theme::readableLine(theme::warningInk());
  const auto add = [&](const elicitation::Interval& interval, double height) {
    chart.parts.emplace_back(ChartLine{
        {interval.low, interval.high}, {height, height}, QPen(color, 2), {ChartDots::Shape::kDisc, 4, QPen(color)}});
  };
  for (const elicitation::RampInterval& ramp : result.intervals->averaged) {
    add(ramp.p, 1);
    add(ramp.q, 1);
  }
  chart.legend.push_back({SpeedTermPlot::tr("95 % interval of a corner"), QPen(color, 2)});
}

}  // namespace

SpeedTermPlot::SpeedTermPlot(QWidget* parent) : ChartView(parent, {940, 340}) {
  setMinimumHeight(120);
  setAccessibleName(tr("Speed terms of each participant and their average"));
  labels_ = new TermLabels(plot(), kWordRows);
  corners_ = new VertexPick(plot(), tr("Click: where does this corner come from?"));
  connect(corners_, &VertexPick::picked, this, &SpeedTermPlot::vertexAsked);
  plot().axisRect()->setAutoMargins(QCP::msBottom | QCP::msLeft);
  plot().axisRect()->setMargins(QMargins(0, labels_->height(), 2 * theme::kGrid, 0));
}

bool SpeedTermPlot::setTerms(const SpeedResult& result, const std::vector<fuzzy::Term>& former) {
  Chart chart{{.universe = result.speed, .label = axisText(result.speed), .grid = false}, membershipAxis()};
  const std::vector<std::size_t> numbers = subjectNumbers(result);
  const bool few = result.subjects.size() <= kMostLegend;
  for (std::size_t i = 0; i < result.subjects.size(); ++i) {
    const SpeedSubject& one = *result.subjects[i];
    if (!one.failure.empty() || result.clusters != result.speed.terms.size()) continue;
    const QColor color = theme::expert(numbers[i]);
    const QPen pen(few ? color : fadedLine(color), few ? 1.5 : 1);
    chart.parts.emplace_back(rampLine(one.speeds.ramps, result.speed.max, pen));
    if (few) chart.legend.push_back({text(one.speeds.participant), pen});
  }
  bool others = false;
  const bool averaged = !result.averaged.empty();
  if (averaged) {
    others = addGhosts(chart, result.speed, result.speed.terms, former, result.speed.min, result.speed.max);
    if (others) chart.legend.push_back({tr("Before the change"), ghostPen(theme::ink())});
    const QPen pen(theme::ink(), 3);
    chart.parts.emplace_back(rampLine(result.averaged, result.speed.max, pen));
    chart.legend.push_back({tr("Terms of the model"), pen});
    addIntervals(result, chart);
  }
  labels_->setTerms(result.speed, averaged ? result.speed.terms : std::vector<fuzzy::Term>());
  corners_->setVertices(averaged ? innerCorners(result.speed) : std::vector<VertexPick::Vertex>());
  setChart(chart);
  return others;
}

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

void addHistogram(const SpeedSubject& subject, Chart& chart) {
  QColor fill = theme::mutedInk();
  fill.setAlphaF(0.22F);
  ChartLine bars;
  bars.fill = theme::onCard(fill);
  const double width_mm_s = subject.end_mm_s / static_cast<double>(std::max<std::size_t>(1, subject.histogram.size()));
  for (std::size_t i = 0; i < subject.histogram.size(); ++i) {
    for (const std::size_t edge : {i, i + 1}) {
      bars.x << static_cast<double>(edge) * width_mm_s;
      bars.y << subject.histogram[i];
    }
  }
  chart.parts.emplace_back(bars);
}

void addCentres(const SpeedSubject& subject, const fuzzy::Variable& speed,
                const std::vector<elicitation::Interval>& intervals, Chart& chart) {
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
    chart.parts.emplace_back(ChartLine{x, memberships[k], QPen(color, 2, kDashes[k % kDashes.size()])});
    chart.parts.emplace_back(ChartLine{{centres[k], centres[k]}, {0.0, 1.0}, QPen(color, 1, Qt::DotLine)});
    if (centres.size() == speed.terms.size()) {
      chart.parts.emplace_back(ChartText{
          labelOf(speed.terms[k]), {centres[k], 1}, Qt::AlignHCenter | Qt::AlignBottom, theme::readableText(color)});
    }
    if (k >= intervals.size()) continue;
    chart.parts.emplace_back(ChartLine{{intervals[k].low, intervals[k].high},
                                       {kFoot, kFoot},
                                       QPen(theme::ink(), 2),
                                       {ChartDots::Shape::kDisc, 4, QPen(theme::ink())}});
  }
}

}  // namespace

ClusterPlot::ClusterPlot(QWidget* parent)
    : QWidget(parent), title_(new ElidedLabel(this)), warnings_(new QLabel(this)), chart_(new ChartView(this)) {
  title_->setFont(theme::headingFont());
  warnings_->setTextFormat(Qt::PlainText);
  warnings_->setFont(theme::smallFont());
  setInk(*warnings_, theme::warningInk());
  chart_->plot().axisRect()->setMinimumMargins(QMargins(0, theme::kGrid / 2, 2 * theme::kGrid, 0));
  makeColumn(this, {makeRow({{title_, 1}, warnings_}), {chart_, 1}}, 2);
  setMinimumSize(200, 130);
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

  Chart chart{{.label = tr("Speed (mm/s)"), .grid = false}, membershipAxis(kTop)};
  chart.x.universe.max = subject.end_mm_s;
  addHistogram(subject, chart);
  addCentres(subject, speed, intervals, chart);
  chart_->setChart(chart);
}

void ClusterPlot::paint(QCPPainter& painter, const QSize& size) {
  painter.setFont(theme::headingFont());
  painter.setPen(theme::ink());
  const int head = painter.fontMetrics().height() + 4;
  painter.drawText(QRect(theme::kGrid, 0, size.width(), head), Qt::AlignLeft | Qt::AlignVCenter, heading_);
  painter.translate(0, head);
  chart_->paintPicture(painter, size - QSize(0, head));
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
  const bool others = terms_->setTerms(*result, price_.formerTerms(result->speed.id));
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
