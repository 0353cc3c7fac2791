#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QToolButton>
#include <algorithm>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/refresh.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/cards.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/kit/quiet_table.h"
#include "app/workbench/tune/rules/rule_controller.h"
#include "app/workbench/tune/rules/rule_editor.h"
#include "app/workbench/tune/rules/rule_list_model.h"
#include "app/workbench/tune/rules/rule_rows.h"

namespace tactus::workbench {
namespace {

using Only = RuleListFilter::Only;

constexpr int kMostRuleLines = 4;   // of the conditions in one row
constexpr int kNarrowestWord = 40;  // px
constexpr int kWidestWord = 140;    // px

QToolButton* makeButton(const QString& text, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setText(text);
  return button;
}

}  // namespace

RuleListPane::RuleListPane(RuleController& rules, QWidget* parent)
    : QWidget(parent),
      rules_(rules),
      list_(new RuleListModel(rules, this)),
      sieve_(new RuleListFilter(*list_, this)),
      text_(new QLineEdit(this)),
      only_(new QComboBox(this)),
      count_(new QLabel(this)),
      table_(makeQuietTable(*sieve_, tr("Rules"), this)),
      add_(makeButton(tr("Add rule…"), this)),
      edit_(makeButton(tr("Edit…"), this)),
      enable_(makeButton(tr("Enable"), this)),
      disable_(makeButton(tr("Disable"), this)),
      remove_(makeButton(tr("Remove"), this)),
      go_(makeButton(tr("Go where it acts"), this)),
      flash_(new Flash(table_->viewport())),
      form_(new RuleForm(rules, this)),
      refresh_(new Refresh(this, [this] { refresh(); })) {
  setFocusProxy(table_);
  text_->setPlaceholderText(tr("Filter: words of a rule, or if … and … then …"));
  text_->setClearButtonEnabled(true);
  text_->setAccessibleName(tr("Filter by words of the rule"));
  only_->addItem(tr("All rules"), static_cast<int>(Only::kAll));
  only_->addItem(tr("Acting here"), static_cast<int>(Only::kActing));
  only_->addItem(tr("Disabled"), static_cast<int>(Only::kDisabled));
  only_->addItem(tr("Conflicts"), static_cast<int>(Only::kConflicts));
  only_->setAccessibleName(tr("Which rules are listed"));
  count_->setFont(theme::smallFont());
  count_->setForegroundRole(QPalette::PlaceholderText);
  buildTable();
  buildPlace();
  connectAll();
  refresh_->request();
}

void RuleListPane::buildTable() {
  table_->setItemDelegate(new RuleListDelegate(rules_, *flash_, table_));
  table_->setFont(theme::smallFont());
  table_->setAlternatingRowColors(true);
  table_->setWordWrap(true);
  table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  table_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  table_->setToolTip(
      tr("Select several rules with Ctrl or Shift: an edit changes all of them · 1–9 answer · Ctrl+C and "
         "Ctrl+V copy and paste them as text"));
  table_->setContextMenuPolicy(Qt::CustomContextMenu);
  table_->setSortingEnabled(true);
  table_->sortByColumn(RuleListModel::kNumber, Qt::AscendingOrder);
  QHeaderView* head = table_->horizontalHeader();
  head->setSectionsClickable(true);
  head->setSectionResizeMode(QHeaderView::Fixed);
  head->setSectionResizeMode(RuleListModel::kConditions, QHeaderView::Stretch);
  head->setMinimumSectionSize(24);
  const QFontMetrics metrics(table_->font());
  const int margin = 2 * theme::kGrid;
  table_->setColumnWidth(RuleListModel::kNumber, metrics.horizontalAdvance(tr("No.")) + margin + 8);
  table_->setColumnWidth(RuleListModel::kWeight, metrics.horizontalAdvance(tr("Weight")) + margin + 8);
  table_->setColumnWidth(RuleListModel::kEnabled, metrics.horizontalAdvance(tr("On")) + margin + 8);
  table_->setColumnWidth(RuleListModel::kStrength, metrics.horizontalAdvance(tr("0.000")) + margin + 8);
}

void RuleListPane::buildPlace() {
  makeColumn(this,
             {makeRow({{text_, 1}, only_, count_}),
              {table_, 1},
              makeRow({add_, edit_, go_, spring(1), enable_, disable_, remove_}, 4),
              form_},
             6);
  new RowStop({text_, only_}, this);
  new RowStop({add_, edit_, go_, enable_, disable_, remove_}, this);
  setFocusProxy(table_);
}

void RuleListPane::connectAll() {
  connect(&rules_, &RuleController::rulesChanged, this, [this] {
    stale_ = true;
    refresh_->request();
  });
  connect(&rules_, &RuleController::expertChanged, form_, &QWidget::hide);
  connect(&rules_, &RuleController::hereChanged, refresh_, &Refresh::request);
  connect(text_, &QLineEdit::textChanged, this, [this](const QString& typed) {
    sieve_->setText(typed);
    showCount();
  });
  connect(only_, &QComboBox::currentIndexChanged, this, [this](int index) {
    sieve_->setOnly(static_cast<Only>(only_->itemData(index).toInt()));
    showCount();
  });
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
    showActions();
    // Rows that come and go are not the user's choice, nor is a list that is a moment older than the rules.
    if (!showing_ && !stale_) rules_.selection().selectRules(chosen());
  });
  connect(&rules_.selection(), &Selection::rulesChanged, refresh_, &Refresh::request);
  connect(&rules_.selection(), &Selection::rulesPointed, this, &RuleListPane::showPointed);
  connect(go_, &QToolButton::clicked, &rules_, &RuleController::goWhereItActs);
  connect(table_, &QTableView::customContextMenuRequested, this, &RuleListPane::openMenu);
  connect(table_, &QTableView::doubleClicked, this, [this](const QModelIndex& index) {
    if (index.column() == RuleListModel::kNumber || index.column() == RuleListModel::kConditions) edit();
  });
  table_->installEventFilter(this);
  table_->viewport()->installEventFilter(this);
  connect(add_, &QToolButton::clicked, form_, &RuleForm::openNew);
  connect(edit_, &QToolButton::clicked, this, &RuleListPane::edit);
  connect(enable_, &QToolButton::clicked, this, [this] { enable(true); });
  connect(disable_, &QToolButton::clicked, this, [this] { enable(false); });
  connect(remove_, &QToolButton::clicked, this, &RuleListPane::remove);
  connect(form_, &RuleForm::done, this, &RuleListPane::showRule);
}

