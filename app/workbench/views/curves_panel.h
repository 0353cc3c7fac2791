// The main area: the plot of the curves with the choice of the x axis and the settings of the paper's figures.
#pragma once

#include "app/workbench/plot_table.h"
#include "app/workbench/views/card.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace tactus::workbench {

class CurvePlot;
class PlotMenu;
class ReadingModel;
class Refresh;
class SceneController;

class CurvesPanel : public Card {
  Q_OBJECT

 public:
  CurvesPanel(SceneController& scene, ReadingModel& readings, QWidget* parent = nullptr);

  PlotMenu& plotMenu() { return *menu_; }

 private:
  void adoptModel();
  void showAxes();
  void showTerms();
  void onXInputChosen(int index);
  void onRowShown(int row, bool shown);
  PlotTable table();

  SceneController& scene_;
  QLabel* title_;
  QComboBox* x_input_;
  QPushButton* presets_;
  CurvePlot* plot_;
  PlotMenu* menu_;
  Refresh* draw_curves_;
  Refresh* draw_reading_;
};

}  // namespace tactus::workbench
