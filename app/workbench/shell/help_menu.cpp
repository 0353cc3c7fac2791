#include "app/workbench/shell/help_menu.h"

#include <QAction>
#include <QMenuBar>
#include <QMessageBox>

#include "app/version.h"
#include "app/workbench/shell/main_window.h"
#include "app/workbench/shell/shortcut_sheet.h"

namespace tactus::workbench {

HelpMenu::HelpMenu(MainWindow& window) {
  QAction* const shortcuts =
      window.menus().addAction(MenuSlot::kHelp, tr("Show the &keyboard shortcuts"), Qt::CTRL | Qt::Key_Slash);
  QAction* const about = window.menus().addAction(MenuSlot::kHelp, tr("&About Tactus Workbench"));
  QObject::connect(shortcuts, &QAction::triggered, &window, [&window] { showShortcuts(window); });
  QObject::connect(about, &QAction::triggered, &window, [&window] { showAbout(window); });
}

void HelpMenu::showShortcuts(MainWindow& window) {
  ShortcutSheet sheet(*window.menuBar(), &window);
  sheet.exec();
}

void HelpMenu::showAbout(MainWindow& window) {
  const QString version = QString::fromUtf8(kVersion.data(), static_cast<qsizetype>(kVersion.size()));
  QMessageBox::about(
      &window, tr("About Tactus Workbench"),
      tr("<h3>Tactus Workbench %1</h3>"
         "<p>Turns what expert nurses know by feel into a force model that a haptic simulator can run.</p>"
         "<p>Free software under the GNU General Public License, version 3 or later, without any "
         "warranty. It uses Qt %2 and QCustomPlot.</p>")
          .arg(version, QString::fromLatin1(qVersion())));
}

}  // namespace tactus::workbench
