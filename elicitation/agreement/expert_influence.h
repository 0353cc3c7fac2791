// The influence of each expert on the averaged force, and the distance between two experts, in N.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"

namespace tactus::elicitation {

/// A difference of forces and its point.
struct SeenDifference {
  double newtons = 0;
  double noticeable = 0;   ///< the same in just-noticeable differences at the averaged force of the point
  std::vector<double> at;  ///< one value per input, in the model's order
};

/// The averaged force with and without one expert.
struct ExpertInfluence {
  std::string expert;
  double rms_n = 0;  ///< over the points where the other experts also give a force
  /// The largest change in N, and the largest in just-noticeable differences. Empty if the expert never fires together
  /// with another one.
  std::optional<SeenDifference> largest;
  std::optional<SeenDifference> most_noticeable;
  /// Share of the space where only this expert fires; without the expert the model abstains there.
  double share_alone = 0;
  std::vector<double> alone_at;  ///< one such point; empty if none was found
};

/// The difference between the forces of two experts, over the points where both fire.
struct ExpertDistance {
  std::string first;
  std::string second;
  double rms_n = 0;
  std::optional<SeenDifference> largest;  ///< `noticeable` is taken at the mean of the two
  double share_both = 0;                  ///< share of the space where both experts fire
};

struct ExpertInfluences {
  std::vector<ExpertInfluence> experts;  ///< in the model's order
  std::vector<ExpertDistance> pairs;     ///< first with second, first with third, …
  std::size_t kink_points = 0;           ///< points tried for the largest differences
  std::size_t spread_points = 0;         ///< evenly spread points, used for root mean squares and shares
};

/// Leaves each expert of `model` out of the averaged force (paper, Eq. 2) in turn, and compares experts in pairs.
///
/// The largest differences are searched at every combination of the vertices of all terms and their midpoints (a
/// deterministic selection if there are more than 200,000 or the model is large), and at 8,192 evenly spread points. So
/// they are lower bounds of the true ones. Root mean squares and shares weigh the whole input space evenly. An expert
/// of weight 0 changes nothing. Returns the error of `fuzzy::compile`.
/// `go_on`: asked about a thousand points each with the share that is done, [0, 1]; false ends with an error of kind
/// kCancelled.
base::Result<ExpertInfluences> expertInfluence(const fuzzy::ForceModel& model,
                                               const std::function<bool(double share)>& go_on = {});

/// Change of the mean, in just-noticeable differences, above which a note is made.
inline constexpr double kNotableDifference = 2;

/// One sentence for each expert whose removal would change the mean by more than kNotableDifference at some point.
std::vector<std::string> influenceNotes(const fuzzy::ForceModel& model, const ExpertInfluences& influences);

/// A point of the input space as text, e.g. `lubrication 1, neck flexion 60 deg, depth 200 mm, speed 50 mm/s`.
std::string pointText(const fuzzy::ForceModel& model, const std::vector<double>& point);
/// The same for a cell of a table: without the names of inputs that their unit tells, e.g. `lubrication 1, 60 deg, 200
/// mm, 50 mm/s`.
std::string shortPointText(const fuzzy::ForceModel& model, const std::vector<double>& point);

}  // namespace tactus::elicitation
