// The panels of the stages as dock widgets: moved, put on top of each other, taken out of the window, closed. Each
// stage has a layout of its own, which is kept in the settings.
#pragma once

#include <QHash>
#include <QMainWindow>
#include <optional>
#include <vector>

#include "app/workbench/views/stage.h"

class QDockWidget;
class QSettings;

namespace tactus::workbench {

/// Where a panel stands in the first layout of a stage.
struct PanelPlace {
  enum class How {
    kFirst,  ///< takes all there is
    kRight,  ///< the right part of what `beside` had
    kBelow,  ///< the lower part of what `beside` had
    kTab,    ///< behind `beside`
  };
  const char* panel = "";  ///< name given to addPanel
  How how = How::kFirst;
  const char* beside = "";
  int percent = 50;  ///< of what `beside` had, for this panel
};

class PanelArea : public QMainWindow {
  Q_OBJECT

 public:
  explicit PanelArea(QSettings& settings, QWidget* parent = nullptr);

  /// Adds `panel` under the name `id`, which is kept in settings. It is shown in the stages that have a place for it.
  QDockWidget* addPanel(const QString& id, const QString& title, QWidget* panel);
  /// The first layout of `stage`; a later call adds places to it.
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
  void shareRoom(const std::vector<PanelPlace>& places);
  QDockWidget* dock(const char* id) const { return docks_.value(QLatin1String(id)); }

  QSettings& settings_;
  QHash<QString, QDockWidget*> docks_;
  QList<QDockWidget*> order_;
  QHash<int, std::vector<PanelPlace>> places_;
  std::optional<Stage> stage_;
};

}  // namespace tactus::workbench
