// The strip above the panels that names the version shown and felt during a comparison; otherwise hidden.
#pragma once

#include "app/workbench/kit/cards.h"

class QToolButton;

namespace tactus::workbench {

class CompareController;
class ElidedLabel;

class CompareStrip : public Card {
  Q_OBJECT

 public:
  explicit CompareStrip(CompareController& compare, QWidget* parent = nullptr);

  /// Whether the shown model is also felt on a device.
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
