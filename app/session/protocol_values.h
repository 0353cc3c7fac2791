// The values of a study's protocol by name, as people write and read them: `force.ladder.highest_n`, `languages`,
// `consent.en`.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/session/study_protocol.h"
#include "core/base/error.h"

namespace tactus::session {

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
