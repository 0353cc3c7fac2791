#include "core/base/json/json_pointer.h"

namespace tactus::base {

std::string childPointer(const std::string& place, std::string_view key) {
  std::string out = place + '/';
  for (const char c : key) {
    if (c == '~') {
      out += "~0";
    } else if (c == '/') {
      out += "~1";
    } else {
      out += c;
    }
  }
  return out;
}

std::string childPointer(const std::string& place, std::size_t index) { return place + '/' + std::to_string(index); }

}  // namespace tactus::base
