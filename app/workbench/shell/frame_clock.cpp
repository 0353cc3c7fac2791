#include "app/workbench/shell/frame_clock.h"

#include <QCoreApplication>
#include <QEvent>
#include <QWidget>
#include <algorithm>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/refresh.h"
#include "app/workbench/base/theme.h"

namespace tactus::workbench {
namespace {

constexpr int kCalmMs = 200;

QString seriesText(const FrameClock::Times& times) {
  return FrameStatus::tr("last %1 ms, median %2 ms, largest %3 ms of %n edit(s)", nullptr,
                         static_cast<int>(times.edits))
      .arg(numberText(times.last_ms, 1), numberText(times.median_ms, 1), numberText(times.largest_ms, 1));
}

}  // namespace

FrameStatus::FrameStatus(const FrameClock& clock, QWidget* parent) : QLabel(parent), clock_(clock) {
  setTextFormat(Qt::PlainText);
  setMuted(*this);
  // Numbers that change with every frame can be neither read nor had for nothing.
  calm_.setSingleShot(true);
  calm_.setInterval(kCalmMs);
  connect(&calm_, &QTimer::timeout, this, &FrameStatus::showLast);
  connect(&clock_, &FrameClock::measured, this, [this] {
    if (!calm_.isActive()) calm_.start();
  });
  hide();
}

void FrameStatus::showLast() {
  setText(tr("Plots after %1 ms").arg(qRound(clock_.painted()->last_ms)));
  setVisible(true);
}

bool FrameStatus::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) setToolTip(explanation());
  return QLabel::event(event);
}

QString FrameStatus::explanation() const {
  const auto painted = clock_.painted();
  const auto finest = clock_.finest();
  if (!painted || !finest) return {};
  return tr("From an edit until every visible plot is painted with it: %1.").arg(seriesText(*painted)) +
         QLatin1Char('\n') + tr("Until map and surface are at their finest: %1.").arg(seriesText(*finest)) +
         QLatin1Char('\n') + tr("A screen of 60 Hz shows a picture every 16.7 ms.");
}

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

void FrameClock::begin() { sending_ = Edit{now_(), std::chrono::steady_clock::now(), {}}; }

void FrameClock::sent() {
  if (!sending_) return;
  sending_->sent = std::chrono::steady_clock::now();
  edits_.push_back(*sending_);
  sending_.reset();
  coarse_ns_.reset();
  watched_.clear();
  for (Refresh* refresh : root_.findChildren<Refresh*>()) watched_ << refresh;
  lookLater();
}

// Work that only a newer edit asked for is no part of this one.
bool FrameClock::isFor(const Refresh& due, std::size_t edit) const {
  return std::none_of(edits_.begin() + static_cast<std::ptrdiff_t>(edit) + 1, edits_.end(),
                      [&](const Edit& newer) { return newer.begun <= due.dueSince() && due.dueSince() <= newer.sent; });
}

void FrameClock::lookLater() {
  if (looking_) return;
  looking_ = true;
  QCoreApplication::postEvent(this, new QEvent(lookEvent()), kAfterPainting);
}

bool FrameClock::event(QEvent* event) {
  if (event->type() != lookEvent()) return QObject::event(event);
  looking_ = false;
  if (!edits_.empty() || coarse_ns_) look();
  return true;
}

void FrameClock::look() {
  if (!root_.isVisible() || root_.window()->isMinimized()) {
    stop();
    return;
  }
  std::vector<const Refresh*> due;
  bool refining = false;
  for (const QPointer<Refresh>& refresh : std::as_const(watched_)) {
    if (!refresh || (!refresh->isDue() && !refresh->isRefining())) continue;
    if (refresh->isDue()) due.push_back(refresh);
    refining = true;
    connect(refresh.data(), &Refresh::done, this, &FrameClock::lookLater, Qt::UniqueConnection);
  }
  std::size_t painted = 0;
  while (painted < edits_.size() &&
         std::none_of(due.begin(), due.end(), [&](const Refresh* one) { return isFor(*one, painted); })) {
    ++painted;
  }
  if (painted > 0) {
    coarse_ns_ = edits_.front().begun_ns;
    edits_.erase(edits_.begin(), edits_.begin() + static_cast<std::ptrdiff_t>(painted));
    painted_ms_.push_back(msSince(*coarse_ns_));
    emit shown();
  }
  if (refining || !coarse_ns_) return;
  finest_ms_.push_back(msSince(*coarse_ns_));
  stop();
  emit measured();
}

double FrameClock::msSince(std::int64_t begun_ns) const { return static_cast<double>(now_() - begun_ns) / 1e6; }

void FrameClock::stop() {
  edits_.clear();
  coarse_ns_.reset();
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
