// Which known word a mistyped one was meant to be.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace tactus::base {

/// Letters to insert, remove, replace, or swap with their neighbor to turn `a` into `b`; capitals count as small
/// letters (optimal string alignment, Damerau 1964).
std::size_t editDistance(std::string_view a, std::string_view b);

/// The one of `known` that differs least from `word`, the first on a tie: by at most a third of its letters and at
/// most 3. Empty if none is that close.
std::string closestWord(std::string_view word, std::span<const std::string> known);

/// ` (slow?)` for the closest known word, otherwise empty: to end the text of an error.
std::string suggestion(std::string_view word, std::span<const std::string> known);

}  // namespace tactus::base
