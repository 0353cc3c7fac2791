#include "app/workbench/views/refresh.h"

#include <QEvent>
#include <QWidget>
#include <algorithm>
#include <utility>

namespace tactus::workbench {

Refresh::Refresh(QWidget* panel, std::function<void()> work) : QObject(panel), panel_(panel), work_(std::move(work)) {
  timer_.setSingleShot(true);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &Refresh::run);
  panel_->installEventFilter(this);
}

void Refresh::request() {
  stale_ = true;
  if (!panel_->isVisible() || timer_.isActive()) return;
  const int passed =
      since_last_.isValid() ? static_cast<int>(std::min<qint64>(since_last_.elapsed(), kFrameMs)) : kFrameMs;
  timer_.start(kFrameMs - passed);
}

bool Refresh::eventFilter(QObject* watched, QEvent* event) {
  // Queued, because at this moment the panel has no size yet.
  if (event->type() == QEvent::Show && stale_) timer_.start(0);
  return QObject::eventFilter(watched, event);
}

void Refresh::run() {
  if (!panel_->isVisible()) return;
  stale_ = false;
  since_last_.start();
  work_();
}

}  // namespace tactus::workbench
