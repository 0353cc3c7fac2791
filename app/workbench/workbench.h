// tactus-workbench as a whole: the bench with all its features, in their order.
#pragma once

#include "app/workbench/features/bench.h"

namespace tactus::workbench {

struct Workbench : Bench {
  /// Autosaved work is kept below `autosave_root`. The devices are those of `devices`.
  explicit Workbench(QSettings& settings, const QString& autosave_root = autosaveRoot(),
                     DeviceAccess devices = realDevices());
  /// Hides the window first: views that are hidden stop what the features compute, and those go before the window.
  ~Workbench();
};

}  // namespace tactus::workbench
