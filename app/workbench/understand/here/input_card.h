// One input: its membership functions, its value as a marker, a slider and a number, and the terms of the value.
#pragma once

#include "app/workbench/base/plot_table.h"
#include "app/workbench/kit/cards.h"
#include "core/fuzzy/force_model.h"

class QSlider;

namespace tactus::workbench {

class ElidedLabel;
class MembershipPlot;
class NumberBox;
class SceneController;

class InputCard : public Card {
  Q_OBJECT

 public:
  InputCard(SceneController& scene, std::size_t input, QWidget* parent = nullptr);

 private:
  void showTerms();
  PlotTable table();
  void showValue();
  void onValue(std::size_t input);
  void onReading();
  void onSlider(int position);
  void onNumber(double value);

  SceneController& scene_;
  std::size_t input_;
  fuzzy::Variable variable_;
  double step_;
  ElidedLabel* title_;
  NumberBox* number_;
  MembershipPlot* plot_;
  QSlider* slider_;
  ElidedLabel* terms_;
};

}  // namespace tactus::workbench
