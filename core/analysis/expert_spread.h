// Points where the experts' forces differ so much that no expert feels the mean force.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/analysis/force_probe.h"

namespace tactus::analysis {

/// The smallest difference that a hand notices around a force, both in the unit of the output.
using NoticeableDifference = std::function<double(double force)>;

/// Two experts at one point.
struct ExpertSpread {
  std::string region;    ///< term of the region input with the largest membership; empty without a region input
  std::size_t low = 0;   ///< index of the expert with the smallest force
  std::size_t high = 0;  ///< index of the expert with the largest force
  double low_n = 0;      ///< their forces
  double high_n = 0;
  double mean_n = 0;        ///< the averaged force
  std::size_t nearest = 0;  ///< expert with the force nearest to the mean
  double nearest_n = 0;
  bool mean_far_from_all = false;  ///< the nearest force is also more than one noticeable difference away
  std::vector<double> point;
};

/// For each region: the point where the forces of the firing experts of weight > 0 differ most. Only points with a
/// difference of more than `times` noticeable differences around the averaged force count. Points where no expert feels
/// the mean come first.
/// Regions are the terms of the input `region_input` in the model's own list, in its order; without it the universe is
/// one region. Tries at most `samples` combinations of vertices and midpoints, so a difference may be larger elsewhere.
std::vector<ExpertSpread> expertsApart(ForceProbe& probe, std::optional<std::size_t> region_input,
                                       const NoticeableDifference& noticeable, double times, std::size_t samples);

}  // namespace tactus::analysis
