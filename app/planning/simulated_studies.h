// What all runs of simulated studies share: a seed for each study, the forces of a model, and the truth.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "app/planning/nurse_family.h"
#include "app/planning/simulated_people.h"
#include "app/planning/study_plan.h"
#include "core/base/error.h"
#include "core/fuzzy/force_model.h"

namespace tactus::planning {

/// A seed of its own for each number (Steele, Lea, Flood 2014).
std::uint64_t seedOf(std::uint64_t seed, std::uint64_t number);

/// The participants of study `number`, N1, N2 and so on: the same nurses whatever the number of strokes, and the first
/// ones whatever the number of nurses. Empty if the strokes of one cannot be clustered.
std::vector<NurseData> peopleOf(const Questions& questions, const NurseSource& source, const PlanSettings& settings,
                                std::uint64_t number, int nurses, int strokes);

/// The forces of a model at the points; false if it cannot be compiled. `silent`: counts those where no rule fires.
bool forcesOf(const fuzzy::ForceModel& model, const std::vector<std::vector<double>>& points, std::vector<double>& out,
              int& silent);

/// The truth at the points: the mean force of the true models of `settings.population` nurses, each with her own words.
base::Result<std::vector<double>> truthOf(const Questions& questions, const NurseSource& source,
                                          const PlanSettings& settings, const std::vector<std::vector<double>>& points,
                                          const std::function<bool(double)>& go_on);

}  // namespace tactus::planning
