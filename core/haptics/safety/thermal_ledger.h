// What the motors of each device have given lately, kept while the program runs.
#pragma once

#include <map>
#include <mutex>
#include <string>

#include "core/haptics/safety/thermal_budget.h"

namespace tactus::haptics {

/// Motors stay warm when a servo ends: the next one on the same device goes on with the budget that is written down
/// here, and the time in between counts as rest. All servos of a ledger tell the time by the same clock. The
/// composition root owns the one of the process and hands it down. Thread: any.
class ThermalLedger {
 public:
  /// The budget of the device `id` as it was kept last; an untouched one for a device that is not known.
  ThermalBudget of(const std::string& id) const;
  /// A servo on the device has ended.
  void keep(const std::string& id, const ThermalBudget& budget);

 private:
  mutable std::mutex mutex_;
  std::map<std::string, ThermalBudget> budgets_;
};

}  // namespace tactus::haptics
