#include "core/base/name_list.h"

#include "core/base/error.h"

namespace tactus::base {

std::string listed(std::span<const std::string> names) {
  constexpr std::size_t kLongestList = 200;
  std::string text;
  for (const auto& name : names) {
    text += (text.empty() ? "" : ", ") + base::quoted(name);
    if (text.size() > kLongestList && &name != &names.back()) return text + ", …";
  }
  return text;
}

}  // namespace tactus::base
