#include "core/haptics/device_calibration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/check.h"
#include "core/base/file.h"
#include "core/base/json_pointer.h"
#include "core/base/json_writer.h"
#include "core/base/text.h"

namespace tactus::haptics {
namespace {

using Json = nlohmann::json;
using base::ErrorCode;
using base::Result;

constexpr std::size_t kMostBytes = std::size_t{1} << 20U;
constexpr long long kVersion = 1;
constexpr const char* kVersionKey = "tactus_devices";
constexpr double kUnitTolerance = 1e-6;  // a direction that went through a text of six digits is still one

Result<void> inRange(const char* key, double value, double low, double high) {
  if (value >= low && value <= high) return {};
  return base::fail(ErrorCode::kValue, key, base::formatNumber(value),
                    "a number from " + base::formatNumber(low) + " to " + base::formatNumber(high));
}

bool isSign(double value) { return value == 1 || value == -1; }

/// Reads the keys of one object and remembers the first error.
class EntryReader {
 public:
  EntryReader(const Json& json, std::string place) : json_(json), place_(std::move(place)) {
    if (!json.is_object()) note("", describe(json), "an object");
  }

  std::string text(const char* key) {
    const Json* value = find(key);
    if (value != nullptr && !value->is_string()) note(key, describe(*value), "a string");
    return value != nullptr && value->is_string() ? value->get<std::string>() : std::string();
  }
  double number(const char* key) {
    const Json* value = find(key);
    if (value != nullptr && !value->is_number()) note(key, describe(*value), "a number");
    return value != nullptr && value->is_number() ? value->get<double>() : 0;
  }
  std::optional<double> optionalNumber(const char* key) {
    const Json* value = find(key);
    if (value == nullptr || value->is_null()) return std::nullopt;
    return number(key);
  }
  bool flag(const char* key) {
    const Json* value = find(key);
    if (value != nullptr && !value->is_boolean()) note(key, describe(*value), "true or false");
    return value != nullptr && value->is_boolean() && value->get<bool>();
  }
  Vector3 vector(const char* key) {
    const Json* value = find(key);
    if (value == nullptr) return {};
    const auto is_number = [](const Json& element) { return element.is_number(); };
    if (!value->is_array() || value->size() != 3 || !std::all_of(value->begin(), value->end(), is_number)) {
      note(key, describe(*value), "three numbers");
      return {};
    }
    return {(*value)[0].get<double>(), (*value)[1].get<double>(), (*value)[2].get<double>()};
  }

  /// To be called last: keys that nobody asked for are errors too.
  Result<void> done() {
    if (!error_ && json_.is_object()) {
      for (const auto& [key, value] : json_.items()) {
        if (!asked_.contains(key)) note(key, "an unknown key", "one of " + base::joined(asked_, ", "));
      }
    }
    if (error_) return tl::unexpected(*error_);
    return {};
  }

  static std::string describe(const Json& json) {
    return json.is_primitive() ? base::quoted(json.dump(-1, ' ', false, Json::error_handler_t::replace))
                               : std::string("an ") + json.type_name();
  }

 private:
  const Json* find(const char* key) {
    asked_.insert(key);
    if (!json_.is_object()) return nullptr;
    const auto found = json_.find(key);
    if (found != json_.end()) return &*found;
    note(key, "nothing", "a value");
    return nullptr;
  }
  void note(std::string_view key, std::string found, std::string wanted) {
    if (error_) return;
    error_ = base::fail(ErrorCode::kSchema, key.empty() ? place_ : base::childPointer(place_, key), std::move(found),
                        std::move(wanted))
                 .value();
  }

