// The version of the programs.
#pragma once

#include <string_view>

namespace tactus {

inline constexpr std::string_view kVersion = TACTUS_VERSION;
inline constexpr std::string_view kGenerator = "tactus " TACTUS_VERSION;

}  // namespace tactus
