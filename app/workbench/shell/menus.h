// The menus View and Help.
#pragma once

#include <QCoreApplication>
#include <QDialog>
#include <QObject>

class QMenu;
class QMenuBar;
class QSettings;

namespace tactus::workbench {

class MainWindow;
class ModelController;

// The menu View: stages, panels, look, and the way back to the first layout.

class ViewMenu : public QObject {
  Q_OBJECT

 public:
  /// Lists the screens and panels that `window` has now.
  ViewMenu(MainWindow& window, const ModelController& models, QSettings& settings);

 private:
  void addStages();
  QMenu* addPanels();
  void addLooks();
  void addTextSizes();

  MainWindow& window_;
  QSettings& settings_;
};

// The menu Help: the list of shortcuts, and what this program is.

/// The list of all shortcuts: those of the menus, read from their actions, and the mouse and key functions of plots.
class ShortcutSheet : public QDialog {
  Q_OBJECT

 public:
  explicit ShortcutSheet(const QMenuBar& menus, QWidget* parent = nullptr);
};

void addHelpMenu(MainWindow& window);

}  // namespace tactus::workbench
