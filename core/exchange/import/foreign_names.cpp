#include "core/exchange/import/foreign_names.h"

#include "core/base/close_match.h"
#include "core/base/text.h"

namespace tactus::exchange {
namespace {

constexpr std::size_t kLongestId = 64;

bool isIdCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

}  // namespace

std::string idFrom(std::string_view name, const std::string& otherwise) {
  std::string out;
  bool gap = false;
  for (const char c : name) {
    if (isIdCharacter(c)) {
      if (gap && !out.empty() && out.back() != '_' && c != '_') out += '_';
      out += c;
    }
    gap = !isIdCharacter(c);
  }
  if (out.find_first_not_of('_') == std::string::npos) return otherwise;
  return out.substr(0, kLongestId);
}

void ForeignNames::add(std::string_view name) {
  const std::size_t index = names_.size();
  names_.emplace_back(name);
  for (auto* list : {&exact_, &loose_}) {
    const auto [found, is_new] = list->emplace(list == &exact_ ? std::string(name) : loose(name), index);
    if (!is_new) found->second = kSeveral;
  }
}

std::optional<std::size_t> ForeignNames::find(std::string_view name) const {
  auto found = exact_.find(name);
  if (found == exact_.end()) {
    found = loose_.find(loose(name));
    if (found == loose_.end()) return std::nullopt;
  }
  return found->second == kSeveral ? std::nullopt : std::optional(found->second);
}

std::string ForeignNames::listed() const { return base::listed(names_); }

std::string ForeignNames::suggestion(std::string_view name) const { return base::suggestion(name, names_); }

std::string ForeignNames::loose(std::string_view name) const {
  if (format_ == ImportFormat::kFcl) return base::lowered(name);
  std::string out;
  for (const char c : name) {
    if (isIdCharacter(c) || c == '.' || format_ == ImportFormat::kFis) out += c;
  }
  return out;
}

}  // namespace tactus::exchange
