#include "app/workbench/labs/origins/origin_window.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QHideEvent>
#include <QLabel>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QTableView>

#include "app/workbench/base/theme.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/labs/data/corrections.h"
#include "app/workbench/labs/frame/lab_card.h"
#include "app/workbench/labs/origins/origin_finder.h"

namespace tactus::workbench {
namespace {

constexpr QSize kWindow(620, 560);  // px
constexpr int kRow = 26;
constexpr int kPreviewHeight = 150;

QLabel* makeWords(QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

constexpr int kMovesColumn = 3;

std::vector<Column<OriginRow>> originColumns(const OriginFinder& finder) {
  using Row = OriginRow;
  std::vector<Column<Row>> out = {
      {OriginWindow::tr("Participant"), [](const Row& row) { return row.record.participant; }},
      {OriginWindow::tr("Record"),
       [](const Row& row) { return row.record.what; },
       Qt::AlignLeft,
       {},
       {{kOrderRole, [](const Row& row) { return static_cast<int>(row.index); }}}},
      {OriginWindow::tr("Says"), [](const Row& row) { return row.record.says; }},
      {OriginWindow::tr("Moves the force"),
       [&finder](const Row& row) {
         const OriginFinder::Influence found = finder.influence(row.index);
         if (!found) return row.index < OriginFinder::kMostUnasked ? QStringLiteral("…") : QStringLiteral("–");
         return *found ? movedText(**found) : OriginWindow::tr("no model");
       },
       Qt::AlignRight,
       OriginWindow::tr(
           "How far the averaged force moves without this record, at most, and in just-noticeable differences."),
       {{Qt::ToolTipRole, [&finder](const Row& row) { return finder.influenceSentence(row.index); }},
        {kOrderRole, [&finder](const Row& row) {
           const OriginFinder::Influence found = finder.influence(row.index);
           return found && *found ? (*found)->difference.largest_n : -1.0;
         }}}}};
  return withRole<Row>(std::move(out), kOrderRole);
}

std::vector<OriginRow> originRows(const Origin* origin) {
  std::vector<OriginRow> rows;
  for (std::size_t i = 0; origin != nullptr && i < origin->records.size(); ++i) rows.push_back({i, origin->records[i]});
  return rows;
}

}  // namespace

OriginWindow::OriginWindow(OriginFinder& finder, QWidget* parent)
    : QDialog(parent, Qt::Tool),
      finder_(finder),
      title_(makeWords(this)),
      notes_(makeWords(this)),
      table_(new Columns<OriginRow>(originColumns(finder), this)),
      view_(makeSortedLabTable(*table_, 1, tr("Records behind the number"), this)),
      moved_(makeWords(this)),
      lead_(new QPushButton(tr("Show in the lab"), this)),
      participant_(new QPushButton(this)) {
  setWindowTitle(tr("Where it comes from"));
  resize(kWindow);
  title_->setFont(theme::headingFont());
  setMuted(*notes_);
  setMuted(*moved_);
  view_->verticalHeader()->setDefaultSectionSize(kRow);
  view_->sortByColumn(kMovesColumn, Qt::DescendingOrder);
  moved_->setFixedHeight(3 * QFontMetrics(moved_->font()).lineSpacing() + theme::kGrid / 2);
  moved_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  buttons->addButton(lead_, QDialogButtonBox::ActionRole);
  buttons->addButton(participant_, QDialogButtonBox::ActionRole);
  makeColumn(this, {title_, notes_, {view_, 1}, moved_, buttons}, theme::kGrid, inset(2 * theme::kGrid));
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
  connect(lead_, &QPushButton::clicked, this, &OriginWindow::lead);
  connect(participant_, &QPushButton::clicked, this, [this] {
    if (const OriginRecord* const record = chosen()) emit participantAsked(*record);
  });
  connect(view_, &QTableView::clicked, this, &OriginWindow::lead);
  connect(view_, &QTableView::activated, this, &OriginWindow::lead);
  connect(view_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, &OriginWindow::followChosen);
  connect(&finder_, &OriginFinder::changed, this, [this] {
    table_->setRows(originRows(finder_.origin()));
    refreshState();
  });
  connect(&finder_, &OriginFinder::influenceChanged, this, [this](std::size_t row) {
    table_->updateColumn(kMovesColumn);
    if (static_cast<int>(row) == chosenRow()) followChosen();
  });
  refreshState();
}

void OriginWindow::setPreview(QWidget* preview, std::function<bool(const OriginRecord&)> shows) {
  preview_ = preview;
  shows_ = std::move(shows);
  preview_->setParent(this);
  preview_->setFixedHeight(kPreviewHeight);
  auto* const column = static_cast<QVBoxLayout*>(layout());
  column->insertWidget(column->indexOf(moved_), preview_);
  followChosen();
}

int OriginWindow::chosenRow() const {
  const QModelIndex at = qobject_cast<QSortFilterProxyModel*>(view_->model())->mapToSource(view_->currentIndex());
  return at.isValid() ? at.row() : -1;
}

const OriginRecord* OriginWindow::chosen() const {
  const int row = chosenRow();
  if (finder_.origin() == nullptr || row < 0) return nullptr;
  return &finder_.origin()->records[static_cast<std::size_t>(row)];
}

void OriginWindow::lead() {
  if (const OriginRecord* const record = chosen()) emit recordChosen(*record);
}

void OriginWindow::refreshState() {
  const Origin* const origin = finder_.origin();
  const QString failure = finder_.failure();
  if (origin != nullptr) {
    title_->setText(origin->title);
    notes_->setText(origin->notes.join(QLatin1Char('\n')));
  } else {
    title_->setText(failure.isEmpty() ? tr("Building the model of the study…") : tr("There is nothing to show"));
    notes_->setText(failure);
  }
  notes_->setVisible(!notes_->text().isEmpty());
  const bool some = origin != nullptr && !origin->records.empty();
  for (QWidget* const part :
       {static_cast<QWidget*>(view_), static_cast<QWidget*>(moved_), static_cast<QWidget*>(lead_)})
    part->setVisible(some || (origin == nullptr && failure.isEmpty()));
  if (view_->model()->rowCount() > 0 && chosenRow() < 0) view_->selectRow(0);
  followChosen();
}

void OriginWindow::followChosen() {
  const OriginRecord* const record = chosen();
  lead_->setEnabled(record != nullptr);
  participant_->setVisible(record != nullptr);
  if (record != nullptr) participant_->setText(tr("Show the record of %1").arg(record->participant));
  if (preview_ != nullptr) preview_->setVisible(record != nullptr && shows_(*record));
  if (record == nullptr) {
    moved_->clear();
    return;
  }
  const auto row = static_cast<std::size_t>(chosenRow());
  finder_.askInfluence(row);
  const QString sentence = finder_.influenceSentence(row);
  moved_->setText(sentence.isEmpty() ? tr("Comparing the force with and without it…") : sentence);
}

// At the right of the window below, where it hides least of the labs.
void OriginWindow::showEvent(QShowEvent* event) {
  if (const QWidget* const below = parentWidget(); below != nullptr && !placed_) {
    const QRect place = below->window()->frameGeometry();
    move(place.right() - width() - 2 * theme::kGrid, place.bottom() - height() - 6 * theme::kGrid);
    placed_ = true;
  }
  QDialog::showEvent(event);
  refreshState();
}

void OriginWindow::hideEvent(QHideEvent* event) {
  QDialog::hideEvent(event);
  if (!event->spontaneous()) finder_.close();
}

}  // namespace tactus::workbench
