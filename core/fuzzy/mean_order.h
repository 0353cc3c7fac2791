// The order in which the evaluation at one point adds, for sources in other languages that are to give its bits.
#pragma once

#include <cstddef>
#include <vector>

#include "core/fuzzy/compiled_model.h"

namespace tactus::fuzzy {

/// Where every expert fires, the mean is the sum of the teams, one after the other. Of a team with the offsets o and
/// the shares s it is (o0 s0 + o2 s2) + (o1 s1 + o3 s3), where places that are left hold 0. Elsewhere the experts that
/// fire follow each other in the order of the teams: mean += (o - mean) (w / sum of w), the sum of the weights so far
/// in a long double.
struct MeanOrder {
  struct Team {
    /// One expert: area and moment are those of the output terms, each less its overlap with the next, and are added as
    /// ((t0 + t4) + (t2 + t6)) + ((t1 + t5) + (t3 + t7)). Else they are added and taken away term after term.
    bool alone = false;
    std::vector<std::size_t> experts;  ///< up to four
  };
  std::vector<Team> teams;     ///< empty: the general path evaluates everything
  std::vector<double> shares;  ///< of each expert: its weight relative to the sum of all
};

MeanOrder meanOrder(const CompiledModel& model);

}  // namespace tactus::fuzzy
