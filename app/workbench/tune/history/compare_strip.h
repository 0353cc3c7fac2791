// Says on top of the panels what is shown and felt while versions are compared; hidden otherwise.
#pragma once

#include "app/workbench/kit/card.h"

class QToolButton;

namespace tactus::workbench {

class CompareController;
class ElidedLabel;

class CompareStrip : public Card {
  Q_OBJECT

 public:
  explicit CompareStrip(CompareController& compare, QWidget* parent = nullptr);

  /// Whether the shown model is felt on a device, too.
  void setFelt(bool felt);

 private:
  void showState();

  CompareController& compare_;
  ElidedLabel* shown_;
  ElidedLabel* other_;
  QToolButton* end_;
  bool felt_ = false;
};

}  // namespace tactus::workbench
