// The rule viewer: which rules fire at the reading place, and how they produce the force, for one expert or for the
// mean.
#pragma once

#include "app/workbench/base/plot_table.h"
#include "app/workbench/kit/cards.h"

class QComboBox;
class QLabel;
class QScrollArea;
class QStackedWidget;
class QToolButton;

namespace tactus::workbench {

class ElidedLabel;
class ExpertFlow;
class OutputSetsPlot;
class PlotMenu;
class Refresh;
class RuleFlow;
class SceneController;
class Selection;

class RulePanel : public Card {
  Q_OBJECT

 public:
  RulePanel(const SceneController& scene, Selection& selection, QWidget* parent = nullptr);

 private:
  void adoptModel();
  void choose(int row);
  void chooseByHand(int row);
  void adoptExpert();
  void showSelected();
  void point(std::size_t rule);
  void explain();
  QString summary() const;
  PlotTable table();

  const SceneController& scene_;
  Selection& selection_;
  QComboBox* who_;
  ElidedLabel* summary_;
  QToolButton* edit_;
  QScrollArea* area_;
  QStackedWidget* flows_;
  RuleFlow* rules_;
  ExpertFlow* experts_;
  OutputSetsPlot* sets_;
  Refresh* refresh_;
};

}  // namespace tactus::workbench
