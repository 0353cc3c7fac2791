// From a number of the model back to the records behind it. Places are indices into the study that built the model;
// the reader of the study file knows their ids.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/study/records.h"
#include "elicitation/model/model_builder.h"

namespace tactus::elicitation {

// Which rule of a built model an answer or a given rule of the study became.

/// A rule of a model: the number of its expert, and its number among the expert's rules.
struct RulePlace {
  std::size_t expert = 0;
  std::size_t rule = 0;

  bool operator==(const RulePlace&) const = default;
};

/// The rule that answer `index` of `study` became. Nothing for an answer without a word, and for one that rules given
/// directly replace. `built`: from `study`.
std::optional<RulePlace> ruleOfAnswer(const study::Study& study, const BuiltModel& built, std::size_t index);

/// The same for the rule `index` of Study::rules.
std::optional<RulePlace> ruleOfGiven(const study::Study& study, const BuiltModel& built, std::size_t index);

/// One stroke of a participant: all samples with these three.
struct StrokeKey {
  std::string participant;
  std::string level;
  int stroke = 0;

  bool operator==(const StrokeKey&) const = default;
};

/// The records behind a number, each once, in the order of the study.
struct Sources {
  std::vector<StrokeKey> strokes;
  std::vector<std::size_t> judgements;  ///< indices of Study::judgements
  std::vector<std::size_t> answers;     ///< indices of Study::answers
  std::vector<std::size_t> rules;       ///< indices of Study::rules
  /// One sentence for each part that comes from no record: default terms, terms placed between others.
  std::vector<std::string> without_records;

  bool empty() const noexcept { return strokes.empty() && judgements.empty() && answers.empty() && rules.empty(); }
};

/// What one participant gave to a vertex of the averaged speed terms.
struct VertexShare {
  std::string participant;
  double value_mm_s = 0;  ///< the participant's own vertex
  double share = 0;       ///< of the average; 0 for the median
  std::vector<StrokeKey> strokes;
};

/// The shares of the participants in vertex `point` (0 to 3) of the speed term `term`. Empty for default terms and for
/// a vertex at an end of the universe, which comes from no stroke. `built`: from `study` with `settings`. Returns an
/// error for an unknown term or vertex.
base::Result<std::vector<VertexShare>> speedVertexShares(const study::Study& study, const BuiltModel& built,
                                                         const BuildSettings& settings, std::string_view term,
                                                         std::size_t point);

/// The records behind vertex `point` of term `term` of the shared list of variable `variable`.
/// Speed: the strokes of the participants that were averaged. Force under the vote: the judgements at the steps where
/// the core of the term or of its neighbor begins or ends; under frequency and thresholds every judgement of the
/// series. Measured depths: no record, but a sentence about their image. Other variables have default terms. Returns an
/// error for an unknown variable, term or vertex.
base::Result<Sources> sourcesOfVertex(const study::Study& study, const BuiltModel& built, const BuildSettings& settings,
                                      std::string_view variable, std::string_view term, std::size_t point);

/// The judgements that were counted at one force of the vote.
Sources sourcesOfVote(const study::Study& study, const BuildSettings& settings, double force_n);

/// The answer or given rule behind rule `rule` of expert `expert` (indices in the model). Returns an error for a rule
/// that is not there.
base::Result<Sources> sourcesOfRule(const study::Study& study, const BuiltModel& built, std::size_t expert,
                                    std::size_t rule);

/// The records behind the averaged force at `inputs`: those of every rule that sets the strength of an output term of
/// an expert, and of the vertices of speed and force next to the point. Returns the error of analysis::explain.
base::Result<Sources> sourcesOfForce(const study::Study& study, const BuiltModel& built, const BuildSettings& settings,
                                     std::span<const double> inputs);

}  // namespace tactus::elicitation
