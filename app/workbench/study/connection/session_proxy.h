// A participant's session (app/session) in the thread of the study, for screens: they call, and see the snapshot of the
// last call that is stored.
//
// Two rules for a call while another one is not stored yet:
//   an answer names the step that it answers, and is dropped unless that step is asked now and no other answer is on
//     its way: a double click, or a key that is held, never answers the next question;
//   an instruction about the session itself (pause, skip, abort, …) is never dropped: it waits for its turn.
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/session/session.h"
#include "app/session/stroke_capture.h"
#include "app/workbench/study/connection/study_connection.h"
#include "app/workbench/study/connection/study_contents.h"

namespace tactus::workbench {

/// A record bears the time of the call, not the time at which the disk took it. What the disk refuses is tried again
/// until it is written (`failure`); the snapshot stays as it is until then. Thread: gui.
class SessionProxy : public QObject {
  Q_OBJECT

 public:
  /// `study` outlives this. `now`: the clocks.
  explicit SessionProxy(StudyConnection& study, QObject* parent = nullptr,
                        std::function<study::Moment()> now = session::systemTools().now);

  /// As of the last stored call; null without a session.
  std::shared_ptr<const SessionSnapshot> snapshot() const { return snapshot_; }
  /// A call is not stored or refused yet.
  bool isSaving() const { return unanswered_ > 0; }
  /// Such a call may ask something else: no answer is taken until it is stored or refused.
  bool isMovingOn() const { return moving_on_ > 0; }
  /// That takes long enough to be said.
  bool isSlow() const { return isSaving() && study_.isSlow(); }
  /// What the disk says; empty if all is well.
  QString failure() const { return isSaving() ? study_.failure() : QString(); }

  /// Begins a session of `start.person`. With `newcomer` that person is stored first. Ends with `changed` or `refused`.
  void begin(const session::SessionStart& start, std::optional<study::Person> newcomer = {});
  /// Continues a session of the study. Ends with `changed` or `refused`.
  void resume(const study::RecordId& session);
  /// Forgets the session once everything is stored. Its records stay.
  void leave();

  // Answers. Each returns whether it was taken: not if `step` is not what is asked now, or `isMovingOn`.
  bool tell(SessionStep step, const study::ProfileRecord& profile, std::optional<session::ExperienceBand> band = {});
  bool addStroke(SessionStep step, session::CapturedStroke stroke);
  bool judge(SessionStep step, const experiments::ForceAnswer& answer, std::optional<session::AnswerInput> input = {});
  /// Session::correctJudgement.
  bool correctJudgement(SessionStep step, const experiments::ForceAnswerOption& word,
                        std::optional<session::AnswerInput> input = {}, std::optional<bool> would_stop = {});
  bool reply(SessionStep step, const questionnaires::Reply& reply, double response_s,
             std::optional<session::AnswerInput> input = {});
  bool rate(SessionStep step, int effort, int comfort);
  /// Moves in the form; where it does not move, the snapshot is the same with another step.
  bool back(SessionStep step);
  bool forward(SessionStep step);
  bool goToFirstOpen(SessionStep step);
  bool goTo(SessionStep step, int item);
  bool goOn(SessionStep step);
  /// Ends the block without a rating.
  bool closeBlock(SessionStep step);

  // Instructions. Without a session they are refused.
  void rejectStroke(const study::RecordId& stroke, const std::string& reason);
  void skipBlock(const std::string& reason);
  void pause(const std::string& reason);
  void unpause();
  void abort(const std::string& reason);
  void setEnteredBy(study::EnteredBy who);
  /// Adds a line to the log of the session.
  void note(session::Note note);

 signals:
  /// One of the above changed.
  void changed();
  /// A call was refused for another reason than the disk; nothing changed. One sentence.
  void refused(const QString& sentence);

 private:
  struct LiveSession;
  using Call = std::function<base::Result<void>(session::Session&)>;
  /// In the thread of the study.
  using Work = std::function<base::Result<void>(LiveSession&, store::StudyFile&)>;
  using Opening = std::function<base::Result<session::Session>(store::StudyFile&, session::SessionTools)>;
  enum class Asks { kSame, kNext };

  void open(Opening opening);
  bool answer(SessionStep step, Call call);
  void instruct(Call call, Asks asks = Asks::kNext);
  void send(std::shared_ptr<LiveSession> room, Asks asks, Work work);
  static Work onSession(Call call, Asks asks);
  void forgetSession();

  StudyConnection& study_;
  std::function<study::Moment()> now_;
  std::shared_ptr<LiveSession> room_;  ///< where the session lives; only the thread of the study looks into it
  std::shared_ptr<const SessionSnapshot> snapshot_;
  int unanswered_ = 0;
  int moving_on_ = 0;  ///< those of them that may ask something else
};

}  // namespace tactus::workbench
