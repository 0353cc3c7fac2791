// The window: menus, files dropped on it, messages, and the screen of the task at hand.
#pragma once

#include <QMainWindow>

#include "app/workbench/kit/say.h"
#include "app/workbench/shell/stage.h"

class QAction;
class QMenu;
class QSettings;
class QStackedWidget;
class QVBoxLayout;

namespace tactus::workbench {

class BenchView;
class FeelController;
class FeelPanel;
class MessageBanner;
class ModelController;
class ModelHeader;
class OperatingStrip;
class PanelArea;
class RecentFiles;
class SceneController;
class StageRail;
class StartView;

class MainWindow : public QMainWindow, public MessagePlace {
  Q_OBJECT

 public:
  MainWindow(ModelController& models, SceneController& scene, FeelController& feel, RecentFiles& recent,
             QSettings& settings);

  /// The entry of the File menu that opens a reference curve, for whoever does it.
  QAction* addReferenceAction();
  /// Where panels of the stages are added, before a model is opened.
  PanelArea& panels();
  FeelPanel& feelPanel();
  OperatingStrip& strip() { return *strip_; }
  MessageBanner& banner() { return *banner_; }
  /// Says one sentence in the strip, for a while: what was done, or why something was not. Errors go to the banner.
  void say(const QString& sentence) override;
  void showError(const QString& sentence) override;
  /// The line above the panels.
  ModelHeader& header();
  /// The study that is open, by its file's name, in the title and beside the heading; empty: none.
  void showStudy(const QString& name);
  /// Adds a line over the screen, below the messages.
  void addStrip(QWidget* strip);
  /// Asks what to do with changes that are not saved, where there are some. Whether another model may be opened.
  bool mayLoseChanges();

 public slots:
  void enter(tactus::workbench::Stage stage);
  /// Opens a model file, or asks for the study file; changes that are not saved are asked about first.
  void openFile(const QString& path);

 signals:
  /// A study file is to be opened.
  void studyChosen(const QString& path);

 protected:
  bool event(QEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool focusNextPrevChild(bool next) override;

 private:
  void buildMenus();
  void buildFeelMenu();
  void showFeel();
  void connectAll();
  void restorePlace();
  void choose();
  void chooseCopy();
  void copyPicture();
  void reopen();
  void showModel();
  void showTitle();
  void showFailure(const QString& path, const QString& sentence);
  void listRecent();
  void listPanels();
  void listLooks();
  void showShortcuts();
  void showAbout();

  ModelController& models_;
  SceneController& scene_;
  FeelController& feel_;
  RecentFiles& recent_;
  QSettings& settings_;
  MessageBanner* banner_;
  QVBoxLayout* column_;
  QStackedWidget* screens_;
  StartView* start_;
  BenchView* bench_;
  QString study_;  ///< name of the file of the study that is open
  StageRail* rail_;
  OperatingStrip* strip_;
  QMenu* recent_menu_ = nullptr;
  QMenu* view_menu_ = nullptr;
  QMenu* stage_menu_ = nullptr;
  QMenu* panel_menu_ = nullptr;
  QMenu* look_menu_ = nullptr;
  QAction* open_ = nullptr;
  QAction* reopen_ = nullptr;
  QAction* save_ = nullptr;
  QAction* save_as_ = nullptr;
  QAction* save_curves_ = nullptr;
  QAction* save_map_ = nullptr;
  QAction* copy_picture_ = nullptr;
  QAction* quit_ = nullptr;
  QAction* reset_layout_ = nullptr;
  QAction* feel_start_ = nullptr;
  QAction* feel_stop_ = nullptr;
  QAction* flex_ = nullptr;
  QAction* new_placement_ = nullptr;
  QAction* shortcuts_ = nullptr;
  QAction* about_ = nullptr;
};

}  // namespace tactus::workbench
