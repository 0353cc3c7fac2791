// Takes the names of a person out of a text that stays: codes of a participant who withdrew.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace tactus::base {

/// What stands in place of a name.
inline constexpr std::string_view kRemovedName = "(withdrawn)";

/// Whether `text` holds one of `names`. A name may be part of a longer word (`velvet-otters`), but not the end of one,
/// not the beginning of another number (`S4` in `S45` or in `S4-2`, which is another code), not half of a code of two
/// words (`calm` in `calm-fox`), and, with fewer than four bytes, no part of a word at all. Empty names are nowhere.
bool holdsName(std::string_view text, std::span<const std::string> names);

/// `text` with `(withdrawn)` in place of each of `names`. The order of the names does not matter, and names that are
/// taken out one after the other leave the same text as all at once.
std::string withoutNames(std::string_view text, std::span<const std::string> names);

}  // namespace tactus::base
