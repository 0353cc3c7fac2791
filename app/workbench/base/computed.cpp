#include "app/workbench/base/computed.h"

namespace tactus::workbench {

void Held::hold(QObject& holder, bool held) {
  if (!held) {
    if (holders_.remove(&holder) && !isHeld()) followHolders();
  } else if (!holders_.contains(&holder)) {
    holders_.insert(&holder);
    // Later: what follows may reach the rest of a holder that is ending.
    connect(&holder, &QObject::destroyed, this, [this](QObject* ended) {
      if (!holders_.remove(ended) || isHeld()) return;
      const auto follow = [this] {
        if (!isHeld()) followHolders();
      };
      QMetaObject::invokeMethod(this, follow, Qt::QueuedConnection);
    });
    if (holders_.size() == 1) followHolders();
  }
}

void Computation::followHolders() {
  for (Held* const need : needs_) need->hold(*this, isHeld());
  if (isHeld()) {
    if (stale_ && !canceled_) begin();
  } else if (isBusy()) {
    drop();
    emit changed();
  }
}

void Computation::refresh() {
  canceled_ = false;
  stale_ = true;
  begin();
}

void Computation::renew() {
  if (isBusy()) drop();
  refresh();
}

void Computation::forget() {
  drop();
  clear();
  refresh();
}

void Computation::cancel() {
  if (!isBusy()) return;
  drop();
  canceled_ = true;
  emit changed();
}

void Computation::drop() {
  background_.drop();
  oldest_ = ++newest_;
  stale_ = true;
}

void Computation::begin() {
  Job now = job();
  if (!now) {
    drop();
    clear();
  } else if (!isHeld()) {
    return;
  } else {
    ++newest_;
    progress_ = 0;
    doing_.clear();
    stale_ = false;
    background_.run([this, now = std::move(now), number = newest_](const std::stop_token& stop) -> Deliver {
      Deliver deliver = now(number, stop);
      return [this, deliver = std::move(deliver)] {
        progress_ = 1;
        if (deliver) deliver();
        emit changed();
      };
    });
  }
  emit changed();
}

void Computation::post(std::uint64_t number, bool older, std::function<void(bool)> deliver) {
  answers_.post([this, number, older, deliver = std::move(deliver)] {
    if (older ? number >= oldest_ : number == newest_) deliver(number == newest_);
  });
}

void Computation::tellProgress(std::uint64_t number, double share) {
  post(number, false, [this, share](bool) {
    progress_ = share;
    emit changed();
  });
}

void Computation::say(std::uint64_t number, const QString& doing) {
  post(number, false, [this, doing](bool) {
    doing_ = doing;
    emit changed();
  });
}

}  // namespace tactus::workbench
