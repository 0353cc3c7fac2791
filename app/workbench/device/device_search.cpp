#include "app/workbench/device/device_search.h"

#include <chrono>

namespace tactus::workbench {

DeviceAccess realDevices() {
  // A device behind a driver may take seconds; the virtual one is there at once.
  DeviceAccess access;
  access.open_device = [](const std::string& id) { return devices::open(id, devices::settingsOfProcess()); };
  access.make_loop = threadedLoop;
  access.is_slow = [](const std::string& id) { return id != "virtual"; };
  return access;
}

namespace {

constexpr int kPollMs = 50;

}  // namespace

DeviceSearch::DeviceSearch(QObject* parent) : QObject(parent), list_(devices::listOf({}, {}, {}, {})) {
  // What was not looked for yet is nothing to remark on.
  list_.notes.clear();
  poll_.setInterval(kPollMs);
  connect(&poll_, &QTimer::timeout, this, &DeviceSearch::look);
}

void DeviceSearch::search() {
  if (isSearching()) return;
  pending_ = std::async(std::launch::async,
                        [settings = devices::settingsOfProcess()] { return devices::listDevices(settings); });
  poll_.start();
  emit searching();
}

void DeviceSearch::look() {
  if (pending_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
  poll_.stop();
  list_ = pending_.get();
  emit found();
}

}  // namespace tactus::workbench
