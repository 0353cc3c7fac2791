// What nurses of a family give to one simulated study, and the model that the pipeline builds from it.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "app/planning/nurse_family.h"
#include "core/base/error.h"
#include "core/base/random.h"
#include "core/fuzzy/force_model.h"
#include "core/study/records.h"
#include "elicitation/force/force_terms_from.h"
#include "elicitation/speed/speed_terms.h"

namespace tactus::planning {

/// The data of one nurse in one study.
struct NurseData {
  std::vector<study::ForceJudgement> judged;
  std::vector<std::size_t> words;        ///< one per question
  std::vector<double> strokes_mm_s;      ///< mean speeds, stroke after stroke at each word of the rate
  std::vector<elicitation::Ramp> ramps;  ///< of her clustered strokes
  double largest_centre_mm_s = 0;
};

/// Her data with `noise` drawn from `random`, with `strokes` at each speed. `code`: of the participant.
base::Result<NurseData> dataOf(const Questions& questions, const TrueNurse& nurse, const RepeatNoise& noise,
                               int strokes, const std::string& code, base::Random& random);
/// The same without any noise: she herself.
base::Result<NurseData> trueDataOf(const Questions& questions, const TrueNurse& nurse);

/// Adds her to `study` as a simulated participant with all that she gave, so that it can be built as any other. `form`:
/// the one of the questions. Strokes are moved with the shape of the published ones.
void addTo(study::Study& study, const study::Form& form, const std::string& code, const NurseData& data);

/// The force terms of the judgements of `people`, as buildModel makes them.
base::Result<fuzzy::Variable> outputOf(const Questions& questions, std::span<const NurseData> people,
                                       elicitation::ForceTermsFrom way);

/// The averaged model of `people` with the answers to `asked` (indices of questions), as buildModel makes it.
/// `output`: outputOf the same people.
fuzzy::ForceModel modelOf(const Questions& questions, std::span<const NurseData> people,
                          std::span<const std::size_t> asked, const fuzzy::Variable& output);

}  // namespace tactus::planning
