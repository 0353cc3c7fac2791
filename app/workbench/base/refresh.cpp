#include "app/workbench/base/refresh.h"

#include <QEvent>
#include <QWidget>
#include <algorithm>
#include <utility>

namespace tactus::workbench {

Refresh::Refresh(QWidget* panel, std::function<void()> work)
    : QObject(panel), panel_(panel), work_(std::move(work)), timer_(this) {
  timer_.setSingleShot(true);
  timer_.setTimerType(Qt::PreciseTimer);
  next_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &Refresh::run);
  panel_->installEventFilter(this);
}

bool Refresh::isDue() const { return stale_ && isSeen(); }

void Refresh::setRefining(bool refining) {
  if (std::exchange(refining_, refining) && !refining) emit done();
}

bool Refresh::isSeen() const { return panel_->isVisible() && !panel_->window()->isMinimized(); }

void Refresh::request() {
  if (!std::exchange(stale_, true)) due_since_ = std::chrono::steady_clock::now();
  if (!isSeen() || timer_.isActive()) return;
  const auto wait = static_cast<int>(std::clamp<qint64>(next_.remainingTime(), 0, kFrameMs));
  // Frames count from the request and not from the work, which comes late where others work before it.
  next_.setRemainingTime(wait + kFrameMs, Qt::PreciseTimer);
  timer_.start(wait);
}

bool Refresh::eventFilter(QObject* watched, QEvent* event) {
  // Queued, because a panel that is being shown has no size yet. A window that was minimized only paints again.
  const bool shown = event->type() == QEvent::Show || event->type() == QEvent::Paint;
  if (shown && stale_ && !timer_.isActive()) timer_.start(0);
  return QObject::eventFilter(watched, event);
}

const Refresh* Refresh::dueAbove() const {
  if (panel_->isWindow()) return nullptr;
  for (const QWidget* above = panel_->parentWidget(); above && !above->isWindow(); above = above->parentWidget()) {
    for (const Refresh* refresh : above->findChildren<Refresh*>(QString(), Qt::FindDirectChildrenOnly)) {
      if (refresh->isDue()) return refresh;
    }
  }
  return nullptr;
}

void Refresh::run() {
  if (!stale_ || !isSeen()) return;
  if (const Refresh* const before = dueAbove()) {
    connect(before, &Refresh::done, this, &Refresh::run,
            static_cast<Qt::ConnectionType>(Qt::UniqueConnection | Qt::SingleShotConnection));
    return;
  }
  stale_ = false;
  work_();
  emit done();
}

}  // namespace tactus::workbench
