// The course of one visit of a participant: profile, then each block of the session with a rating after it.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/session/session_settings.h"
#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/session_records.h"
#include "experiments/force_protocol.h"
#include "experiments/speed_protocol.h"
#include "questionnaires/questionnaire_run.h"

namespace tactus::session {

/// Where a session stands.
enum class SessionPart {
  kProfile,   ///< the participant tells of themselves
  kSpeed,     ///< `speed()` says what comes next
  kForce,     ///< `force()` does
  kForm,      ///< `form()` does
  kRating,    ///< effort and comfort of the block that was done
  kFinished,  ///< nothing is left to do
  kAborted,   ///< ended before its end, for good
};

/// `profile`, `speed`, `force`, `form`, `rating`, `finished`, `aborted`.
std::string_view name(SessionPart part) noexcept;

/// What a session needs besides its study file.
struct SessionTools {
  std::function<study::Moment()> now;
  study::RecordIds ids;
};

/// The clocks of this machine, and ids that were never used before.
SessionTools systemTools();

/// What is known before the session begins. A session begins when the participant has consented, never before.
struct SessionStart {
  study::RecordId person;  ///< of a person in the file
  study::SessionKind kind = study::SessionKind::kElicitation;
  std::string consent_version;  ///< of the text that was agreed to; not empty
  std::uint64_t seed = 0;
  std::string language = "en";
  std::string station;
  std::string program;
  std::string device;
  std::optional<double> device_friction_n;  ///< as in ForceSettings; that of the settings is not used
  SessionSettings settings;
};

struct SessionState;

/// Every step is stored before it counts: a call that succeeds was committed to the file, and only then does the next
/// question open. A call that fails changes nothing, in the file or here. The state follows from the records alone, so
/// `resume` goes on after a crash at the last committed answer, in the same order.
/// Thread: the one that opened the file, which must outlive the session.
class Session {
 public:
  /// Refused: settings that make no sense, an unknown person, form or language, no consent.
  static base::Result<Session> begin(store::StudyFile& file, const SessionStart& start, SessionTools tools);

  /// Goes on with a session of the file. Refused: an unknown session, records that do not fit its settings.
  static base::Result<Session> resume(store::StudyFile& file, const study::RecordId& session, SessionTools tools);

  Session(Session&&) noexcept;
  Session& operator=(Session&&) noexcept;
  ~Session();

  SessionPart part() const;
  /// The block that is being done or rated; nothing before the first and after the last.
  std::optional<Block> block() const;
  std::size_t blocksDone() const;
  const study::SessionRecord& record() const;
  const SessionSettings& settings() const;
  bool isPaused() const;

  /// Each throws nothing and is valid in every part of a session that has the block; nullptr where it has not.
  const experiments::SpeedProtocol* speed() const;
  const experiments::ForceProtocol* force() const;
  const questionnaires::QuestionnaireRun* form() const;
  /// The profile as told last, or nothing.
  const study::ProfileRecord* profile() const;

  /// From now on records are marked as entered by this person. Simulated persons are always entered by a program.
  void setEnteredBy(study::EnteredBy who);

  /// Stores the profile; its entry is filled in here. Again at any time: a correction.
  base::Result<void> tell(study::ProfileRecord profile);
  /// Stores what came of the stroke that `speed()->next()` asked for; arguments as in SpeedProtocol::record.
  base::Result<void> addStroke(const experiments::Stroke& stroke, study::Recording recording,
                               std::size_t recording_first);
  /// Takes an accepted stroke of this session back, which is then asked for again.
  base::Result<void> rejectStroke(const study::RecordId& stroke, const std::string& reason);
  base::Result<void> judge(const experiments::ForceAnswer& answer);
  base::Result<void> reply(const questionnaires::Reply& reply, double response_s);
  /// Moves between the questions of the form without an answer; from the rating after it too, as long as it is not
  /// given.
  void back();
  bool forward();
  bool goToFirstOpen();
  /// 1 to 7 each; ends the block.
  base::Result<void> rate(int effort, int comfort);

  base::Result<void> pause(const std::string& reason);
  base::Result<void> unpause();
  /// Leaves the rest of the block out.
  base::Result<void> skipBlock(const std::string& reason);
  /// Ends the session. What was recorded stays.
  base::Result<void> abort(const std::string& reason);

 private:
  explicit Session(std::unique_ptr<SessionState> state);

  std::unique_ptr<SessionState> state_;
};

}  // namespace tactus::session
