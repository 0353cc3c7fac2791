// What a step of the tour says, with the way to the next one.
#pragma once

#include "app/workbench/kit/cards.h"

class QLabel;
class QPushButton;

namespace tactus::workbench {

class PrimaryButton;

class TourCard : public Card {
  Q_OBJECT

 public:
  explicit TourCard(QWidget* parent = nullptr);

  /// `step` counts from 0.
  void showStep(const QString& title, const QString& text, int step, int steps);

 signals:
  void backRequested();
  void nextRequested();
  void endRequested();

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QLabel* title_;
  QLabel* text_;
  QLabel* place_;
  QPushButton* back_;
  PrimaryButton* next_;
  QPushButton* end_;
};

}  // namespace tactus::workbench
