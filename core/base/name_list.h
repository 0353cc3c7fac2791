// Lists of outside names in messages.
#pragma once

#include <span>
#include <string>

namespace tactus::base {

/// Outside names for a message: quoted (error.h), with commas between them, and `…` in place of those beyond some 200
/// bytes.
std::string listed(std::span<const std::string> names);

}  // namespace tactus::base
