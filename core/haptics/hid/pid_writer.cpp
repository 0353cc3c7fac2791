#include "core/haptics/hid/pid_writer.h"

#include <algorithm>
#include <cmath>

#include "core/haptics/device/seconds.h"

namespace tactus::haptics {

std::array<double, 2> PidWriter::sharesOf(const Vector3& force_n) const {
  if (!std::isfinite(force_n.x) || !std::isfinite(force_n.y) || !std::isfinite(force_n.z)) return {};
  const auto axes = hidAxesOf({sign_.x * force_n.x, sign_.y * force_n.y, sign_.z * force_n.z});
  return {std::clamp(axes[0] / full_scale_n_, -1.0, 1.0), std::clamp(axes[1] / full_scale_n_, -1.0, 1.0)};
}

base::Result<void> PidWriter::step(std::int64_t now_ns) {
  const PidCommand& command = commands_.take();
  const double over_s = secondsBetween(command.time_ns, now_ns) - PidSession::kHoldS;
  const double left = command.valid ? std::clamp(1 - over_s / kLetGoS, 0.0, 1.0) : 0;
  command_ns_ = command.time_ns;
  auto shares = sharesOf(command.force_n);
  for (double& share : shares) share *= left;
  auto sent = session_.send(shares, now_ns);
  let_go_ = left == 0 && sent.has_value();
  return sent;
}

bool PidWriter::letsGo(std::int64_t now_ns) const noexcept {
  return !let_go_ && secondsBetween(command_ns_, now_ns) > PidSession::kHoldS;
}

}  // namespace tactus::haptics
