// The main window: menus, messages, the stages with their screens, and the strip below. Features add to it what they
// show; it knows none of them.
#pragma once

#include <QAbstractButton>
#include <QHash>
#include <QKeySequence>
#include <QMainWindow>
#include <QMap>
#include <QObject>
#include <QString>
#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

#include "app/workbench/kit/notes.h"
#include "app/workbench/shell/stage.h"

class QAction;
class QMenu;
class QMenuBar;
class QSettings;
class QStackedWidget;
class QVBoxLayout;
class QPainter;

namespace tactus::workbench {

class MessageBanner;
class ModelController;
class ModelHeader;
class OperatingStrip;
class Panel;
class PanelArea;
class SceneController;
class StageButton;
struct PanelPlace;

// One stage in the rail: its picture, its name and its task.

class StageButton : public QAbstractButton {
  Q_OBJECT

 public:
  explicit StageButton(Stage stage, QWidget* parent = nullptr);

  Stage stage() const { return stage_; }

  /// True: the name stands below the picture, and the task is the tool tip.
  void setCompact(bool compact);
  /// How far the stage is, e.g. `4 nurses`, instead of its task; empty: its task.
  void setState(const QString& state);

  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString hint() const;
  QRect hintRect() const;
  void paintRoomy(QPainter& painter, const QColor& ink, const QColor& muted);
  void paintCompact(QPainter& painter, const QColor& ink);

  Stage stage_;
  QString state_;
  bool compact_ = false;
};

// The menu bar. The menus and the groups in them have a fixed order, so that features may add their actions in any.

/// A group of actions, between two separators of a menu. In the order on the screen: all groups of the first menu, then
/// those of the second.
enum class MenuSlot {
  kFileOpen,
  kFileSave,
  kFilePictures,
  kFileQuit,
  kEditUndo,
  kEditStates,
  kEditCompare,
  kEditAuthor,
  kStudyOpen,
  kStudyModel,
  kStudyClose,
  kStudyNotes,
  kView,
  kFeelDevice,
  kFeelPatient,
  kFeelLink,
  kHelp,
};

class WindowMenus {
 public:
  /// `bar` owns the menus.
  explicit WindowMenus(QMenuBar& bar);

  /// Adds an action at the end of `slot`. A menu is shown once it has an action.
  QAction* addAction(MenuSlot slot, const QString& text, const QKeySequence& keys = {});
  /// Adds a menu of its own at the end of `slot`.
  QMenu* addMenu(MenuSlot slot, const QString& title);
  /// The menu that holds `slot`.
  QMenu& menu(MenuSlot slot) const;

 private:
  struct Group {
    QMenu* menu;
    QAction* end;  ///< the separator behind its last action
  };
  const Group& group(MenuSlot slot) const;
  void insert(MenuSlot slot, QAction* action);

  std::vector<Group> groups_;  ///< one for each slot
};

// The rail on the left: Collect, Build, Understand, Tune, Deliver.

class StageRail : public QWidget {
  Q_OBJECT

 public:
  explicit StageRail(QWidget* parent = nullptr);

  /// `stage` has a screen; the others are not shown.
  void show(Stage stage);
  /// Whether `stage` can be entered now.
  void setReady(Stage stage, bool ready);
  /// How far `stage` is, below its name; empty: its task.
  void setState(Stage stage, const QString& state);
  /// Marks the stage on the screen; nothing: none is, as in the Feel layout.
  void setStage(std::optional<Stage> stage);
  /// True: a narrow rail.
  void setCompact(bool compact);

 signals:
  /// The user chose `stage`, which can be entered.
  void chosen(tactus::workbench::Stage stage);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void fitWidth();

  QMap<Stage, StageButton*> buttons_;
  bool compact_ = false;
};

// The screen of the stages that show the open model: its header and the panels of the current stage.

class BenchView : public QWidget {
  Q_OBJECT

 public:
  BenchView(SceneController& scene, QSettings& settings, QWidget* parent = nullptr);

  PanelArea& panels() { return *panels_; }
  ModelHeader& header() { return *header_; }

 private:
  ModelHeader* header_;
  PanelArea* panels_;
};

// Where the line of the open model stands: above the panels, or, in a low window, in the row of the menus.

class HeaderPlace : public QObject {
  Q_OBJECT

 public:
  /// `bench` owns the line while it stands above the panels, `menus` while it stands beside them.
  HeaderPlace(QMenuBar& menus, BenchView& bench, QObject* parent);

