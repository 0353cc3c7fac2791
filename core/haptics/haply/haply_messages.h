// The messages of the Haply Inverse Service (JSON, format 3.1), read and written: those of the service and those of its
// clients. On the wire: meters, m/s and N; x to the right, y away from the user, z up. docs/devices.md, "Haply".
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/haptics/device/device.h"

namespace tactus::haptics {

/// The same vector in the frame of the project (device.h), and back. Exact.
constexpr Vector3 fromHaplyAxes(const Vector3& v) noexcept { return {v.x, v.z, -v.y}; }
constexpr Vector3 haplyAxesOf(const Vector3& v) noexcept { return {v.x, -v.z, v.y}; }

/// A message of the service about one device of the list `inverse3`. What the message does not say is absent.
struct HaplyReport {
  std::string id;                       ///< `device_id`
  std::optional<Vector3> position_m;    ///< `state.cursor_position`
  std::optional<Vector3> velocity_m_s;  ///< `state.cursor_velocity`
  std::optional<bool> is_calibrated;    ///< `status.calibrated`
  std::optional<bool> is_powered;       ///< `status.power_supply`
  std::optional<std::string> preset;    ///< `config.preset`: where the origin is
  std::optional<std::string> basis;     ///< `config.basis.permutation`: the order of the axes
  bool is_mounted_otherwise = false;    ///< `config.mount` turns or scales positions
  std::optional<bool> is_simulated;     ///< `config.simulated`, which only `tactus emulate haply` writes
};

/// One message of the service.
struct HaplyMessage {
  std::vector<HaplyReport> devices;
  std::vector<std::uint32_t> grips;  ///< pressed buttons of each grip, as bits; its first button is bit 0
  std::string error;                 ///< the sentence of a service that refuses; empty: none
};

/// Reads a message of the service. Unknown members are ignored. Refused: no JSON object, a list or a state of another
/// kind, a vector without one of its numbers, an entry without an id.
base::Result<HaplyMessage> readHaplyMessage(std::string_view text);

/// The command for a force on the hand, N, and the question for everything that the service knows.
std::string haplyForceText(std::string_view device_id, const Vector3& force_n);
std::string haplyProbeText(std::string_view device_id);
std::string haplyFullStateText();

/// A message of a client.
struct HaplyCommand {
  std::string id;
  std::optional<Vector3> force_n;  ///< nothing: it only asks for the state
};
struct HaplyRequest {
  std::vector<HaplyCommand> commands;
  bool wants_everything = false;
};
/// Reads a message of a client. Unknown members are ignored. Refused as in `readHaplyMessage`, and a force that is not
/// finite.
base::Result<HaplyRequest> readHaplyRequest(std::string_view text);

/// What the double of the service says of one device.
struct HaplyState {
  std::string id;
  Vector3 position_m;
  Vector3 velocity_m_s;
  Vector3 force_n;           ///< in effect
  std::optional<bool> grip;  ///< its first button is down; nothing: there is no grip
};
/// The message of the double. `with_config`: the first one, and the answer to a question for everything. `error`: a
/// sentence for a client that is refused; may be empty.
std::string haplyStateText(const std::vector<HaplyState>& devices, bool with_config, std::string_view error = {});

}  // namespace tactus::haptics