  const Json& json_;
  std::string place_;
  std::set<std::string> asked_;
  std::optional<base::Error> error_;
};

Result<DeviceCalibration> readEntry(const Json& json, const std::string& place) {
  EntryReader reader(json, place);
  DeviceCalibration entry;
  entry.device = reader.text("device");
  entry.serial = reader.text("serial");
  entry.full_scale_n = reader.number("full_scale_n");
  entry.force_sign = reader.vector("force_sign");
  entry.mm_per_count = reader.number("mm_per_count");
  entry.inwards = reader.vector("inwards");
  entry.origin_mm = reader.vector("origin_mm");
  entry.friction_in_n = reader.optionalNumber("friction_in_n");
  entry.friction_out_n = reader.optionalNumber("friction_out_n");
  entry.silent_when_still = reader.flag("silent_when_still");
  entry.measured_at = reader.text("measured_at");
  entry.procedure = reader.text("procedure");
  if (auto done = reader.done(); !done) return tl::unexpected(done.error());
  if (auto checked = checkCalibration(entry); !checked) {
    auto error = checked.error();
    error.place = base::childPointer(place, error.place);
    return tl::unexpected(error);
  }
  return entry;
}

Result<std::vector<DeviceCalibration>> parse(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) return base::fail(ErrorCode::kSyntax, "", "text that is not JSON", "a calibration file");
  const Json* version = json.is_object() && json.contains(kVersionKey) ? &json[kVersionKey] : nullptr;
  if (version == nullptr || !version->is_number_integer())
    return base::fail(ErrorCode::kSchema, "", "no whole number under 'tactus_devices'", "a calibration file");
  if (*version != kVersion)
    return base::fail(ErrorCode::kVersion, "/tactus_devices", version->dump(), std::to_string(kVersion));
  if (!json.contains("devices") || !json["devices"].is_array() || json.size() != 2)
    return base::fail(ErrorCode::kSchema, "", "other keys", "'tactus_devices' and an array 'devices'");
  std::vector<DeviceCalibration> entries;
  for (const Json& element : json["devices"]) {
    const std::string place = base::childPointer("/devices", entries.size());
    auto entry = readEntry(element, place);
    if (!entry) return tl::unexpected(entry.error());
    if (findCalibration(entries, entry->device, entry->serial) != nullptr)
      return base::fail(ErrorCode::kSchema, place, "a second entry of " + base::quoted(entry->device),
                        "one entry per device and serial number");
    entries.push_back(*std::move(entry));
  }
  return entries;
}

void writeVector(base::JsonWriter& json, const char* key, const Vector3& v) {
  json.key(key).values(std::array{v.x, v.y, v.z});
}

void writeOptional(base::JsonWriter& json, const char* key, const std::optional<double>& value) {
  json.key(key);
  if (value) {
    json.value(*value);
  } else {
    json.null();
  }
}

std::string format(const std::vector<DeviceCalibration>& entries) {
  base::JsonWriter json;
  json.beginObject().key(kVersionKey).value(kVersion).key("devices").beginArray();
  for (const DeviceCalibration& entry : entries) {
    json.beginObject().key("device").value(entry.device).key("serial").value(entry.serial);
    json.key("full_scale_n").value(entry.full_scale_n);
    writeVector(json, "force_sign", entry.force_sign);
    json.key("mm_per_count").value(entry.mm_per_count);
    writeVector(json, "inwards", entry.inwards);
    writeVector(json, "origin_mm", entry.origin_mm);
    writeOptional(json, "friction_in_n", entry.friction_in_n);
    writeOptional(json, "friction_out_n", entry.friction_out_n);
    json.key("silent_when_still").value(entry.silent_when_still);
    json.key("measured_at").value(entry.measured_at).key("procedure").value(entry.procedure).endObject();
  }
  return json.endArray().endObject().text();
}

}  // namespace

Result<void> checkCalibration(const DeviceCalibration& c) {
  if (c.device.empty()) return base::fail(ErrorCode::kValue, "device", "nothing", "the id of a device");
  if (auto ok = inRange("full_scale_n", c.full_scale_n, 0.05, 500); !ok) return ok;
  if (auto ok = inRange("mm_per_count", c.mm_per_count, 1e-6, 100); !ok) return ok;
  if (!isSign(c.force_sign.x) || !isSign(c.force_sign.y) || !isSign(c.force_sign.z))
    return base::fail(ErrorCode::kValue, "force_sign", "another number", "1 or -1 three times");
  const double length = std::sqrt(dot(c.inwards, c.inwards));
  if (!(std::abs(length - 1) <= kUnitTolerance))
    return base::fail(ErrorCode::kValue, "inwards", "a vector of length " + base::formatNumber(length), "length 1");
  for (const double coordinate : {c.origin_mm.x, c.origin_mm.y, c.origin_mm.z}) {
    if (auto ok = inRange("origin_mm", coordinate, -1e5, 1e5); !ok) return ok;
  }
  if (c.friction_in_n) {
    if (auto ok = inRange("friction_in_n", *c.friction_in_n, 0, c.full_scale_n); !ok) return ok;
  }
  if (c.friction_out_n) return inRange("friction_out_n", *c.friction_out_n, 0, c.full_scale_n);
  return {};
}

AxisMapping axisOf(const DeviceCalibration& calibration) {
  auto axis = AxisMapping::make(calibration.inwards, calibration.origin_mm);
  TACTUS_CHECK(axis);
  return *axis;
}

Result<std::vector<DeviceCalibration>> readCalibrations(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored) && !ignored) return std::vector<DeviceCalibration>();
  auto text = base::readFile(path, kMostBytes);
  if (!text) return tl::unexpected(text.error());
  auto entries = parse(*text);
  if (!entries) return base::inFile(entries.error(), path);
  return entries;
}

Result<void> storeCalibration(const std::string& path, const DeviceCalibration& calibration) {
  if (auto ok = checkCalibration(calibration); !ok) return ok;
  auto entries = readCalibrations(path);
  if (!entries) return tl::unexpected(entries.error());
  const auto same = std::find_if(entries->begin(), entries->end(), [&](const DeviceCalibration& entry) {
    return entry.device == calibration.device && entry.serial == calibration.serial;
  });
  if (same != entries->end()) {
    *same = calibration;
  } else {
    entries->push_back(calibration);
  }
  return base::writeFileAtomically(path, format(*entries));
}

const DeviceCalibration* findCalibration(const std::vector<DeviceCalibration>& entries, std::string_view device,
                                         std::string_view serial) {
  for (const DeviceCalibration& entry : entries) {
    if (entry.device == device && entry.serial == serial) return &entry;
  }
  return nullptr;
}

}  // namespace tactus::haptics
