// Reads a study from the disk and builds its model: the first half of `tactus build`. The commands that need a built
// model share it.
#pragma once

#include <string>
#include <vector>

#include "app/cli/commands.h"
#include "core/base/error.h"
#include "core/study/csv_tables.h"
#include "core/study/data_finding.h"
#include "elicitation/model/model_builder.h"
#include "experiments/order_effects.h"
#include "questionnaires/scale_summary.h"

namespace tactus::cli {

// What a person said is right though the program would refuse it: `--accept KIND`.

/// The ids of the kinds that can be accepted.
std::vector<std::string> acceptableWords();

/// The kinds called `words`; an error about the first that is none of them, with the known ones.
base::Result<std::vector<study::DataFinding::Kind>> acceptedKinds(const std::vector<std::string>& words);

/// `Accepted as it is: speed_unit of N1, N4; force_unit of N2.`, and which of `words` nothing was refused for.
std::vector<std::string> acceptedNotes(const std::vector<study::DataFinding>& findings,
                                       const std::vector<study::DataFinding::Kind>& accepted);

/// A JSON object with the participants of each kind that was accepted: `{"speed_unit": ["N1", "N4"]}`. Empty where
/// nothing was.
std::string acceptedJson(const std::vector<study::DataFinding>& findings,
                         const std::vector<study::DataFinding::Kind>& accepted);

struct StudyBuild {
  study::StudyTables tables;
  std::vector<study::DataFinding> data;
  std::vector<study::DataFinding::Kind> accepted;
  std::vector<std::string> notices;                     ///< about the file, with its name
  std::vector<questionnaires::ScaleSummary> usability;  ///< of a study file; empty without answers to the scale
  bool usability_simulated = false;                     ///< a simulated person gave one of these answers
  /// What each participant of a study file did in its order.
  base::Result<std::vector<experiments::DoneInOrder>> in_order;
  elicitation::BuildSettings settings;
  elicitation::BuiltModel built;

  /// The lines for standard error.
  std::vector<std::string> warnings() const;
};

/// Whether a study without answers and rules is refused, or gives its terms alone (elicitation::buildTerms).
enum class RulesNeeded { kYes, kNo };

/// Reads the study of `options`, checks its data and builds the model. Errors name the file or the option.
base::Result<StudyBuild> buildStudy(const BuildOptions& options, RulesNeeded rules = RulesNeeded::kYes);

}  // namespace tactus::cli
