#include "core/haptics/device/calibration_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "core/base/check.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/json/json_document.h"
#include "core/base/json/json_members.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"

namespace tactus::haptics {
namespace {

using base::ErrorCode;
using base::Result;

constexpr double kUnitTolerance = 1e-6;  // a direction that went through a text of six digits is still one

Result<void> inRange(const char* key, double value, double low, double high) {
  if (value >= low && value <= high) return {};
  return base::fail(ErrorCode::kValue, key, base::formatNumber(value),
                    "a number from " + base::formatNumber(low) + " to " + base::formatNumber(high));
}

bool isSign(double value) { return value == 1 || value == -1; }

}  // namespace

Result<void> checkCalibration(const DeviceCalibration& c) {
  if (c.device.empty()) return base::fail(ErrorCode::kValue, "device", "nothing", "the id of a device");
  if (auto ok = inRange("full_scale_n", c.full_scale_n, 0.05, 500); !ok) return ok;
  if (auto ok = inRange("mm_per_count", c.mm_per_count, 1e-6, 100); !ok) return ok;
  if (!isSign(c.force_sign.x) || !isSign(c.force_sign.y) || !isSign(c.force_sign.z))
    return base::fail(ErrorCode::kValue, "force_sign", "another number", "1 or -1 three times");
  if (auto ok = checkDirection("inwards", c.inwards); !ok) return ok;
  for (const double coordinate : {c.origin_mm.x, c.origin_mm.y, c.origin_mm.z}) {
    if (auto ok = inRange("origin_mm", coordinate, -1e5, 1e5); !ok) return ok;
  }
  if (c.friction_in_n) {
    if (auto ok = inRange("friction_in_n", *c.friction_in_n, 0, c.full_scale_n); !ok) return ok;
  }
  if (c.friction_out_n) return inRange("friction_out_n", *c.friction_out_n, 0, c.full_scale_n);
  return {};
}

Result<void> checkDirection(const char* key, const Vector3& direction) {
  const double length = std::sqrt(dot(direction, direction));
  if (std::abs(length - 1) <= kUnitTolerance) return {};
  return base::fail(ErrorCode::kValue, key, "a vector of length " + base::formatNumber(length), "length 1");
}

AxisMapping axisOf(const DeviceCalibration& calibration) {
  auto axis = AxisMapping::make(calibration.inwards, calibration.origin_mm);
  TACTUS_CHECK(axis);
  return *axis;
}

namespace {

using base::ErrorCode;
using base::JsonMembers;
using base::JsonValue;
using base::required;
using base::Result;

constexpr std::size_t kMostBytes = std::size_t{1} << 20U;
constexpr int kVersion = 1;
constexpr const char* kVersionKey = "tactus_devices";
constexpr const char* kCalibrationsKey = "devices";
constexpr const char* kAxesKey = "axes";

void vector(JsonMembers& members, const char* key, Vector3& target) {
  std::vector<double> numbers;
  members.numbers(required(key), numbers);
  if (numbers.size() != 3) return members.refuse(key, std::to_string(numbers.size()) + " numbers", "three numbers");
  target = {numbers[0], numbers[1], numbers[2]};
}

/// What is wrong with the values of an entry, said of the entry.
void note(std::optional<base::Error>& error, const JsonValue& json, const Result<void>& checked) {
  if (error || checked) return;
  error = checked.error();
  error->place = base::childPointer(json.pointer(), error->place);
}

DeviceCalibration readCalibration(const JsonValue& json, std::optional<base::Error>& error) {
  JsonMembers members(json, error);
  DeviceCalibration entry;
  members.text(required("device"), entry.device);
  members.textOrEmpty(required("serial"), entry.serial);
  members.number(required("full_scale_n"), entry.full_scale_n);
  vector(members, "force_sign", entry.force_sign);
  members.number(required("mm_per_count"), entry.mm_per_count);
  vector(members, "inwards", entry.inwards);
  vector(members, "origin_mm", entry.origin_mm);
  members.numberOrNull(required("friction_in_n"), entry.friction_in_n);
  members.numberOrNull(required("friction_out_n"), entry.friction_out_n);
  members.flag(required("silent_when_still"), entry.silent_when_still);
  members.textOrEmpty(required("measured_at"), entry.measured_at);
  members.textOrEmpty(required("procedure"), entry.procedure);
  members.refuseOthers();
  if (!error) note(error, json, checkCalibration(entry));
  return entry;
}

DeviceAxis readAxis(const JsonValue& json, std::optional<base::Error>& error) {
  JsonMembers members(json, error);
  DeviceAxis entry;
  members.text(required("device"), entry.device);
  members.textOrEmpty(required("serial"), entry.serial);
  vector(members, "inwards", entry.inwards);
  members.refuseOthers();
  if (!error) note(error, json, checkDirection("inwards", entry.inwards));
  return entry;
}

template <class Entry>
const Entry* find(const std::vector<Entry>& entries, std::string_view device, std::string_view serial) {
  const auto same = [&](const Entry& entry) { return entry.device == device && entry.serial == serial; };
  const auto found = std::find_if(entries.begin(), entries.end(), same);
  return found == entries.end() ? nullptr : &*found;
}

/// Adds what `read` makes of each element of the array `key`.
template <class Entry, class Read>
void readEntries(JsonMembers& file, base::JsonKey key, std::vector<Entry>& entries, std::optional<base::Error>& error,
                 Read read) {
  for (const JsonValue& element : file.elements(key)) {
    Entry entry = read(element, error);
    if (error) return;
    if (find(entries, entry.device, entry.serial) != nullptr) {
      error = base::fail(ErrorCode::kSchema, element.pointer(), "a second entry of " + base::quoted(entry.device),
                         "one entry per device and serial number")
                  .value();
      return;
    }
    entries.push_back(std::move(entry));
  }
}

Result<CalibrationFile> parse(const std::string& text) {
  TACTUS_TRY(const auto document, base::JsonDocument::parse(text));
  std::optional<base::Error> error;
  CalibrationFile file;
  JsonMembers members(document.root(), error);
  members.version(required(kVersionKey));
  readEntries(members, required(kCalibrationsKey), file.calibrations, error, readCalibration);
  readEntries(members, kAxesKey, file.axes, error, readAxis);
  members.refuseOthers();
  if (error) return tl::unexpected(*error);
  return file;
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

std::string format(const CalibrationFile& file) {
  base::JsonWriter json;
  json.beginObject().key(kVersionKey).value(kVersion).key(kCalibrationsKey).beginArray();
  for (const DeviceCalibration& entry : file.calibrations) {
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
  json.endArray().key(kAxesKey).beginArray();
  for (const DeviceAxis& entry : file.axes) {
    json.beginObject().key("device").value(entry.device).key("serial").value(entry.serial);
    writeVector(json, "inwards", entry.inwards);
    json.endObject();
  }
  return json.endArray().endObject().text();
}

/// Puts `entry` into the list `entries` of the file, in the place of an older one.
template <class Entry>
Result<void> store(const std::string& path, const Entry& entry, std::vector<Entry> CalibrationFile::*entries) {
  TACTUS_TRY(auto file, readCalibrationFile(path));
  std::vector<Entry>& list = file.*entries;
  const Entry* const older = find(list, entry.device, entry.serial);
  if (older != nullptr) {
    list[static_cast<std::size_t>(older - list.data())] = entry;
  } else {
    list.push_back(entry);
  }
  return base::writeFileAtomically(path, format(file));
}

}  // namespace

Result<CalibrationFile> readCalibrationFile(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored) && !ignored) return CalibrationFile();
  TACTUS_TRY(const auto text, base::readFile(path, kMostBytes));
  auto file = parse(text);
  if (!file) return base::inFile(file.error(), path);
  return file;
}

Result<void> storeCalibration(const std::string& path, const DeviceCalibration& calibration) {
  if (auto ok = checkCalibration(calibration); !ok) return ok;
  return store(path, calibration, &CalibrationFile::calibrations);
}

Result<void> storeAxis(const std::string& path, const DeviceAxis& axis) {
  if (auto ok = checkDirection("inwards", axis.inwards); !ok) return ok;
  return store(path, axis, &CalibrationFile::axes);
}

const DeviceCalibration* findCalibration(const std::vector<DeviceCalibration>& entries, std::string_view device,
                                         std::string_view serial) {
  return find(entries, device, serial);
}

const DeviceAxis* findAxis(const std::vector<DeviceAxis>& entries, std::string_view device, std::string_view serial) {
  return find(entries, device, serial);
}

}  // namespace tactus::haptics
