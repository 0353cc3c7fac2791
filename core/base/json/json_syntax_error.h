// Describes a JSON syntax error in words for the user.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace tactus::base {

/// `line 3, column 14` for the byte `at` of `text`. Both count from 1; columns count characters.
std::string linePlace(std::string_view text, std::size_t at);

/// The error if a parser stopped in `text` after `position` bytes. A position beyond the text means its end.
Error syntaxError(std::string_view text, std::size_t position);

}  // namespace tactus::base
