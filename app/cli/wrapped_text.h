// Wraps sentences to the width of a terminal.
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

}  // namespace tactus::cli
