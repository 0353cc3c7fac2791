// Who takes part in one imagined repetition of a study: a cast, drawn from the participants with replacement.
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/random.h"

namespace tactus::elicitation {

/// How often each participant takes part, in the order of the study; 0: not at all.
using Cast = std::vector<std::size_t>;

struct WeightedCast {
  Cast cast;
  double weight = 1;  ///< its probability among all draws of as many people as there are
};

/// Each person once.
Cast everyPerson(std::size_t people);

/// As many draws as there are people, each of them equally likely.
Cast drawCast(std::size_t people, base::Random& random);

/// Largest number of people whose casts are enumerated: 6,435 of them.
inline constexpr std::size_t kMostEnumerated = 8;

/// Every cast of `people` draws from as many, C(2n - 1, n) of them, with the weights n! / (c1! c2! …) / n^n, which sum
/// to 1. `people`: 1 to kMostEnumerated.
std::vector<WeightedCast> everyCast(std::size_t people);

}  // namespace tactus::elicitation
