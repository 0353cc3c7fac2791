// Checks that the parts of a force model share. Nothing outside core/fuzzy includes this.
#pragma once

#include <cstddef>
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

/// Whether `value` lies in [min, max]; NaN does not.
inline bool isWithin(double value, double min, double max) noexcept { return value >= min && value <= max; }

/// The number is finite and in [min, max].
base::Result<void> checkNumber(double value, double min, double max, const Place& place);

/// `count` things named `what` are between 1 and `most`.
base::Result<void> checkCount(std::size_t count, std::size_t most, std::string_view what, const Place& place);

/// `id` is an id and new among `seen`, where it is remembered.
base::Result<void> checkUnique(NameList& seen, const std::string& id, const Place& place);

/// A list of terms; `output` where they are terms of this output, which they must meet.
base::Result<void> checkTerms(const std::vector<Term>& terms, const Variable* output, const Place& place);

}  // namespace tactus::fuzzy
