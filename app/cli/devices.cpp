// `tactus devices`: the list.
#include "app/cli/device_commands.h"
#include "app/cli/wrapped_text.h"
#include "app/devices/device_list.h"
#include "core/base/json/json_writer.h"

namespace tactus::cli {
namespace {

using devices::DeviceList;
using devices::ListedDevice;

std::string state(const ListedDevice& device) {
  if (!device.usable) return "cannot be used";
  if (device.simulated) return "ready (simulated)";
  return device.calibrated.value_or(true) ? "ready" : "not calibrated";
}

std::string asText(const DeviceList& list) {
  std::string text;
  for (const auto& device : list.devices) {
    text += base::oneLine(device.id + ": " + device.name);
    if (!device.serial.empty()) text += base::oneLine(", serial number " + device.serial);
    text += ", " + state(device) + '\n';
    if (!device.reason.empty()) text += wrapped(base::oneLine(device.reason), "  why: ", 7);
    if (!device.advice.empty()) text += wrapped(base::oneLine(device.advice), "  do: ", 6);
  }
  for (const auto& note : list.notes) text += wrapped(base::oneLine(note), "note: ", 6);
  return text;
}

std::string asJson(const DeviceList& list) {
  base::JsonWriter json;
  json.beginObject().key("devices").beginArray();
  for (const auto& device : list.devices) {
    json.beginObject().key("id").value(device.id).key("name").value(device.name).key("serial").value(device.serial);
    json.key("backend").value(device.backend).key("simulated").value(device.simulated);
    json.key("usable").value(device.usable).key("calibrated");
    device.calibrated ? json.value(*device.calibrated) : json.null();
    json.key("used_by");
    device.used_by.empty() ? json.null() : json.value(device.used_by);
    json.key("reason").value(device.reason).key("advice").value(device.advice).endObject();
  }
  json.endArray().key("notes").values(list.notes);
  return json.endObject().text();
}

}  // namespace

base::Result<Output> devices(const DevicesOptions& options) {
  const DeviceList list = devices::listDevices(devices::settingsOfProcess());
  return Output{options.json ? asJson(list) : asText(list), {}};
}

}  // namespace tactus::cli
