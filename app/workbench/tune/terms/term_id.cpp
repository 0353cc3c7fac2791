#include "app/workbench/tune/terms/term_id.h"

#include <cstddef>

namespace tactus::workbench {
namespace {

constexpr std::size_t kLongestId = 48;  // bytes; leaves room for a number behind it

}  // namespace

std::string termIdFrom(const QString& label) {
  std::string id;
  for (const QChar letter : label.toLower()) {
    const char c = letter.toLatin1();
    const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    if (plain) {
      id += c;
    } else if (!id.empty() && id.back() != '_') {
      id += '_';
    }
    if (id.size() == kLongestId) break;
  }
  while (!id.empty() && id.back() == '_') id.pop_back();
  return id.empty() ? "term" : id;
}

}  // namespace tactus::workbench
