// What is wrong where a JSON text breaks off, in words for a person.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace tactus::base {

/// `line 3, column 14` of the byte `at` of `text`; both count from 1, columns count characters.
std::string linePlace(std::string_view text, std::size_t at);

/// The error where a parser stopped in `text` after reading `position` bytes; more than the text has means at its end.
Error syntaxError(std::string_view text, std::size_t position);

}  // namespace tactus::base
