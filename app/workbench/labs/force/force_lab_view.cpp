#include "app/workbench/labs/force/force_lab_view.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QLabel>
#include <QSignalBlocker>
#include <QStyledItemDelegate>
#include <QTabWidget>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/figures/colors.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/base/plot_table.h"
#include "app/workbench/base/refresh.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/buttons.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/labs/data/settings_price.h"
#include "app/workbench/labs/force/force_lab.h"
#include "app/workbench/labs/force/force_terms_view.h"
#include "app/workbench/labs/force/judgement_view.h"
#include "app/workbench/labs/force/votes_view.h"
#include "app/workbench/labs/frame/lab_card.h"
#include "app/workbench/plot/chart.h"
#include "app/workbench/plot/plot_menu.h"
#include "app/workbench/plot/term_marks.h"
#include "elicitation/force/force_terms.h"

namespace tactus::workbench {
namespace {

constexpr double kDelivered = 6;  // px
constexpr double kGood = 0.9;     // share of the force that counts as delivered

QString summaryOf(const DeliveredForces& forces) {
  if (forces.forces.empty()) return DeliveredPlot::tr("No delivered force was measured.");
  const auto weak = std::count_if(forces.forces.begin(), forces.forces.end(), [](const DeliveredForce& one) {
    return one.least_n && *one.least_n < kGood * one.commanded_n;
  });
  QString out = DeliveredPlot::tr("%n judgement(s)", nullptr, static_cast<int>(forces.forces.size())) +
                QStringLiteral(" · ") +
                DeliveredPlot::tr("%n below 90 % of the force", nullptr, static_cast<int>(weak));
  if (forces.unknown > 0) {
    out += QStringLiteral(" · ") + DeliveredPlot::tr("%n not measured", nullptr, static_cast<int>(forces.unknown));
  }
  return out;
}

std::vector<std::size_t> colorNumbers(const std::vector<std::string>& participants) {
  std::vector<fuzzy::Expert> experts;
  for (const std::string& code : participants) {
    fuzzy::Expert expert;
    expert.id = code;
    experts.push_back(expert);
  }
  return figures::expertNumbers(experts);
}

}  // namespace

DeliveredForces deliveredForces(const std::vector<session::JudgedForce>& all) {
  DeliveredForces out;
  for (const session::JudgedForce& one : all) {
    if (one.record.commanded_n <= 0) continue;
    const auto& share = one.record.delivered_share;
    if (!share && !one.record.felt_n) {
      ++out.unknown;
      continue;
    }
    if (out.participants.empty() || out.participants.back() != one.participant)
      out.participants.push_back(one.participant);
    out.forces.push_back({out.participants.size() - 1, one.record.commanded_n,
                          share ? std::optional(*share * one.record.commanded_n) : std::nullopt, one.record.felt_n});
  }
  return out;
}

namespace {

Chart deliveredChart(const DeliveredForces& forces) {
  double highest = 1.1;  // N, the end of the paper's table
  for (const DeliveredForce& one : forces.forces)
    highest = std::max({highest, one.commanded_n, one.felt_n.value_or(0)});
  fuzzy::Variable axis;
  axis.max = std::ceil(highest * 10) / 10;
  Chart chart{{.universe = axis, .label = DeliveredPlot::tr("Commanded force (N)")},
              {.universe = axis, .label = DeliveredPlot::tr("Force in the hand (N)")}};
  const QPen equal(theme::mutedInk(), 1, Qt::DashLine);
  chart.parts.emplace_back(ChartLine{{0, axis.max}, {0, axis.max}, equal});
  chart.legend.push_back({DeliveredPlot::tr("Commanded"), equal});
  const auto numbers = colorNumbers(forces.participants);
  for (std::size_t who = 0; who < forces.participants.size(); ++who) {
    const QColor color = theme::expert(numbers[who]);
    const auto dots = [&color](ChartDots::Shape shape) {
      return ChartLine{{}, {}, Qt::NoPen, {shape, kDelivered, QPen(color, 1.2)}};
    };
    ChartLine least = dots(ChartDots::Shape::kDisc);
    ChartLine felt = dots(ChartDots::Shape::kCircle);
    const auto add = [](ChartLine& line, double commanded_n, const std::optional<double>& force_n) {
      if (force_n) line.x << commanded_n, line.y << *force_n;
    };
    for (const DeliveredForce& one : forces.forces) {
      if (one.participant != who) continue;
      add(least, one.commanded_n, one.least_n);
      add(felt, one.commanded_n, one.felt_n);
    }
    chart.parts.emplace_back(least);
    chart.parts.emplace_back(felt);
    chart.legend.push_back({harmless(text(forces.participants[who])), QPen(color, 2), Qt::NoBrush, true});
  }
  return chart;
}

}  // namespace

DeliveredPlot::DeliveredPlot(QWidget* parent)
    : QWidget(parent),
      chart_(new ChartView(this)),
      summary_(new QLabel(this)),
      head_(makeRow({{summary_, 1}}, kStyleGap)) {
  setMuted(*summary_);
  makeColumn(this, {head_, {chart_, 1}}, theme::kGrid, inset(theme::kGrid));
  setAccessibleName(tr("Delivered against commanded force"));
  setToolTip(tr("Discs: the least force while it was judged. Circles: the force with the friction of the device."));
}

void DeliveredPlot::setForces(const DeliveredForces& forces) {
  summary_->setText(summaryOf(forces));
  const bool some = !forces.forces.empty();
  chart_->setVisible(some);
  if (tool_ != nullptr) tool_->setVisible(some);
  summary_->setAlignment(some ? Qt::AlignLeft | Qt::AlignVCenter : Qt::AlignCenter);
  chart_->setChart(deliveredChart(forces));
}

void DeliveredPlot::addTool(QWidget* tool) {
  tool_ = tool;
  head_->addWidget(tool);
}

// The numbers of the plots of the force lab.

class ForceLab;

/// The words by one method; empty if it gives none.
PlotTable forceTermsTable(const ForceLab& lab, elicitation::ForceTermsFrom from);
PlotTable deliveredTable(const ForceLab& lab);
PlotTable wordIntervalTable(const ForceLab& lab);

namespace {

struct ForceTables {
  Q_DECLARE_TR_FUNCTIONS(ForceTables)
};

PlotTable::Cell cellOf(const std::optional<double>& value) {
  return value ? PlotTable::Cell(*value) : PlotTable::Cell();
}

}  // namespace

PlotTable forceTermsTable(const ForceLab& lab, elicitation::ForceTermsFrom from) {
  PlotTable table = labTable(lab.data(), ForceTables::tr("words of the force, %1").arg(methodName(from)),
                             QStringLiteral("-force-words"), {methodRule(from)});
  for (const ForceMethod& method : lab.votes().methods) {
    if (method.from == from && method.terms) fillTable(table, method.terms->output, method.terms->output.terms);
  }
  return table;
}

PlotTable deliveredTable(const ForceLab& lab) {
  PlotTable table =
      labTable(lab.data(), ForceTables::tr("delivered against commanded force"), QStringLiteral("-delivered-forces"));
  table.columns = {"participant", "commanded_n", "least_n", "felt_n"};
  const DeliveredForces forces = deliveredForces(lab.judgements());
  for (const DeliveredForce& one : forces.forces) {
    table.rows.push_back(
        {forces.participants[one.participant], one.commanded_n, cellOf(one.least_n), cellOf(one.felt_n)});
  }
  return table;
}

PlotTable wordIntervalTable(const ForceLab& lab) {
  PlotTable table = labTable(lab.data(), ForceTables::tr("forces that each participant called by each word"),
                             QStringLiteral("-word-intervals"));
  table.columns = {"person", "word", "left_n", "right_n"};
  const ForceVotes& votes = lab.votes();
  for (const auto& one : votes.intervals)
    table.rows.push_back({one.participant, votes.words.terms[one.word].id, one.left_n, one.right_n});
  return table;
}

namespace {

/// What deserves attention stands on the color of a warning.
class NotableDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
    QStyledItemDelegate::initStyleOption(option, index);
    if (!index.data(kNotableRole).toBool()) return;
    option->backgroundBrush = theme::warningFill();
    option->palette.setColor(QPalette::Text, theme::warningInk());
  }
};

}  // namespace

