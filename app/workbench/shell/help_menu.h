// The menu Help: the list of shortcuts, and what this program is.
#pragma once

#include <QCoreApplication>

namespace tactus::workbench {

class MainWindow;

class HelpMenu {
  Q_DECLARE_TR_FUNCTIONS(HelpMenu)

 public:
  explicit HelpMenu(MainWindow& window);

 private:
  static void showShortcuts(MainWindow& window);
  static void showAbout(MainWindow& window);
};

}  // namespace tactus::workbench
