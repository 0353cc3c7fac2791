#include "core/exchange/import/foreign_model.h"

namespace tactus::exchange {
namespace {

std::optional<base::Error> overLimit(const SourceText& source, Word name, std::size_t count, std::size_t most,
                                     const std::string& what) {
  if (count < most) return std::nullopt;
  return source.error(base::ErrorCode::kLimit, name.at,
                      what + " " + std::to_string(count + 1) + ", " + base::quoted(name.text),
                      "at most " + std::to_string(most));
}

}  // namespace

std::optional<base::Error> tooMany(const SourceText& source, const std::vector<ForeignVariable>& variables, Word name) {
  return overLimit(source, name, variables.size(), kMostForeignVariables, "variable");
}

std::optional<base::Error> tooMany(const SourceText& source, const std::vector<ForeignTerm>& terms, Word name) {
  return overLimit(source, name, terms.size(), kMostForeignTerms, "term");
}

}  // namespace tactus::exchange
