// The force-perception experiment (paper, Section 3.1.5) as a state machine: the next force, and the judgement of the
// last one.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/study/session_records.h"
#include "experiments/force_series.h"

namespace tactus::experiments {

/// One possible answer.
struct ForceAnswerOption {
  study::ForceJudgement::Kind kind = study::ForceJudgement::Kind::kTerm;
  std::string id;             ///< a term id, `not_felt` or `beyond_practice`
  bool our_addition = false;  ///< not one of the paper's five terms, and never counted as a term

  bool operator==(const ForceAnswerOption&) const = default;
};

/// Why a step comes again.
enum class RepeatReason {
  kNone,          ///< the first attempt
  kStoodStill,    ///< the hand did not move forward while it felt the force
  kNotDelivered,  ///< the device did not give the whole force
};

/// `none`, `stood_still`, `not_delivered`.
std::string_view name(RepeatReason reason) noexcept;

/// The part of a step that the participant may see: no force, no step number, no position in the series.
struct ForceQuestion {
  std::vector<ForceAnswerOption> answers;
  std::string repeat_reason;                  ///< one sentence: why the step is repeated; empty for the first attempt
  RepeatReason repeat = RepeatReason::kNone;  ///< the same for screens in other languages
  bool rest_first = false;                    ///< offer a rest before this step

  bool operator==(const ForceQuestion&) const = default;
};

/// The next step. `question` is for the participant, the other members for the servo and the researcher.
struct ForcePlan {
  bool finished = false;  ///< no step is left; all other members are then invalid
  SeriesStep step;
  int attempt = 1;
  double pause_before_s = 0;           ///< without force, before the step can start
  double start_zone_mm = 0;            ///< it starts when the stylus is held within this way of its place of rest
  double ramp_s = 0;                   ///< from no force to the full force
  std::optional<double> hold_limit_s;  ///< the force fades after this time; nothing = it is held until the answer
  double forward_least_mm = 0;         ///< the judgement counts after this way forward
  double forward_least_mm_s = 0;
  double device_scale = 1;  ///< the device gives the force divided by it
  ForceQuestion question;

  bool operator==(const ForcePlan&) const = default;
};

/// The result of one step.
struct ForceAnswer {
  study::ForceJudgement::Kind kind = study::ForceJudgement::Kind::kNoAnswer;
  std::string term;       ///< if `kind` is kTerm
  int feel_again = 0;     ///< number of times that the participant asked to feel it again
  double forward_mm = 0;  ///< from ForwardMotion, between the full force and the answer
  double forward_speed_mm_s = 0;
  double response_s = 0;  ///< from the full force to the answer
  bool delivered = true;  ///< false: a stall, a trip or a limit kept the force from the hand (stimulus_delivery.h)
  /// The least share of the force that was in the hand, [0, 1] (StimulusDelivery::leastShare); nothing: not known. Less
  /// than kLeastShare counts as not delivered.
  std::optional<double> delivered_share = {};
  std::optional<bool> would_stop = {};  ///< whether she would stop at this force; nothing: not asked
};

/// A force that was cut by more than 1 % is not the force of the step; the smallest difference that a hand feels is
/// about 12 %.
inline constexpr double kLeastShare = 0.99;

/// The state depends only on settings, seed and records, so an interrupted session can continue from its records.
///
/// Order: familiarisation, ascending series (to its end or to the first `beyond_practice`), descending series, random
/// block. A judgement without forward motion, or of a force that was not delivered, is recorded but not scored, and its
/// step comes again, until `attempts_most` of them: then the step is left out. Corrections (`entry.supersedes`) count
/// instead of what they correct: where one takes a `beyond_practice` back, the ascending series continues.
class ForceProtocol {
 public:
  /// `records`: those of the session so far, in the order of insertion. Returns an error if they do not fit the
  /// settings.
  static base::Result<ForceProtocol> create(const ForceSettings& settings, std::uint64_t seed,
                                            std::span<const study::JudgementRecord> records = {});

  ForcePlan next() const;

  /// The record of an answer to the step of next(). The caller completes its entry. Returns an error for an answer that
  /// was not offered, or an impossible number (a negative distance or time). `kNoAnswer` is always allowed.
  base::Result<study::JudgementRecord> record(const ForceAnswer& answer) const;

  /// The last judgement that counts, of a step that asked for a word; null if there is none.
  const study::JudgementRecord* lastScored() const;
  /// The correction of lastScored() with another of the answers: it keeps what was measured. The caller completes its
  /// entry. Returns an error for an answer that was not offered, and if there is nothing to correct.
  base::Result<study::JudgementRecord> correction(study::ForceJudgement::Kind kind, const std::string& term) const;

  /// Adds a stored record: the next step, or a correction of an earlier one. For any other record returns an error and
  /// changes nothing.
  base::Result<void> add(const study::JudgementRecord& record);

  /// The steps known so far, done or not. Grows when the ascending series ends. For the researcher.
  std::vector<SeriesStep> steps() const;

 private:
  ForceProtocol(const ForceSettings& settings, std::uint64_t seed, std::vector<SeriesStep> block);
  std::optional<SeriesStep> nextStep() const;
  std::vector<SeriesStep> ascendingSteps() const;
  bool isScored(const SeriesStep& step) const;
  bool isDone(const SeriesStep& step) const;
  std::optional<SeriesStep> stepFor(const study::JudgementRecord& record) const;
  int attemptsAt(const SeriesStep& step) const;
  bool movedForward(const study::JudgementRecord& record) const;
  RepeatReason repeatReason(const SeriesStep& step) const;

  ForceSettings settings_;
  std::uint64_t seed_;
  std::vector<SeriesStep> block_;
  std::vector<study::JudgementRecord> judgements_;  ///< a correction replaces the corrected record
};

}  // namespace tactus::experiments
