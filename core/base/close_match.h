// Finds the known word that a mistyped word probably means.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace tactus::base {

/// The number of letters to insert, remove, replace, or swap with their neighbor to turn `a` into `b`. Ignores case
/// (optimal string alignment, Damerau 1964).
std::size_t editDistance(std::string_view a, std::string_view b);

/// The element of `known` nearest to `word`, the first of equals. It may differ by at most a third of the letters of
/// `word`, and at most 3. Empty if no element is that close.
std::string closestWord(std::string_view word, std::span<const std::string> known);

/// ` (slow?)` for the closest known word, to append to an error; empty if there is none.
std::string suggestion(std::string_view word, std::span<const std::string> known);

}  // namespace tactus::base
