// What a client of the live link may say: one line of JSON, read strictly.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/error.h"

namespace tactus::link {

inline constexpr std::string_view kProtocol = "tactus-link";
inline constexpr double kLowestStateHz = 0.1;
inline constexpr double kHighestStateHz = 1000;

/// The first line of a client.
struct Hello {
  std::string token;
  std::string name;         ///< of the program, for the screen; may be empty; at most 60 bytes
  bool wants_model = true;  ///< as `want` says; models without it
  bool wants_state = false;
  double state_hz = 100;  ///< kLowestStateHz to kHighestStateHz
};

/// A question for the force at a point.
struct Ask {
  std::string id;  ///< as JSON text: a number or a string of the client, repeated in the answer
  std::vector<double> inputs;
};

/// Reads the first line of a client. Unknown keys are ignored: a later version of the protocol may have them.
base::Result<Hello> readHello(std::string_view line);

/// Reads any later line.
base::Result<Ask> readAsk(std::string_view line);

}  // namespace tactus::link
