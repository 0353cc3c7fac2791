#include "core/exchange/import/method_words.h"

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
    case ForeignShape::kTrapezoid:
      return 4;
    case ForeignShape::kTriangle:
      return 3;
    default:
      return 2;
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

}  // namespace tactus::exchange
