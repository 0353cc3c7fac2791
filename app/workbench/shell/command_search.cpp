#include "app/workbench/shell/command_search.h"

#include <QAction>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <algorithm>
#include <optional>
#include <utility>

#include "app/workbench/base/theme.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/shell/main_window.h"
#include "app/workbench/shell/panel_area.h"

namespace tactus::workbench {
namespace {

struct SearchText {
  Q_DECLARE_TR_FUNCTIONS(SearchText)
};

QString withoutMnemonic(QString text) {
  return text.replace(QLatin1String("&&"), QLatin1String("\1"))
      .remove(QLatin1Char('&'))
      .replace(QLatin1Char('\1'), QLatin1Char('&'));
}

void addActions(const QMenu& menu, const QString& path, QList<SearchEntry>& entries) {
  for (QAction* action : menu.actions()) {
    if (action->isSeparator() || !action->isVisible() || !action->isEnabled()) continue;
    const QString text = withoutMnemonic(action->text());
    if (action->menu() != nullptr) {
      addActions(*action->menu(), path + QStringLiteral(" › ") + text, entries);
      continue;
    }
    const QString keys = action->shortcut().toString(QKeySequence::NativeText);
    entries << SearchEntry{text, keys.isEmpty() ? path : path + QStringLiteral(" · ") + keys,
                           [action] { action->trigger(); }};
  }
}

}  // namespace

QList<SearchEntry> menuEntries(const QMenuBar& bar) {
  QList<SearchEntry> entries;
  for (const QAction* menu : bar.actions()) {
    if (menu->isVisible() && menu->menu() != nullptr) addActions(*menu->menu(), withoutMnemonic(menu->text()), entries);
  }
  return entries;
}

void goToPanel(MainWindow& window, Panel& panel) {
  const auto stage = window.stage();
  const bool has_panels = stage == Stage::kUnderstand || stage == Stage::kTune || stage == Stage::kDeliver;
  if (!has_panels) window.enter(Stage::kUnderstand);
  panel.reveal();
}

QList<SearchEntry> panelEntries(MainWindow& window) {
  QList<SearchEntry> entries;
  if (!window.canEnter(Stage::kUnderstand)) return entries;
  for (Panel* panel : window.panels().panels()) {
    entries << SearchEntry{panel->windowTitle(), SearchText::tr("Panel"),
                           [&window, panel] { goToPanel(window, *panel); }};
  }
  return entries;
}

namespace {

constexpr int kMostShown = 60;  // more rows are not read
constexpr QSize kSearchSize(680, 380);

/// Words that people type for the same thing: each finds what the others find. Those of a row are separated by blanks.
QStringList synonymsOf(const QString& word) {
  const QString rows[] = {SearchText::tr("why reason explain rules"),
                          SearchText::tr("export write save deliver bundle"),
                          SearchText::tr("import read tables answer"),
                          SearchText::tr("alpha α membership speed"),
                          SearchText::tr("uncertainty interval band bands"),
                          SearchText::tr("new make template"),
                          SearchText::tr("weight weights experts"),
                          SearchText::tr("report page print"),
                          SearchText::tr("nurse participant session collect"),
                          SearchText::tr("agree build experts labs")};
  QStringList out{word};
  if (word.size() < 2 && word != QStringLiteral("α")) return out;
  for (const QString& row : rows) {
    const QStringList words = row.split(QLatin1Char(' '));
    if (words.contains(word, Qt::CaseInsensitive)) out << words;
  }
  return out;
}

/// Smaller is better; nothing: not found.
std::optional<int> rankOf(const SearchEntry& entry, const QStringList& words) {
  const auto has = [](const QString& text, const QString& word) { return text.contains(word, Qt::CaseInsensitive); };
  const auto has_alike = [&](const QString& word) {
    const QStringList alike = synonymsOf(word);
    return std::any_of(alike.begin(), alike.end(),
                       [&](const QString& one) { return has(entry.text, one) || has(entry.kind, one); });
  };
  if (!std::all_of(words.begin(), words.end(), has_alike)) return std::nullopt;
  if (words.isEmpty() || entry.text.startsWith(words.first(), Qt::CaseInsensitive)) return 0;
  return has(entry.text, words.first()) ? 1 : has(entry.kind, words.first()) ? 2 : 3;
}

}  // namespace

QList<SearchEntry> foundEntries(const QList<SearchEntry>& all, const QString& typed) {
  const QStringList words = typed.split(QLatin1Char(' '), Qt::SkipEmptyParts);
  std::vector<std::pair<int, const SearchEntry*>> ranked;
  for (const SearchEntry& entry : all) {
    if (const auto rank = rankOf(entry, words)) ranked.emplace_back(*rank, &entry);
  }
  std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  QList<SearchEntry> found;
  for (const auto& [rank, entry] : ranked) found << *entry;
  return found;
}

CommandSearch::CommandSearch(const std::vector<SearchSource>& sources, SearchReading reading, QWidget* parent)
    : QDialog(parent), reading_(std::move(reading)), line_(new QLineEdit(this)), list_(new QListWidget(this)) {
  setWindowTitle(tr("Search"));
  for (const SearchSource& source : sources) all_ << source();
  line_->setPlaceholderText(tr("Type a command, panel, expert, term or finding; or a place: 130 mm poor fast"));
  line_->setAccessibleName(tr("Search for"));
  line_->setClearButtonEnabled(true);
  line_->installEventFilter(this);
  list_->setAccessibleName(tr("Found"));
  list_->setFocusPolicy(Qt::NoFocus);
  list_->setFrameShape(QFrame::NoFrame);
  // Findings are long; they wrap, so that their ends can be read.
  list_->setWordWrap(true);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setSpacing(2);
  makeColumn(this, {line_, {list_, 1}}, theme::kGrid, inset(theme::kGrid));
  resize(kSearchSize);
  connect(line_, &QLineEdit::textChanged, this, &CommandSearch::find);
  connect(line_, &QLineEdit::returnPressed, this, &CommandSearch::choose);
  connect(list_, &QListWidget::itemClicked, this, &CommandSearch::choose);
  find({});
}

void CommandSearch::find(const QString& typed) {
  found_ = (reading_(typed) << foundEntries(all_, typed)).mid(0, kMostShown);
  list_->clear();
  for (const SearchEntry& entry : found_) {
    list_->addItem(entry.kind.isEmpty() ? entry.text : entry.text + QStringLiteral("   –   ") + entry.kind);
  }
  if (!found_.isEmpty()) return list_->setCurrentRow(0);
  auto* const nothing = new QListWidgetItem(tr("Nothing found. Try a command (“export”), a panel (“map”), a figure "
                                               "(“figure 7”), a participant's code, or a place: "
                                               "“130 mm poor fast”."),
                                            list_);
  nothing->setFlags(Qt::NoItemFlags);
}

void CommandSearch::choose() {
  const int row = list_->currentRow();
  if (row < 0 || row >= found_.size()) return;
  const auto run = found_[row].run;
  // What is chosen may show a dialog of its own.
  accept();
  run();
}

// The line keeps the keyboard; the arrows go through the list.
bool CommandSearch::eventFilter(QObject* watched, QEvent* event) {
  if (watched == line_ && event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    const int last = list_->count() - 1;
    const int step = key == Qt::Key_Down       ? 1
                     : key == Qt::Key_Up       ? -1
                     : key == Qt::Key_PageDown ? 10
                     : key == Qt::Key_PageUp   ? -10
                                               : 0;
    if (step != 0 && last >= 0) {
      list_->setCurrentRow(std::clamp(list_->currentRow() + step, 0, last));
      return true;
    }
  }
  return QDialog::eventFilter(watched, event);
}

}  // namespace tactus::workbench
