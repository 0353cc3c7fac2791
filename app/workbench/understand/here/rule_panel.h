// The rule viewer: which rules fire at the reading place, and how they produce the force, for one expert or for the
// mean.
#pragma once

#include "app/workbench/base/plot_table.h"
#include "app/workbench/kit/card.h"

class QComboBox;
class QLabel;
class QScrollArea;
class QStackedWidget;

namespace tactus::workbench {

class ElidedLabel;
class ExpertFlow;
class OutputSetsPlot;
class PlotMenu;
class Refresh;
class RuleFlow;
class SceneController;

class RulePanel : public Card {
  Q_OBJECT

 public:
  explicit RulePanel(const SceneController& scene, QWidget* parent = nullptr);

 private:
  void adoptModel();
  void choose(int row);
  void explain();
  QString summary() const;
  PlotTable table();

  const SceneController& scene_;
  QComboBox* who_;
  ElidedLabel* summary_;
  QScrollArea* area_;
  QStackedWidget* flows_;
  RuleFlow* rules_;
  ExpertFlow* experts_;
  OutputSetsPlot* sets_;
  Refresh* refresh_;
};

}  // namespace tactus::workbench
