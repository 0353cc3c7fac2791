#include "app/workbench/tune/terms/roomiest_place.h"

#include <algorithm>

#include "core/fuzzy/membership.h"

namespace tactus::workbench {

double roomiestPlace(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms) {
  std::vector<fuzzy::MembershipFunction> shapes;
  for (const fuzzy::Term& term : terms) {
    auto shape = fuzzy::MembershipFunction::of(term);
    if (shape.gaussian)
      shape = {false, shape.mean - 3 * shape.sigma, shape.mean, shape.mean, shape.mean + 3 * shape.sigma};
    shapes.push_back(shape);
  }
  std::sort(shapes.begin(), shapes.end(), [](const auto& one, const auto& other) { return one.a < other.a; });
  double gap_end = variable.min;
  double widest_gap = 0;
  double widest_core = 0;
  double in_gap = 0;
  double in_core = (variable.min + variable.max) / 2;
  const auto offer_gap = [&](double to) {
    if (to - gap_end > widest_gap) {
      widest_gap = to - gap_end;
      in_gap = (gap_end + to) / 2;
    }
  };
  for (const auto& shape : shapes) {
    offer_gap(std::min(shape.a, variable.max));
    gap_end = std::max(gap_end, shape.d);
    const double from = std::max(shape.b, variable.min);
    const double to = std::min(shape.c, variable.max);
    if (to - from > widest_core) {
      widest_core = to - from;
      in_core = from + 0.75 * (to - from);
    }
  }
  offer_gap(variable.max);
  return widest_gap > 0 ? in_gap : in_core;
}

}  // namespace tactus::workbench
