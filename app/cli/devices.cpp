// `tactus devices`: the list.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <ostream>
#include <sstream>
#include <thread>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/terminal.h"
#include "app/devices/device_list.h"
#include "app/devices/guided_runs.h"
#include "core/base/clock.h"
#include "core/base/error.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"

namespace tactus::cli {
namespace {

class CalibrationPrompt final : public devices::CalibrationGuide {
 public:
  explicit CalibrationPrompt(const Terminal& terminal) : terminal_(terminal), lines_(*terminal.in) {}

  void instruct(const std::string& sentence) override { say(wrapped(sentence, "> ", 2)); }
  void refuse(const std::string& sentence) override { say(wrapped(sentence, "! ", 2)); }
  std::optional<std::string> answer() override {
    const auto line = lines_.next();
    return !line && lines_.ended() ? "stop" : line;
  }
  bool interrupted() const noexcept override { return signals_.raised(); }

  void say(const std::string& text) { *terminal_.out << base::plainLines(text) << std::flush; }

 private:
  Terminal terminal_;
  TypedLines lines_;
  InterruptSignals signals_;
};

/// The folder of the file of calibrations may not be there yet.
base::Result<void> makeFolderOf(const std::string& file) {
  const auto folder = std::filesystem::path(file).parent_path();
  std::error_code error;
  if (!folder.empty()) std::filesystem::create_directories(folder, error);
  if (!error) return {};
  return base::fail(base::ErrorCode::kIo, folder.string(), error.message(), "a folder that can be made");
}

base::Result<Output> byDriver(const DeviceCalibrateOptions& options, const devices::DeviceSettings& settings) {
  CalibrationPrompt guide(options.terminal);
  TACTUS_TRY(const auto opened, devices::open(options.id, settings));
  if (const auto done = devices::calibrateByDriver(*opened.device, guide); !done) return tl::unexpected(done.error());
  return Output{options.id + ": calibrated by its driver\nTest it: tactus devices test " + options.id + '\n', {}};
}

/// The three numbers of `x,y,z`, as a direction.
base::Result<haptics::AxisMapping> parseAxis(const std::string& text) {
  std::vector<double> numbers;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const auto number = base::parseNumber(base::trimmed(part));
    if (number) numbers.push_back(*number);
    if (!number) break;
  }
  const bool three = numbers.size() == 3 && std::count(text.begin(), text.end(), ',') == 2;
  if (!three)
    return base::fail(base::ErrorCode::kValue, "--inwards", base::quoted(text), "three numbers such as 0,0,-1");
  return haptics::AxisMapping::make({numbers[0], numbers[1], numbers[2]});
}

base::Result<Output> storeAxis(const DeviceCalibrateOptions& options, const devices::DeviceSettings& settings) {
  if (!devices::hasOwnCalibration(options.id))
    return base::fail(base::ErrorCode::kValue, options.id, "--inwards",
                      options.id.starts_with("hid:")
                          ? "a calibration, which measures the axis too (leave --inwards out)"
                          : "a device behind OpenHaptics or the Haply service");
  TACTUS_TRY(const auto axis, parseAxis(options.inwards));
  TACTUS_TRY(const auto opened, devices::open(options.id, settings));
  if (const auto made = makeFolderOf(settings.calibrations); !made) return tl::unexpected(made.error());
  const auto& info = opened.device->info();
  if (const auto stored = haptics::storeAxis(settings.calibrations, {info.id, info.serial, axis.inwards()}); !stored)
    return tl::unexpected(stored.error());
  return Output{options.id + ": the tube goes along " + devices::directionText(axis.inwards()) + "; stored in " +
                    settings.calibrations + "\nTest it: tactus devices test " + options.id + '\n',
                {}};
}

}  // namespace

base::Result<Output> calibrateDevice(const DeviceCalibrateOptions& options) {
  const auto settings = devices::settingsOfProcess();
  if (!options.inwards.empty()) return storeAxis(options, settings);
  if (!options.id.starts_with("hid:")) return byDriver(options, settings);
  TACTUS_TRY(const auto opened, devices::openRaw(options.id));
  if (const auto made = makeFolderOf(settings.calibrations); !made) return tl::unexpected(made.error());

  auto plan = haptics::planFor(opened.device->info());
  if (options.method == "weight") plan.method = haptics::ScaleMethod::kKnownWeight;
  CalibrationPrompt guide(options.terminal);
  guide.say(wrapped("Press Enter to continue. Type a number if asked. Type stop to end.", "", 0));
  const std::string now = base::formatUtc(std::chrono::system_clock::now());
  TACTUS_TRY(const auto calibration, devices::runCalibration(*opened.device, plan, now, guide));
  if (const auto stored = haptics::storeCalibration(settings.calibrations, calibration); !stored)
    return tl::unexpected(stored.error());
  return Output{options.id + ": full scale " + base::formatFixed(calibration.full_scale_n, 2) + " N, " +
                    base::formatFixed(calibration.mm_per_count, 4) + " mm per count; stored in " +
                    settings.calibrations + "\nTest it: tactus devices test " + options.id + '\n',
                {}};
}

