#include "core/analysis/strongest_term.h"

#include "core/fuzzy/membership.h"

namespace tactus::analysis {

std::optional<std::size_t> strongestTerm(const fuzzy::Variable& variable, double x) {
  std::optional<std::size_t> best;
  double largest = 0;
  for (std::size_t t = 0; t < variable.terms.size(); ++t) {
    const double membership = fuzzy::MembershipFunction::of(variable.terms[t])(x);
    if (membership <= largest) continue;
    largest = membership;
    best = t;
  }
  return best;
}

}  // namespace tactus::analysis
