// What each expert does to the averaged force, and how far two experts are apart, in newtons.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"

namespace tactus::elicitation {

/// A difference of forces and the point where it was seen.
struct SeenDifference {
  double newtons = 0;
  double noticeable = 0;   ///< the same in just-noticeable differences at the averaged force there
  std::vector<double> at;  ///< one value per input, in the model's order
};

/// The averaged force with and without one expert.
struct ExpertInfluence {
  std::string expert;
  double rms_n = 0;  ///< over the points where the others give a force too
  /// The largest change in newtons, and the largest in just-noticeable differences; nothing where the expert never
  /// fires together with another one.
  std::optional<SeenDifference> largest;
  std::optional<SeenDifference> most_noticeable;
  /// Share of the space where this expert alone fires: without the expert the model abstains there.
  double share_alone = 0;
  std::vector<double> alone_at;  ///< one such point; empty where none was seen
};

/// The forces of two experts, where both fire.
struct ExpertDistance {
  std::string first;
  std::string second;
  double rms_n = 0;
  std::optional<SeenDifference> largest;  ///< noticeable: at the mean of the two
  double share_both = 0;                  ///< share of the space where both fire
};

struct ExpertInfluences {
  std::vector<ExpertInfluence> experts;  ///< in the model's order
  std::vector<ExpertDistance> pairs;     ///< first with second, first with third, …
  std::size_t kink_points = 0;           ///< where the largest differences were looked for
  std::size_t spread_points = 0;         ///< the others, spread evenly; root mean squares and shares are over these
};

/// Leaves each expert of `model` out of the averaged force (paper, Eq. 2) in turn and compares experts in pairs.
///
/// The largest differences are looked for at every combination of the vertices of all terms and the middles between
/// them (a deterministic selection where these are more than 200,000 or the model is large) and at 8,192 points spread
/// evenly, so they are lower bounds of the true ones. Root mean squares and shares weigh the whole input space evenly.
/// An expert of weight 0 changes nothing. The error is that of `fuzzy::compile`.
base::Result<ExpertInfluences> expertInfluence(const fuzzy::ForceModel& model);

/// From how many just-noticeable differences on a change of the mean is worth a note.
inline constexpr double kNotableDifference = 2;

/// One sentence for each expert without whom the mean would change by more than kNotableDifference somewhere.
std::vector<std::string> influenceNotes(const fuzzy::ForceModel& model, const ExpertInfluences& influences);

/// `lubrication 1, neck flexion 60 deg, depth 200 mm, speed 50 mm/s`: a point of the input space for people.
std::string pointText(const fuzzy::ForceModel& model, const std::vector<double>& point);

}  // namespace tactus::elicitation
