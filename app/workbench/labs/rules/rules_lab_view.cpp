#include "app/workbench/labs/rules/rules_lab_view.h"

#include <QCoreApplication>
#include <QHeaderView>
#include <QLabel>
#include <QTabWidget>
#include <QTableView>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/refresh.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/buttons.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/labs/data/corrections.h"
#include "app/workbench/labs/frame/lab_card.h"
#include "app/workbench/labs/rules/agreement_rows.h"
#include "app/workbench/labs/rules/grids_view.h"
#include "app/workbench/labs/rules/rules_lab.h"
#include "app/workbench/model/finding_words.h"
#include "app/workbench/plot/term_marks.h"

namespace tactus::workbench {
namespace {

const QString kNothing = QStringLiteral("–");

constexpr int kFromMeanColumn = 3;
constexpr int kWithoutColumn = 4;

std::vector<Column<CellRow>> cellColumns(const RulesLab& lab) {
  using Row = CellRow;
  const auto newtons = [&lab](double force_n) { return quantityText(force_n, lab.grids().output.unit, 3); };
  return {{RulesLabView::tr("Expert"),
           &Row::expert,
           Qt::AlignLeft,
           {},
           {{Qt::DecorationRole, [](const Row& row) { return theme::expert(row.number); }},
            {kOrderRole, [](const Row& row) { return static_cast<int>(row.index); }}}},
          {RulesLabView::tr("Says"),
           &Row::word,
           Qt::AlignLeft,
           {},
           {{Qt::DecorationRole,
             [&lab](const Row& row) {
               const fuzzy::Variable& output = lab.grids().output;
               return row.term ? QVariant(termFill(output, output.terms, *row.term)) : QVariant();
             }},
            {kOrderRole, [](const Row& row) { return row.term ? static_cast<int>(*row.term) : -1; }}}},
          {RulesLabView::tr("Would feel"),
           [newtons](const Row& row) { return row.felt_n ? newtons(*row.felt_n) : kNothing; },
           Qt::AlignRight,
           {},
           {{kOrderRole, [](const Row& row) { return row.felt_n.value_or(-1); }}}},
          {RulesLabView::tr("From the mean"),
           // With its sign, so that more and less are seen at once.
           [newtons](const Row& row) {
             if (!row.from_mean_n) return kNothing;
             return (*row.from_mean_n < 0 ? QStringLiteral("−") : QStringLiteral("+")) +
                    newtons(std::abs(*row.from_mean_n));
           },
           Qt::AlignRight,
           {},
           {{kOrderRole, [](const Row& row) { return row.from_mean_n ? std::abs(*row.from_mean_n) : -1; }}}},
          {RulesLabView::tr("Mean without it"),
           [&lab](const Row& row) {
             if (const auto moved = lab.influenceOf(row.index)) return movedText(*moved);
             return row.term && lab.isComparing() ? QStringLiteral("…") : kNothing;
           },
           Qt::AlignRight,
           RulesLabView::tr(
               "How far the averaged force moves without this rule, at most, and in just-noticeable differences."),
           {{Qt::ToolTipRole,
             [&lab](const Row& row) {
               const auto moved = lab.influenceOf(row.index);
               return moved ? QVariant(influenceText(row.expert, *moved, lab.model())) : QVariant();
             }},
            {kOrderRole,
             [&lab](const Row& row) {
               const auto moved = lab.influenceOf(row.index);
               return moved ? moved->difference.largest_n : -1;
             }}}},
          {RulesLabView::tr("From"), &Row::source, Qt::AlignLeft, {}, {{kOrderRole, &Row::source}}}};
}

std::vector<CellRow> cellRows(const RulesLab& lab) {
  std::vector<CellRow> rows;
  if (!lab.chosen()) return rows;
  const ExpertGrids& grids = lab.grids();
  const elicitation::CellConflict* const conflict = lab.conflictAt(*lab.chosen());
  double sum = 0;
  double weights = 0;
  for (std::size_t e = 0; e < grids.experts.size(); ++e) {
    const AskedCell& cell = grids.at(e, lab.chosen()->row, lab.chosen()->column);
    CellRow row{e, grids.experts[e].number, harmless(grids.experts[e].label), kNothing, cell.word, {}, {}, {}};
    if (cell.word) row.word = labelOf(grids.output.terms[*cell.word]);
    if (!cell.asked) row.word = RulesLabView::tr("not asked");
    if (cell.asked && !cell.word && !cell.without.isEmpty()) row.word = cell.without;
    row.source = cell.given      ? RulesLabView::tr("given directly")
                 : cell.item > 0 ? RulesLabView::tr("item %1").arg(cell.item)
                                 : kNothing;
    if (cell.corrected) row.source += RulesLabView::tr(", corrected");
    if (cell.word && conflict != nullptr && e < conflict->felt_n.size()) {
      row.felt_n = conflict->felt_n[e];
      sum += grids.experts[e].weight * *row.felt_n;
      weights += grids.experts[e].weight;
    }
    rows.push_back(std::move(row));
  }
  for (CellRow& row : rows) {
    if (row.felt_n && weights > 0) row.from_mean_n = *row.felt_n - sum / weights;
  }
  return rows;
}

}  // namespace

QString cellSummary(const RulesLab& lab) {
  if (!lab.chosen()) return {};
  const elicitation::CellConflict* const conflict = lab.conflictAt(*lab.chosen());
  if (conflict == nullptr) return RulesLabView::tr("No expert has a rule here.");
  const fuzzy::Variable& output = lab.grids().output;
  const QString apart = quantityText(conflict->rms_n, output.unit, 3);
  const QString times = numberText(conflict->rms_noticeable, 1);
  QStringList out;
  if (conflict->rms_n == 0) {
    out << RulesLabView::tr("All say the same here.");
  } else if (conflict->rms_noticeable > 1) {
    out << RulesLabView::tr(
               "With each other's word the experts would feel %1 more or less: %2 just-noticeable differences.")
               .arg(apart, times);
  } else {
    out << RulesLabView::tr("With each other's word the experts would feel %1 more or less: not noticeable (%2).")
               .arg(apart, times);
  }
  if (conflict->rms_n > 0) {
    const fuzzy::Term* const middle = fuzzy::findTerm(output.terms, conflict->middle_word);
    const double percent = std::round(conflict->share * 100);
    const QString said =
        percent < 0
            ? RulesLabView::tr("If all said %1, the mean would move by %2, and the disagreement would grow by %3 %.")
            : RulesLabView::tr("If all said %1, the mean would move by %2, and %3 % of the disagreement would vanish.");
    out << said.arg(middle == nullptr ? text(conflict->middle_word) : labelOf(*middle),
                    quantityText(conflict->stake_n, output.unit, 3), numberText(std::abs(percent), 0));
  }
  return out.join(QLatin1Char(' '));
}

namespace {

std::vector<Column<RuleFindingRow>> findingColumns() {
  using Row = RuleFindingRow;
  return withRole<Row>({{RulesLabView::tr("Kind"),
                         &Row::kind,
                         Qt::AlignLeft,
                         {},
                         {{Qt::ForegroundRole, [](const Row&) { return theme::ink(); }}}},
                        {RulesLabView::tr("At stake"), &Row::newtons, Qt::AlignRight},
                        {RulesLabView::tr("Experts"), &Row::who},
                        {RulesLabView::tr("What is found; a click leads to the cell"), &Row::sentence}},
                       Qt::ToolTipRole, &Row::sentence);
}

/// The group with the most newtons first. `unit`: of the force.
std::vector<RuleFindingRow> findingRows(const std::vector<WordedFinding>& all, const std::string& unit) {
  using Kind = elicitation::RuleFinding::Kind;
  const auto newtons = [&](std::size_t i) { return all[i].finding.newtons.value_or(-1); };
  std::map<Kind, std::pair<double, std::size_t>> groups;  // largest newtons and members
  for (std::size_t i = 0; i < all.size(); ++i) {
    auto& [largest, members] = groups.try_emplace(all[i].finding.kind, -1.0, 0U).first->second;
    largest = std::max(largest, newtons(i));
    ++members;
  }
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&](std::size_t i) {
    const Kind kind = all[i].finding.kind;
    return std::tuple(-groups.at(kind).first, kind, -newtons(i));
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  std::vector<RuleFindingRow> rows;
  for (const std::size_t i : order) {
    const elicitation::RuleFinding& finding = all[i].finding;
    const bool first = rows.empty() || all[rows.back().index].finding.kind != finding.kind;
    RuleFindingRow row{i, {}, kNothing, all[i].who, all[i].sentence};
    if (first) row.kind = QStringLiteral("%1 (%2)").arg(kindText(finding.kind)).arg(groups.at(finding.kind).second);
    if (finding.newtons) {
      row.newtons = (finding.at_least ? QStringLiteral("≥ ") : QString()) + quantityText(*finding.newtons, unit, 3);
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

constexpr int kReadAtOnce = 24;  // experts
constexpr int kExpertRow = 22;   // px: four experts are seen at once in a window of 720 px

// How far the experts are apart as a whole, for the heading.
QString spreadText(const RulesLab& lab) {
  const elicitation::ConflictMap* const conflicts = lab.conflicts();
  if (conflicts == nullptr) return {};
  int noticeable = 0;
  for (const auto& cell : conflicts->cells) noticeable += cell.rms_noticeable > 1 ? 1 : 0;
  const std::string& unit = lab.grids().output.unit;
  return RulesLabView::tr("%n cell(s) apart by more than one just-noticeable difference", nullptr, noticeable) +
         QStringLiteral(" · ") +
         RulesLabView::tr("between the experts %1 (SD), at most %2")
             .arg(quantityText(conflicts->between_n, unit, 3), quantityText(conflicts->largest_spread_n, unit, 3));
}

}  // namespace

RulesLabView::RulesLabView(RulesLab& lab, QWidget* parent)
    : LabView(
          QStringLiteral("rules"), tr("Rules"), [&lab](bool wanted) { lab.setWanted(wanted); }, parent),
      lab_(lab),
      grids_(new GridsView(lab)),
      spread_(new QLabel),
      cell_(new Columns<CellRow>(cellColumns(lab), this)),
      cell_title_(new QLabel),
      cell_summary_(new WrappedLabel),
      findings_(new Columns<RuleFindingRow>(findingColumns(), this)),
      findings_note_(new ElidedLabel),
      agreement_(new Columns<AgreementRow>(agreementColumns(), this)),
      usability_(new Columns<UsabilityRow>(usabilityColumns(), this)),
      usability_note_(new ElidedLabel),
      details_(makeTabs()) {
  setMuted(*spread_);
  auto* grids = new LabCard(tr("What each expert says, and what it costs"), grids_, tr("Answers"));
  grids->addTool(spread_);
  details_->addTab(makeCell(), tr("Chosen cell"));
  details_->addTab(makeFindings(), tr("Findings"));
  auto* agreement = makeLabTable(*agreement_, 0, tr("Measures of agreement"), nullptr);
  agreement->setObjectName(QStringLiteral("agreement"));
  details_->addTab(agreement, tr("Agreement"));
  details_->setCornerWidget(new StatisticHelp({Statistic::kAlpha, Statistic::kInterval, Statistic::kConsensus,
                                               Statistic::kKendallW, Statistic::kKappa, Statistic::kNoticeable}));
  details_->addTab(makeUsability(), tr("Usability (Table 3)"));
  auto* below = new Card;
  makeColumn(below, {details_}, theme::kGrid, inset(theme::kGrid, theme::kGrid / 2));
  makeColumn(this, {makeSplit(Qt::Vertical, {{grids, 5}, {below, 3}})});

  auto* refresh = new Refresh(this, [this] { refreshState(); });
  connect(&lab_, &RulesLab::changed, refresh, &Refresh::request);
  connect(&lab_, &RulesLab::chosenChanged, this, &RulesLabView::followCell);
  connect(&lab_, &RulesLab::influencesChanged, cell_, [this] { cell_->updateColumn(kWithoutColumn); });
  followCell();
}

QWidget* RulesLabView::makeCell() {
  auto* page = new QWidget;
  page->setObjectName(QStringLiteral("cell"));
  cell_title_->setFont(theme::headingFont());
  cell_title_->setTextFormat(Qt::PlainText);
  cell_summary_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  experts_ = makeSortedLabTable(*cell_, cell_->columnCount() - 1, tr("Experts in the chosen cell"), page);
  experts_->verticalHeader()->setDefaultSectionSize(kExpertRow);
  makeRow(page, {{makeColumn({cell_title_, {cell_summary_, 1}}), 1}, {experts_, 2}}, 2 * theme::kGrid,
          {theme::kGrid, theme::kGrid / 2, theme::kGrid, 0});
  return page;
}

QWidget* RulesLabView::makeFindings() {
  auto* page = new QWidget;
  page->setObjectName(QStringLiteral("findings"));
  setMuted(*findings_note_);
  auto* const table = makeLabTable(*findings_, findings_->columnCount() - 1, tr("Findings about the rules"), page);
  table->verticalHeader()->setDefaultSectionSize(kExpertRow);
  connect(table, &QTableView::clicked, this, [this](const QModelIndex& index) {
    const std::size_t finding = findings_->row(index.row()).index;
    // The row may be too narrow for the whole sentence.
    const QString sentence = (*lab_.findings())[finding].sentence;
    findings_note_->setFullText(lab_.chooseFinding(finding) ? sentence : tr("%1 (in no single cell)").arg(sentence));
  });
  makeColumn(page, {{table, 1}, findings_note_}, theme::kGrid / 2, {0, theme::kGrid, 0, 0});
  return page;
}

QWidget* RulesLabView::makeUsability() {
  auto* page = new QWidget;
  page->setObjectName(QStringLiteral("usability"));
  setMuted(*usability_note_);
  auto* const table = makeLabTable(*usability_, 0, tr("Usability scale"), page);
  table->verticalHeader()->setDefaultSectionSize(kExpertRow);
  makeColumn(page, {{table, 1}, usability_note_}, theme::kGrid / 2, {0, theme::kGrid, 0, 0});
  return page;
}

void RulesLabView::refreshState() {
  grids_->refreshState();
  spread_->setText(spreadText(lab_));
  const auto* const findings = lab_.findings();
  findings_->setRows(findings == nullptr ? std::vector<RuleFindingRow>()
                                         : findingRows(*findings, lab_.grids().output.unit));
  findings_note_->setFullText(findings == nullptr ? tr("Looking at the rules…")
                              : findings->empty() ? tr("Nothing is odd in the rules.")
                                                  : QString());
  agreement_->setRows(lab_.agreement());
  usability_->setRows(lab_.usability());
  const auto& rows = lab_.usability();
  const bool answered = std::any_of(rows.begin(), rows.end(), [](const UsabilityRow& row) { return row.here.n > 0; });
  usability_note_->setFullText(
      (answered ? QString() : tr("This study has no usability forms yet. ")) +
      tr("Published: nine clinical teachers (Table 3); no nine answers give its third line as printed."));
  followCell();
}

void RulesLabView::followCell() {
  const int few = cell_->rowCount();
  cell_->setRows(cellRows(lab_));
  // Of many experts those far from the mean are worth reading first.
  if (few <= kReadAtOnce && cell_->rowCount() > kReadAtOnce) {
    experts_->sortByColumn(kFromMeanColumn, Qt::DescendingOrder);
  }
  cell_title_->setText(lab_.chosen() ? lab_.textOf(*lab_.chosen()) : tr("No cell is chosen"));
  cell_summary_->setText(lab_.chosen()
                             ? cellSummary(lab_)
                             : tr("Click a cell of the grids. A double click on an expert's word corrects it; "
                                  "the old one stays in the study."));
}

}  // namespace tactus::workbench
