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

/// A cell of a table: `text`, escaped by base::oneLine, filled with spaces to `width` bytes, and by `gap` at least.
std::string padded(const std::string& text, std::size_t width, std::size_t gap = 1);

}  // namespace tactus::cli
