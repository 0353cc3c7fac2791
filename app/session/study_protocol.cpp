#include "app/session/study_protocol.h"

#include <algorithm>
#include <nlohmann/json.hpp>
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
using base::JsonMembers;
using base::Result;
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
