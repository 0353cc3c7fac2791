// The stated bands on trial: simulated studies whose truth only the simulation knows, built and banded like any study,
// and how often the truth lies in the band (docs/uncertainty.md).
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "app/planning/nurse_family.h"
#include "app/planning/study_plan.h"
#include "core/base/error.h"

namespace tactus::planning {

struct TrialSettings {
  Design design;           ///< of every study; all questions of the form are asked
  std::size_t places = 3;  ///< in each region
  double coverage = 0.95;  ///< that the band states
  PlanSettings plan;       ///< studies, population, seed, threads, force terms and noise
};

/// Over all studies and the places of one region.
struct RegionTrial {
  std::string region;  ///< id of the term of the way; empty: all regions
  double covered = 0;  ///< share of the places and studies where the truth lies in the band
  double low = 0;      ///< 95 % interval of it for the number of studies: places of one study hold or fail together
  double high = 0;
  double error_n = 0;       ///< root mean square of the averaged force less the truth
  double error_jnd = 0;     ///< the same over the just-noticeable difference at the truth
  double half_width_n = 0;  ///< mean of the band's half width, before it is cut at the ends of the force
};

struct BandTrial {
  std::vector<RegionTrial> regions;  ///< along the way
  RegionTrial all;
  std::size_t studies = 0;  ///< of which a model was built
  double refused = 0;       ///< share of the studies without one
};

/// Draws `settings.plan.studies` studies from `source`, builds each with all its data (elicitation::buildModel) and
/// compares the band "others" with the truth (truthOf). The same arguments give the same bits. Refused: a design with
/// one nurse, for whom there is no band, and those of planStudy.
base::Result<BandTrial> tryBands(const Questions& questions, const NurseSource& source, const TrialSettings& settings,
                                 const std::function<bool(double share)>& go_on = {});

}  // namespace tactus::planning
