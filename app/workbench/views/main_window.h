// The window: menus, files dropped on it, messages, and the screen of the task at hand.
#pragma once

#include <QMainWindow>

class QAction;
class QMenu;
class QSettings;
class QStackedWidget;

namespace tactus::workbench {

class ExploreView;
class MessageBanner;
class ModelController;
class RecentFiles;
class SceneController;
class StartView;

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  MainWindow(ModelController& models, SceneController& scene, RecentFiles& recent, QSettings& settings);

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

 private:
  void buildMenus();
  void connectAll();
  void restorePlace();
  void chooseModel();
  void choosePicture();
  void showModel();
  void showFailure(const QString& path, const QString& sentence);
  void listRecent();
  void showAbout();

  ModelController& models_;
  SceneController& scene_;
  RecentFiles& recent_;
  QSettings& settings_;
  MessageBanner* banner_;
  QStackedWidget* screens_;
  StartView* start_;
  ExploreView* explore_;
  QMenu* recent_menu_ = nullptr;
  QAction* open_ = nullptr;
  QAction* reopen_ = nullptr;
  QAction* save_picture_ = nullptr;
  QAction* quit_ = nullptr;
  QAction* about_ = nullptr;
};

}  // namespace tactus::workbench
