#include "core/exchange/import/foreign_model.h"

#include <algorithm>
#include <iterator>

#include "core/base/error.h"
#include "core/base/text.h"

namespace tactus::exchange {
namespace {

template <class Value>
struct Known {
  std::string_view word;
  Value value;
};

constexpr Known<Meaning> kMethods[] = {
    {"minimum", Meaning::kMinimum},
    {"min", Meaning::kMinimum},
    {"maximum", Meaning::kMaximum},
    {"max", Meaning::kMaximum},
    {"prod", Meaning::kProduct},
    {"product", Meaning::kProduct},
    {"algebraicproduct", Meaning::kProduct},
    {"centroid", Meaning::kCentroid},
    {"cog", Meaning::kCentroid},
    {"none", Meaning::kNone},
    {"", Meaning::kNone},
};

constexpr Known<ForeignShape> kShapes[] = {
    {"trapezoid", ForeignShape::kTrapezoid},
    {"trapezoidal", ForeignShape::kTrapezoid},
    {"trape", ForeignShape::kTrapezoid},
    {"trapmf", ForeignShape::kTrapezoid},
    {"triangle", ForeignShape::kTriangle},
    {"triangular", ForeignShape::kTriangle},
    {"trian", ForeignShape::kTriangle},
    {"trimf", ForeignShape::kTriangle},
    {"gaussian", ForeignShape::kGaussian},
    {"gauss", ForeignShape::kGaussian},
    {"gaussmf", ForeignShape::kGaussian},
    {"rectangle", ForeignShape::kRectangle},
    {"rectangular", ForeignShape::kRectangle},
    {"rectmf", ForeignShape::kRectangle},
    {"ramp", ForeignShape::kRamp},
    {"rampmf", ForeignShape::kRamp},
    {"linsmf", ForeignShape::kRising},
    {"linzmf", ForeignShape::kFalling},
    {"binary", ForeignShape::kStep},
    {"binarymf", ForeignShape::kStep},
    {"discrete", ForeignShape::kPoints},
    {"discretemf", ForeignShape::kPoints},
};

constexpr std::string_view kSugenoShapes[] = {"constant", "linear", "function", "singletons"};

constexpr std::string_view kHedges[] = {"any",  "extremely", "seldom",       "somewhat", "very", "slightly",
                                        "more", "less",      "more_or_less", "plus",     "norm"};

template <class Table, class Value>
Value find(const Table& table, std::string_view word, Value otherwise) {
  const std::string lower = base::lowered(word);
  const auto found = std::find_if(std::begin(table), std::end(table), [&](const auto& k) { return k.word == lower; });
  return found == std::end(table) ? otherwise : found->value;
}

std::size_t numbersOf(ForeignShape shape) {
  switch (shape) {
    case ForeignShape::kTrapezoid: return 4;
    case ForeignShape::kTriangle: return 3;
    default: return 2;
  }
}

}  // namespace

Method methodOf(Word word) { return {word, find(kMethods, word.text, Meaning::kOther)}; }

ForeignShape shapeOf(std::string_view word) { return find(kShapes, word, ForeignShape::kOther); }

std::string shapeFound(std::string_view word) {
  const std::string lower = base::lowered(word);
  const bool sugeno = std::find(std::begin(kSugenoShapes), std::end(kSugenoShapes), lower) != std::end(kSugenoShapes);
  return base::quoted(word) + (sugeno ? ", a function of a Takagi-Sugeno system" : "");
}

void takeHeight(ForeignTerm& term) {
  const bool extra = term.shape == ForeignShape::kPoints
                         ? term.numbers.size() % 2 == 1
                         : term.shape != ForeignShape::kOther && term.numbers.size() == numbersOf(term.shape) + 1;
  if (!extra) return;
  term.height = term.numbers.back();
  term.numbers.pop_back();
}

bool isAny(std::string_view word) { return base::lowered(word) == "any"; }

bool isHedge(std::string_view word) {
  const std::string lower = base::lowered(word);
  return std::find(std::begin(kHedges), std::end(kHedges), lower) != std::end(kHedges);
}

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
