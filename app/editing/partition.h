// Terms whose memberships sum to one everywhere (a Ruspini partition): found, kept and made.
#pragma once

#include <optional>
#include <vector>

#include "app/editing/term_list.h"

namespace tactus::editing {

/// The terms of a list in the order in which they follow each other on the universe, as indices.
using TermOrder = std::vector<std::size_t>;

/// The order in which trapezoids and triangles sum to one on the universe of `variable`: the first holds its lower end
/// in full, each right edge is the left edge of the next term, the last holds the upper end in full. Nothing where it
/// is not so; vertices count as equal within 1e-9 of the universe. Two terms with one vertical edge in common sum to
/// one but for that point.
std::optional<TermOrder> partitionOrder(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms);

/// Narrowest ramp that an edit leaves between two terms that sum to one, and narrowest output term: a share of the
/// universe. With a vertical edge two terms would both hold in full at one point.
inline constexpr double kNarrowestShare = 1e-6;

/// Makes the terms sum to one: neighbours, in the order of the middles of their cores, share the mean of the two edges
/// that face each other (sorted where they cross), the first and the last term are stretched to the ends of the
/// universe. Terms become trapezoids; a triangle that keeps its peak stays one. Refused: a Gaussian in the list.
base::Result<Edit> makeSumToOne(const fuzzy::ForceModel& model, const TermListId& list);

}  // namespace tactus::editing
