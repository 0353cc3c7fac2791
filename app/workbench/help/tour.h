// The tour: a few sentences at one panel after another, beside a frame around the panel. The program stays in use.
#pragma once

#include <QObject>
#include <QString>
#include <QWidget>
#include <functional>
#include <vector>

#include "app/workbench/kit/cards.h"

class QLabel;
class QPushButton;
class QWidget;

namespace tactus::workbench {

class PrimaryButton;

// What a step of the tour says, with the way to the next one.

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

/// The frame around the panel of which the tour speaks. It lets the mouse through.
class TourFrame : public QWidget {
  Q_OBJECT

 public:
  explicit TourFrame(QWidget* parent = nullptr);

 protected:
  void paintEvent(QPaintEvent* event) override;
};

struct TourStep {
  QString title;
  QString text;
  /// Brings what the step speaks of onto the screen and returns it.
  std::function<QWidget*()> show;
};

class Tour : public QObject {
  Q_OBJECT

 public:
  /// `window`: what is toured; it outlives this.
  Tour(QWidget& window, std::vector<TourStep> steps);

  void start() { goTo(0); }
  void end();
  bool isRunning() const { return step_ >= 0; }
  int step() const { return step_; }
  int steps() const { return static_cast<int>(steps_.size()); }
  /// `step` from 0; one behind the last ends the tour.
  void goTo(int step);
  TourCard& card() { return *card_; }
  TourFrame& frame() { return *frame_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void place();
  void watch(QWidget* shown);

  QWidget& window_;
  std::vector<TourStep> steps_;
  TourFrame* frame_;
  TourCard* card_;
  QWidget* shown_ = nullptr;
  int step_ = -1;
};

/// Where a card of the size `card` stands beside `target` in a window of the size `window`: right, left, below or above
/// it, in this order; where none has room, in the lower right corner of `target`.
QRect cardPlace(const QSize& window, const QRect& target, const QSize& card);

}  // namespace tactus::workbench
