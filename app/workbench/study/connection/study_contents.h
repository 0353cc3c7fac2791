// The part of a study that every screen may need as soon as it is open: participants, recordings, and what happened to
// the file.
#pragma once

#include <QString>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/session/session.h"
#include "app/session/study_procedure.h"
#include "app/workbench/base/messages.h"
#include "core/base/error.h"
#include "core/store/feel_records.h"
#include "core/store/study_file.h"
#include "core/study/session_records.h"
#include "experiments/force_protocol.h"
#include "experiments/speed_protocol.h"
#include "questionnaires/questionnaire_run.h"

namespace tactus::workbench {

// What keeps more in the study than single records, such as the versions of a model: it is asked when a study is
// opened, written, and closed.

/// Thread: gui.
class StudyKeeper {
 public:
  StudyKeeper() = default;
  virtual ~StudyKeeper() = default;
  StudyKeeper(const StudyKeeper&) = delete;
  StudyKeeper& operator=(const StudyKeeper&) = delete;

  /// Takes over what was read. Called while the new study is the open one, before `opened`.
  using Take = std::function<void()>;
  /// Reads the keeper's share of a study, in the thread of the study. An error keeps the study from being opened.
  using ReadShare = std::function<base::Result<Take>(const store::StudyFile&)>;
  virtual ReadShare reader() = 0;
  /// Orders everything that is not ordered yet.
  virtual void orderRest() = 0;
  /// Why an order was refused for another reason than the disk; empty if all is well. The study stays open with it.
  virtual QString refusal() const = 0;
  /// Orders again what was refused.
  virtual void orderAgain() = 0;
  /// The study is written and about to be closed.
  virtual void leave() = 0;
};

// The state of a session for one screen: the next question and the answers so far. Immutable.

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
  std::optional<double> unknown_n = {};        ///< what is unknown of the force, N, where the order follows from it
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

/// A person who can feel a model.
struct StudyPerson {
  study::RecordId id;
  QString code;
  bool simulated = false;
  bool researcher = false;  ///< says so in a profile
};

/// The profile category that marks the researcher of a study.
inline constexpr auto kResearcherCategory = "researcher";

struct StudyContents {
  QString path;
  session::ProcedurePtr procedure;  ///< as the study keeps it; null: the default one
  std::vector<StudyPerson> people;  ///< sorted by code
  std::vector<store::FeelSummary> recordings;
  StudyNotices notices;
};

/// Reads the study. Thread: the one of `file`.
base::Result<StudyContents> readContents(const store::StudyFile& file);

/// What happened to the study. Thread: that of `file`.
base::Result<StudyNotices> readNotices(const store::StudyFile& file);

/// The participants of the study. Thread: that of `file`.
base::Result<std::vector<StudyPerson>> readPeople(const store::StudyFile& file);

/// The current time of the wall clock, ms since 1970 UTC.
std::int64_t utcNowMs();

}  // namespace tactus::workbench
