#include "core/haptics/haply/haply_messages.h"

#include <array>
#include <cmath>

#include "core/base/json/json_members.h"
#include "core/base/json/json_writer.h"

namespace tactus::haptics {
namespace {

using base::JsonMembers;
using base::JsonValue;
using base::required;

constexpr const char* kPlace = "message";

/// The names of buttons in the order of their bits. Clients of several versions use the one or the other.
constexpr std::array<std::array<std::string_view, 2>, 4> kButtons = {
    {{"a", "button_0"}, {"b", "button_1"}, {"c", "button_2"}, {"d", "button_3"}}};

/// The member, which is an object; `null` counts as absent.
std::optional<JsonValue> partOf(JsonMembers& members, const char* key) {
  const auto value = members.child(key);
  if (!value || value->kind() == base::JsonKind::kNull) return std::nullopt;
  return members.object(key);
}

std::vector<JsonValue> listOf(JsonMembers& members, const char* key) {
  const auto value = members.child(key);
  if (!value || value->kind() == base::JsonKind::kNull) return {};
  return members.elements(key);
}

std::optional<Vector3> vectorOf(JsonMembers& members, const char* key, std::optional<base::Error>& error) {
  const auto value = partOf(members, key);
  if (!value) return std::nullopt;
  JsonMembers numbers(*value, error);
  Vector3 vector;
  numbers.number(required("x"), vector.x);
  numbers.number(required("y"), vector.y);
  numbers.number(required("z"), vector.z);
  return vector;
}

// What is only of interest if it is there: another kind of value counts as absent.

std::optional<JsonValue> found(const std::optional<JsonValue>& object, std::string_view key) {
  return object && object->kind() == base::JsonKind::kObject ? object->find(key) : std::nullopt;
}

std::optional<std::string> foundText(const std::optional<JsonValue>& object, std::string_view key) {
  const auto value = found(object, key);
  if (!value || value->kind() != base::JsonKind::kString) return std::nullopt;
  return std::string(value->text());
}

std::optional<bool> foundFlag(const std::optional<JsonValue>& object, std::string_view key) {
  const auto value = found(object, key);
  if (value && value->kind() == base::JsonKind::kTrue) return true;
  if (value && value->kind() == base::JsonKind::kFalse) return false;
  return std::nullopt;
}

bool differs(const std::optional<JsonValue>& vector, std::string_view key, double usual) {
  const auto value = found(vector, key);
  return value && value->kind() == base::JsonKind::kNumber && std::abs(value->number() - usual) > 1e-6;
}

bool isMountedOtherwise(const std::optional<JsonValue>& mount) {
  bool otherwise = false;
  for (const char* const axis : {"x", "y", "z"})
    otherwise = otherwise || differs(found(mount, "scale"), axis, 1) || differs(found(mount, "rotation"), axis, 0);
  return otherwise;
}

HaplyReport readReport(const JsonValue& value, std::optional<base::Error>& error) {
  HaplyReport report;
  JsonMembers entry(value, error);
  entry.text(required("device_id"), report.id);
  if (const auto state = partOf(entry, "state")) {
    JsonMembers members(*state, error);
    report.position_m = vectorOf(members, "cursor_position", error);
    report.velocity_m_s = vectorOf(members, "cursor_velocity", error);
  }
  const auto status = found(value, "status");
  report.is_calibrated = foundFlag(status, "calibrated");
  report.is_powered = foundFlag(status, "power_supply");
  const auto config = found(value, "config");
  report.preset = foundText(config, "preset");
  report.basis = foundText(found(config, "basis"), "permutation");
  report.is_mounted_otherwise = isMountedOtherwise(found(config, "mount"));
  if (config) report.is_simulated = foundFlag(config, "simulated").value_or(false);
  return report;
}

std::uint32_t readButtons(const JsonValue& grip) {
  std::uint32_t pressed = 0;
  const auto buttons = found(found(grip, "state"), "buttons");
  for (std::size_t bit = 0; bit < kButtons.size(); ++bit) {
    for (const std::string_view name : kButtons[bit]) {
      if (foundFlag(buttons, name).value_or(false)) pressed |= std::uint32_t{1} << bit;
    }
  }
  return pressed;
}

/// A service says it in a text, or in an object with a text.
void readError(JsonMembers& members, std::string& sentence) {
  const auto value = members.child("error");
  if (!value || value->kind() == base::JsonKind::kNull) return;
  sentence = foundText(value, "message").value_or(std::string(value->text()));
  if (sentence.empty()) sentence = "an error without a sentence";
}

std::string vectorText(const Vector3& v) {
  return "{\"x\":" + base::jsonNumber(v.x) + ",\"y\":" + base::jsonNumber(v.y) + ",\"z\":" + base::jsonNumber(v.z) +
         '}';
}

std::string commandText(std::string_view device_id, const std::string& command) {
  return "{\"inverse3\":[{\"device_id\":" + base::jsonString(device_id) + ",\"commands\":{" + command + "}}]}";
}

}  // namespace

base::Result<HaplyMessage> readHaplyMessage(std::string_view text) {
  return base::readJson(text, kPlace, [](JsonMembers& members, std::optional<base::Error>& error) {
    HaplyMessage message;
    for (const JsonValue& entry : listOf(members, "inverse3")) message.devices.push_back(readReport(entry, error));
    for (const JsonValue& grip : listOf(members, "wireless_verse_grip")) message.grips.push_back(readButtons(grip));
    readError(members, message.error);
    return message;
  });
}

std::string haplyForceText(std::string_view device_id, const Vector3& force_n) {
  // Format 3.1 reads `values`; the documents of 3.5 name the same vector `vector`.
  const std::string force = vectorText(haplyAxesOf(force_n));
  return commandText(device_id, "\"set_cursor_force\":{\"values\":" + force + ",\"vector\":" + force + '}');
}

std::string haplyProbeText(std::string_view device_id) { return commandText(device_id, "\"probe_position\":{}"); }

std::string haplyFullStateText() { return "{\"session\":{\"force_render_full_state\":{}}}"; }

base::Result<HaplyRequest> readHaplyRequest(std::string_view text) {
  return base::readJson(text, kPlace, [](JsonMembers& members, std::optional<base::Error>& error) {
    HaplyRequest request;
    if (const auto session = partOf(members, "session"))
      request.wants_everything = JsonMembers(*session, error).has("force_render_full_state");
    for (const JsonValue& value : listOf(members, "inverse3")) {
      HaplyCommand command;
      JsonMembers entry(value, error);
      entry.text(required("device_id"), command.id);
      if (const auto commands = partOf(entry, "commands")) {
        if (const auto force = JsonMembers(*commands, error).object("set_cursor_force")) {
          JsonMembers vectors(*force, error);
          command.force_n = vectorOf(vectors, "values", error);
          if (!command.force_n) command.force_n = vectorOf(vectors, "vector", error);
          if (!command.force_n) vectors.refuse("values", "nothing", "the force as {x, y, z}, N");
        }
      }
      if (command.force_n) command.force_n = fromHaplyAxes(*command.force_n);
      request.commands.push_back(std::move(command));
    }
    return request;
  });
}

std::string haplyStateText(const std::vector<HaplyState>& devices, bool with_config, std::string_view error) {
  std::string inverse;
  std::string grips;
  for (const HaplyState& device : devices) {
    inverse += std::string(inverse.empty() ? "" : ",") + "{\"device_id\":" + base::jsonString(device.id);
    if (with_config) {
      inverse +=
          ",\"config\":{\"type\":\"inverse3\",\"name\":\"Tactus emulator (simulated)\",\"simulated\":true,"
          "\"port\":\"none\",\"handedness\":\"right\",\"gravity_compensation\":{\"enabled\":true,\"scaling_factor\":1},"
          "\"preset\":\"defaults\",\"basis\":{\"permutation\":\"XYZ\"},"
          "\"mount\":{\"position\":{\"x\":0,\"y\":0,\"z\":0},\"rotation\":{\"w\":1,\"x\":0,\"y\":0,\"z\":0},"
          "\"scale\":{\"x\":1,\"y\":1,\"z\":1}}}";
    }
    inverse += ",\"state\":{\"cursor_position\":" + vectorText(device.position_m) +
               ",\"cursor_velocity\":" + vectorText(device.velocity_m_s) +
               ",\"current_cursor_force\":" + vectorText(device.force_n) +
               ",\"control_domain\":\"cartesian\",\"control_mode\":\"force\"},\"status\":{\"calibrated\":true,"
               "\"in_use\":true,\"power_supply\":true,\"ready\":true,\"started\":true}}";
    if (!device.grip) continue;
    grips += std::string(grips.empty() ? "" : ",") + "{\"device_id\":" + base::jsonString(device.id + "-grip");
    if (with_config) grips += ",\"config\":{\"type\":\"wireless_verse_grip\",\"simulated\":true}";
    grips += std::string(",\"state\":{\"orientation\":{\"w\":1,\"x\":0,\"y\":0,\"z\":0},\"buttons\":{\"a\":") +
             (*device.grip ? "true" : "false") +
             ",\"b\":false,\"c\":false},\"battery_level\":1},\"status\":{\"connected\":true,\"awake\":true,"
             "\"ready\":true}}";
  }
  std::string text = "{\"inverse3\":[" + inverse + "],\"wireless_verse_grip\":[" + grips + ']';
  if (!error.empty()) text += ",\"error\":" + base::jsonString(error);
  return text + '}';
}

}  // namespace tactus::haptics
