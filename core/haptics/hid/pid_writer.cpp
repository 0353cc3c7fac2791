#include "core/haptics/hid/pid_writer.h"

#include <algorithm>
#include <cmath>

namespace tactus::haptics {

std::array<double, 2> PidWriter::sharesOf(const Vector3& force_n) const {
  if (!std::isfinite(force_n.x) || !std::isfinite(force_n.y) || !std::isfinite(force_n.z)) return {};
  const auto axes = hidAxesOf({sign_.x * force_n.x, sign_.y * force_n.y, sign_.z * force_n.z});
  return {std::clamp(axes[0] / full_scale_n_, -1.0, 1.0), std::clamp(axes[1] / full_scale_n_, -1.0, 1.0)};
}

base::Result<void> PidWriter::step(std::int64_t now_ns) {
  const PidCommand& command = commands_.take();
  const bool alive = command.valid && now_ns - command.time_ns < kCommandLifeNs;
  return session_.send(alive ? sharesOf(command.force_n) : std::array<double, 2>{}, now_ns);
}

}  // namespace tactus::haptics
