// A simulated nurse who goes through a whole session. Not a model of anybody: for tests and demonstrations only.
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

/// Who goes through a session, and how often things go wrong; shares are probabilities, 0 to 1.
struct NurseTraits {
  study::ProfileRecord profile;                  ///< without its entry
  std::map<std::string, SimulatedLevel> levels;  ///< by the term id of each speed that the session asks for
  ResponderTraits responder;
  std::vector<study::Answer> answers;  ///< to the items of the form; an item without one is skipped
  double stops_early = 0.08;           ///< of strokes: the first attempt is too short
  double holds_still = 0.08;           ///< of forces: the first attempt is judged without moving forward
  double second_thoughts = 0.06;       ///< of answers: another choice at first, corrected from a later page
};

/// Does what a session asks for, through the same calls as a person's screens. What is done at a step follows from the
/// traits, the seed and the step alone, so that a session that was interrupted goes on as it would have.
class SimulatedNurse {
 public:
  /// Called with the seconds that something takes, before it is recorded.
  using PassTime = std::function<void(double seconds)>;

  /// `judged`: what the nurse judged before the session was resumed, in order; only with an assimilation does it count.
  SimulatedNurse(NurseTraits traits, std::uint64_t seed, PassTime pass_time = {},
                 std::span<const study::JudgementRecord> judged = {});

  /// Does what the session asks for next: exactly one record. The session must not be at its end. Refused: what the
  /// session refuses, a speed without strokes.
  base::Result<void> doNext(Session& session);

  /// Goes on to the end of the session.
  base::Result<void> finish(Session& session);

 private:
  base::Random randomFor(const std::string& step) const;
  base::Result<void> doStroke(Session& session) const;
  base::Result<void> doJudgement(Session& session);
  base::Result<void> doAnswer(Session& session) const;
  base::Result<void> doRating(Session& session) const;
  base::Result<bool> correct(Session& session) const;
  questionnaires::Reply replyTo(int item) const;
  Response responseTo(const experiments::ForceStep& step, int attempt, const Session& session);

  NurseTraits traits_;
  std::uint64_t seed_;
  PassTime pass_time_;
  SimulatedResponder responder_;
};

}  // namespace tactus::session
