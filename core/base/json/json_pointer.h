// Places in a JSON text (RFC 6901), as errors name them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tactus::base {

/// The place of the member `key` of the object at `place`; `/` and `~` in the key are escaped.
std::string childPointer(const std::string& place, std::string_view key);

/// The place of element `index` of the array at `place`.
std::string childPointer(const std::string& place, std::size_t index);

}  // namespace tactus::base
