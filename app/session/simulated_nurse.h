// A simulated nurse who does a whole session. For tests and demonstrations only; it is not a model of a real person.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/session/session.h"
#include "app/session/simulated_strokes.h"
#include "core/base/random.h"
#include "core/study/records.h"
#include "experiments/published_tables.h"

namespace tactus::session {

// A simulated nurse's judgement of a force. For tests and demonstrations only; it is not a model of a real person.

// Simulated judgements of the force experiment with exactly the votes of Table 2. They are not the nurses' answers.

/// One ascending series of 0.1 to 1.7 N for each of S1 to S4. Table 2 gives the number of votes for each term at each
/// force, but not the voters. The votes are therefore split so that a person's terms never fall with the force: at each
/// force the k-th largest of the four votes is S<k>'s. So S1 is the first to call a force large and S4 the last. The
/// assignment is arbitrary, and voting does not depend on it. Above 1.1 N, "the upper bound of insertion force
/// experienced", all four judge `beyond_practice`.
std::vector<study::ForceJudgement> simulatedJudgements();

/// The just noticeable difference of a force, N: sqrt(0.04² + (0.12 F)²), from the absolute threshold (0.04 N;
/// Feyzabadi 2013, King 2010) and a Weber fraction of 0.12 (Feyzabadi 2013 gives .08 to .13). `force_n` >= 0.
double justNoticeableN(double force_n);

/// The person, and the noise of the judgements.
struct ResponderTraits {
  std::string code;                 ///< participant
  std::vector<double> threshold_n;  ///< ascending thresholds between the terms, from the smallest term
  double felt_from_n = 0.04;        ///< a smaller percept is judged `not_felt`
  double stop_from_n = 1.0;         ///< a percept of this size or more: she would stop
  double beyond_from_n = 1.15;      ///< a percept of this size or more is judged `beyond_practice`
  double noise = 1;                 ///< noise of the percept in just-noticeable differences; 0: none
  double lapse = 0.02;              ///< probability of a random term, 0 to 1
  double assimilation = 0;          ///< share by which a percept moves toward the previous one, 0 to 1; 0.1 is usual
};

/// The four persons of simulatedJudgements(), whose votes are those of Table 2. A threshold is the middle between the
/// last force of a term and the first force of the next term; the lowest one is the middle between the first force and
/// 0 N. With `noise` and `lapse` 0 they reproduce Table 2, as one of many possible splits of its votes.
std::vector<ResponderTraits> respondersOfTable2();

struct Response {
  study::ForceJudgement::Kind kind = study::ForceJudgement::Kind::kNoAnswer;
  std::string term;
  double percept_n = 0;
};

/// Judges forces one after another. The order matters if `assimilation` is above 0.
class SimulatedResponder {
 public:
  /// `terms`: ids from the smallest term, one more than thresholds.
  SimulatedResponder(ResponderTraits traits, std::vector<std::string> terms);

  /// The judgement of a force that the moving hand feels, N.
  Response judge(double felt_n, base::Random& random);

 private:
  ResponderTraits traits_;
  std::vector<std::string> terms_;
  std::optional<double> before_n_;
};

/// The traits of a simulated nurse. Shares are probabilities, 0 to 1.
struct NurseTraits {
  study::ProfileRecord profile;                  ///< without its entry
  std::map<std::string, SimulatedLevel> levels;  ///< by the term id of each speed in the session
  ResponderTraits responder;
  std::vector<std::string> words = experiments::publishedVoteTerms();  ///< ids, from the smallest force
  std::vector<study::Answer> answers;  ///< to the items of the form; an item without an answer is skipped
  double stops_early = 0.08;           ///< share of strokes whose first attempt is too short
  double holds_still = 0.08;           ///< share of forces whose first attempt is judged without moving forward
  double second_thoughts = 0.06;       ///< share of answers that are corrected from a later page
};

/// Does the steps of a session through the same calls as the screens. Each action follows from the traits, the seed and
/// the step alone, so a resumed session continues as if it had not been interrupted.
class SimulatedNurse {
 public:
  /// Called before a record is made, with the duration of the action in seconds.
  using PassTime = std::function<void(double seconds)>;

  /// `judged`: the judgements before the session was resumed, in order. They matter only with an assimilation above 0.
  SimulatedNurse(NurseTraits traits, std::uint64_t seed, PassTime pass_time = {},
                 std::span<const study::JudgementRecord> judged = {});

  /// Does the next step of the session: exactly one record. The session must not be at its end. Refused: a step that
  /// the session refuses, a speed without strokes.
  base::Result<void> doNext(Session& session);

  /// Does all steps to the end of the session.
  base::Result<void> finish(Session& session);

 private:
  base::Random randomFor(const std::string& step) const;
  base::Result<void> doStroke(Session& session) const;
  base::Result<void> doJudgement(Session& session);
  base::Result<void> doAnswer(Session& session) const;
  base::Result<void> doRating(Session& session) const;
  base::Result<bool> correct(Session& session) const;
  questionnaires::Reply replyTo(int item) const;
  Response responseTo(const experiments::SeriesStep& step, int attempt, const Session& session);

  NurseTraits traits_;
  std::uint64_t seed_;
  PassTime pass_time_;
  SimulatedResponder responder_;
};

}  // namespace tactus::session
