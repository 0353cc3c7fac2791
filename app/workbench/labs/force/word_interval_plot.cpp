#include <QLabel>
#include <algorithm>
#include <cmath>

#include "app/figures/colors.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/labs/force/force_lab_view.h"
#include "app/workbench/plot/chart.h"
#include "app/workbench/plot/plot_style.h"
#include "app/workbench/plot/term_marks.h"

namespace tactus::workbench {
namespace {

constexpr double kLane = 0.84;  // of the place of a word: the height of full agreement
constexpr double kEnd = 5;      // px
constexpr float kShareFill = 0.3F;
constexpr double kTickLines = 1.6;     // of text, below the lanes
constexpr double kAxisLines = 2.8;     // with the name of the axis
constexpr std::size_t kMostNamed = 8;  // participants beside the summary

std::vector<std::string> peopleIn(const std::vector<elicitation::WordInterval>& intervals) {
  std::vector<std::string> people;
  for (const auto& one : intervals) {
    if (people.empty() || people.back() != one.participant) people.push_back(one.participant);
  }
  return people;
}

/// The color numbers that these participants have as experts.
std::vector<std::size_t> numbersOf(const std::vector<std::string>& people) {
  std::vector<fuzzy::Expert> experts(people.size());
  for (std::size_t i = 0; i < people.size(); ++i) experts[i].id = people[i];
  return figures::expertNumbers(experts);
}

/// `Very small 3 of 3 · Small 2 of 4`: how many of the intervals of a word share a force.
QString summaryText(const fuzzy::Variable& words, const std::vector<elicitation::WordInterval>& intervals) {
  if (intervals.empty()) return WordIntervalPlot::tr("No force of this series was called by a word.");
  QStringList parts;
  for (std::size_t word = 0; word < words.terms.size(); ++word) {
    const auto users = std::count_if(intervals.begin(), intervals.end(),
                                     [word](const elicitation::WordInterval& one) { return one.word == word; });
    double most = 0;
    for (const auto& one : elicitation::intervalAgreement(intervals, word)) most = std::max(most, one.share);
    parts << WordIntervalPlot::tr("%1 %2 of %3")
                 .arg(labelOf(words.terms[word]))
                 .arg(std::lround(most * static_cast<double>(users)))
                 .arg(users);
  }
  return WordIntervalPlot::tr("Intervals that share a force, at most: %1").arg(parts.join(QStringLiteral(" · ")));
}

/// The share of the participants whose interval of the word holds a force, as a surface on its lane.
void addAgreement(const fuzzy::Variable& words, const std::vector<elicitation::WordInterval>& intervals, Chart& chart) {
  for (std::size_t word = 0; word < words.terms.size(); ++word) {
    const auto base = static_cast<double>(word);
    ChartLine shares;
    double end_n = 0;
    for (const auto& one : elicitation::intervalAgreement(intervals, word)) {
      if (shares.x.isEmpty() || one.left_n > end_n) {
        if (!shares.x.isEmpty()) shares.x << end_n, shares.y << base;
        shares.x << one.left_n;
        shares.y << base;
      }
      shares.x << one.left_n << one.right_n;
      shares.y << base + kLane * one.share << base + kLane * one.share;
      end_n = one.right_n;
    }
    if (!shares.x.isEmpty()) shares.x << end_n, shares.y << base;
    QColor fill = termLine(words, words.terms, word);
    fill.setAlphaF(kShareFill);
    shares.pen = QPen(theme::onCard(fill), 1);  // a single force has no width
    shares.fill = theme::onCard(fill);
    shares.is_function_of_x = false;
    chart.parts.emplace_back(shares);
  }
}

void addPeople(const std::vector<std::string>& people, const std::vector<elicitation::WordInterval>& intervals,
               Chart& chart) {
  const auto numbers = numbersOf(people);
  for (std::size_t who = 0; who < people.size(); ++who) {
    const QColor color = theme::expert(numbers[who]);
    ChartLine line{{}, {}, QPen(color, 1.6), {ChartDots::Shape::kDisc, kEnd}};
    line.is_function_of_x = false;
    const double place = kLane * (static_cast<double>(who) + 0.5) / static_cast<double>(people.size());
    for (const auto& one : intervals) {
      if (one.participant != people[who]) continue;
      line.x << one.left_n << one.right_n << qQNaN();
      line.y << static_cast<double>(one.word) + place << static_cast<double>(one.word) + place << qQNaN();
    }
    chart.parts.emplace_back(line);
    chart.legend.push_back({harmless(text(people[who])), QPen(color, 2), Qt::NoBrush, true});
  }
}

}  // namespace

WordIntervalPlot::WordIntervalPlot(QWidget* parent)
    : QWidget(parent),
      chart_(new ChartView(this)),
      summary_(new ElidedLabel(this)),
      people_(makeRow({}, theme::kGrid)),
      head_(makeRow({{summary_, 1}, people_}, kStyleGap)) {
  setMuted(*summary_);
  chart_->plot().axisRect()->setMinimumMargins(QMargins(0, theme::kGrid / 2, 2 * theme::kGrid, 0));
  makeColumn(this, {head_, {chart_, 1}}, theme::kGrid / 2, inset(theme::kGrid, theme::kGrid / 2));
  setAccessibleName(tr("Forces that each participant called by each word"));
  setToolTip(
      tr("Lines: from the lowest to the highest force that a participant called so. Surface: the share of the "
         "participants who used the word whose line holds this force; it reaches the next word where all agree."));
}

void WordIntervalPlot::setIntervals(const fuzzy::Variable& words,
                                    const std::vector<elicitation::WordInterval>& intervals, double end_n) {
  summary_text_ = summaryText(words, intervals);
  summary_->setFullText(summary_text_);
  const bool some = !intervals.empty();
  chart_->setVisible(some);
  if (tool_ != nullptr) tool_->setVisible(some);
  summary_->setAlignment(some ? Qt::AlignLeft | Qt::AlignVCenter : Qt::AlignCenter);
  Chart chart{{.universe = words}, {.grid = false}};
  double& right_n = chart.x.universe.max;
  right_n = end_n;
  for (const auto& one : intervals) right_n = std::max(right_n, one.right_n);
  chart.y.universe.max = static_cast<double>(words.terms.size());
  addAgreement(words, intervals, chart);
  addPeople(peopleIn(intervals), intervals, chart);
  chart_->setChart(chart);
  force_text_ = axisText(chart.x.universe);
  words_.clear();
  for (const fuzzy::Term& word : words.terms) words_ << labelOf(word);
  nameAxes();
  namePeople();
}

void WordIntervalPlot::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  layout()->activate();
  nameAxes();
}

