// `tactus devices calibrate`: the guided calibration of a HID device; the insertion axis of one that its driver
// calibrates.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <ostream>
#include <sstream>
#include <vector>

#include "app/cli/device_commands.h"
#include "app/cli/interrupt_signals.h"
#include "app/cli/typed_lines.h"
#include "app/cli/wrapped_text.h"
#include "app/devices/calibration_run.h"
#include "app/devices/open_device.h"
#include "core/base/clock.h"
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
  const auto opened = devices::open(options.id, settings);
  if (!opened) return tl::unexpected(opened.error());
  if (const auto done = devices::calibrateByDriver(*opened->device, guide); !done) return tl::unexpected(done.error());
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
  if (!options.id.starts_with("openhaptics"))
    return base::fail(base::ErrorCode::kValue, options.id, "--inwards",
                      options.id.starts_with("hid:")
                          ? "a calibration, which measures the axis too (leave --inwards out)"
                          : "a device behind OpenHaptics");
  const auto axis = parseAxis(options.inwards);
  if (!axis) return tl::unexpected(axis.error());
  const auto opened = devices::open(options.id, settings);
  if (!opened) return tl::unexpected(opened.error());
  if (const auto made = makeFolderOf(settings.calibrations); !made) return tl::unexpected(made.error());
  const auto& info = opened->device->info();
  if (const auto stored = haptics::storeAxis(settings.calibrations, {info.id, info.serial, axis->inwards()}); !stored)
    return tl::unexpected(stored.error());
  return Output{options.id + ": the tube goes along " + devices::directionText(axis->inwards()) + "; stored in " +
                    settings.calibrations + "\nTest it: tactus devices test " + options.id + '\n',
                {}};
}

}  // namespace

base::Result<Output> calibrateDevice(const DeviceCalibrateOptions& options) {
  const auto settings = devices::settingsOfProcess();
  if (!options.inwards.empty()) return storeAxis(options, settings);
  if (!options.id.starts_with("hid:")) return byDriver(options, settings);
  const auto opened = devices::openRaw(options.id);
  if (!opened) return tl::unexpected(opened.error());
  if (const auto made = makeFolderOf(settings.calibrations); !made) return tl::unexpected(made.error());

  auto plan = haptics::planFor(opened->device->info());
  if (options.method == "weight") plan.method = haptics::ScaleMethod::kKnownWeight;
  CalibrationPrompt guide(options.terminal);
  guide.say(wrapped("Press Enter to continue. Type a number if asked. Type stop to end.", "", 0));
  const std::string now = base::formatUtc(std::chrono::system_clock::now());
  const auto calibration = devices::runCalibration(*opened->device, plan, now, guide);
  if (!calibration) return tl::unexpected(calibration.error());
  if (const auto stored = haptics::storeCalibration(settings.calibrations, *calibration); !stored)
    return tl::unexpected(stored.error());
  return Output{options.id + ": full scale " + base::formatFixed(calibration->full_scale_n, 2) + " N, " +
                    base::formatFixed(calibration->mm_per_count, 4) + " mm per count; stored in " +
                    settings.calibrations + "\nTest it: tactus devices test " + options.id + '\n',
                {}};
}

}  // namespace tactus::cli
