// Sentences and tables on a terminal.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tactus::cli {

inline constexpr std::size_t kTextColumns = 100;

/// `sentence` (UTF-8), escaped by base::oneLine, in lines of at most kTextColumns characters, each with a line feed.
/// Lines break at spaces; a longer word stays whole. The first line starts with `first`, all others with `indent`
/// spaces.
std::string wrapped(std::string_view sentence, std::string_view first, std::size_t indent);

/// The number of characters of `text` (UTF-8) on the screen, one for each code point.
std::size_t characters(std::string_view text);

/// A cell of a table: `text` (UTF-8), escaped by base::oneLine, with spaces behind it up to `width` characters, and at
/// least `gap` spaces.
std::string padded(std::string_view text, std::size_t width, std::size_t gap = 1);

/// The same with the spaces before the text, for numbers.
std::string rightAligned(std::string_view text, std::size_t width, std::size_t gap = 1);

}  // namespace tactus::cli
