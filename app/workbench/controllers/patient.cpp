#include "app/workbench/controllers/patient.h"

#include <algorithm>

#include "core/fuzzy/membership.h"

namespace tactus::workbench {

std::optional<std::size_t> inputNamed(const fuzzy::ForceModel& model, const char* id) {
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    if (model.inputs[i].id == id) return i;
  }
  return std::nullopt;
}

double coreMiddle(const fuzzy::Variable& variable, const fuzzy::Term& term) {
  const auto inside = [&variable](double x) { return std::clamp(x, variable.min, variable.max); };
  switch (term.shape) {
    case fuzzy::Shape::kTrapezoid:
      return (inside(term.points[1]) + inside(term.points[2])) / 2;
    case fuzzy::Shape::kTriangle:
      return inside(term.points[1]);
    case fuzzy::Shape::kGaussian:
      return inside(term.points[0]);
  }
  return variable.min;
}

std::optional<std::size_t> strongestTerm(const fuzzy::Variable& variable, double value) {
  std::optional<std::size_t> best;
  double largest = 0;
  for (std::size_t i = 0; i < variable.terms.size(); ++i) {
    const double membership = fuzzy::MembershipFunction::of(variable.terms[i])(value);
    if (membership <= largest) continue;
    largest = membership;
    best = i;
  }
  return best;
}

std::optional<NeckPostures> neckPostures(const fuzzy::Variable& neck_flexion) {
  if (neck_flexion.terms.size() < 2) return std::nullopt;
  return NeckPostures{coreMiddle(neck_flexion, neck_flexion.terms.front()),
                      coreMiddle(neck_flexion, neck_flexion.terms.back())};
}

}  // namespace tactus::workbench
