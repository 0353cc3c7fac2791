// The tour: a few sentences at one panel after another, beside a frame around the panel. The program stays in use.
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <vector>

class QWidget;

namespace tactus::workbench {

class TourCard;
class TourFrame;

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
