// A term of another program as Tactus carries it, exactly or not at all.
#pragma once

#include <optional>
#include <vector>

#include "core/exchange/import/foreign_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::exchange {

/// A shape of Tactus with its points.
struct CarriedTerm {
  fuzzy::Shape shape = fuzzy::Shape::kTrapezoid;
  std::vector<double> points;
};

/// Why a term is not carried.
struct TermProblem {
  base::Error error;
  bool is_wrong = false;  ///< the term makes no sense in its own format either, so the file is refused in any case
};

/// The places on the axis that the term needs; nothing for a shape that Tactus lacks. A Gaussian needs four sigmas.
std::optional<ForeignRange> reachOf(const ForeignTerm& term);

/// `term` on the universe `range`. Exact inside the universe: a rectangle, a ramp, a step and points that go from 0 to
/// 1 and back become trapezoids, and what continues beyond the universe ends at its end. `fold`: shoulders beyond the
/// universe are put back to its end (FIS files move them out).
tl::expected<CarriedTerm, TermProblem> carried(const ForeignTerm& term, ForeignRange range, bool fold,
                                               const SourceText& source);

/// NOT of a term: the part below its falling edge and the part above its rising edge, each 1 where the term is 0. None
/// where the term covers the universe. Nothing for a Gaussian, whose complement is no shape of Tactus.
std::optional<std::vector<CarriedTerm>> complement(const CarriedTerm& term, ForeignRange range);

/// Whether the term is above 0 in positive width of the universe.
bool meets(const CarriedTerm& term, ForeignRange range);

}  // namespace tactus::exchange