/// Where the lanes are low, initials stand beside some of them, and the name of the axis is left out.
void WordIntervalPlot::nameAxes() {
  if (words_.isEmpty()) return;
  QCustomPlot* const plot = &chart_->plot();
  const double line = QFontMetricsF(plot->yAxis->tickLabelFont()).height();
  const bool low = plot->height() < (static_cast<double>(words_.size()) + kAxisLines) * line;
  const double lanes = plot->height() - (low ? kTickLines : kAxisLines) * line;
  const auto step =
      static_cast<qsizetype>(std::ceil(line * static_cast<double>(words_.size()) / std::max(lanes, line)));
  auto names = QSharedPointer<QCPAxisTickerText>::create();
  for (qsizetype word = 0; word < words_.size(); word += low ? std::max<qsizetype>(1, step) : 1)
    names->addTick(static_cast<double>(word) + kLane / 2, low ? initialsOf(words_[word]) : words_[word]);
  plot->yAxis->setTicker(names);
  plot->xAxis->setLabel(low ? QString() : force_text_);
  redraw(*plot);
}

void WordIntervalPlot::namePeople() {
  while (QLayoutItem* const item = people_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  const auto people = chart_->legend();
  if (people.size() > kMostNamed) return;
  for (const LegendEntry& one : people) {
    auto* const name = new QLabel(QStringLiteral("● %1").arg(one.name), this);
    name->setTextFormat(Qt::PlainText);
    setInk(*name, theme::readableText(one.pen.color()));
    people_->addWidget(name);
  }
}

void WordIntervalPlot::addTool(QWidget* tool) {
  tool_ = tool;
  head_->addWidget(tool);
}

}  // namespace tactus::workbench
