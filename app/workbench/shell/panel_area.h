// The panels of the stages as dock widgets: the user can move, stack, undock and close them. Each stage has its own
// layout, which the settings keep. A panel on its own has a slim title. Panels in one place have tabs instead; a right
// click on a tab moves or closes its panel.
#pragma once

#include <QHash>
#include <QMainWindow>
#include <QTimer>
#include <optional>
#include <vector>

#include "app/workbench/shell/panel.h"
#include "app/workbench/shell/stage.h"

class QSettings;
class QTabBar;

namespace tactus::workbench {

class PanelArea : public QMainWindow {
  Q_OBJECT

 public:
  explicit PanelArea(QSettings& settings, QWidget* parent = nullptr);
  ~PanelArea() override;

  /// Adds a panel with this content. `id` is its name in the settings and nowhere else. Shown by the stages whose
  /// layout has a place for it.
  Panel& addPanel(const QString& id, const QString& title, QWidget* content);
  /// Sets the default layout of `stage`.
  void setLayout(Stage stage, std::vector<PanelPlace> places);

  /// Shows the panels of `stage` in their last places.
  void enter(Stage stage);
  std::optional<Stage> stage() const { return stage_; }
  /// Resets the panels of the current stage to the default layout.
  void resetLayout();
  /// Stores the layout of the current stage.
  void storeLayout();

  const QList<Panel*>& panels() const { return panels_; }
  /// Whether the tab of another panel lies before this one.
  bool isBehind(const Panel& panel) const;
  /// Shows or hides each panel.
  QList<QAction*> toggleActions() const;

 private:
  void layOut(const std::vector<PanelPlace>& places);
  void put(const PanelPlace& place);
  void shareRoom(const std::vector<PanelPlace>& places);
  QStringList panelNames() const;
  void showTitles();
  void showMenu(Panel& panel, const QPoint& place);
  Panel* panelOfTab(const QTabBar& tabs, int index) const;

  QSettings& settings_;
  QList<Panel*> panels_;
  QHash<int, std::vector<PanelPlace>> places_;
  std::optional<Stage> stage_;
  QTimer titles_{this};  ///< one update after any number of moved panels
};

}  // namespace tactus::workbench
