#include "app/workbench/participant/device_button.h"

namespace tactus::workbench {
namespace {

constexpr std::uint32_t kFirstButton = 1;

double secondsBetween(std::int64_t from_ns, std::int64_t to_ns) { return static_cast<double>(to_ns - from_ns) * 1e-9; }

}  // namespace

std::optional<ButtonPress> DeviceButton::add(const haptics::Sample& sample) {
  const bool down = (sample.buttons & kFirstButton) != 0;
  if (!down_since_ns_) {
    if (!down) {
      if (!open_since_ns_) open_since_ns_ = sample.time_ns;
      return std::nullopt;
    }
    const bool settled = open_since_ns_ && secondsBetween(*open_since_ns_, sample.time_ns) >= kSettleS;
    down_since_ns_ = sample.time_ns;
    told_ = !settled;
    return std::nullopt;
  }
  const double down_s = secondsBetween(*down_since_ns_, sample.time_ns);
  if (down) {
    if (told_ || down_s < kHeldS) return std::nullopt;
    told_ = true;
    return ButtonPress::kHeld;
  }
  const bool tap = !told_ && down_s < kTapS;
  down_since_ns_.reset();
  // One tap may follow the other at once.
  if (!open_since_ns_) open_since_ns_ = sample.time_ns;
  return tap ? std::optional(ButtonPress::kTap) : std::nullopt;
}

}  // namespace tactus::workbench
