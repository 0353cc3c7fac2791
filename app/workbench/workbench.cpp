#include "app/workbench/workbench.h"

#include <utility>

#include "app/workbench/features/features.h"

namespace tactus::workbench {

Workbench::Workbench(QSettings& user_settings, const QString& autosave_root, DeviceAccess devices)
    : Bench(user_settings, autosave_root, std::move(devices)) {
  addFeatures(*this);
}

Workbench::~Workbench() { window.hide(); }

}  // namespace tactus::workbench
