// `tactus emulate`: a device of another maker, simulated on the same wire.
#include <cmath>
#include <limits>
#include <ostream>
#include <poll.h>

#include "app/cli/commands.h"
#include "app/cli/terminal.h"
#include "core/base/files/file.h"
#include "core/base/json/json_writer.h"
#include "core/haptics/haply/haply_device.h"

namespace tactus::cli {
namespace {

constexpr int kLookMs = 20;

/// What a person does in the self-test, again and again: waiting, away and back, the button, then holding still with
/// it.
haptics::HandPlan selfTestHand() {
  constexpr double kBeginS = 3;
  constexpr double kMoveS = 1;
  constexpr double kPressS = 6;
  constexpr double kHoldS = 7.5;
  constexpr double kPeriodS = 18;
  haptics::StrokeSeries series;
  series.length_mm = 50;
  const auto forth = haptics::stroke(series.length_mm, kMoveS);
  return [=](double time_s) -> haptics::HandTarget {
    const double t = std::fmod(time_s, kPeriodS);
    haptics::HandTarget wish = forth(t - kBeginS);
    if (t >= kBeginS + kMoveS) {
      const haptics::HandTarget back = forth(t - kBeginS - kMoveS);
      wish = {series.length_mm - back.position_mm, -back.speed_mm_s};
    }
    wish.button = (t >= kPressS && t < kPressS + 0.3) || (t >= kHoldS && t < kPeriodS - 1);
    return wish;
  };
}

haptics::HandPlan handOf(const std::string& name) {
  if (name == "still") return {};
  if (name == "self-test") return selfTestHand();
  haptics::StrokeSeries series;
  series.count = std::numeric_limits<int>::max();
  return haptics::strokes(series);
}

haptics::HaplyEmulatorSettings settingsOf(const EmulateHaplyOptions& options) {
  haptics::HaplyEmulatorSettings settings;
  settings.port = options.port;
  settings.devices = options.devices;
  settings.grip = !options.without_grip;
  settings.rate_hz = options.rate_hz;
  settings.late_s = 1e-3 * options.late_ms;
  settings.late_share = options.late_share;
  settings.dead_after_s = options.dead_after_s;
  settings.silent_after_s = options.silent_after_s;
  settings.plan = handOf(options.hand);
  settings.trace = !options.trace.empty();
  return settings;
}

std::string summaryOf(const haptics::HaplyEmulation& emulation) {
  base::JsonWriter json;
  json.beginObject().key("summary").beginObject().key("simulated").value(true);
  json.key("seconds").value(emulation.seconds).key("clients").value(static_cast<std::size_t>(emulation.clients));
  json.key("messages").value(static_cast<std::size_t>(emulation.messages));
  json.key("refused").value(static_cast<std::size_t>(emulation.refused)).key("devices").beginArray();
  for (const haptics::HaplyCommanded& device : emulation.devices) {
    json.beginObject(base::JsonWriter::Layout::kInline).key("device_id").value(device.id);
    json.key("forces").value(static_cast<std::size_t>(device.forces)).key("largest_n").value(device.largest_n);
    json.key("farthest_mm").value(device.farthest_mm).endObject();
  }
  return json.endArray().endObject().endObject().text();
}

}  // namespace

base::Result<Output> emulateHaply(const EmulateHaplyOptions& options, std::ostream& out) {
  const InterruptSignals signals;
  TACTUS_TRY(const auto emulator, haptics::HaplyEmulator::start(settingsOf(options)));
  out << "{\"listening\":{\"port\":" << emulator->port() << "},\"simulated\":true}\n" << std::flush;
  if (!out.good()) return Output{};  // the caller says so
  while (!signals.raised() && !emulator->isDead()) ::poll(nullptr, 0, kLookMs);
  if (!options.trace.empty()) {
    if (auto written = base::writeFileAtomically(options.trace, emulator->trace()); !written)
      return tl::unexpected(written.error());
  }
  return Output{summaryOf(emulator->summary()), {}};
}

}  // namespace tactus::cli
