#include "core/haptics/safety/thermal_ledger.h"

namespace tactus::haptics {

ThermalBudget ThermalLedger::of(const std::string& id) const {
  const std::lock_guard lock(mutex_);
  const auto kept = budgets_.find(id);
  return kept == budgets_.end() ? ThermalBudget{} : kept->second;
}

void ThermalLedger::keep(const std::string& id, const ThermalBudget& budget) {
  const std::lock_guard lock(mutex_);
  budgets_[id] = budget;
}

}  // namespace tactus::haptics
