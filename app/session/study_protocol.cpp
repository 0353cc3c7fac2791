#include "app/session/study_protocol.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "app/session/judged_forces.h"
#include "app/session/study_procedure.h"
#include "core/base/error.h"
#include "core/base/json/json_members.h"
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

namespace {

using base::JsonMembers;
using Json = nlohmann::ordered_json;

bool has(const SessionSettings& settings, Block block) {
  return std::find(settings.blocks.begin(), settings.blocks.end(), block) != settings.blocks.end();
}

Result<void> validateLanguages(const StudyProtocol& protocol) {
  if (protocol.languages.empty()) return fail(ErrorCode::kValue, "languages", "none", "at least one language");
  const auto known = questionnaires::languagesOf(protocol.settings.about(), protocol.settings.form);
  for (const auto& language : protocol.languages) {
    const std::string place = "language " + base::quoted(language);
    if (std::count(protocol.languages.begin(), protocol.languages.end(), language) > 1) {
      return fail(ErrorCode::kValue, place, "twice", "each language once");
    }
    const procedure::Procedure& about = protocol.settings.about();
    const auto is_of = [&](const auto& list) { return std::find(list.begin(), list.end(), language) != list.end(); };
    const bool is_default = about.id == procedure::defaultProcedure()->id;
    if (is_default ? !is_of(kScreenLanguages) : !is_of(about.languages)) {
      return fail(
          ErrorCode::kReference, place, "no screens in it",
          "one of " + (is_default ? base::joined(kScreenLanguages, ", ") : base::joined(about.languages, ", ")));
    }
    if (has(protocol.settings, Block::kForm) && std::find(known.begin(), known.end(), language) == known.end()) {
      return fail(ErrorCode::kReference, place, "no wording of " + base::quoted(protocol.settings.form),
                  "one of " + base::joined(known, ", "));
    }
    const auto text = protocol.consent.find(language);
    if (text == protocol.consent.end() || text->second.empty()) {
      return fail(ErrorCode::kValue, place, "no consent text", "the text that participants agree to");
    }
  }
  return {};
}

Result<void> validateDevice(const StudyProtocol& protocol) {
  const ProtocolDevice& device = protocol.device;
  const double friction_n = device.friction_n.value_or(0);
  if (!(friction_n >= 0 && friction_n <= 1)) {
    return fail(ErrorCode::kValue, "device/friction_n", base::formatNumber(friction_n), "0 to 1 N");
  }
  haptics::LimitSettings limits;
  limits.force_cap_n = device.force_cap_n;
  limits.continuous_force_n = device.continuous_force_n;
  if (!haptics::wellFormed(limits) || limits.force_cap_n > experiments::kHighestForceN) {
    return fail(ErrorCode::kValue, "device",
                base::formatNumber(device.force_cap_n) + " N and " + base::formatNumber(device.continuous_force_n) +
                    " N continuously",
                "forces from 0 to " + base::formatNumber(experiments::kHighestForceN) + " N");
  }
  return has(protocol.settings, Block::kForce) ? requireHolds(protocol.settings.force, limits) : Result<void>();
}

Json deviceJson(const ProtocolDevice& device) {
  Json json = {{"name", device.name},
               {"friction_n", nullptr},
               {"force_cap_n", device.force_cap_n},
               {"continuous_force_n", device.continuous_force_n}};
  if (device.friction_n) json["friction_n"] = *device.friction_n;
  return json;
}

void readDevice(JsonMembers& members, ProtocolDevice& device) {
  members.textOrEmpty("name", device.name);
  members.numberOrNull("friction_n", device.friction_n);
  members.number("force_cap_n", device.force_cap_n);
  members.number("continuous_force_n", device.continuous_force_n);
}

}  // namespace

Result<void> validate(const StudyProtocol& protocol) {
  if (auto ok = validate(protocol.settings); !ok) return ok;
  if (protocol.consent_version.empty()) {
    return fail(ErrorCode::kValue, "consent_version", "none", "the version of the consent texts");
  }
  if (auto ok = validateLanguages(protocol); !ok) return ok;
  return validateDevice(protocol);
}

