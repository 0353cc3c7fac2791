// The force at which a participant would stop, from the question "I would stop here" beside the word of each force.
// Asked of experts by Tefik et al. (2024, World J Urol): what they would not push against any more.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace tactus::experiments {

/// One answer to the question.
struct StopAnswer {
  std::string participant;
  std::string series;  ///< as of the judgement
  int step = 0;
  double force_n = 0;  ///< commanded
  bool would_stop = false;

  bool operator==(const StopAnswer&) const = default;
};

struct StopForce {
  std::size_t asked = 0;
  std::size_t stops = 0;  ///< forces at which she would stop
  std::optional<double> lowest_stop_n;
  std::optional<double> highest_on_n;  ///< the largest force at which she would go on
  /// The force at which she would stop half of the time (study::termThresholds with two answers); nothing where one of
  /// the two was never given.
  std::optional<double> stop_force_n;
};

/// Of one participant's answers.
StopForce stopForce(std::span<const StopAnswer> answers);

}  // namespace tactus::experiments
