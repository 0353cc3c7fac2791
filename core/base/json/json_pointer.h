// Places in a JSON text (RFC 6901), as errors name them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tactus::base {

/// The pointer of the member `key` of the object at `place`. Escapes `/` and `~` in the key.
std::string childPointer(const std::string& place, std::string_view key);

/// The pointer of element `index` of the array at `place`.
std::string childPointer(const std::string& place, std::size_t index);

}  // namespace tactus::base
