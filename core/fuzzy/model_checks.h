// Checks that the parts of a force model share. Nothing outside core/fuzzy includes this.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "core/fuzzy/name_list.h"
#include "core/fuzzy/place.h"

namespace tactus::fuzzy {

// Larger numbers would overflow in the moments of the output set, narrower universes underflow.
inline constexpr double kLargest = 1e150;
inline constexpr double kNarrowest = 1e-150;

/// What is wrong with a model, or null. One word to hand back for each of many checks, where a Result has twenty.
using Problem = std::unique_ptr<base::Error>;

Problem problem(base::ErrorCode code, const Place& place, std::string found, std::string wanted);

/// Whether `value` lies in [min, max]; NaN does not.
inline bool isWithin(double value, double min, double max) noexcept { return value >= min && value <= max; }

/// The number is finite and in [min, max].
Problem checkNumber(double value, double min, double max, const Place& place);

/// `count` things named `what` are between 1 and `most`.
Problem checkCount(std::size_t count, std::size_t most, std::string_view what, const Place& place);

/// `id` is an id and new among `seen`, where it is remembered.
Problem checkUnique(NameList& seen, const std::string& id, const Place& place);

/// A list of terms, whose names come to stand in `names`; `output` where they are terms of this output, which they must
/// meet.
Problem checkTerms(const std::vector<Term>& terms, const Variable* output, const Place& place, NameList& names);

}  // namespace tactus::fuzzy