  /// True: beside the menus. A menu bar outside the window has no room for it.
  void setLow(bool low);
  /// Whether the panels are on the screen. While the window shows another screen, a line beside the menus is hidden.
  void setShown(bool shown);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void fit();

  QMenuBar& menus_;
  BenchView& bench_;
  bool low_ = false;
  bool shown_ = false;
};

class MainWindow : public QMainWindow, public MessagePlace {
  Q_OBJECT

 public:
  MainWindow(const ModelController& models, SceneController& scene, QSettings& settings);

  WindowMenus& menus() { return menus_; }
  /// What must be open before a stage can be entered.
  enum class Needs { kModel, kStudy };
  /// How far `stage` is, in the rail, e.g. `4 nurses`.
  void setStageState(Stage stage, const QString& state);
  /// The screen that is shown while no stage can be entered.
  void setStartScreen(QWidget* screen);
  /// Adds the screen of `stage`, which can be entered while what it needs is open.
  void addScreen(Stage stage, QWidget* screen, Needs needs = Needs::kModel);
  /// Adds a panel; `id` is its name in the settings and nowhere else.
  Panel& addPanel(const QString& id, const QString& title, QWidget* content);
  /// Gives `stage` these panels as its screen. `tight`: their places where the text is large for the window; empty: the
  /// same.
  void addScreen(Stage stage, std::vector<PanelPlace> layout, std::vector<PanelPlace> tight = {});
  /// Adds a layout of panels beside those of the stages; `id` is its name in the settings.
  void addLayout(const QString& id, std::vector<PanelPlace> layout);
  /// Adds a line above the screen, below the messages.
  void addStrip(QWidget* strip);
  /// Adds a question for the user before the window closes: false keeps it open. The one added last is asked first.
  void addCloseGuard(std::function<bool()> may_close);

  PanelArea& panels() { return bench_->panels(); }
  /// The line above the panels.
  ModelHeader& header() { return bench_->header(); }
  OperatingStrip& strip() { return *strip_; }
  MessageBanner& banner() { return *banner_; }
  /// Shows one sentence in the strip for some seconds: what was done, or why it was refused. Errors go to the banner.
  void say(const QString& sentence) override;
  void showError(const QString& sentence, MessageAct act, const QObject& from) override;
  void takeBackError(const QObject& from) override;

  /// Whether `stage` has a screen.
  bool hasScreen(Stage stage) const { return stages_.contains(static_cast<int>(stage)); }
  /// Whether `stage` has a screen, and what it needs is open.
  bool canEnter(Stage stage) const;
  std::optional<Stage> stage() const { return stage_; }
  /// The layout beside those of the stages that is on the screen; empty: that of the stage is.
  const QString& layoutBeside() const { return layout_beside_; }

 public slots:
  /// `stage` has a screen. Where what it needs is not open, the start screen stays.
  void enter(tactus::workbench::Stage stage);
  /// The start screen, also while something is open; a stage of the rail leads back.
  void showStart();
  /// Shows the panels of an added layout. Without a model it does nothing.
  void enterLayout(const QString& id);
  /// Back to the screen of the stage.
  void leaveLayout();
  /// Gives the keyboard to the next part of the window (a panel, the strip, the rail), or to the one before.
  void focusNextPart(bool forward);
  /// Whether a study is open.
  void setStudyOpen(bool open);

 signals:
  void entered(tactus::workbench::Stage stage);
  /// `layoutBeside` changed.
  void layoutChanged();
  /// The window is about to close, and all guards have agreed.
  void closing();

 protected:
  bool event(QEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool focusNextPrevChild(bool next) override;

 private:
  void showStages();
  void fitPanels();
  void setLayoutBeside(const QString& id);
  QList<QWidget*> parts() const;
  std::optional<Stage> lastStage() const;

  QSettings& settings_;
  WindowMenus menus_;
  MessageBanner* banner_;
  QVBoxLayout* column_;
  QStackedWidget* screens_;
  BenchView* bench_;
  HeaderPlace* header_place_;
  StageRail* rail_;
  OperatingStrip* strip_;
  struct Entrance {
    QWidget* screen = nullptr;
    Needs needs = Needs::kModel;
  };
  const ModelController& models_;
  QWidget* start_ = nullptr;
  QHash<int, Entrance> stages_;  ///< of each stage that has a screen
  std::optional<Stage> stage_;
  QString layout_beside_;
  bool study_open_ = false;
  std::vector<std::function<bool()>> close_guards_;
};

}  // namespace tactus::workbench
