// The recent motor load of each device, kept while the program runs.
#pragma once

#include <map>
#include <mutex>
#include <string>

#include "core/haptics/safety/thermal_budget.h"

namespace tactus::haptics {

/// Motors stay warm when a servo ends. The next servo on the same device continues with the budget stored here; the
/// time between counts as rest. All servos of a ledger use the same clock. The composition root owns the ledger of the
/// process and passes it on. Thread: any.
class ThermalLedger {
 public:
  /// The last stored budget of the device `id`; an unused one if the device is unknown.
  ThermalBudget of(const std::string& id) const;
  /// Stores the budget of a device. Call when the servo on it has ended.
  void keep(const std::string& id, const ThermalBudget& budget);

 private:
  mutable std::mutex mutex_;
  std::map<std::string, ThermalBudget> budgets_;
};

}  // namespace tactus::haptics