namespace {

constexpr int kVotesWidth = 520;        // px: all columns of Table 2
constexpr int kNarrowVotesWidth = 384;  // px: all but the reasons
constexpr int kNarrowLab = 1400;        // px: below it the words need the room of the reasons

}  // namespace

ForceLabView::ForceLabView(ForceLab& lab, const SettingsPrice& price, QWidget* parent)
    : LabView(
          QStringLiteral("force"), tr("Force"), [&lab](bool wanted) { lab.setWanted(wanted); }, parent),
      lab_(lab),
      price_(price),
      votes_(new VotesView),
      terms_(new ForceTermsView),
      judgements_(new JudgementView),
      checks_(new Columns<ParticipantChecks>(checkColumns(), this)),
      delivered_(new DeliveredPlot),
      intervals_(new WordIntervalPlot),
      details_(makeTabs()),
      series_(new QComboBox) {
  judgements_->setObjectName(QStringLiteral("judgements"));
  delivered_->setObjectName(QStringLiteral("delivered"));
  intervals_->setObjectName(QStringLiteral("word_intervals"));
  series_->setAccessibleName(tr("Series that votes"));
  series_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  series_->setToolTip(tr("Choose the series that votes for the words of the force."));
  auto* table = new LabCard(tr("Votes for each force (Table 2)"), votes_);
  table->addTool(series_);
  auto* words = new LabCard(tr("Words of the force (Fig. 3e), four ways"), terms_);
  for (const auto from : kForceMethods) {
    terms_->addTool(from, new PlotMenu(
                              terms_->plot(from), [this, from] { return forceTermsTable(lab_, from); }, terms_));
  }
  top_ = makeSplit(Qt::Horizontal, {table, {words, 1}});
  details_->addTab(judgements_, tr("Judgements"));
  auto* checks = new QWidget;
  checks->setObjectName(QStringLiteral("checks"));
  QTableView* const participants = makeLabTable(*checks_, -1, tr("Checks of the judgements"), checks);
  participants->setItemDelegate(new NotableDelegate(participants));
  makeColumn(checks, {participants}, theme::kGrid, inset(theme::kGrid));
  details_->addTab(checks, tr("Checks"));
  details_->addTab(delivered_, tr("Delivered force"));
  details_->addTab(intervals_, tr("Words of each participant"));
  details_->setCornerWidget(new StatisticHelp({Statistic::kWeightedKappa, Statistic::kInterval}));
  delivered_->addTool(new PlotMenu(
      delivered_->chart(), [this] { return deliveredTable(lab_); }, delivered_));
  intervals_->addTool(new PlotMenu(
      intervals_->chart(), [this] { return wordIntervalTable(lab_); }, intervals_));
  auto* below = new Card;
  makeColumn(below, {details_}, theme::kGrid, inset(theme::kGrid, theme::kGrid / 2));
  makeColumn(this, {makeSplit(Qt::Vertical, {{top_, 3}, {below, 2}})});
  divide();

  connect(votes_, &VotesView::forceChosen, judgements_, &JudgementView::showForce);
  connect(terms_, &ForceTermsView::chosen, &lab_, &ForceLab::setMethod);
  connect(judgements_, &JudgementView::correctionAsked, &lab_, &ForceLab::correct);
  connect(judgements_, &JudgementView::judgementChosen, &lab_, &ForceLab::askInfluence);
  connect(&lab_, &ForceLab::influenceChanged, judgements_, [this] { judgements_->tell(lab_.influence()); });
  connect(series_, &QComboBox::activated, this,
          [this] { lab_.setSeries(series_->currentData().toString().toStdString()); });
  auto* refresh = new Refresh(this, [this] { refreshState(); });
  connect(&lab_, &ForceLab::changed, refresh, &Refresh::request);
  connect(&lab_, &ForceLab::effectsChanged, refresh, &Refresh::request);
  connect(&price_, &SettingsPrice::changed, refresh, &Refresh::request);
}

