// Eyes and hands of a simulated nurse in front of the screens: she sees the buttons that can be pressed, and everything
// that she does arrives at the window as events of a mouse.
#pragma once

#include <QPointF>
#include <QString>
#include <functional>

#include "app/workbench/participant/kit/look.h"

class QAbstractButton;

namespace tactus::workbench {

class ParticipantWindow;

/// Thread: gui.
class ScreenHands {
 public:
  /// Both outlive this.
  ScreenHands(ParticipantWindow& window, const nurse::Look& look) : window_(window), look_(look) {}

  /// Clicks the button or card that says this (`id`: of the word book). False: none can be pressed, as it is not
  /// visible, waits or is covered.
  bool press(const char* id) const;
  bool press(const QString& id) const;
  bool press(const nurse::Phrase& text) const;
  /// Clicks the cell of this item in the review. False: it is not on the page.
  bool pressCell(int item) const;

  /// Takes the handle of the virtual device: a press on the free area, which lasts until `letGo`.
  void takeHold();
  /// Moves the handle along its axis, mm from where it was taken.
  void moveTo(double position_mm) const;
  void letGo();
  bool holds() const { return holds_; }

 private:
  QAbstractButton* button(const nurse::Phrase& text) const;
  QAbstractButton* buttonThat(const std::function<bool(const QAbstractButton&)>& is_it) const;
  void click(const QAbstractButton& button) const;
  QPointF freePlace() const;

  ParticipantWindow& window_;
  const nurse::Look& look_;
  bool holds_ = false;
  QPointF held_at_;  ///< in the window
};

}  // namespace tactus::workbench