bool RuleListPane::eventFilter(QObject* watched, QEvent* event) {
  if (watched == table_->viewport() && event->type() == QEvent::Resize) fitRows();
  // Before the menus take the keys of copy and paste.
  if (watched == table_ && event->type() == QEvent::ShortcutOverride) {
    const auto* pressed = static_cast<QKeyEvent*>(event);
    if (pressed->matches(QKeySequence::Copy) || pressed->matches(QKeySequence::Paste)) event->accept();
  }
  if (watched == table_ && event->type() == QEvent::KeyPress) {
    if (answerWithKey(static_cast<QKeyEvent*>(event))) return true;
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Delete || key == Qt::Key_Backspace) {
      remove();
      return true;
    }
    if (key == Qt::Key_Space) {
      const auto rules = chosen();
      const auto& all = rules_.isOpen() ? rules_.expert().rules : std::vector<fuzzy::Rule>();
      enable(std::any_of(rules.begin(), rules.end(), [&](std::size_t r) { return r < all.size() && !all[r].enabled; }));
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

bool RuleListPane::answerWithKey(QKeyEvent* event) {
  if (!rules_.isOpen()) return false;
  if (event->matches(QKeySequence::Copy)) {
    copy();
    return true;
  }
  if (event->matches(QKeySequence::Paste)) {
    paste();
    return true;
  }
  const bool plain = (event->modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
  const int word = event->key() - Qt::Key_1;
  if (!plain || word < 0 || word > 8 || word >= static_cast<int>(rules_.words().size())) return false;
  sync();
  rules_.setConsequent(chosen(), rules_.words()[static_cast<std::size_t>(word)].id);
  return true;
}

void RuleListPane::copy() {
  sync();
  const QString lines = rules_.copied();
  if (!lines.isEmpty()) QGuiApplication::clipboard()->setText(lines);
}

void RuleListPane::paste() { rules_.paste(QGuiApplication::clipboard()->text()); }

void RuleListPane::refresh() {
  if (!rules_.isOpen()) return;
  if (stale_) {
    sync();
    form_->refreshState();
    fitRows();
  } else {
    list_->refreshStrengths();
  }
  showSelected();
  showCount();
  showActions();
}

// Before an edit of what is selected: the list must be that of the rules as they stand.
void RuleListPane::sync() {
  if (!stale_) return;
  showing_ = true;
  list_->refresh();
  showing_ = false;
  stale_ = false;
}

// The selection of the program is that of the table.
void RuleListPane::showSelected() {
  if (chosen() == rules_.selection().rules()) return;
  QItemSelection rows;
  QModelIndex first;
  for (const std::size_t rule : rules_.selection().rules()) {
    const QModelIndex row = sieve_->mapFromSource(list_->index(static_cast<int>(rule), 0));
    if (!row.isValid()) continue;
    if (!first.isValid()) first = row;
    rows.select(row, row.siblingAtColumn(RuleListModel::kColumns - 1));
  }
  showing_ = true;
  if (first.isValid()) table_->selectionModel()->setCurrentIndex(first, QItemSelectionModel::NoUpdate);
  table_->selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect);
  showing_ = false;
  if (first.isValid()) table_->scrollTo(first);
}

// A rule that was pointed at is seen, whatever the filter says.
void RuleListPane::showPointed() {
  if (!rules_.isOpen()) return;
  sync();
  const auto& selected = rules_.selection().rules();
  const bool hidden = std::any_of(selected.begin(), selected.end(), [this](std::size_t rule) {
    return !sieve_->mapFromSource(list_->index(static_cast<int>(rule), 0)).isValid();
  });
  if (hidden) {
    text_->clear();
    only_->setCurrentIndex(0);
  }
  showSelected();
  flash_->start();
}

void RuleListPane::showCount() {
  const int all = list_->rowCount();
  const int shown = sieve_->rowCount();
  const QString whole = tr("%n rule(s)", nullptr, all);
  count_->setText(shown == all ? whole : tr("%1 of %2").arg(shown).arg(all));
}

void RuleListPane::showActions() {
  const QModelIndexList rows = table_->selectionModel()->selectedRows();
  const auto on = std::count_if(rows.begin(), rows.end(),
                                [](const QModelIndex& row) { return row.data(RuleListModel::kIsEnabled).toBool(); });
  edit_->setEnabled(rows.size() == 1);
  remove_->setEnabled(!rows.isEmpty());
  enable_->setEnabled(on < rows.size());
  disable_->setEnabled(on > 0);
  go_->setEnabled(!rows.isEmpty());
}

// All rows are as high as the longest conditions need, the words as wide as the longest one.
void RuleListPane::fitRows() {
  if (!rules_.isOpen()) return;
  const QFontMetrics metrics(table_->font());
  const int room = table_->columnWidth(RuleListModel::kConditions) - theme::kGrid;
  int lines = 1;
  for (int row = 0; row < list_->rowCount(); ++row) {
    const QModelIndex conditions = list_->index(row, RuleListModel::kConditions);
    if (metrics.horizontalAdvance(conditions.data().toString()) <= room) continue;
    lines = std::max(lines, static_cast<int>(list_->wordsOf(row).conditions.size()));
  }
  const int height = metrics.height() * std::min(lines, kMostRuleLines) + theme::kGrid;
  if (table_->verticalHeader()->defaultSectionSize() != height) {
    table_->verticalHeader()->setDefaultSectionSize(height);
  }
  int widest = 0;
  for (const fuzzy::Term& word : rules_.words()) widest = std::max(widest, metrics.horizontalAdvance(labelOf(word)));
  const int width = std::clamp(widest, kNarrowestWord, kWidestWord) + 4 * theme::kGrid;
  if (table_->columnWidth(RuleListModel::kConsequent) != width) {
    table_->setColumnWidth(RuleListModel::kConsequent, width);
  }
}

std::vector<std::size_t> RuleListPane::chosen() const {
  std::vector<std::size_t> out;
  for (const QModelIndex& row : table_->selectionModel()->selectedRows()) {
    out.push_back(static_cast<std::size_t>(sieve_->mapToSource(row).row()));
  }
  std::sort(out.begin(), out.end());
  return out;
}

void RuleListPane::enable(bool enabled) {
  sync();
  rules_.enable(chosen(), enabled);
}

void RuleListPane::remove() {
  sync();
  rules_.remove(chosen());
}

void RuleListPane::edit() {
  sync();
  const auto rules = chosen();
  if (rules.size() == 1) form_->openFor(rules.front());
}

void RuleListPane::showRule(std::size_t rule) {
  sync();
  rules_.selection().selectRules({rule});
  showSelected();
}

void RuleListPane::openMenu(QPoint at) {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  for (QToolButton* button : {edit_, go_, enable_, disable_, remove_}) {
    QAction* action = menu->addAction(button->text());
    action->setEnabled(button->isEnabled());
    connect(action, &QAction::triggered, button, &QToolButton::click);
  }
  menu->addSeparator();
  QAction* copied = menu->addAction(tr("Copy as text"), this, &RuleListPane::copy);
  copied->setEnabled(!rules_.selection().rules().empty());
  menu->addAction(tr("Paste rules from text"), this, &RuleListPane::paste);
  menu->popup(table_->viewport()->mapToGlobal(at));
}

}  // namespace tactus::workbench
