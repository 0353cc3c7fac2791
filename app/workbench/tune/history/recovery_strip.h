// Offers the work that a crash left behind: restore, discard, or later.
#pragma once

#include "app/workbench/kit/cards.h"

class QLabel;
class QPushButton;

namespace tactus::workbench {

class RecoveryController;

class RecoveryStrip : public Card {
  Q_OBJECT

 public:
  explicit RecoveryStrip(RecoveryController& recovery, QWidget* parent = nullptr);

 signals:
  void restoreRequested();

 private:
  void showOffer();

  RecoveryController& recovery_;
  QLabel* label_;
  QPushButton* restore_;
  QPushButton* discard_;
  QPushButton* later_;
};

}  // namespace tactus::workbench
