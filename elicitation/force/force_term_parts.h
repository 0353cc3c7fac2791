// What the ways from judgements to the terms of the force share (part of force_terms.h).
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "core/fuzzy/force_model.h"
#include "elicitation/force/force_end.h"
#include "elicitation/force/force_frequency_fit.h"
#include "elicitation/force/force_terms.h"

namespace tactus::elicitation {

/// `output` without terms on the universe that `end` says, with the notes of `end`.
ForceTerms emptyForceTerms(const fuzzy::Variable& output, const ForceEnd& end);

/// The universe of `out` ends `steps` steps above the last force with a term, at `end_n`; an end that was asked for
/// stays.
void endAbove(ForceTerms& out, const ForceEnd& end, std::size_t steps, double end_n);

/// `term` has no room in the universe: an absent term and a note.
void addAbsent(ForceTerms& out, const fuzzy::Term& term);

/// Nobody gave `term` to a force that counts; it lies between its neighbours, around `at_n`, or above the last force.
void addInterpolated(ForceTerms& out, const fuzzy::Term& term, const ForceEnd& end, double at_n);

/// The terms of `output`, one ramp between each two neighbours, ascending; the lowest and the highest have shoulders.
/// Terms without width in the universe of `out` are absent.
void placeBetween(const fuzzy::Variable& output, std::span<const TermRamp> ramps, ForceTerms& out);

}  // namespace tactus::elicitation
