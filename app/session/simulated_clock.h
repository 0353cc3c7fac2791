// A clock under the control of a simulation, so that the same seed gives the same study file.
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>

#include "app/session/session.h"

namespace tactus::session {

/// Time advances on request, and by one millisecond with each reading. Copies share the same time.
class SimulatedClock {
 public:
  explicit SimulatedClock(std::int64_t utc_ms) : now_(std::make_shared<study::Moment>(study::Moment{utc_ms, 0})) {}

  void pass(double seconds) const { passMs(std::llround(seconds * 1000)); }
  study::Moment look() const {
    passMs(1);
    return *now_;
  }
  /// Tools for a session, with ids derived from `seed`. Two sessions of one file need different seeds.
  SessionTools tools(std::uint64_t seed) const {
    return {[clock = *this] { return clock.look(); }, study::RecordIds(seed)};
  }

 private:
  void passMs(std::int64_t ms) const {
    now_->utc_ms += ms;
    now_->monotonic_ns += ms * 1'000'000;
  }

  std::shared_ptr<study::Moment> now_;
};

}  // namespace tactus::session
