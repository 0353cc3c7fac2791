// The blind comparison of two models by hand (a duel) as a state machine: two strokes, "which was heavier?" or "which
// was more like a real insertion?", trial after trial; then a verdict. Its records restore it.
// Nothing that a screen may show says which model is in the hand: only `felt`, which is for the servo, does.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/study/session_records.h"
#include "experiments/two_interval.h"

namespace tactus::experiments {

/// Of the large catch trials: everybody tells it right who feels the strokes at all.
inline constexpr double kLargeCatchJnd = 3;
/// Fewer right answers to the large catch trials mark the result.
inline constexpr double kLeastLargeShare = 0.8;
/// Strokes of one trial must have the speed of the prompt within this share, because the force depends on it.
inline constexpr double kSpeedTolerance = 0.2;
/// From the end of the first stroke to the beginning of the second: the memory of a force fades.
inline constexpr double kLongestPauseS = 2;
inline constexpr int kMostSequentialTrials = 40;
inline constexpr int kRestEvery = 12;

/// One trial of the plan.
struct DuelTrial {
  study::DuelTrialKind kind = study::DuelTrialKind::kPair;
  bool second_first = false;  ///< `b`, or the heavier one, is felt first

  bool operator==(const DuelTrial&) const = default;
};
/// `trials` pairs, with catch trials between them. Both orders come equally often (within one, if `trials` is odd), in
/// random order within blocks of four, and never more than three times running. One catch trial for each nine pairs,
/// large and same in turn, which makes 5 to 10 % of all trials; a shorter plan has none. Catch trials are neither first
/// nor last nor beside each other.
std::vector<DuelTrial> duelTrials(int trials, std::uint64_t seed);
/// Trials of an own JND: no catch trials, because each trial is a known difference.
std::vector<DuelTrial> ownJndTrials(int trials, std::uint64_t seed);

/// What is in the hand.
struct DuelForce {
  bool is_b = false;
  double heavier_jnd = 0;  ///< the force is enlarged until it differs by this along the stroke

  bool operator==(const DuelForce&) const = default;
};

/// One stroke of the hand.
struct DuelStroke {
  double from_mm = 0;  ///< where the hand began to push
  double to_mm = 0;    ///< where it ended
  double mean_mm_s = 0;
  double pause_s = 0;  ///< since the stroke before it ended; used for the second one
};

enum class DuelRepeat { kNone, kNotWhole, kTooSlow, kTooFast, kPause };
/// `none`, `not_whole`, `too_slow`, `too_fast`, `pause`.
std::string_view name(DuelRepeat repeat) noexcept;

/// Returns an error with one sentence for a plan that cannot be carried out.
base::Result<void> validate(const study::DuelStart& start);

/// The state depends only on the plan and the records.
class DuelRun {
 public:
  enum class Stage { kFirstStroke, kSecondStroke, kQuestion, kFinished };

  /// `answers`: those of this duel so far, in the order of insertion. Returns an error if they do not fit the plan.
  static base::Result<DuelRun> create(const study::DuelStart& start, std::span<const study::DuelAnswer> answers = {});

  const study::DuelStart& start() const { return start_; }
  const std::vector<study::DuelAnswer>& answers() const { return answers_; }
  Stage stage() const { return stage_; }
  /// Why the current trial comes again.
  DuelRepeat repeat() const { return repeat_; }
  /// A rest is offered before the current trial.
  bool restFirst() const;
  /// Trials answered, catch trials included. Says nothing of who leads.
  int done() const { return static_cast<int>(done_); }
  /// All trials, catch trials included; for a sequential plan the most there can be.
  int all() const { return static_cast<int>(plan_.size()); }

  /// The force of the current stroke. For the servo alone. Needs a stroke.
  DuelForce felt() const;

  /// The hand has made the stroke: the second stroke, the question, or the trial comes again; then the record of that,
  /// which counts for nothing. The caller completes its entry. Needs a stroke.
  std::optional<study::DuelAnswer> stroke(const DuelStroke& stroke);
  /// The record of an answer. The caller completes its entry. Needs a question.
  study::DuelAnswer answer(study::DuelChoice choice, double response_s);

 private:
  DuelRun(const study::DuelStart& start, std::vector<DuelTrial> plan) : start_(start), plan_(std::move(plan)) {}
  const DuelTrial& trial() const { return plan_[done_]; }
  study::DuelAnswer record() const;
  void add(const study::DuelAnswer& answer);
  DuelRepeat wrongWith(const DuelStroke& stroke) const;
  bool isDecided() const;

  study::DuelStart start_;
  std::vector<DuelTrial> plan_;
  std::vector<study::DuelAnswer> answers_;
  std::size_t done_ = 0;
  int attempt_ = 1;
  Stage stage_ = Stage::kFirstStroke;
  DuelRepeat repeat_ = DuelRepeat::kNone;
  double first_mm_s_ = 0;
  double second_mm_s_ = 0;
  JndSearch search_;
};

/// What a duel shows.
struct DuelVerdict {
  enum class Outcome {
    kUnfinished,  ///< nothing is said of the answers so far
    kDiffer,
    kNotShown,
    kMeasured,  ///< of an own JND
  };
  Outcome outcome = Outcome::kUnfinished;
  int trials = 0;    ///< answered pairs
  double right = 0;  ///< of these, with "can't tell" as one half
  int cant_tell = 0;
  int repeated = 0;           ///< trials that came again
  int critical = 0;           ///< fewest right answers that show a difference; 0 for a sequential plan
  double chance = 1;          ///< of so many right answers without a difference; not for a sequential plan
  ShareInterval share;        ///< 95 %; of a sequential plan too narrow, because it stopped at a favourable moment
  double detectable_jnd = 0;  ///< would have been found with the plan's power
  std::optional<OrderEffect> order;  ///< where both orders were felt
  int large = 0;                     ///< large catch trials, and those told right
  int large_right = 0;
  int same = 0;  ///< same catch trials, and those in which a difference was named
  int same_named = 0;
  bool marked = false;        ///< too few of the large catch trials were told right
  std::optional<OwnJnd> own;  ///< of an own JND
};
DuelVerdict verdictOf(const study::DuelStart& start, std::span<const study::DuelAnswer> answers);

/// `differ`, `not_shown`, `measured`, `unfinished`.
std::string_view name(DuelVerdict::Outcome outcome) noexcept;

/// The end of the duel of `run`. The caller completes its entry.
study::DuelEnd endOf(const DuelRun& run);

/// `B "S4 alone" is felt as heavier: 18 of 23 (95 % interval 56–93 %).`, `Not shown to differ: … `, with what limits
/// it: sequential, catch trials, a device without force.
std::string sentenceOf(const study::DuelStart& start, const DuelVerdict& verdict);

/// A duel as a report shows it.
struct JudgedDuel {
  std::string participant;
  study::DuelStart start;
  DuelVerdict verdict;
};

/// A person who is simulated.
struct DuelResponder {
  double difference_jnd = 0;  ///< between the two models, in favour of the expected one
  double own_jnd = 1;         ///< as a multiple of the nominal one
  double order_bias = 0;      ///< > 0: the first of two equal strokes is named more often; in JND
  double cant_tell = 0;       ///< share of trials without an answer
  double off_speed = 0;       ///< share of strokes that are too fast
};
/// All records of a duel as `responder` does it. Deterministic in `seed`. Entries have neither ids nor times.
std::vector<study::DuelAnswer> simulatedAnswers(const study::DuelStart& start, const DuelResponder& responder,
                                                std::uint64_t seed);

}  // namespace tactus::experiments
