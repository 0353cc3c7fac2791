// A simulated nurse who does a whole session. For tests and demonstrations only; it is not a model of a real person.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "app/session/session.h"
#include "app/session/simulated_responder.h"
#include "app/session/simulated_strokes.h"
#include "core/study/records.h"

namespace tactus::session {

/// The traits of a simulated nurse. Shares are probabilities, 0 to 1.
struct NurseTraits {
  study::ProfileRecord profile;                  ///< without its entry
  std::map<std::string, SimulatedLevel> levels;  ///< by the term id of each speed in the session
  ResponderTraits responder;
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
