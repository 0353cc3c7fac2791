// The thermal budget of a running servo, followed from its samples.
#pragma once

#include "core/haptics/safety/limit_settings.h"
#include "core/haptics/safety/thermal_budget.h"
#include "core/haptics/servo/sample.h"

namespace tactus::haptics {

/// Only the servo thread knows its budget. The reader of the samples needs it, too: how long a rest must be before the
/// next force (thermal_rest.h). Where samples were lost, the last force before the gap counts for the gap, for at most
/// 2 s. Plain state. Thread: the reader of the samples. Real-time safe: yes.
class ThermalFollower {
 public:
  /// `thermal`: the load before the servo started, from the ledger.
  explicit ThermalFollower(const ThermalBudget& thermal = {}) noexcept : budget_(thermal) {}

  /// All samples, oldest first. `limits`: those of the orders in effect.
  void add(const Sample& sample, const LimitSettings& limits) noexcept;

  /// The budget at the time of the last sample.
  const ThermalBudget& budget() const noexcept { return budget_; }

 private:
  ThermalBudget budget_;
  bool begun_ = false;
  std::int64_t last_ns_ = 0;
  double held_n_ = 0;
};

}  // namespace tactus::haptics
