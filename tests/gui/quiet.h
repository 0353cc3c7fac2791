// What is still to come from the timers of a window, so that no test waits for a clock.
#pragma once

#include <QTimer>
#include <algorithm>
#include <string>

#include "app/workbench/base/refresh.h"

namespace tactus::tests {

/// Who below `root` is about to work, in words for a test that waited in vain.
inline std::string whatIsLeft(const QObject& root) {
  std::string out;
  const auto add = [&out](const char* what, const QObject& one) {
    const QObject* const parent = one.parent();
    out += std::string(what) + " of " + (parent != nullptr ? parent->metaObject()->className() : "nobody") + "; ";
  };
  for (const auto* refresh : root.findChildren<workbench::Refresh*>()) {
    if (refresh->isRefining()) add("refining", *refresh);
  }
  for (const QTimer* timer : root.findChildren<QTimer*>()) {
    if (timer->isActive()) add((std::to_string(timer->interval()) + " ms").c_str(), *timer);
  }
  return out;
}

/// Whether no object below `root` is about to work: no timer of a frame, of a slice of work, or of a rest is running.
/// Longer ones, such as that of a message, only take something away.
inline bool isQuiet(const QObject& root) {
  constexpr int kLongest = 500;  // ms
  // What another thread computes for a panel comes too.
  for (const auto* refresh : root.findChildren<workbench::Refresh*>()) {
    if (refresh->isRefining()) return false;
  }
  const QList<QTimer*> timers = root.findChildren<QTimer*>();
  return std::none_of(timers.begin(), timers.end(), [](const QTimer* timer) {
    const bool ends = timer->isSingleShot() || timer->interval() == 0;
    return timer->isActive() && ends && timer->interval() < kLongest;
  });
}

}  // namespace tactus::tests
