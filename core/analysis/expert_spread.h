// Where experts are so far apart that their mean is a force that none of them feels.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/analysis/force_probe.h"

namespace tactus::analysis {

/// The smallest difference of forces around a force that a hand feels, in the unit of the output.
using NoticeableDifference = std::function<double(double force)>;

/// Two experts at one point.
struct ExpertSpread {
  std::string region;    ///< term of the region input that is largest at the point; empty where there is no such input
  std::size_t low = 0;   ///< index of the expert with the smallest force
  std::size_t high = 0;  ///< and of the one with the largest
  double low_n = 0;      ///< their forces
  double high_n = 0;
  double mean_n = 0;        ///< the averaged force
  std::size_t nearest = 0;  ///< expert whose own force is nearest to the mean
  double nearest_n = 0;
  bool nobody_feels_mean = false;  ///< even that one is more than one noticeable difference away
  std::vector<double> point;
};

/// The point of each region where experts of weight > 0 that fire are farthest apart, if that is by more than `times`
/// noticeable differences around the averaged force; points where nobody feels the mean come before others. Regions
/// are the terms of the input `region_input` in the model's own list, in its order; without it the universe is one
/// region. Looks at `samples` combinations of vertices and the middles between them at most, so a difference may be
/// larger elsewhere.
std::vector<ExpertSpread> expertsApart(ForceProbe& probe, std::optional<std::size_t> region_input,
                                       const NoticeableDifference& noticeable, double times, std::size_t samples);

}  // namespace tactus::analysis
