#include "app/workbench/labs/rules/rules_lab_view.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QSortFilterProxyModel>
#include <QSplitter>
#include <QTabBar>
#include <QTabWidget>
#include <QTableView>
#include <QVBoxLayout>
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
#include "app/workbench/plot/term_colors.h"

namespace tactus::workbench {
namespace {

const QString kNothing = QStringLiteral("–");

// With its sign, so that more and less are seen at once.
QString signedText(double force_n, const std::string& unit) {
  const QString number = quantityText(std::abs(force_n), unit, 3);
  return (force_n < 0 ? QStringLiteral("−") : QStringLiteral("+")) + number;
}

}  // namespace

CellTable::CellTable(const RulesLab& lab, QObject* parent)
    : LabTableModel({{tr("Expert")},
                     {tr("Says")},
                     {tr("Would feel"), Qt::AlignRight},
                     {tr("From the mean"), Qt::AlignRight},
                     {tr("Mean without it"), Qt::AlignRight,
                      tr("How far the averaged force moves without this rule, at most, and in just-noticeable "
                         "differences.")},
                     {tr("From")}},
                    parent),
      lab_(lab) {}

void CellTable::follow() {
  beginResetModel();
  rows_.clear();
  mean_n_.reset();
  const ExpertGrids& grids = lab_.grids();
  if (lab_.chosen()) {
    const GridPlace place = *lab_.chosen();
    const elicitation::CellConflict* const conflict = lab_.conflictAt(place);
    double sum = 0;
    double weights = 0;
    for (std::size_t e = 0; e < grids.experts.size(); ++e) {
      const AskedCell& cell = grids.at(e, place.row, place.column);
      Row row{harmless(grids.experts[e].label), grids.experts[e].number, kNothing, cell.word, {}, {}};
      if (cell.word) row.word = labelOf(grids.output.terms[*cell.word]);
      if (!cell.asked) row.word = tr("not asked");
      if (cell.asked && !cell.word && !cell.without.isEmpty()) row.word = cell.without;
      row.source = cell.given ? tr("given directly") : cell.item > 0 ? tr("item %1").arg(cell.item) : kNothing;
      if (cell.corrected) row.source += tr(", corrected");
      if (cell.word && conflict != nullptr && e < conflict->felt_n.size()) {
        row.felt_n = conflict->felt_n[e];
        sum += grids.experts[e].weight * *row.felt_n;
        weights += grids.experts[e].weight;
      }
      rows_.push_back(row);
    }
    if (weights > 0) mean_n_ = sum / weights;
  }
  endResetModel();
}

void CellTable::followInfluences() {
  if (!rows_.empty()) emit dataChanged(index(0, kWithout), index(rows() - 1, kWithout));
}

int CellTable::rows() const { return static_cast<int>(rows_.size()); }

QString CellTable::withoutText(std::size_t row) const {
  const auto moved = lab_.influenceOf(row);
  if (!moved) return rows_[row].term && lab_.isComparing() ? QStringLiteral("…") : kNothing;
  return movedText(*moved);
}

QVariant CellTable::orderOf(std::size_t row, int column) const {
  const Row& at = rows_[row];
  switch (column) {
    case kWord: return at.term ? static_cast<int>(*at.term) : -1;
    case kFelt: return at.felt_n.value_or(-1);
    case kFromMean: return at.felt_n && mean_n_ ? std::abs(*at.felt_n - *mean_n_) : -1;
    case kWithout: {
      const auto moved = lab_.influenceOf(row);
      return moved ? moved->difference.largest_n : -1;
    }
    case kSource: return at.source;
    default: return static_cast<int>(row);
  }
}

QVariant CellTable::cell(int row, int column, int role) const {
  const auto expert = static_cast<std::size_t>(row);
  const Row& at = rows_[expert];
  const std::string& unit = lab_.grids().output.unit;
  if (role == kOrderRole) return orderOf(expert, column);
  if (role == Qt::DecorationRole && column == kExpert) return theme::expert(at.number);
  if (role == Qt::DecorationRole && column == kWord && at.term) {
    return termFill(lab_.grids().output, lab_.grids().output.terms, *at.term);
  }
  if (role == Qt::ToolTipRole && column == kWithout) {
    const auto moved = lab_.influenceOf(expert);
    return moved ? QVariant(influenceText(at.expert, *moved, lab_.model())) : QVariant();
  }
  if (role != Qt::DisplayRole) return {};
  switch (column) {
    case kExpert: return at.expert;
    case kWord: return at.word;
    case kFelt: return at.felt_n ? quantityText(*at.felt_n, unit, 3) : kNothing;
    case kFromMean: return at.felt_n && mean_n_ ? signedText(*at.felt_n - *mean_n_, unit) : kNothing;
    case kWithout: return withoutText(expert);
    default: return at.source;
  }
}

QString cellSummary(const RulesLab& lab) {
  if (!lab.chosen()) return {};
  const elicitation::CellConflict* const conflict = lab.conflictAt(*lab.chosen());
  if (conflict == nullptr) return CellTable::tr("No expert has a rule here.");
  const fuzzy::Variable& output = lab.grids().output;
  const QString apart = quantityText(conflict->rms_n, output.unit, 3);
  const QString times = numberText(conflict->rms_noticeable, 1);
  QStringList out;
  if (conflict->rms_n == 0) {
    out << CellTable::tr("All say the same here.");
  } else if (conflict->rms_noticeable > 1) {
    out << CellTable::tr(
               "With each other's word the experts would feel %1 more or less: %2 just-noticeable differences.")
               .arg(apart, times);
  } else {
    out << CellTable::tr("With each other's word the experts would feel %1 more or less: not noticeable (%2).")
               .arg(apart, times);
  }
  if (conflict->rms_n > 0) {
    const fuzzy::Term* const middle = fuzzy::findTerm(output.terms, conflict->middle_word);
    const double percent = std::round(conflict->share * 100);
    const QString said =
        percent < 0
            ? CellTable::tr("If all said %1, the mean would move by %2, and the disagreement would grow by %3 %.")
            : CellTable::tr("If all said %1, the mean would move by %2, and %3 % of the disagreement would vanish.");
    out << said.arg(middle == nullptr ? text(conflict->middle_word) : labelOf(*middle),
                    quantityText(conflict->stake_n, output.unit, 3), numberText(std::abs(percent), 0));
  }
  return out.join(QLatin1Char(' '));
}

namespace {

using Kind = elicitation::RuleFinding::Kind;

}  // namespace

FindingTable::FindingTable(QObject* parent)
    : LabTableModel({{tr("Kind")},
                     {tr("At stake"), Qt::AlignRight},
                     {tr("Experts")},
                     {tr("What is found; a click leads to the cell")}},
                    parent) {}

void FindingTable::setFindings(const std::vector<WordedFinding>& findings, const std::string& unit) {
  beginResetModel();
  findings_ = findings;
  unit_ = unit;
  const auto newtons = [this](std::size_t i) { return findings_[i].finding.newtons.value_or(-1); };
  std::map<Kind, std::pair<double, std::size_t>> groups;  // largest newtons and members
  for (std::size_t i = 0; i < findings_.size(); ++i) {
    auto& [largest, members] = groups.try_emplace(findings_[i].finding.kind, -1.0, 0U).first->second;
    largest = std::max(largest, newtons(i));
    ++members;
  }
  std::vector<std::size_t> order(findings_.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&](std::size_t i) {
    const Kind kind = findings_[i].finding.kind;
    return std::tuple(-groups.at(kind).first, kind, -newtons(i));
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  rows_.clear();
  for (const std::size_t i : order) {
    const bool first = rows_.empty() || findings_[rows_.back().finding].finding.kind != findings_[i].finding.kind;
    rows_.push_back({i, first ? groups.at(findings_[i].finding.kind).second : 0});
  }
  endResetModel();
}

int FindingTable::rows() const { return static_cast<int>(rows_.size()); }

QVariant FindingTable::cell(int row, int column, int role) const {
  const Row& at = rows_[static_cast<std::size_t>(row)];
  const WordedFinding& worded = findings_[at.finding];
  const elicitation::RuleFinding& finding = worded.finding;
  if (role == Qt::ToolTipRole) return worded.sentence;
  if (role == Qt::ForegroundRole && column == kKind) return theme::ink();
  if (role != Qt::DisplayRole) return {};
  switch (column) {
    case kKind: return at.group == 0 ? QString() : QStringLiteral("%1 (%2)").arg(kindText(finding.kind)).arg(at.group);
    case kNewtons:
      if (!finding.newtons) return QStringLiteral("–");
      return (finding.at_least ? QStringLiteral("≥ ") : QString()) + quantityText(*finding.newtons, unit_, 3);
    case kExperts: return worded.who;
    default: return worded.sentence;
  }
}

namespace {

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
    : QWidget(parent),
      lab_(lab),
      grids_(new GridsView(lab)),
      spread_(new QLabel),
      cell_(new CellTable(lab, this)),
      cell_title_(new QLabel),
      cell_summary_(new WrappedLabel),
      findings_(new FindingTable(this)),
      findings_note_(new ElidedLabel),
      agreement_(new AgreementTable(this)),
      usability_(new UsabilityTable(this)),
      usability_note_(new ElidedLabel),
      details_(new QTabWidget) {
  setObjectName(QStringLiteral("rules"));
  setWindowTitle(tr("Rules"));
  setMuted(*spread_);
  auto* grids = new LabCard(tr("What each expert says, and what it costs"), grids_);
  grids->addTool(spread_);
  new TabLook(*details_->tabBar());
  details_->setDocumentMode(true);
  details_->addTab(makeCell(), tr("Chosen cell"));
  details_->addTab(makeFindings(), tr("Findings"));
  auto* agreement = makeLabTable(*agreement_, AgreementTable::kRatings, tr("Measures of agreement"), nullptr);
  agreement->setObjectName(QStringLiteral("agreement"));
  details_->addTab(agreement, tr("Agreement"));
  details_->setCornerWidget(new StatisticHelp({Statistic::kAlpha, Statistic::kInterval, Statistic::kConsensus,
                                               Statistic::kKendallW, Statistic::kKappa, Statistic::kNoticeable}));
  details_->addTab(makeUsability(), tr("Usability (Table 3)"));
  auto* below = new Card;
  auto* inside = new QVBoxLayout(below);
  inside->setContentsMargins(theme::kGrid, theme::kGrid / 2, theme::kGrid, theme::kGrid / 2);
  inside->addWidget(details_);
  auto* all = new QSplitter(Qt::Vertical);
  all->setChildrenCollapsible(false);
  all->setHandleWidth(theme::kGrid);
  all->addWidget(grids);
  all->addWidget(below);
  all->setStretchFactor(0, 5);
  all->setStretchFactor(1, 3);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(all);

  auto* refresh = new Refresh(this, [this] { follow(); });
  connect(&lab_, &RulesLab::changed, refresh, &Refresh::request);
  connect(&lab_, &RulesLab::chosenChanged, this, &RulesLabView::followCell);
  connect(&lab_, &RulesLab::influencesChanged, cell_, &CellTable::followInfluences);
  followCell();
}

QWidget* RulesLabView::makeCell() {
  auto* page = new QWidget;
  page->setObjectName(QStringLiteral("cell"));
  cell_title_->setFont(theme::headingFont());
  cell_title_->setTextFormat(Qt::PlainText);
  cell_summary_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  auto* words = new QVBoxLayout;
  words->setSpacing(theme::kGrid);
  words->addWidget(cell_title_);
  words->addWidget(cell_summary_, 1);
  auto* row = new QHBoxLayout(page);
  row->setContentsMargins(theme::kGrid, theme::kGrid / 2, theme::kGrid, 0);
  row->setSpacing(2 * theme::kGrid);
  row->addLayout(words, 1);
  auto* const sorted = new QSortFilterProxyModel(this);
  sorted->setSourceModel(cell_);
  sorted->setSortRole(CellTable::kOrderRole);
  experts_ = makeLabTable(*sorted, CellTable::kSource, tr("Experts in the chosen cell"), page);
  experts_->verticalHeader()->setDefaultSectionSize(kExpertRow);
  sortByHeads(*experts_);
  row->addWidget(experts_, 2);
  return page;
}

QWidget* RulesLabView::makeFindings() {
  auto* page = new QWidget;
  page->setObjectName(QStringLiteral("findings"));
  setMuted(*findings_note_);
  auto* const table = makeLabTable(*findings_, FindingTable::kSentence, tr("Findings about the rules"), page);
  table->verticalHeader()->setDefaultSectionSize(kExpertRow);
  connect(table, &QTableView::clicked, this, [this](const QModelIndex& index) {
    const std::size_t finding = findings_->findingAt(index.row());
    // The row may be too narrow for the whole sentence.
    const QString sentence = (*lab_.findings())[finding].sentence;
    findings_note_->setFullText(lab_.chooseFinding(finding) ? sentence : tr("%1 (in no single cell)").arg(sentence));
  });
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, theme::kGrid, 0, 0);
  column->setSpacing(theme::kGrid / 2);
  column->addWidget(table, 1);
  column->addWidget(findings_note_);
  return page;
}

QWidget* RulesLabView::makeUsability() {
  auto* page = new QWidget;
  page->setObjectName(QStringLiteral("usability"));
  setMuted(*usability_note_);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, theme::kGrid, 0, 0);
  column->setSpacing(theme::kGrid / 2);
  auto* const table = makeLabTable(*usability_, UsabilityTable::kStatement, tr("Usability scale"), page);
  table->verticalHeader()->setDefaultSectionSize(kExpertRow);
  column->addWidget(table, 1);
  column->addWidget(usability_note_);
  return page;
}

void RulesLabView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  lab_.setWanted(true);
}

void RulesLabView::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  lab_.setWanted(false);
}

void RulesLabView::follow() {
  grids_->follow();
  spread_->setText(spreadText(lab_));
  const auto* const findings = lab_.findings();
  findings_->setFindings(findings == nullptr ? std::vector<WordedFinding>() : *findings, lab_.grids().output.unit);
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
  cell_->follow();
  // Of many experts those far from the mean are worth reading first.
  if (few <= kReadAtOnce && cell_->rowCount() > kReadAtOnce) {
    experts_->sortByColumn(CellTable::kFromMean, Qt::DescendingOrder);
  }
  cell_title_->setText(lab_.chosen() ? lab_.textOf(*lab_.chosen()) : tr("No cell is chosen"));
  cell_summary_->setText(lab_.chosen()
                             ? cellSummary(lab_)
                             : tr("Click a cell of the grids. A double click on an expert's word corrects it; "
                                  "the old one stays in the study."));
}

}  // namespace tactus::workbench
