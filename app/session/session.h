// The session of a participant: the profile, then each block of the session followed by a rating.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/session/session_notes.h"
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
  kAborted,   ///< ended early, permanently
};

/// `profile`, `speed`, `force`, `form`, `rating`, `finished`, `aborted`.
std::string_view name(SessionPart part) noexcept;

/// The parts of a session besides its study file.
struct SessionTools {
  std::function<study::Moment()> now;
  study::RecordIds ids;
};

/// The clocks of this machine, and a source of new unique ids.
SessionTools systemTools();

/// The data needed before a session begins. A session begins only after the participant has consented.
struct SessionStart {
  study::RecordId person;  ///< of a person in the file
  study::SessionKind kind = study::SessionKind::kElicitation;
  std::string consent_version;  ///< version of the consent text; not empty
  std::uint64_t seed = 0;
  std::string language = "en";
  std::string station;
  std::string program;
  std::string device;
  std::optional<double> device_friction_n;  ///< as in ForceSettings, whose own value is not used
  SessionSettings settings;
  /// The record of the study's protocol that the session follows (study_protocol.h); it must be the current one.
  std::optional<study::RecordId> protocol;
};

struct SessionState;

/// Every step is stored before it counts: a call succeeds only after its commit to the file, and only then does the
/// next question open. A failed call changes nothing, neither in the file nor here. The state follows from the records
/// alone, so `resume` continues after a crash at the last committed answer, in the same order. Thread: the one that
/// opened the file, which must outlive the session.
class Session {
 public:
  /// Refused: invalid settings, an unknown person, form or language, missing consent.
  static base::Result<Session> begin(store::StudyFile& file, const SessionStart& start, SessionTools tools);

  /// Continues a session of the file. Refused: an unknown session, records that contradict its settings.
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
  /// The latest profile, or nothing.
  const study::ProfileRecord* profile() const;

  /// From now on records are marked as entered by `who`. For simulated persons the mark is always "program".
  void setEnteredBy(study::EnteredBy who);

  /// Stores the profile and fills in its entry. A later call is a correction.
  base::Result<void> tell(study::ProfileRecord profile);
  /// The same for a participant who named a band of years: the profile gets its middle, and the log the band.
  base::Result<void> tell(study::ProfileRecord profile, const ExperienceBand& band);
  /// Stores the result of the stroke that `speed()->next()` asked for. Arguments as in SpeedProtocol::record.
  base::Result<void> addStroke(const experiments::Stroke& stroke, study::Recording recording,
                               std::size_t recording_first);
  /// Rejects an accepted stroke of this session. The protocol then asks for it again.
  base::Result<void> rejectStroke(const study::RecordId& stroke, const std::string& reason);
  /// `input`: how the answer was entered; stored with it, all or none. An answer that came very soon or very late gets
  /// a note (responseMark); so does what she says of stopping here.
  base::Result<void> judge(const experiments::ForceAnswer& answer, const std::optional<AnswerInput>& input = {});
  /// Another word for the last judgement that counts, also after the last step until the block is ended: a record of
  /// its own, which counts instead (ForceProtocol::correction).
  base::Result<void> correctJudgement(study::ForceJudgement::Kind kind, const std::string& term,
                                      const std::optional<AnswerInput>& input = {},
                                      std::optional<bool> would_stop = {});
  base::Result<void> reply(const questionnaires::Reply& reply, double response_s,
                           const std::optional<AnswerInput>& input = {});
  /// Moves to the previous or the next question, or to the first one without an answer. Also possible from the rating
  /// after the form, until the rating is given.
  void back();
  bool forward();
  bool goToFirstOpen();
  /// Moves to the item `number`, or on to where the participant went back from.
  bool goTo(int number);
  void goOn();
  /// Stores the rating, 1 to 7 each, and ends the block.
  base::Result<void> rate(int effort, int comfort);

  /// Ends the block that is done without a rating. Its answers are sealed: no way leads back to them.
  base::Result<void> closeBlock();
  /// Adds a line to the log, in every part of the session, also after its end. Refused: a kind that steers the session.
  base::Result<void> note(const Note& note);

  base::Result<void> pause(const std::string& reason);
  base::Result<void> unpause();
  /// Skips the rest of the block.
  base::Result<void> skipBlock(const std::string& reason);
  /// Ends the session. Its records stay.
  base::Result<void> abort(const std::string& reason);

 private:
  explicit Session(std::unique_ptr<SessionState> state);

  std::unique_ptr<SessionState> state_;
};

}  // namespace tactus::session
