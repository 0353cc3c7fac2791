#include "app/link/link_lines.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "core/base/error.h"
#include "core/base/files/checksums.h"
#include "core/base/json/json_document.h"
#include "core/base/json/json_members.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"

namespace tactus::link {
namespace {

using base::ErrorCode;
using base::JsonKind;
using base::JsonMembers;
using base::JsonValue;
using base::required;
using base::Result;

constexpr std::size_t kLongestName = 60;
constexpr std::size_t kLongestId = 100;

/// `text` on one line, cut to whole characters.
std::string shortName(std::string_view text) {
  std::string name = base::oneLine(text);
  if (name.size() <= kLongestName) return name;
  std::size_t end = 0;
  while (true) {
    const auto bytes = base::firstCharacter(std::string_view(name).substr(end)).bytes;
    if (end + bytes > kLongestName) break;
    end += bytes;
  }
  name.resize(end);
  return name;
}

void readWant(JsonMembers& members, Hello& hello) {
  if (!members.has("want")) return;
  hello.wants_model = false;
  std::vector<std::string> wanted;
  members.texts("want", wanted);
  for (const std::string& word : wanted) {
    if (word == "model") {
      hello.wants_model = true;
    } else if (word == "state") {
      hello.wants_state = true;
    } else if (word == "felt") {
      hello.wants_felt = true;
    } else {
      members.refuse("want", "the word " + base::quoted(word), "model, state or felt");
    }
  }
}

/// The line has none of the members that it may have; `wanted`: these.
base::Error noMember(const base::JsonDocument& document, const std::string& wanted) {
  std::string found = "an object without members";
  for (const JsonValue first : document.root()) {
    found = "the member " + base::quoted(first.key());
    break;
  }
  return base::fail(ErrorCode::kSchema, {}, std::move(found), "a line with the member " + wanted).value();
}

Result<base::JsonDocument> parseLine(std::string_view line) {
  if (!base::isUtf8(line)) return base::fail(ErrorCode::kSyntax, {}, "bytes that are not UTF-8", "JSON in UTF-8");
  return base::JsonDocument::parse(line);
}

}  // namespace

Result<Hello> readHello(std::string_view line) {
  TACTUS_TRY(const auto document, parseLine(line));
  const auto greeting = document.root().find("hello");
  if (!greeting) return tl::unexpected(noMember(document, "'hello'"));
  std::optional<base::Error> error;
  JsonMembers members(document.root(), error);
  Hello hello;
  std::string name;
  if (greeting->kind() != JsonKind::kString || greeting->text() != kProtocol) {
    members.refuse("hello", "'" + std::string(kProtocol) + "'");
  }
  members.version(required("version"));
  members.text(required("token"), hello.token);
  members.textOrEmpty("name", name);
  readWant(members, hello);
  members.number("state_hz", hello.state_hz, {kLowestStateHz, kHighestStateHz});
  if (error) return tl::unexpected(*std::move(error));
  hello.name = shortName(name);
  return hello;
}

namespace {

Result<Ask> askOf(JsonValue question) {
  std::optional<base::Error> error;
  JsonMembers members(question, error);
  Ask ask;
  if (const auto id = members.child(required("id"))) {
    const bool fits = id->kind() == JsonKind::kNumber || id->kind() == JsonKind::kString;
    if (fits && id->text().size() <= kLongestId) {
      ask.id = id->json();
    } else {
      members.refuse("id", "a number or a string of at most " + std::to_string(kLongestId) + " bytes");
    }
  }
  members.numbers(required("inputs"), ask.inputs);
  if (error) return tl::unexpected(*std::move(error));
  return ask;
}

Result<Felt> feltOf(JsonValue report) {
  std::optional<base::Error> error;
  JsonMembers members(report, error);
  Felt felt;
  const base::NumberRange near{-kFarthestFelt, kFarthestFelt};
  members.number(required("time_s"), felt.time_s);
  members.number(required("depth_mm"), felt.depth_mm, near);
  members.number(required("speed_mm_s"), felt.speed_mm_s, near);
  members.number(required("force_n"), felt.force_n, near);
  members.numbers("conditions", felt.conditions, base::kAnyNumber);
  if (error) return tl::unexpected(*std::move(error));
  return felt;
}

}  // namespace

Result<std::variant<Ask, Felt>> readLaterLine(std::string_view line) {
  using Line = std::variant<Ask, Felt>;
  TACTUS_TRY(const auto document, parseLine(line));
  if (const auto question = document.root().find("ask")) return askOf(*question).map([](Ask ask) { return Line(ask); });
  if (const auto report = document.root().find("felt"))
    return feltOf(*report).map([](Felt felt) { return Line(felt); });
  return tl::unexpected(noMember(document, "'ask' or 'felt'"));
}

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

namespace {

/// A JSON object of numbers by name.
template <typename Numbers>
std::string numbersJson(const Numbers& numbers) {
  std::string json = "{";
  for (const auto& [id, value] : numbers)
    json += (json.size() > 1 ? "," : "") + jsonString(id) + ':' + jsonNumber(value);
  return json + '}';
}

}  // namespace

std::string stateLine(const LinkState& state, const LinkSetting& setting) {
  std::string line = "{\"state\":{\"time_s\":" + jsonNumber(state.time_s);
  line += ",\"depth_mm\":" + jsonNumber(state.depth_mm) + ",\"speed_mm_s\":" + jsonNumber(state.speed_mm_s);
  line += ",\"slip_speed_mm_s\":" + jsonNumber(state.slip_speed_mm_s) + ",\"force_n\":" + jsonNumber(state.force_n);
  line += ",\"model_force_n\":" + jsonNumber(state.model_force_n) + ",\"held\":" + truth(state.held);
  line += ",\"stroke\":" + std::to_string(state.stroke) + ",\"region\":" + regionAt(setting, state.depth_mm);
  line += ",\"conditions\":" + numbersJson(setting.conditions);
  line += std::string(",\"simulated\":") + truth(setting.simulated) + ",\"held_last\":" + truth(state.held_last);
  return line + "}}\n";
}

std::string answerLine(std::string_view id, const fuzzy::Evaluation& force, std::uint64_t serial) {
  return "{\"answer\":{\"id\":" + std::string(id) + ",\"force_n\":" + jsonNumber(force.force_n) +
         ",\"fired\":" + truth(force.fired) + ",\"serial\":" + std::to_string(serial) + "}}\n";
}

std::string feltLine(const Felt& felt, std::string_view name) {
  std::string line = "{\"felt\":{\"time_s\":" + jsonNumber(felt.time_s) + ",\"depth_mm\":" + jsonNumber(felt.depth_mm);
  line += ",\"speed_mm_s\":" + jsonNumber(felt.speed_mm_s) + ",\"force_n\":" + jsonNumber(felt.force_n);
  line += ",\"conditions\":" + numbersJson(felt.conditions) + ",\"name\":" + jsonString(name);
  return line + "}}\n";
}

std::string errorLine(std::string_view sentence) { return "{\"error\":" + jsonString(sentence) + "}\n"; }

}  // namespace tactus::link