std::string toJson(const StudyProtocol& protocol, const procedure::Procedure* kept) {
  Json json = {{"settings", Json::parse(toJson(protocol.settings))},
               {"languages", protocol.languages},
               {"consent_version", protocol.consent_version},
               {"consent", protocol.consent},
               {"statements", protocol.statements},
               {"contact", protocol.contact},
               {"device", deviceJson(protocol.device)}};
  const auto& procedure = protocol.settings.procedure;
  if (procedure != nullptr && procedure != procedure::defaultProcedure()) {
    json["procedure"] = {{"id", procedure->id}, {"pack_version", procedure->version}, {"sha256", procedure->sha256}};
    if (kept != nullptr) json["procedure"]["files"] = kept->files;
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Result<StudyProtocol> parseStudyProtocol(std::string_view text) {
  // A member of a newer program is ignored.
  return base::readJson(text, {}, [](JsonMembers& members, std::optional<base::Error>& error) {
    StudyProtocol protocol;
    if (const auto settings = members.object("settings")) {
      JsonMembers part(*settings, error);
      protocol.settings = readSessionSettings(part, error);
    }
    members.texts("languages", protocol.languages);
    members.textOrEmpty("consent_version", protocol.consent_version);
    std::vector<JsonMembers::NamedText> consent;
    members.texts("consent", consent);
    protocol.consent = {consent.begin(), consent.end()};
    std::vector<JsonMembers::NamedText> statements;
    members.texts("statements", statements);
    protocol.statements = {statements.begin(), statements.end()};
    members.textOrEmpty("contact", protocol.contact);
    if (const auto device = members.object("device")) {
      JsonMembers part(*device, error);
      readDevice(part, protocol.device);
    }
    return protocol;
  });
}

Result<study::ProtocolRecord> setProtocol(store::StudyFile& file, const StudyProtocol& protocol,
                                          const std::string& author, const std::string& reason, SessionTools& tools) {
  if (auto ok = validate(protocol); !ok) return tl::unexpected(ok.error());
  TACTUS_TRY(const auto state, store::protocolState(file));
  study::ProtocolRecord record{tools.ids.next(), state.nextVersion(), tools.now().utc_ms, author,
                               reason,           toJson(protocol)};
  // The latest draft counts by its time, whatever the clock does.
  if (state.current && state.current->version == record.version) {
    record.utc_ms = std::max(record.utc_ms, state.current->utc_ms + 1);
  }
  if (auto added = store::append(file, record); !added) return tl::unexpected(added.error());
  return record;
}

Result<std::optional<StudyProtocol>> currentProtocol(const store::StudyFile& file) {
  TACTUS_TRY(const auto state, store::protocolState(file));
  if (!state.current) return std::nullopt;
  TACTUS_TRY(auto protocol, protocolOf(file, *state.current));
  return protocol;
}

Result<SessionStart> startUnderProtocol(const store::StudyFile& file, const study::RecordId& person,
                                        const std::string& language, std::uint64_t seed) {
  TACTUS_TRY(const auto state, store::protocolState(file));
  if (!state.current) return fail(ErrorCode::kReference, "session", "a study without a protocol", "one that was set");
  TACTUS_TRY(auto protocol, protocolOf(file, *state.current));
  if (!protocol.consent.contains(language)) {
    return fail(ErrorCode::kValue, "language", base::quoted(language),
                "one of " + base::joined(protocol.languages, ", "));
  }
  SessionStart start;
  start.person = person;
  start.consent_version = protocol.consent_version;
  start.seed = seed;
  start.language = language;
  start.device_friction_n = protocol.device.friction_n;
  start.settings = std::move(protocol.settings);
  start.protocol = state.current->id;
  return start;
}

}  // namespace tactus::session
