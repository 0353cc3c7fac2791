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

}  // namespace tactus::session
