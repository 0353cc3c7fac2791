// What the search finds in the window itself: the entries of its menus, and its panels.
#pragma once

#include "app/workbench/shell/command_search.h"

class QMenuBar;

namespace tactus::workbench {

class MainWindow;
class Panel;

/// Actions that can be used now, with their menu and keys.
QList<SearchEntry> menuEntries(const QMenuBar& bar);

/// The panels, while a model is open.
QList<SearchEntry> panelEntries(MainWindow& window);

/// Brings `panel` to the front in the stage that is shown, or in Understand where that shows no panels.
void goToPanel(MainWindow& window, Panel& panel);

}  // namespace tactus::workbench
