#include "app/workbench/rehearsal/screen_hands.h"

#include <QAbstractButton>
#include <QCoreApplication>
#include <QLineEdit>
#include <QMouseEvent>
#include <QWindow>
#include <algorithm>

#include "app/workbench/participant/kit/look.h"
#include "app/workbench/participant/participant_window.h"
#include "app/workbench/participant/screens/review_cell.h"

namespace tactus::workbench {
namespace {

/// Through the window, as a mouse does it: what lies on top gets the event.
void send(const ParticipantWindow& window, QEvent::Type type, const QPointF& at) {
  const bool moves = type == QEvent::MouseMove;
  const bool released = type == QEvent::MouseButtonRelease;
  QMouseEvent event(type, at, window.mapToGlobal(at), moves ? Qt::NoButton : Qt::LeftButton,
                    released ? Qt::NoButton : Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(window.windowHandle(), &event);
}

/// The widget itself, or what it is part of.
template <class Kind>
Kind* around(QWidget* widget) {
  for (QWidget* at = widget; at != nullptr; at = at->parentWidget()) {
    if (auto* found = qobject_cast<Kind*>(at)) return found;
  }
  return nullptr;
}

}  // namespace

bool ScreenHands::press(const char* id) const { return press(QString::fromLatin1(id)); }

bool ScreenHands::press(const QString& id) const { return press(nurse::phrase(id)); }

bool ScreenHands::press(const nurse::Phrase& text) const {
  const QAbstractButton* found = button(text);
  if (found != nullptr) click(*found);
  return found != nullptr;
}

bool ScreenHands::pressCell(int item) const {
  const QAbstractButton* found = buttonThat([item](const QAbstractButton& each) {
    const auto* cell = qobject_cast<const nurse::ReviewCell*>(&each);
    return cell != nullptr && cell->item() == item;
  });
  if (found != nullptr) click(*found);
  return found != nullptr;
}

QAbstractButton* ScreenHands::button(const nurse::Phrase& text) const {
  const QString wanted = look_.say(text);
  return buttonThat([&wanted](const QAbstractButton& each) { return each.text() == wanted; });
}

QAbstractButton* ScreenHands::buttonThat(const std::function<bool(const QAbstractButton&)>& is_it) const {
  for (QAbstractButton* each : window_.findChildren<QAbstractButton*>()) {
    if (!each->isVisible() || !each->isEnabled() || !is_it(*each)) continue;
    const QPoint middle = each->mapTo(&window_, each->rect().center());
    if (around<QAbstractButton>(window_.childAt(middle)) == each) return each;
  }
  return nullptr;
}

void ScreenHands::click(const QAbstractButton& button) const {
  const QPointF middle = button.mapTo(&window_, button.rect().center());
  send(window_, QEvent::MouseButtonPress, middle);
  send(window_, QEvent::MouseButtonRelease, middle);
}

void ScreenHands::takeHold() {
  held_at_ = freePlace();
  holds_ = true;
  send(window_, QEvent::MouseButtonPress, held_at_);
}

void ScreenHands::moveTo(double position_mm) const {
  constexpr double kScaleMm = 100;  // whole pixels of a long way
  if (holds_) send(window_, QEvent::MouseMove, held_at_ + QPointF(position_mm * look_.mm(kScaleMm) / kScaleMm, 0));
}

void ScreenHands::letGo() {
  if (!holds_) return;
  holds_ = false;
  send(window_, QEvent::MouseButtonRelease, held_at_);
}

QPointF ScreenHands::freePlace() const {
  constexpr int kStepPx = 16;
  for (int y = window_.height() / 2; y < window_.height(); y += kStepPx) {
    for (int x = window_.width() / 8; x < window_.width() / 2; x += kStepPx) {
      QWidget* const there = window_.childAt(x, y);
      if (around<QAbstractButton>(there) == nullptr && around<QLineEdit>(there) == nullptr) return {x * 1.0, y * 1.0};
    }
  }
  return QPointF(1, 1);
}

}  // namespace tactus::workbench
