// Removes the names of a person from a remaining text: codes of a participant who withdrew.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace tactus::base {

/// The replacement of a name.
inline constexpr std::string_view kRemovedName = "(withdrawn)";

/// Whether `text` contains one of `names`. Empty names never match. A name may be the start of a longer word
/// (`velvet-otters`). It does not match:
/// - at the end of a longer word;
/// - at the start of another number (`S4` in `S45`, or in `S4-2`, which is another code);
/// - as half of a two-word code (`calm` in `calm-fox`);
/// - as part of any word, if it has fewer than four bytes.
bool holdsName(std::string_view text, std::span<const std::string> names);

/// `text` with `(withdrawn)` in place of each of `names`. The order of the names does not matter. Removing names one
/// after the other gives the same text as removing all at once.
std::string withoutNames(std::string_view text, std::span<const std::string> names);

}  // namespace tactus::base
