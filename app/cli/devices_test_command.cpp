// `tactus devices test`: the guided self-test.
#include <chrono>
#include <ostream>
#include <thread>

#include "app/cli/device_commands.h"
#include "app/cli/interrupt_signals.h"
#include "app/cli/typed_lines.h"
#include "app/cli/wrapped_text.h"
#include "app/devices/open_device.h"
#include "app/devices/self_test_run.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"

namespace tactus::cli {
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
  auto settings = devices::settingsFor(opened.device->info());
  settings.axis = opened.axis;
  settings.axis_advice = opened.axis_advice;
  if (!opened.calibration_advice.empty()) settings.calibration_advice = opened.calibration_advice;
  guide.say(wrapped(opened.device->info().simulated
                        ? "This device is simulated, and so is the person who holds it."
                        : "No force above 0.1 N is asked for. Letting the button go ends every force.",
                    "", 0));
  return devices::selfTest(*opened.device, settings, guide);
}

}  // namespace

base::Result<Output> testDevice(const DeviceTestOptions& options) {
  const auto settings = devices::settingsOfProcess();
  const std::string id = options.id.empty() ? chosenId(settings) : options.id;
  const auto opened = devices::open(id, settings);
  if (!opened) return tl::unexpected(opened.error());
  const auto& info = opened->device->info();

  SelfTestPrompt guide(options.terminal);
  guide.say(wrapped(info.id + ": " + info.name, "Self-test of ", 2));
  const auto test = run(*opened, guide);
  if (!test) return tl::unexpected(test.error());
  if (test->passed()) {
    const std::string text = std::string("All checks passed") + (info.simulated ? ", all of it simulated.\n" : ".\n");
    return Output{options.json ? asJson(info, *test) : text, {}};
  }
  if (options.json) *options.results << asJson(info, *test) << std::flush;
  const auto& failed = test->results().back();
  return base::fail(base::ErrorCode::kMismatch, info.id + ": " + std::string(describe(failed.check)), failed.found,
                    "a check that passes: " + failed.advice);
}

}  // namespace tactus::cli
