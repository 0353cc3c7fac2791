#include "app/session/protocol_values.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/base/close_match.h"
#include "core/base/text.h"
#include "questionnaires/questionnaire.h"

namespace tactus::session {
namespace {

using base::ErrorCode;
using base::fail;
using base::Result;
using Json = nlohmann::ordered_json;

constexpr std::string_view kConsent = "consent.";
constexpr std::string_view kStatements = "statements.";

// The settings of sessions are most of a protocol: their names begin without `settings`.
std::string nameOf(const std::string& path) {
  constexpr std::string_view kSettings = "settings.";
  return path.starts_with(kSettings) ? path.substr(kSettings.size()) : path;
}

std::string textOf(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_null()) return {};
  if (!value.is_array()) return value.dump();
  std::string text;
  for (const Json& each : value) text += (text.empty() ? "" : ",") + textOf(each);
  return text;
}

// Calls `visit` with the name of each value and its place in `json`.
template <class Visit>
void walk(Json& json, const std::string& path, const Visit& visit) {
  for (auto& [key, value] : json.items()) {
    const std::string name = path.empty() ? key : path + '.' + key;
    if (value.is_object()) {
      walk(value, name, visit);
    } else {
      visit(nameOf(name), value);
    }
  }
}

std::vector<std::string> partsOf(std::string_view text) {
  std::vector<std::string> parts;
  while (!text.empty()) {
    const auto comma = text.find(',');
    parts.emplace_back(base::trimmed(text.substr(0, comma)));
    text = comma == std::string_view::npos ? std::string_view() : text.substr(comma + 1);
  }
  return parts;
}

// Numbers and flags are JSON; anything else is text.
Json scalarOf(const std::string& text, bool is_text) {
  if (is_text) return text;
  Json value = Json::parse(text, nullptr, false);
  return value.is_number() || value.is_boolean() ? value : Json(text);
}

/// What the value at a place may be, by what it is now.
enum class ValueKind { kText, kFlag, kWhole, kNumber, kNumberOrNone, kTexts, kNumbers };

ValueKind kindOf(const std::string& name, const Json& now) {
  if (now.is_array()) return name.ends_with("_n") ? ValueKind::kNumbers : ValueKind::kTexts;
  if (now.is_null() || name.ends_with("friction_n")) return ValueKind::kNumberOrNone;
  if (now.is_boolean()) return ValueKind::kFlag;
  if (now.is_string()) return ValueKind::kText;
  return now.is_number_integer() ? ValueKind::kWhole : ValueKind::kNumber;
}

const char* wantedOf(ValueKind kind) {
  switch (kind) {
    case ValueKind::kFlag: return "true or false";
    case ValueKind::kWhole: return "a whole number";
    case ValueKind::kNumber: return "a number";
    case ValueKind::kNumberOrNone: return "a number, or nothing";
    case ValueKind::kNumbers: return "numbers with commas between them";
    case ValueKind::kText:
    case ValueKind::kTexts: break;
  }
  return "text";
}

std::optional<Json> read(ValueKind kind, const std::string& text) {
  const bool is_list = kind == ValueKind::kTexts || kind == ValueKind::kNumbers;
  if (is_list) {
    Json list = Json::array();
    for (const std::string& part : partsOf(text)) {
      list.push_back(scalarOf(part, kind == ValueKind::kTexts));
      if (kind == ValueKind::kNumbers && !list.back().is_number()) return std::nullopt;
    }
    return list;
  }
  if (kind == ValueKind::kNumberOrNone && text.empty()) return Json(nullptr);
  Json value = scalarOf(text, kind == ValueKind::kText);
  const bool fits = kind == ValueKind::kText    ? true
                    : kind == ValueKind::kFlag  ? value.is_boolean()
                    : kind == ValueKind::kWhole ? value.is_number_integer()
                                                : value.is_number();
  return fits ? std::optional(std::move(value)) : std::nullopt;
}

/// The procedure is no value: it stays that with which the study was made.
Json valuesOf(const StudyProtocol& protocol) {
  Json json = Json::parse(toJson(protocol));
  json.erase("procedure");
  return json;
}

}  // namespace

std::vector<ProtocolValue> protocolValues(const StudyProtocol& protocol) {
  Json json = valuesOf(protocol);
  std::vector<ProtocolValue> values;
  walk(json, {}, [&](const std::string& name, const Json& value) { values.push_back({name, textOf(value)}); });
  return values;
}

