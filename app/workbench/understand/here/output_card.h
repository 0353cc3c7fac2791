// The output: its membership functions and the mean force at the reading place.
#pragma once

#include "app/workbench/base/plot_table.h"
#include "app/workbench/kit/cards.h"
#include "core/fuzzy/force_model.h"

class QLabel;

namespace tactus::workbench {

class ElidedLabel;
class MembershipPlot;
class SceneController;

class OutputCard : public Card {
  Q_OBJECT

 public:
  explicit OutputCard(SceneController& scene, QWidget* parent = nullptr);

 private:
  void showTerms();
  PlotTable table();
  void showReading();

  SceneController& scene_;
  fuzzy::Variable variable_;
  ElidedLabel* title_;
  QLabel* number_;
  MembershipPlot* plot_;
  ElidedLabel* terms_;
};

}  // namespace tactus::workbench
