// The averaged force of a study with another counts: who is clustered, who votes, whose rules count.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/study/records.h"
#include "elicitation/model/model_builder.h"

namespace tactus::elicitation {

// Who takes part in one imagined repetition of a study: a resample, drawn from the participants with replacement.

/// How often each participant takes part, in the order of the study; 0: not at all.
using ResampleCounts = std::vector<std::size_t>;

struct WeightedResample {
  ResampleCounts counts;
  double weight = 1;  ///< its probability among all draws of as many people as there are
};

/// Each person once.
ResampleCounts everyPerson(std::size_t people);

/// As many draws as there are people, each of them equally likely.
ResampleCounts drawResample(std::size_t people, base::Random& random);

/// Largest number of people whose resamples are enumerated: 6,435 of them.
inline constexpr std::size_t kMostEnumerated = 8;

/// Every resample of `people` draws from as many, C(2n - 1, n) of them, with the weights n! / (c1! c2! …) / n^n, which
/// sum to 1. `people`: 1 to kMostEnumerated.
std::vector<WeightedResample> everyResample(std::size_t people);

/// One imagined study. Each part has its resample; usually all are the same.
struct Resample {
  ResampleCounts speeds;
  ResampleCounts judgements;
  ResampleCounts rules;
  /// What replaces the participants' own data, one entry per participant; empty: nothing. A participant without ramps
  /// has an empty list.
  std::vector<std::vector<Ramp>> ramps = {};
  std::vector<std::vector<study::ForceJudgement>> judged = {};
};

/// A study and its built model, prepared for many resamples. Immutable.
/// Thread: any.
class ResampledStudy {
 public:
  /// `built`: from `study` with `settings` by buildModel. Copies what it needs.
  ResampledStudy(const study::Study& study, const BuiltModel& built, const BuildSettings& settings);

  std::size_t people() const noexcept { return codes_.size(); }
  const std::vector<std::string>& codes() const noexcept { return codes_; }
  /// Whether the part is made from data; otherwise it has default terms and no resample changes it.
  bool hasSpeeds() const noexcept { return has_speeds_; }
  bool hasJudgements() const noexcept { return has_judgements_; }
  /// The participants' own ramps and judgements of the series that votes.
  const std::vector<std::vector<Ramp>>& ramps() const noexcept { return ramps_; }
  const std::vector<std::vector<study::ForceJudgement>>& judged() const noexcept { return judged_; }
  const fuzzy::ForceModel& model() const noexcept { return built_; }
  const BuildSettings& settings() const noexcept { return settings_; }

  /// The averaged model of `resample`: the same steps as buildModel. Errors are those of the steps, e.g. that the
  /// resample has no rules, no votes, or rules with a word that its votes gave no term.
  base::Result<fuzzy::ForceModel> model(const Resample& resample) const;

  /// Its forces at `points`; nothing where no rule fires. All nothing if the model cannot be built.
  std::vector<std::optional<double>> forces(const Resample& resample,
                                            std::span<const std::vector<double>> points) const;

 private:
  base::Result<fuzzy::Variable> outputOf(const Resample& resample) const;

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
