// The menu Help: the list of shortcuts, and what this program is.
#pragma once

#include <QCoreApplication>
#include <QDialog>

class QMenuBar;

namespace tactus::workbench {

/// The list of all shortcuts: those of the menus, read from their actions, and the mouse and key functions of plots.
class ShortcutSheet : public QDialog {
  Q_OBJECT

 public:
  explicit ShortcutSheet(const QMenuBar& menus, QWidget* parent = nullptr);
};

class MainWindow;

void addHelpMenu(MainWindow& window);

}  // namespace tactus::workbench