void ForceLabView::showJudgement(const std::string& participant, const std::string& series, double force_n) {
  details_->setCurrentWidget(judgements_);
  judgements_->showJudgement(participant, series, force_n);
}

// The user's own division stays until the lab becomes wide or narrow.
void ForceLabView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  const bool narrow = width() < kNarrowLab;
  if (std::exchange(narrow_, narrow) != narrow) divide();
}

void ForceLabView::divide() {
  const int votes = narrow_ ? kNarrowVotesWidth : kVotesWidth;
  top_->setSizes({votes, std::max(1, width() - votes)});
}

void ForceLabView::refreshState() {
  votes_->setVotes(lab_.votes());
  terms_->setVotes(lab_.votes(), lab_.settings().force_terms, price_.formerTerms(lab_.votes().words.id));
  for (const auto from : kForceMethods) terms_->setEffect(from, lab_.effectOf(from));
  judgements_->setJudgements(lab_.votes().words, lab_.judgements());
  checks_->setRows(lab_.checks());
  delivered_->setForces(deliveredForces(lab_.judgements()));
  intervals_->setIntervals(lab_.votes().words, lab_.votes().intervals, lab_.votes().words.max);
  followSeries();
}

void ForceLabView::followSeries() {
  const QSignalBlocker quiet(series_);
  series_->clear();
  for (const std::string& name : lab_.series()) series_->addItem(seriesText(name), text(name));
  series_->setCurrentIndex(std::max(0, series_->findData(text(lab_.settings().series))));
  series_->setVisible(series_->count() > 1);
}

}  // namespace tactus::workbench
