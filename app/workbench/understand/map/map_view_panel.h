// A drawing of the force over two inputs, with the choice of its axes and of whose force it shows: what the panels of
// the map and of the surface have in common.
#pragma once

#include <QString>

#include "app/workbench/base/plot_table.h"
#include "app/workbench/kit/card.h"

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
  /// What the panel says and shows.
  struct Content {
    QWidget* plot;    ///< becomes a child
    MapView* view;    ///< the same
    QWidget* below;   ///< the plot, or null; becomes a child
    QString missing;  ///< where the model has one input alone
    QString suffix;   ///< of the file proposed for its table or picture: `-map`
  };
  MapViewPanel(const SceneController& scene, ForceMapController& map, const Content& content, QWidget* parent);

  /// Has the plot show what it would show if it were seen.
  virtual void catchUp() { showMap(); }

 private:
  void adoptModel();
  void showChoice();
  void showMap();
  void showPoint();
  void onMap();
  void onValue(std::size_t input);
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