Result<StudyProtocol> withProtocolValue(const StudyProtocol& protocol, std::string_view name, std::string_view value) {
  if (name.starts_with(kConsent) && name.size() > kConsent.size()) {
    StudyProtocol out = protocol;
    out.consent[std::string(name.substr(kConsent.size()))] = std::string(value);
    return out;
  }
  if (name.starts_with(kStatements) && name.size() > kStatements.size()) {
    StudyProtocol out = protocol;
    const std::string language(name.substr(kStatements.size()));
    out.statements.erase(language);
    if (!value.empty()) out.statements[language] = std::string(value);
    return out;
  }
  Json json = valuesOf(protocol);
  std::vector<std::string> known;
  std::optional<base::Error> refused;
  bool found = false;
  walk(json, {}, [&](const std::string& one, Json& place) {
    known.push_back(one);
    if (one != name) return;
    found = true;
    const ValueKind kind = kindOf(one, place);
    if (auto now = read(kind, std::string(value))) {
      place = std::move(*now);
    } else {
      refused = base::Error{ErrorCode::kValue, {}, one, base::quoted(value), wantedOf(kind)};
    }
  });
  if (refused) return tl::unexpected(*refused);
  if (!found) {
    return fail(ErrorCode::kReference, "protocol", base::quoted(name) + base::suggestion(name, known),
                "the name of a value, as 'tactus study protocol FILE' lists them");
  }
  TACTUS_TRY(auto out, parseStudyProtocol(json.dump()));
  out.settings.procedure = protocol.settings.procedure;
  return out;
}

const std::vector<ProtocolPreset>& protocolPresets() {
  static const std::vector<ProtocolPreset> all = {{"published",
                                                   {{"speed.order", "as_given"},
                                                    {"speed.strokes", "4"},
                                                    {"force.familiarisation_n", "0.5"},
                                                    {"force.ascending", "true"},
                                                    {"force.descending", "false"},
                                                    {"force.ladder_catches", "0"},
                                                    {"force.random", "false"},
                                                    {"force.ladder.lowest_n", "0.1"},
                                                    {"force.ladder.highest_n", "1.7"},
                                                    {"force.ladder.step_n", "0.1"},
                                                    {"force.rest_every", "20"},
                                                    {"item_order", "fixed"}}},
                                                  {"recommended",
                                                   {{"speed.order", "latin_square"},
                                                    {"speed.strokes", "4"},
                                                    {"force.familiarisation_n", "0.5"},
                                                    {"force.ascending", "true"},
                                                    {"force.descending", "true"},
                                                    {"force.ladder_catches", "2"},
                                                    {"force.random", "false"},
                                                    {"force.ladder.lowest_n", "0.1"},
                                                    {"force.ladder.highest_n", "1.7"},
                                                    {"force.ladder.step_n", "0.1"},
                                                    {"force.rest_every", "10"},
                                                    {"item_order", "within_blocks"}}},
                                                  {"short",
                                                   {{"speed.order", "latin_square"},
                                                    {"speed.strokes", "3"},
                                                    {"force.familiarisation_n", "0.5"},
                                                    {"force.ascending", "true"},
                                                    {"force.descending", "false"},
                                                    {"force.ladder_catches", "2"},
                                                    {"force.random", "false"},
                                                    {"force.ladder.lowest_n", "0.1"},
                                                    {"force.ladder.highest_n", "1.3"},
                                                    {"force.ladder.step_n", "0.1"},
                                                    {"force.rest_every", "10"},
                                                    {"item_order", "within_blocks"}}}};
  return all;
}

Result<StudyProtocol> withPreset(const StudyProtocol& protocol, std::string_view id) {
  std::string known;
  for (const ProtocolPreset& preset : protocolPresets()) {
    known += (known.empty() ? "" : ", ") + std::string(preset.id);
    if (preset.id != id) continue;
    StudyProtocol out = protocol;
    for (const auto& [name, value] : preset.values) {
      TACTUS_TRY(auto next, withProtocolValue(out, name, value));
      out = std::move(next);
    }
    return out;
  }
  return base::fail(base::ErrorCode::kReference, "preset", base::quoted(id), "one of " + known);
}

ProtocolLoad loadOf(const StudyProtocol& protocol) {
  const SessionSettings& settings = protocol.settings;
  ProtocolLoad load;
  load.minutes = expectedMinutes(settings);
  for (const Block block : settings.blocks) {
    if (block == Block::kSpeed) load.strokes = static_cast<int>(settings.speed.levels.size()) * settings.speed.strokes;
    if (block == Block::kForm) {
      if (const auto form =
              questionnaires::questionnaire(settings.about(), settings.form, settings.about().languages.front()))
        load.questions = static_cast<int>(form->questions.size());
    }
    if (block != Block::kForce) continue;
    const auto& force = settings.force;
    const int ladders = (force.ascending ? 1 : 0) + (force.descending ? 1 : 0);
    load.judgements = (force.ladder.count() + force.ladder_catches) * ladders;
    double squares = 0;
    int stimuli = 0;
    const auto add = [&](const auto& steps, int times) {
      for (int i = 0; i < steps.count(); ++i) {
        const double force_n = steps.at(i);
        squares += times * force_n * force_n;
      }
      stimuli += times * steps.count();
    };
    add(force.ladder, ladders);
    if (force.random) {
      load.judgements += force.random_steps.count() * force.random_repeats;
      add(force.random_steps, force.random_repeats);
    }
    if (stimuli == 0 || !(protocol.device.continuous_force_n > 0)) continue;
    const double held_s = force.ramp_s + force.hold_limit_s;
    const double duty = held_s / (held_s + force.pause_s);
    load.heat_share = std::sqrt(squares / stimuli * duty) / protocol.device.continuous_force_n;
  }
  return load;
}

}  // namespace tactus::session
