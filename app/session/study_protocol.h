// The study's protocol: what each participant is asked, and its text in the study file.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/session/session.h"
#include "app/session/session_settings.h"
#include "core/base/error.h"
#include "core/store/study_records.h"

namespace tactus::session {

/// The languages in which the participant's screens are written; a pack may bring others.
inline constexpr std::array<std::string_view, 3> kScreenLanguages = {"en", "zh-Hant", "zh-Hans"};

/// The device that the forces are meant for. The defaults are those of a Touch.
struct ProtocolDevice {
  std::string name;                  ///< empty: any
  std::optional<double> friction_n;  ///< its own friction against forward motion; 0 to 1
  double force_cap_n = 2;            ///< as haptics::LimitSettings
  double continuous_force_n = 0.88;
};

struct StudyProtocol {
  SessionSettings settings;                     ///< levels, steps, order
  std::vector<std::string> languages = {"en"};  ///< offered to participants in this order
  std::string consent_version;
  std::map<std::string, std::string> consent;  ///< text by language
  /// By language: statements instead of those that the consent screen makes of blocks and device; empty: those.
  std::map<std::string, std::string> statements;
  std::string contact;  ///< whom a participant can ask; no session of a real person begins without
  ProtocolDevice device;
};

/// Refuses, with one sentence: invalid settings, a language that the screens or the form lack or that stands twice, no
/// consent version, a language without a consent text, forces that the device cannot hold.
base::Result<void> validate(const StudyProtocol& protocol);

/// A JSON object on one line. `kept`: the procedure whose whole pack it holds; otherwise it names the procedure.
std::string toJson(const StudyProtocol& protocol, const procedure::Procedure* kept = nullptr);
/// Reads what `toJson` wrote; a missing member keeps its default.
base::Result<StudyProtocol> parseStudyProtocol(std::string_view text);

/// Stores a valid protocol as the next record (store::ProtocolState). `reason`: needed for an amendment.
base::Result<study::ProtocolRecord> setProtocol(store::StudyFile& file, const StudyProtocol& protocol,
                                                const std::string& author, const std::string& reason,
                                                SessionTools& tools);

/// The current protocol of the file, or nothing.
base::Result<std::optional<StudyProtocol>> currentProtocol(const store::StudyFile& file);

/// The start of a session that follows the file's current protocol, for a person who agreed to its consent text in
/// `language`. The caller adds station, program and device. Returns an error if the file has no protocol, or the
/// protocol no such language.
base::Result<SessionStart> startUnderProtocol(const store::StudyFile& file, const study::RecordId& person,
                                              const std::string& language, std::uint64_t seed);

// The values of a study's protocol by name, as people write and read them: `force.ladder.highest_n`, `languages`,
// `consent.en`.

struct ProtocolValue {
  std::string name;
  std::string value;  ///< as `withProtocolValue` reads it: a list is joined by commas, no value is empty

  bool operator==(const ProtocolValue&) const = default;
};

/// All values, in the order of the protocol's JSON text.
std::vector<ProtocolValue> protocolValues(const StudyProtocol& protocol);

/// `protocol` with another value for `name`, not validated. Refused: an unknown name, with the closest one; a value of
/// another kind.
base::Result<StudyProtocol> withProtocolValue(const StudyProtocol& protocol, std::string_view name,
                                              std::string_view value);

/// Settings to begin with. `published`: as the paper describes its study, with one middle force for practice.
/// `recommended`: forces rise and fall with two catch trials each, a rest after ten, speeds by Latin square, questions
/// shuffled within blocks. `short`: about 20 minutes, for a trial or a busy ward.
struct ProtocolPreset {
  std::string_view id;
  std::vector<ProtocolValue> values;
};
const std::vector<ProtocolPreset>& protocolPresets();
/// `protocol` with the values of the preset; consent, contact, languages and device stay. Refused: an unknown id.
base::Result<StudyProtocol> withPreset(const StudyProtocol& protocol, std::string_view id);

/// What a protocol asks of a person and of the device.
struct ProtocolLoad {
  double minutes = 0;
  int strokes = 0;     ///< without practice
  int judgements = 0;  ///< without practice and repeats
  int questions = 0;
  /// The force that heats the motors as much as the ladder does on average, as a share of what the device can hold
  /// for long; 0: no forces. Above 1 the device rests longer than the protocol asks.
  double heat_share = 0;
};
ProtocolLoad loadOf(const StudyProtocol& protocol);

}  // namespace tactus::session
