#include "core/fuzzy/force_model.h"

#include <algorithm>

namespace tactus::fuzzy {

std::string_view name(Shape shape) noexcept {
  switch (shape) {
    case Shape::kTrapezoid:
      return "trapezoid";
    case Shape::kTriangle:
      return "triangle";
    case Shape::kGaussian:
      return "gaussian";
  }
  return "";
}

std::string_view name(Implication implication) noexcept { return implication == Implication::kClip ? "clip" : "scale"; }

std::size_t pointCount(Shape shape) noexcept {
  switch (shape) {
    case Shape::kTrapezoid:
      return 4;
    case Shape::kTriangle:
      return 3;
    case Shape::kGaussian:
      return 2;
  }
  return 0;
}

const Term* findTerm(const std::vector<Term>& terms, std::string_view id) noexcept {
  const auto it = std::find_if(terms.begin(), terms.end(), [id](const Term& term) { return term.id == id; });
  return it == terms.end() ? nullptr : &*it;
}

const std::vector<Term>& termsFor(const Expert& expert, const Variable& variable) noexcept {
  for (const auto& own : expert.overrides) {
    if (own.variable == variable.id) return own.terms;
  }
  return variable.terms;
}

}  // namespace tactus::fuzzy
