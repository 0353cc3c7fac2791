// The menu of the layouts that the user named.
#pragma once

#include <QObject>

class QMenu;

namespace tactus::workbench {

class MainWindow;

class LayoutMenu : public QObject {
  Q_OBJECT

 public:
  /// Fills `menu` each time it opens. `menu` owns this.
  LayoutMenu(MainWindow& window, QMenu& menu);

 private:
  void fill();
  void show(const QString& name);
  void askName();

  MainWindow& window_;
  QMenu& menu_;
};

}  // namespace tactus::workbench
