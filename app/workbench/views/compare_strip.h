// Says on top of the panels what is shown and felt while versions are compared; hidden otherwise.
#pragma once

#include "app/workbench/views/card.h"

class QToolButton;

namespace tactus::workbench {

class CompareController;
class ElidedLabel;
class FeelController;

class CompareStrip : public Card {
  Q_OBJECT

 public:
  CompareStrip(CompareController& compare, FeelController& feel, QWidget* parent = nullptr);

 private:
  void showState();

  CompareController& compare_;
  FeelController& feel_;
  ElidedLabel* shown_;
  ElidedLabel* other_;
  QToolButton* end_;
};

}  // namespace tactus::workbench
