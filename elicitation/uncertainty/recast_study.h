// The averaged force of a study with another cast: who is clustered, who votes, whose rules count.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/study/records.h"
#include "elicitation/model/model_builder.h"
#include "elicitation/uncertainty/cast.h"

namespace tactus::elicitation {

/// One imagined study. Each part has its cast; usually all are the same.
struct Recast {
  Cast speeds;
  Cast judgements;
  Cast rules;
  /// What replaces the participants' own data, one entry per participant; empty: nothing. A participant without ramps
  /// has an empty list.
  std::vector<std::vector<Ramp>> ramps = {};
  std::vector<std::vector<study::ForceJudgement>> judged = {};
};

/// A study and its built model, prepared for many casts. Immutable.
/// Thread: any.
class RecastStudy {
 public:
  /// `built`: from `study` with `settings` by buildModel. Copies what it needs.
  RecastStudy(const study::Study& study, const BuiltModel& built, const BuildSettings& settings);

  std::size_t people() const noexcept { return codes_.size(); }
  const std::vector<std::string>& codes() const noexcept { return codes_; }
  /// Whether the part is made from data; otherwise it has default terms and no cast changes it.
  bool hasSpeeds() const noexcept { return has_speeds_; }
  bool hasJudgements() const noexcept { return has_judgements_; }
  /// The participants' own ramps and judgements of the series that votes.
  const std::vector<std::vector<Ramp>>& ramps() const noexcept { return ramps_; }
  const std::vector<std::vector<study::ForceJudgement>>& judged() const noexcept { return judged_; }
  const fuzzy::ForceModel& model() const noexcept { return built_; }
  const BuildSettings& settings() const noexcept { return settings_; }

  /// The averaged model of `recast`: the same steps as buildModel. Errors are those of the steps, e.g. that the cast
  /// has no rules, no votes, or rules with a word that its votes gave no term.
  base::Result<fuzzy::ForceModel> model(const Recast& recast) const;

  /// Its forces at `points`; nothing where no rule fires. All nothing if the model cannot be built.
  std::vector<std::optional<double>> forces(const Recast& recast, std::span<const std::vector<double>> points) const;

 private:
  base::Result<fuzzy::Variable> outputOf(const Recast& recast) const;

  BuildSettings settings_;
  fuzzy::ForceModel built_;
  fuzzy::Variable default_output_;
  std::vector<std::string> codes_;
  std::vector<std::vector<Ramp>> ramps_;
  std::vector<double> speed_weights_;
  std::vector<std::vector<study::ForceJudgement>> judged_;
  std::vector<std::size_t> expert_of_;  ///< index in the model's experts; experts.size() without rules
  bool has_speeds_ = false;
  bool has_judgements_ = false;
};

}  // namespace tactus::elicitation
