// The state of a session for one screen: the next question and the answers so far. Immutable.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/session/session.h"
#include "core/study/session_records.h"
#include "experiments/force_protocol.h"
#include "experiments/speed_protocol.h"
#include "questionnaires/questionnaire_run.h"

namespace tactus::workbench {

/// The number of what is asked. It rises with each stored answer and each move between questions, and stays while a
/// session is paused or continued.
using SessionStep = std::uint64_t;

/// An item of the form with its last reply.
struct ItemReply {
  int item = 0;  ///< the form's item number
  std::optional<questionnaires::Reply> reply;

  /// Still to be answered: no reply, or one that was taken back.
  bool isOpen() const { return !reply || reply->status == study::Answer::Status::kCleared; }
};

/// The item of the form that is shown.
struct ItemPage {
  int item = 0;
  std::size_t position = 0;  ///< from 1, in the order shown
  std::size_t count = 0;
  std::optional<questionnaires::Reply> reply;  ///< the last one
};

struct SessionSnapshot {
  SessionStep step = 0;
  std::shared_ptr<const study::SessionRecord> record;
  std::shared_ptr<const session::SessionSettings> settings;
  session::SessionPart part = session::SessionPart::kProfile;
  std::optional<session::Block> block;  ///< being done or rated
  std::size_t blocks_done = 0;
  bool paused = false;
  std::optional<study::ProfileRecord> profile;  ///< the latest

  std::optional<experiments::SpeedPlan> speed;  ///< what the speed experiment asks next; nothing: no such block
  std::optional<experiments::ForcePlan> force;  ///< likewise
  /// The last judgement that counts, if it can be corrected now.
  std::optional<study::JudgementRecord> judged;
  std::shared_ptr<const questionnaires::Questionnaire> form;  ///< null: no such block
  std::optional<ItemPage> page;                               ///< of the form; nothing after its last item
  std::vector<ItemReply> replies;                             ///< of the form, in its own order
  questionnaires::Progress progress;                          ///< of the form
};

/// `record`, `settings` and `form` of `before` are shared where it is of the same session.
SessionSnapshot snapshotOf(const session::Session& session, SessionStep step, const SessionSnapshot* before);

}  // namespace tactus::workbench
