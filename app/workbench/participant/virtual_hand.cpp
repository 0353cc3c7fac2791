#include "app/workbench/participant/virtual_hand.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWindow>
#include <algorithm>

#include "app/workbench/device/device_session.h"
#include "app/workbench/participant/kit/look.h"
#include "app/workbench/participant/participant_window.h"

namespace tactus::workbench {
namespace {

// As far as the virtual device reaches.
constexpr double kLeastMm = -10;
constexpr double kMostMm = 150;
constexpr double kKeyMm = 4;  // with a key that repeats 25 times a second: 100 mm/s, a fast insertion

}  // namespace

VirtualHand::VirtualHand(ParticipantWindow& window, const nurse::Look& look, DeviceSession& device)
    : window_(window), look_(look), device_(device) {
  QCoreApplication::instance()->installEventFilter(this);
}

void VirtualHand::setWanted(bool wanted) {
  if (wanted == wanted_) return;
  wanted_ = wanted;
  if (!wanted && !holds()) letGo();
}

bool VirtualHand::eventFilter(QObject* watched, QEvent* event) {
  auto* const widget = qobject_cast<QWidget*>(watched);
  if (holds() && window_.isCovered()) letGo();
  if (from_px_ && watched == window_.windowHandle()) follow(*event);
  const bool here = widget != nullptr && widget->window() == &window_ && !window_.isCovered();
  if (!here || !(wanted_ || holds()) || !device_.isHandLive()) return QObject::eventFilter(watched, event);
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      // Buttons and cards take their presses; what reaches the window is meant for nothing else.
      if (wanted_ && watched == &window_ && press(static_cast<const QMouseEvent&>(*event))) return true;
      break;
    case QEvent::WindowDeactivate:
      if (holds()) letGo();
      break;
    case QEvent::KeyPress:
      return key(static_cast<const QKeyEvent&>(*event), true);
    case QEvent::KeyRelease:
      return key(static_cast<const QKeyEvent&>(*event), false);
    default:
      break;
  }
  return QObject::eventFilter(watched, event);
}

bool VirtualHand::press(const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton) return false;
  from_px_ = event.globalPosition().x();
  device_.setHeld(true);
  return true;
}

// At the window itself: what the press went to may be hidden meanwhile, and gets no more events.
void VirtualHand::follow(const QEvent& event) {
  if (event.type() == QEvent::MouseMove) drag(static_cast<const QMouseEvent&>(event));
  if (event.type() == QEvent::MouseButtonRelease) letGo();
}

void VirtualHand::drag(const QMouseEvent& event) {
  constexpr double kScaleMm = 100;
  moveTo((event.globalPosition().x() - *from_px_) / look_.mm(kScaleMm) * kScaleMm);
}

void VirtualHand::letGo() {
  from_px_.reset();
  space_ = false;
  device_.setHeld(false);
  moveTo(0);
}

bool VirtualHand::key(const QKeyEvent& event, bool down) {
  switch (event.key()) {
    case Qt::Key_Space:
      if (event.isAutoRepeat()) return true;
      if (!wanted_ && down) return false;
      space_ = down;
      device_.setHeld(down);
      if (!wanted_) letGo();
      return true;
    case Qt::Key_Right:
    case Qt::Key_Left:
      if (down) moveTo(device_.targetMm() + (event.key() == Qt::Key_Right ? kKeyMm : -kKeyMm));
      return true;
    default:
      return false;
  }
}

void VirtualHand::moveTo(double position_mm) { device_.setTarget(std::clamp(position_mm, kLeastMm, kMostMm)); }

}  // namespace tactus::workbench
