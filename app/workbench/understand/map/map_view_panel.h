// The common panel of map and surface: a drawing of the force over two inputs, with the choice of its axes and its
// expert.
#pragma once

#include <QBrush>
#include <QColor>
#include <QString>
#include <QWidget>
#include <optional>

#include "app/workbench/base/plot_table.h"
#include "app/workbench/kit/cards.h"
#include "app/workbench/plot/plot_menu.h"
#include "app/workbench/understand/map/force_map.h"
#include "core/fuzzy/force_model.h"

class QComboBox;
class QLabel;
class QVBoxLayout;

namespace tactus::workbench {

class ForceMapController;
class PlotMenu;
class Refresh;
class SceneController;

// The color of a force for map, surface and their scales. It is the color ramp of the output's terms.

/// Color of a force at `share` of the way from the lowest to the highest force of the universe. Values beyond the ends
/// get the color of the end.
QColor forceColor(double share);

/// The background where no rule fires: hatched, like the gaps of the curves.
QBrush silentGround();

/// The common interface of the color map and the surface for the panel around them.
class MapView : public PlotSource {
 public:
  /// The map says which parts of the universes it shows. The axes become the universes of `x`, `y` and of the force.
  /// This removes the map.
  virtual void setAxes(const fuzzy::Variable& x, const fuzzy::Variable& y, const fuzzy::Variable& output) = 0;
  /// The map for the current axes; null: none.
  virtual void setMap(const ForceMap* map) = 0;
  /// The operating point and its label. `force_n` is nothing if no rule fires.
  virtual void setPoint(double x, double y, std::optional<double> force_n, const QString& tag) = 0;
};

// The boxes in the header of a map or surface panel: the expert (or mean) and the two inputs.

/// All instances of one controller show the same choice. A visible instance counts its panel as a viewer of the map.
class MapChoice : public QWidget {
  Q_OBJECT

 public:
  MapChoice(const SceneController& scene, ForceMapController& map, QWidget* parent = nullptr);

  /// The owner of the force, as shown: `Mean`.
  QString who() const;

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void adoptModel();
  void showChoice();

  const SceneController& scene_;
  ForceMapController& map_;
  QComboBox* who_;
  QComboBox* x_input_;
  QComboBox* y_input_;
  bool counted_ = false;
};

class MapViewPanel : public Card {
  Q_OBJECT

 public:
  PlotMenu& plotMenu() { return *menu_; }

 protected:
  /// The texts and widgets of the panel.
  struct Content {
    QWidget* plot;    ///< becomes a child
    MapView* view;    ///< the same object
    QWidget* below;   ///< the widget below the plot, or null; becomes a child
    QString missing;  ///< shown if the model has only one input
    QString suffix;   ///< ends the proposed file name of a table or picture: `-map`
  };
  MapViewPanel(const SceneController& scene, ForceMapController& map, const Content& content, QWidget* parent);

  /// A map that was unfinished when the panel was hidden goes on.
  void showEvent(QShowEvent* event) override;
  /// Updates a hidden plot.
  virtual void catchUp() { showMap(); }

 private:
  void adoptModel();
  void showChoice();
  void showMap();
  void showPoint();
  void onMap();
  void onValue(std::size_t input);
  void onRange(const std::string& input_id);
  PlotTable table();

  const SceneController& scene_;
  ForceMapController& map_;
  Content content_;
  PlotMenu* menu_;
  QLabel* missing_;
  Refresh* compute_;
  Refresh* draw_map_;
  Refresh* draw_point_;
};

}  // namespace tactus::workbench
