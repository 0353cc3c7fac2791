#include "app/workbench/participant/virtual_hand.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QMouseEvent>
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
  if (!wanted) letGo();
}

bool VirtualHand::eventFilter(QObject* watched, QEvent* event) {
  auto* const widget = qobject_cast<QWidget*>(watched);
  if (!wanted_ || widget == nullptr || widget->window() != &window_ || window_.isCovered() || !device_.isHandLive()) {
    return QObject::eventFilter(watched, event);
  }
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      // Buttons and cards take their presses; what reaches the window is meant for nothing else.
      if (watched == &window_ && press(static_cast<const QMouseEvent&>(*event))) return true;
      break;
    case QEvent::MouseMove:
      if (from_px_) drag(static_cast<const QMouseEvent&>(*event));
      break;
    case QEvent::MouseButtonRelease:
    case QEvent::WindowDeactivate:
      if (from_px_) letGo();
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

void VirtualHand::drag(const QMouseEvent& event) {
  constexpr double kScaleMm = 100;
  moveTo((event.globalPosition().x() - *from_px_) / look_.mm(kScaleMm) * kScaleMm);
}

void VirtualHand::letGo() {
  from_px_.reset();
  device_.setHeld(false);
  moveTo(0);
}

bool VirtualHand::key(const QKeyEvent& event, bool down) {
  switch (event.key()) {
    case Qt::Key_Space:
      if (!event.isAutoRepeat()) device_.setHeld(down);
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
