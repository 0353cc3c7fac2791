// Shared parts of the methods for the force terms (part of force_terms.h).
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/fuzzy/force_model.h"
#include "elicitation/force/force_end.h"
#include "elicitation/force/force_frequency.h"
#include "elicitation/force/force_terms.h"

namespace tactus::elicitation {

/// `output` without terms, on the universe given by `end`, with the notes of `end`.
ForceTerms emptyForceTerms(const fuzzy::Variable& output, const ForceEnd& end);

/// Ends the universe of `out` at `end_n`, `steps` steps above the last force with a term. A requested end stays.
void endAbove(ForceTerms& out, const ForceEnd& end, std::size_t steps, double end_n);

/// Records `term` as absent, because it does not fit into the universe, and adds a note.
void addAbsent(ForceTerms& out, const fuzzy::Term& term);

/// Records `term` as interpolated, because no counting force got it. It lies between its neighbors, around `at_n`, or
/// above the last force.
void addInterpolated(ForceTerms& out, const fuzzy::Term& term, const ForceEnd& end, double at_n);

/// Sets the terms of `output`, with one ramp between two neighbors, ascending. The lowest and the highest have
/// shoulders. Terms without width in the universe of `out` become absent.
void placeBetween(const fuzzy::Variable& output, std::span<const TermRamp> ramps, ForceTerms& out);

/// A ramp of up to `half_n` to both sides of each threshold (ascending or equal), of up to `last_half_n` around the
/// last one; narrower if a neighbor is nearer. Equal thresholds share the width.
std::vector<TermRamp> rampsAround(std::span<const double> threshold_n, double half_n, double last_half_n);

/// `force_n`, rounded to a micronewton.
double toMicronewton(double force_n);

}  // namespace tactus::elicitation
