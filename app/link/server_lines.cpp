#include "app/link/server_lines.h"

#include "app/link/client_message.h"
#include "core/base/files/checksums.h"
#include "core/base/json/json_writer.h"

namespace tactus::link {
namespace {

using base::jsonNumber;
using base::jsonString;

const char* truth(bool flag) { return flag ? "true" : "false"; }

/// The id of the region at `depth_mm` as JSON; null outside of all regions.
std::string regionAt(const LinkSetting& setting, double depth_mm) {
  for (const auto& region : setting.regions) {
    if (depth_mm >= region.from_mm && depth_mm < region.to_mm) return jsonString(region.id);
  }
  const bool at_end = !setting.regions.empty() && depth_mm == setting.regions.back().to_mm;
  return at_end ? jsonString(setting.regions.back().id) : "null";
}

// `json`, which must be valid, without its byte order mark and without white space between tokens. Strings, digits and
// the order of keys stay byte for byte, so the result reads as the same model.
std::string compactJson(std::string_view json) {
  if (json.starts_with("\xEF\xBB\xBF")) json.remove_prefix(3);
  std::string out;
  out.reserve(json.size());
  bool in_string = false;
  bool escaped = false;
  for (const char c : json) {
    if (!in_string && (c == ' ' || c == '\t' || c == '\n' || c == '\r')) continue;
    out += c;
    if (c == '"' && !escaped) in_string = !in_string;
    escaped = in_string && c == '\\' && !escaped;
  }
  return out;
}

}  // namespace

std::string helloLine(std::string_view program) {
  return "{\"hello\":" + jsonString(kProtocol) + ",\"version\":1,\"program\":" + jsonString(program) + "}\n";
}

std::string modelLine(std::uint64_t serial, std::string_view sha256, std::string_view text) {
  const std::string file = compactJson(text);
  return "{\"model\":{\"serial\":" + std::to_string(serial) + ",\"sha256\":\"" + std::string(sha256) +
         "\",\"sent_sha256\":\"" + base::sha256(file) + "\",\"file\":" + file + "}}\n";
}

std::string stateLine(const LinkState& state, const LinkSetting& setting) {
  std::string line = "{\"state\":{\"time_s\":" + jsonNumber(state.time_s);
  line += ",\"depth_mm\":" + jsonNumber(state.depth_mm) + ",\"speed_mm_s\":" + jsonNumber(state.speed_mm_s);
  line += ",\"slip_speed_mm_s\":" + jsonNumber(state.slip_speed_mm_s) + ",\"force_n\":" + jsonNumber(state.force_n);
  line += ",\"model_force_n\":" + jsonNumber(state.model_force_n) + ",\"held\":" + truth(state.held);
  line += ",\"stroke\":" + std::to_string(state.stroke) + ",\"region\":" + regionAt(setting, state.depth_mm);
  line += ",\"conditions\":{";
  const char* separator = "";
  for (const auto& [id, value] : setting.conditions) {
    line += separator + jsonString(id) + ':' + jsonNumber(value);
    separator = ",";
  }
  line += std::string("},\"simulated\":") + truth(setting.simulated) + ",\"held_last\":" + truth(state.held_last);
  return line + "}}\n";
}

std::string answerLine(std::string_view id, const fuzzy::Evaluation& force, std::uint64_t serial) {
  return "{\"answer\":{\"id\":" + std::string(id) + ",\"force_n\":" + jsonNumber(force.force_n) +
         ",\"fired\":" + truth(force.fired) + ",\"serial\":" + std::to_string(serial) + "}}\n";
}

std::string errorLine(std::string_view sentence) { return "{\"error\":" + jsonString(sentence) + "}\n"; }

}  // namespace tactus::link
