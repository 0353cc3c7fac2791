// The main area: the plot of the curves with the choice of the x axis and the settings of the paper's figures.
#pragma once

#include "app/workbench/views/card.h"
#include "core/base/error.h"

class QComboBox;
class QLabel;
class QPushButton;
class QToolButton;

namespace tactus::workbench {

class CurvePlot;
class ReadingModel;
class Refresh;
class SceneController;

class CurvesPanel : public Card {
  Q_OBJECT

 public:
  CurvesPanel(SceneController& scene, ReadingModel& readings, QWidget* parent = nullptr);

  base::Result<void> savePicture(const QString& path);

 signals:
  void savePictureRequested();

 private:
  void adoptModel();
  void showAxes();
  void showTerms();
  void onXInputChosen(int index);
  void onRowShown(int row, bool shown);
  QString settingText() const;

  SceneController& scene_;
  QLabel* title_;
  QComboBox* x_input_;
  QPushButton* presets_;
  QToolButton* save_;
  CurvePlot* plot_;
  Refresh* draw_curves_;
  Refresh* draw_reading_;
};

}  // namespace tactus::workbench
