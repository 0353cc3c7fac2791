// Checks used for several parts of a force model. Nothing outside core/fuzzy includes this.
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

// Values beyond kLargest would overflow the moments of the output set; universes below kNarrowest would underflow.
inline constexpr double kLargest = 1e150;
inline constexpr double kNarrowest = 1e-150;

/// The error of a check, or null if the check passes. Smaller than a Result: one word instead of twenty.
using Problem = std::unique_ptr<base::Error>;

Problem problem(base::ErrorCode code, const Place& place, std::string found, std::string wanted);

/// Whether `value` lies in [min, max]. False for NaN.
inline bool isWithin(double value, double min, double max) noexcept { return value >= min && value <= max; }

/// Checks that the number is finite and in [min, max].
Problem checkNumber(double value, double min, double max, const Place& place);

/// Checks that `count` is between 1 and `most`. `what`: the name of the counted things in the message.
Problem checkCount(std::size_t count, std::size_t most, std::string_view what, const Place& place);

/// Checks that `id` is a valid id and not yet in `seen`, and adds it to `seen`.
Problem checkUnique(NameList& seen, const std::string& id, const Place& place);

/// Checks a list of terms and puts their ids into `names`. `output`: the output variable if the terms belong to it,
/// else null. Output terms must overlap its universe.
Problem checkTerms(const std::vector<Term>& terms, const Variable* output, const Place& place, NameList& names);

}  // namespace tactus::fuzzy
