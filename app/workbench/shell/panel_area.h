// The panels of the stages as dock widgets: the user can move, stack, undock and close them. Each stage has its own
// layout, which the settings keep. A panel on its own has a slim title. Panels in one place have tabs instead; a right
// click on a tab moves or closes its panel.
#pragma once

#include <QHash>
#include <QMainWindow>
#include <QTimer>
#include <optional>
#include <vector>

#include "app/workbench/shell/panel_place.h"
#include "app/workbench/shell/stage.h"

class QDockWidget;
class QSettings;
class QTabBar;

namespace tactus::workbench {

class PanelArea : public QMainWindow {
  Q_OBJECT

 public:
  explicit PanelArea(QSettings& settings, QWidget* parent = nullptr);

  /// Adds `panel` under the settings key `id`. The stages that have a place for it show it.
  QDockWidget* addPanel(const QString& id, const QString& title, QWidget* panel);
  /// Sets the default layout of `stage`; a later call adds places. A place whose panel was not added is left out; its
  /// neighbors take the space.
  void addPlaces(Stage stage, const std::vector<PanelPlace>& places);

  /// Shows the panels of `stage` in their last places.
  void enter(Stage stage);
  std::optional<Stage> stage() const { return stage_; }
  /// Resets the panels of the current stage to the default layout.
  void resetLayout();
  /// Stores the layout of the current stage.
  void storeLayout();

  /// Shows or hides each panel.
  QList<QAction*> toggleActions() const;

 private:
  void layOut(const std::vector<PanelPlace>& places);
  void put(const PanelPlace& place);
  void shareRoom(const std::vector<PanelPlace>& places);
  QStringList panelNames() const;
  void showTitles();
  void showMenu(QDockWidget& panel, const QPoint& place);
  bool isBehind(const QDockWidget& panel) const;
  QDockWidget* dockOfTab(const QTabBar& tabs, int index) const;
  QDockWidget* dock(const char* id) const { return docks_.value(QLatin1String(id)); }

  QSettings& settings_;
  QHash<QString, QDockWidget*> docks_;
  QList<QDockWidget*> order_;
  QHash<int, std::vector<PanelPlace>> places_;
  std::optional<Stage> stage_;
  QTimer titles_;  ///< one update after any number of moved panels
};

}  // namespace tactus::workbench
