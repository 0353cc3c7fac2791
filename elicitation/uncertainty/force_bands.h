// How far the averaged force can be trusted: four bands with plain names, each with its parts.
//
//   "again":  these participants once more: other strokes of theirs, their judgements with the noise of a hand.
//   "others": as many other participants like these. The participants are drawn, each as a whole.
//   "next":   one more participant.
//   "words":  these participants' own words: the averaged rules with the force words of one of them at a time.
//
// Bands are for one point at a time, not for a whole curve. A band says nothing about holes: where a replicate gives no
// force it is left out, and `abstains` says how often.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/study/records.h"
#include "elicitation/model/model_builder.h"
#include "elicitation/speed/stroke_bootstrap.h"
#include "elicitation/uncertainty/own_words.h"

namespace tactus::elicitation {

// The averaged force of a study with another counts: who is clustered, who votes, whose rules count.

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
  /// The force with the default terms of the procedure.
  const fuzzy::Variable& defaultOutput() const noexcept { return default_output_; }
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

enum class BandKind { kAgain, kOthers, kNext, kWords };
/// `again`, `others`, `next`, `words`.
std::string_view name(BandKind kind) noexcept;

/// What is drawn anew in a plan; everything else stays.
enum class Drawn {
  kPeople,        ///< participants, each with all of their data
  kWhoMoved,      ///< whose strokes are clustered
  kWhoJudged,     ///< who votes on the forces
  kWhoAnswered,   ///< whose rules count
  kOwnStrokes,    ///< each participant's strokes, within each level
  kOwnJudgements  ///< each participant's judgements, with the noise of one just-noticeable difference
};
inline constexpr std::size_t kDrawnKinds = 6;
/// `people`, `who_moved`, `who_judged`, `who_answered`, `own_strokes`, `own_judgements`.
std::string_view name(Drawn drawn) noexcept;

/// The force at one point over the replicates of one plan.
struct DrawnForce {
  double mean_n = 0;
  double sd_n = 0;       ///< square root of the weighted mean square deviation from mean_n
  double abstains = 0;   ///< share of the replicates without a force there
  bool on_edge = false;  ///< the mean is more than a quarter of sd_n away from the estimate, which sits on an edge
};

struct BandPoint {
  std::optional<double> force_n;  ///< the averaged force; nothing where no rule fires
  double half_width_n = 0;        ///< before the band is cut at the ends of the force; of "words" half the range
  double low_n = 0;
  double high_n = 0;
  double abstains = 0;  ///< share of what the band is made of (draws, experts, participants) without a force there
  bool on_edge = false;
};

struct ForceBand {
  BandKind kind = BandKind::kOthers;
  std::vector<BandPoint> points;          ///< empty if the study has nothing to draw from
  std::vector<std::string> assumed;       ///< one sentence each
  std::vector<std::string> not_included;  ///< one sentence each
};

struct BandSettings {
  std::vector<std::vector<double>> points;  ///< one value per input of the model
  double coverage = 0.95;
  std::uint64_t seed = 1;
  std::size_t replicates = 2000;  ///< of each plan that is not enumerated; bands are shown from 200 on
  bool again = true;              ///< whether the plans of the band "again" are made
  bool others = true;             ///< whether the plans of the band "others" are made
  bool split = true;              ///< whether its parts are drawn too
  bool words = true;              ///< whether the band "words" is made
};

/// Adds replicates in batches, so that a caller can show, refine and stop.
/// With at most kMostEnumerated participants the plans that draw participants are enumerated: no random error.
/// Thread: any, one at a time.
class ForceBands {
 public:
  /// `built`: from `study` with `settings` by buildModel. Returns an error for a model that cannot be compiled.
  static base::Result<ForceBands> of(const study::Study& study, const BuiltModel& built, const BuildSettings& settings,
                                     BandSettings bands);

  /// Makes about `replicates` more, spread over the plans. Returns whether any is left to do.
  bool add(std::size_t replicates);
  std::size_t done() const;
  std::size_t planned() const;

  /// The band from the replicates so far (add() at least once).
  /// "others": force ± t(n-1) sqrt(n / (n-1)) sd of kPeople. "next": ± t(n-1) s sqrt(1 + 1/n), s the standard deviation
  /// of the experts' own forces; too narrow where they share words. "again": ± t sqrt(variances of kOwnStrokes,
  /// widened for few strokes, and kOwnJudgements). "words": from the lowest to the highest force under own words, no
  /// interval; it needs no replicates, and the averaged force can lie outside.
  /// With one participant "others" and "next" have no points; "words" has none if no force was judged.
  ForceBand band(BandKind kind) const;

  /// One entry per point, for each plan; empty for a plan that the study has no data for.
  std::vector<DrawnForce> drawn(Drawn plan) const;
  /// Each participant's own words, and the force under them at each point, participant after participant.
  const std::vector<OwnWords>& ownWords() const noexcept { return words_; }
  const std::vector<std::vector<std::optional<double>>>& underOwnWords() const noexcept { return under_words_; }
  /// The smallest force whose cumulated weight reaches `share`; nothing without a force. For comparisons.
  std::optional<double> drawnQuantile(Drawn plan, std::size_t point, double share) const;

 private:
  struct Plan {
    Drawn drawn = Drawn::kPeople;
    std::size_t planned = 0;
    std::vector<WeightedResample> resamples;                 // if enumerated
    std::vector<double> weights;                             // of the replicates made
    std::vector<std::vector<std::optional<double>>> forces;  // of the replicates made, one per point
  };

  ForceBands(ResampledStudy study, BandSettings settings);
  void prepareStrokes(const study::Study& study, const BuiltModel& built);
  void prepareThresholds(const BuiltModel& built);
  base::Result<void> prepareWords(const study::Study& study, const BuiltModel& built);
  void plan();
  void addOne(Plan& plan);
  Resample nextOf(const Plan& plan, double& weight);
  std::vector<study::ForceJudgement> judgedAgain(std::size_t who);
  const Plan* find(Drawn drawn) const;
  void setHalfWidths(BandKind kind, ForceBand& band) const;
  ForceBand wordBand() const;

  ResampledStudy study_;
  BandSettings settings_;
  base::Random random_;
  std::vector<Plan> plans_;
  std::vector<std::optional<double>> own_;                   // the averaged force at each point
  std::vector<std::vector<std::optional<double>>> experts_;  // each expert's own force at each point
  double lowest_n_ = 0;
  double highest_n_ = 0;
  std::vector<std::optional<StrokeBootstrap>> strokes_;  // of each participant; absent without speeds
  std::optional<DrawSpread> stroke_spread_;              // absent if strokes cannot be drawn
  std::string no_strokes_;                               // why not
  std::vector<std::vector<double>> thresholds_n_;        // of each participant; empty without judgements
  std::vector<OwnWords> words_;
  std::vector<std::vector<std::optional<double>>> under_words_;  // of each of words_, at each point
};

}  // namespace tactus::elicitation
