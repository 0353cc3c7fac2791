// The panels of the stages as dock widgets: moved, put on top of each other, taken out of the window, closed. Each
// stage has a layout of its own, which is kept in the settings. A panel that stands alone has a slim title; where
// panels share a place, their tabs are all there is, and a click with the right button on a tab moves or closes its
// panel.
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

  /// Adds `panel` under the name `id`, which is kept in settings. It is shown in the stages that have a place for it.
  QDockWidget* addPanel(const QString& id, const QString& title, QWidget* panel);
  /// The first layout of `stage`; a later call adds places to it. A panel that was not added is left out, and what
  /// stands beside it moves up.
  void addPlaces(Stage stage, const std::vector<PanelPlace>& places);

  /// Shows the panels of `stage` where they were left there.
  void enter(Stage stage);
  std::optional<Stage> stage() const { return stage_; }
  /// Puts the panels of the present stage back in their first places.
  void resetLayout();
  /// Stores the layout of the present stage.
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
  QTimer titles_;  ///< once after any number of panels moved
};

}  // namespace tactus::workbench
