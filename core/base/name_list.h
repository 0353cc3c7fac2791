// Lists of outside names in messages.
#pragma once

#include <span>
#include <string>

namespace tactus::base {

/// Outside names for a message: quoted (error.h), separated by commas. After about 200 bytes, `…` replaces the rest.
std::string listed(std::span<const std::string> names);

}  // namespace tactus::base
