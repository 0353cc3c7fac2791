#include "app/workbench/shell/frame_clock.h"

#include <QCoreApplication>
#include <QEvent>
#include <QWidget>
#include <algorithm>
#include <chrono>
#include <utility>

#include "app/workbench/base/refresh.h"

namespace tactus::workbench {
namespace {

QEvent::Type lookEvent() {
  static const auto kType = static_cast<QEvent::Type>(QEvent::registerEventType());
  return kType;
}

// Windows are painted on an event of low priority, so an event of this one comes after all that is painted by then.
constexpr int kAfterPainting = Qt::LowEventPriority - 1;

}  // namespace

FrameClock::FrameClock(const QWidget& root, QObject* parent, Now now)
    : QObject(parent), root_(root), now_(std::move(now)) {}

FrameClock::Now FrameClock::steadyTime() {
  return [] { return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count(); };
}

void FrameClock::begin() {
  if (!begun_ns_ || coarse_ || !isWaiting()) begun_ns_ = now_();
  coarse_ = false;
}

bool FrameClock::isWaiting() const {
  return std::any_of(watched_.begin(), watched_.end(),
                     [](const QPointer<Refresh>& refresh) { return refresh && refresh->isDue(); });
}

void FrameClock::sent() {
  if (!begun_ns_) return;
  watched_.clear();
  for (Refresh* refresh : root_.findChildren<Refresh*>()) watched_ << refresh;
  lookLater();
}

void FrameClock::lookLater() {
  if (looking_) return;
  looking_ = true;
  QCoreApplication::postEvent(this, new QEvent(lookEvent()), kAfterPainting);
}

bool FrameClock::event(QEvent* event) {
  if (event->type() != lookEvent()) return QObject::event(event);
  looking_ = false;
  if (begun_ns_) look();
  return true;
}

void FrameClock::look() {
  if (!root_.isVisible() || root_.window()->isMinimized()) {
    stop();
    return;
  }
  bool due = false;
  bool refining = false;
  for (const QPointer<Refresh>& refresh : std::as_const(watched_)) {
    if (!refresh) continue;
    if (!refresh->isDue() && !refresh->isRefining()) continue;
    due = due || refresh->isDue();
    refining = true;
    connect(refresh.data(), &Refresh::done, this, &FrameClock::lookLater, Qt::UniqueConnection);
  }
  if (due) return;
  const double passed_ms = static_cast<double>(now_() - *begun_ns_) / 1e6;
  if (!coarse_) painted_ms_.push_back(passed_ms);
  if (refining) {
    coarse_ = true;
    return;
  }
  finest_ms_.push_back(passed_ms);
  stop();
  emit measured();
}

void FrameClock::stop() {
  begun_ns_.reset();
  coarse_ = false;
  for (const QPointer<Refresh>& refresh : std::as_const(watched_)) {
    if (refresh) disconnect(refresh.data(), nullptr, this, nullptr);
  }
  watched_.clear();
}

std::optional<FrameClock::Times> FrameClock::timesOf(const std::vector<double>& all_ms) {
  if (all_ms.empty()) return std::nullopt;
  std::vector<double> times_ms = all_ms;
  const auto middle = times_ms.begin() + static_cast<std::ptrdiff_t>(times_ms.size() / 2);
  std::nth_element(times_ms.begin(), middle, times_ms.end());
  return Times{all_ms.back(), *middle, *std::max_element(middle, times_ms.end()), times_ms.size()};
}

}  // namespace tactus::workbench
