#include "app/workbench/shell/search_sources.h"

#include <QAction>
#include <QCoreApplication>
#include <QMenu>
#include <QMenuBar>

#include "app/workbench/shell/main_window.h"
#include "app/workbench/shell/panel.h"
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

}  // namespace tactus::workbench
