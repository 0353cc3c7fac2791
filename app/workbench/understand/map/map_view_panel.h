// The common panel of map and surface: a drawing of the force over two inputs, with the choice of its axes and its
// expert.
#pragma once

#include <QString>

#include "app/workbench/base/plot_table.h"
#include "app/workbench/kit/cards.h"

class QLabel;
class QVBoxLayout;

namespace tactus::workbench {

class ForceMapController;
class MapView;
class PlotMenu;
class Refresh;
class SceneController;

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