namespace {

using devices::CheckResult;
using devices::Felt;
using devices::SelfTest;

/// The conversation, line by line.
class SelfTestPrompt final : public devices::SelfTestGuide {
 public:
  explicit SelfTestPrompt(const Terminal& terminal) : terminal_(terminal), lines_(*terminal.in) {}

  void instruct(const std::string& sentence) override { say(wrapped(sentence, "> ", 2)); }

  void tell(const CheckResult& result) override {
    const std::string mark = result.passed ? "ok      " : "failed  ";
    say(wrapped(std::string(describe(result.check)) + ": " + result.found, mark, 8));
    if (!result.advice.empty()) say(wrapped("do: " + result.advice, "        ", 8));
  }

  Felt ask(const std::string& question) override {
    for (;;) {
      say(wrapped(question + " Type t (toward), a (away) or n (nothing).", "? ", 2));
      const auto line = nextLine();
      // Without a person to answer, no force was felt.
      if (!line) return Felt::kNothing;
      const std::string answer = base::lowered(base::trimmed(*line));
      if (answer == "t" || answer == "toward") return Felt::kToward;
      if (answer == "a" || answer == "away") return Felt::kAway;
      if (answer == "n" || answer == "nothing") return Felt::kNothing;
    }
  }

  bool interrupted() const noexcept override { return signals_.raised(); }

  void say(const std::string& text) { *terminal_.out << base::plainLines(text) << std::flush; }

 private:
  /// Waits for it; nothing: there is none, or the program is to end.
  std::optional<std::string> nextLine() {
    while (!interrupted()) {
      if (auto line = lines_.next(); line || lines_.ended()) return line;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return std::nullopt;
  }

  Terminal terminal_;
  TypedLines lines_;
  InterruptSignals signals_;
};

std::string chosenId(const devices::DeviceSettings& settings) {
  for (const auto& device : devices::listDevices(settings).devices) {
    if (device.usable) return device.id;
  }
  return "virtual";
}

std::string asJson(const haptics::DeviceInfo& info, const SelfTest& test) {
  base::JsonWriter json;
  json.beginObject().key("id").value(info.id).key("name").value(info.name).key("serial").value(info.serial);
  json.key("simulated").value(info.simulated).key("passed").value(test.passed()).key("checks").beginArray();
  for (const auto& result : test.results()) {
    json.beginObject().key("check").value(describe(result.check)).key("passed").value(result.passed);
    json.key("found").value(result.found).key("advice").value(result.advice).endObject();
  }
  return json.endArray().endObject().text();
}

base::Result<SelfTest> run(const devices::OpenedDevice& opened, SelfTestPrompt& guide) {
  const haptics::DeviceInfo& info = opened.device->info();
  auto settings = devices::settingsFor(info);
  settings.axis = opened.axis;
  settings.axis_advice = opened.axis_advice;
  if (!opened.calibration_advice.empty()) settings.calibration_advice = opened.calibration_advice;
  guide.say(wrapped(info.backend == "virtual" ? "This device is simulated, and so is the person who holds it."
                    : info.simulated          ? "This device is simulated: its hand moves by itself."
                                     : "No force above 0.1 N is asked for. Letting the button go ends every force.",
                    "", 0));
  return devices::selfTest(*opened.device, settings, guide);
}

}  // namespace

base::Result<Output> testDevice(const DeviceTestOptions& options) {
  const auto settings = devices::settingsOfProcess();
  const std::string id = options.id.empty() ? chosenId(settings) : options.id;
  TACTUS_TRY(const auto opened, devices::open(id, settings));
  const auto& info = opened.device->info();

  SelfTestPrompt guide(options.terminal);
  guide.say(wrapped(info.id + ": " + info.name, "Self-test of ", 2));
  TACTUS_TRY(const auto test, run(opened, guide));
  if (test.passed()) {
    const std::string text = std::string("All checks passed") + (info.simulated ? ", all of it simulated.\n" : ".\n");
    return Output{options.json ? asJson(info, test) : text, {}};
  }
  if (options.json) *options.results << asJson(info, test) << std::flush;
  const auto& failed = test.results().back();
  return base::fail(base::ErrorCode::kMismatch, info.id + ": " + std::string(describe(failed.check)), failed.found,
                    "a check that passes: " + failed.advice);
}

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
    if (device.round_trip_s && device.largest_stiffness_n_mm)
      text += "  measured: it replies within " + base::formatFixed(1e3 * *device.round_trip_s, 2) +
              " ms, so a tube is rendered with at most " + base::formatFixed(*device.largest_stiffness_n_mm, 2) +
              " N/mm\n";
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
    json.key("usable").value(device.usable).key("calibrated").value(device.calibrated).key("used_by");
    device.used_by.empty() ? json.null() : json.value(device.used_by);
    json.key("reason").value(device.reason).key("advice").value(device.advice);
    const auto round_trip_s = device.round_trip_s;
    json.key("round_trip_ms").value(round_trip_s ? std::optional(1e3 * *round_trip_s) : std::nullopt);
    json.key("largest_stiffness_n_mm").value(device.largest_stiffness_n_mm).endObject();
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
