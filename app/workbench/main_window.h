// The main window: menus, dropped files, messages, and the current screen.
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

  /// The entry of the File menu that opens a reference curve. The caller connects it.
  QAction* addReferenceAction();
  /// The panels of the stages. Add panels before a model is opened.
  PanelArea& panels();
  FeelPanel& feelPanel();
  OperatingStrip& strip() { return *strip_; }
  MessageBanner& banner() { return *banner_; }
  /// Shows one sentence in the strip for some seconds: what was done, or why it was refused. Errors go to the banner.
  void say(const QString& sentence) override;
  void showError(const QString& sentence) override;
  /// The line above the panels.
  ModelHeader& header();
  /// The study that is open, by its file's name, in the title and beside the heading; empty: none.
  void showStudy(const QString& name);
  /// Adds a line above the screen, below the messages.
  void addStrip(QWidget* strip);
  /// Asks the user about unsaved changes, if there are any. Returns whether another model may be opened.
  bool mayLoseChanges();

 public slots:
  void enter(tactus::workbench::Stage stage);
  /// Opens a model file, or emits `studyChosen` for a study file. Asks about unsaved changes first.
  void openFile(const QString& path);

 signals:
  /// The user chose a study file to open.
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
  QString study_;  ///< file name of the open study
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
