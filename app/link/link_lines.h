// The lines of the live link: what the server says, what a client may say, and what the hand feels.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/compiled_model.h"

namespace tactus::link {

// What the hand feels at one moment, for simulators that follow it.

/// What is the same at many moments. Immutable.
struct LinkSetting {
  struct Region {
    double from_mm = 0;
    double to_mm = 0;
    std::string id;  ///< of the depth term
  };
  std::vector<Region> regions;                             ///< in the order of their depths
  std::vector<std::pair<std::string, double>> conditions;  ///< the inputs that the hand does not move: id and value
  bool simulated = false;                                  ///< the hand, or its device, is simulated or replayed
};

struct LinkState {
  double time_s = 0;  ///< since the run began
  double depth_mm = 0;
  double speed_mm_s = 0;
  double slip_speed_mm_s = 0;
  double force_n = 0;
  double model_force_n = 0;
  bool held = false;       ///< the hand holds the tube
  bool held_last = false;  ///< no rule fires, so the last force is held
  std::uint32_t stroke = 0;
};

/// Moments that follow each other, oldest first, in one setting.
struct LinkStates {
  std::shared_ptr<const LinkSetting> setting;
  std::vector<LinkState> states;
};

// What a client of the live link may say: one line of JSON, read strictly.

inline constexpr std::string_view kProtocol = "tactus-link";
inline constexpr double kLowestStateHz = 0.1;
inline constexpr double kHighestStateHz = 1000;

/// The first line of a client.
struct Hello {
  std::string token;
  std::string name;         ///< of the program, for the screen; may be empty; at most 60 bytes
  bool wants_model = true;  ///< as `want` says; models without it
  bool wants_state = false;
  bool wants_felt = false;  ///< where other clients are
  double state_hz = 100;    ///< kLowestStateHz to kHighestStateHz
};

/// A question for the force at a point.
struct Ask {
  std::string id;  ///< as JSON text: a number or a string of the client, repeated in the answer
  std::vector<double> inputs;
};

/// Where a simulator is.
struct Felt {
  double time_s = 0;  ///< of the simulator's clock
  double depth_mm = 0;
  double speed_mm_s = 0;
  double force_n = 0;
  std::map<std::string, double> conditions;  ///< inputs by id; those that the simulator does not say are missing

  bool operator==(const Felt&) const = default;
};

/// Depth, speed and force of a simulator are at most this far from 0, in mm, mm/s and N.
inline constexpr double kFarthestFelt = 1e6;

/// Reads the first line of a client. Unknown keys are ignored: a later version of the protocol may have them.
base::Result<Hello> readHello(std::string_view line);

/// Reads any later line.
base::Result<std::variant<Ask, Felt>> readLaterLine(std::string_view line);

// What the server of the live link says: each function gives one line of JSON with its line end.

/// `program`: name and version of the server.
std::string helloLine(std::string_view program);

/// `text`: of a valid model file. `file` in the line is that text without white space between tokens and the last
/// member, so that a client without a JSON reader can cut it out. `sha256` is of `text`, as `sha256sum` gives for the
/// file; `sent_sha256` is of the bytes of `file` in this line.
std::string modelLine(std::uint64_t serial, std::string_view sha256, std::string_view text);

std::string stateLine(const LinkState& state, const LinkSetting& setting);

/// `id`: JSON text. `serial`: of the model that answers.
std::string answerLine(std::string_view id, const fuzzy::Evaluation& force, std::uint64_t serial);

/// `name`: of the client that says so.
std::string feltLine(const Felt& felt, std::string_view name);

std::string errorLine(std::string_view sentence);

}  // namespace tactus::link
