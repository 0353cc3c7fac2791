#include "app/workbench/labs/rules/rules_lab_view.h"

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

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/refresh.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/buttons.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/labs/frame/lab_card.h"
#include "app/workbench/labs/frame/lab_table.h"
#include "app/workbench/labs/rules/cell_table.h"
#include "app/workbench/labs/rules/finding_table.h"
#include "app/workbench/labs/rules/grids_view.h"
#include "app/workbench/labs/rules/measure_tables.h"
#include "app/workbench/labs/rules/rules_lab.h"

namespace tactus::workbench {
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
