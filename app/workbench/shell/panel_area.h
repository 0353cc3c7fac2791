// The panels of the stages as dock widgets: the user can move, stack, undock and close them. Each stage has its own
// layout, which the settings keep. A panel on its own has a slim title. Panels in one place have tabs instead; a right
// click on a tab moves or closes its panel.
#pragma once

#include <QDockWidget>
#include <QHash>
#include <QMainWindow>
#include <QTimer>
#include <QWidget>
#include <optional>
#include <vector>

#include "app/workbench/shell/stage.h"

class QDockWidget;
class QSettings;
class QTabBar;
class QToolButton;

namespace tactus::workbench {

// A panel of the window, and its place in the default layout of a stage.

/// What PanelArea::addPanel returns: layouts name a panel by it.
class Panel : public QDockWidget {
  Q_OBJECT

 public:
  using QDockWidget::QDockWidget;

  /// Shows the panel before others in the same place.
  void reveal();

 signals:
  /// The user closed it.
  void closed();

 protected:
  void closeEvent(QCloseEvent* event) override;
  bool focusNextPrevChild(bool next) override;
};

/// Places in a layout build on those before them: `right(map, 44, curves)` needs a place of `curves` first.
struct PanelPlace {
  enum class How { kFirst, kRight, kBelow, kTab };

  /// Takes the whole area.
  static PanelPlace first(Panel& panel) { return {&panel, How::kFirst, nullptr, 100}; }
  /// Takes the right `percent` of the place of `beside`.
  static PanelPlace right(Panel& panel, int percent, Panel& beside) { return {&panel, How::kRight, &beside, percent}; }
  /// Takes the lower `percent` of the place of `above`.
  static PanelPlace below(Panel& panel, int percent, Panel& above) { return {&panel, How::kBelow, &above, percent}; }
  /// A tab behind `before`.
  static PanelPlace behind(Panel& panel, Panel& before) { return {&panel, How::kTab, &before, 100}; }

  Panel* panel;
  How how;
  Panel* beside;  ///< null for kFirst
  int percent;    ///< of the place of `beside`
};

// The title of a panel that stands alone: one slim line. It is hidden while tabs name the panel.

class ElidedLabel;

class PanelTitle : public QWidget {
  Q_OBJECT

 public:
  explicit PanelTitle(QDockWidget& panel);

  /// Whether a tab already names the panel.
  void setTabbed(bool tabbed);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {0, sizeHint().height()}; }

 signals:
  /// The user asks for the menu of the panel, at `place` on the screen.
  void menuRequested(const QPoint& place);

 protected:
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  void showFloating(bool floating);

  QDockWidget& panel_;
  ElidedLabel* name_;
  QToolButton* float_;
  QToolButton* close_;
  bool tabbed_ = false;
};

class PanelArea : public QMainWindow {
  Q_OBJECT

 public:
  explicit PanelArea(QSettings& settings, QWidget* parent = nullptr);
  ~PanelArea() override;

  /// Adds a panel with this content. `id` is its name in the settings and nowhere else. Shown by the stages whose
  /// layout has a place for it.
  Panel& addPanel(const QString& id, const QString& title, QWidget* content);
  /// Sets the default of the layout `id`, its name in the settings. That of a stage is called like the stage. `tight`:
  /// the default where there is little room for the size of the text; the settings keep both. Empty: the same.
  void setLayout(const QString& id, std::vector<PanelPlace> places, std::vector<PanelPlace> tight = {});
  /// Whether there is little room. A layout with places of its own for that changes.
  void setTight(bool tight);

  /// Shows the panels of `stage` in their last places.
  void enter(Stage stage);
  std::optional<Stage> stage() const { return stage_; }
  /// Shows the panels of the layout `id` in their last places; the stage stays.
  void enterLayout(const QString& id);
  /// The layout on the screen.
  const QString& layoutId() const { return layout_; }
  /// Resets the panels of the current layout to its default.
  void resetLayout();
  /// Stores the current layout.
  void storeLayout();

  const QList<Panel*>& panels() const { return panels_; }
  /// Whether the tab of another panel lies before this one.
  bool isBehind(const Panel& panel) const;
  /// Shows or hides each panel.
  QList<QAction*> toggleActions() const;

 private:
  /// The name in the settings of what `layoutId` shows in the present room.
  QString shownId() const;
  void showLayout();
  void layOut(const std::vector<PanelPlace>& places);
  void put(const PanelPlace& place);
  void shareRoom(const std::vector<PanelPlace>& places);
  QStringList panelNames() const;
  bool restore(const QString& key, const QString& panels_key);
  void store(const QString& key, const QString& panels_key);
  void showTitles();
  void showMenu(Panel& panel, const QPoint& place);
  Panel* panelOfTab(const QTabBar& tabs, int index) const;

  QSettings& settings_;
  QList<Panel*> panels_;
  QHash<QString, std::vector<PanelPlace>> places_;  ///< of each layout
  std::optional<Stage> stage_;
  QString layout_;
  bool tight_ = false;
  QTimer titles_{this};  ///< one update after any number of moved panels
};

}  // namespace tactus::workbench
