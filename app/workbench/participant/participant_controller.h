// The course of the nurse's screens, without any widget: which screen is shown, what may be done on it, and what is
// stored. The views show `state()` and call the slots; the records are made by the session (app/session) in the thread
// of the study, and the next screen opens on the acknowledged commit.
#pragma once

#include <QObject>
#include <QString>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "app/workbench/device/device_session.h"
#include "app/workbench/participant/about_you.h"
#include "app/workbench/participant/arrival.h"
#include "app/workbench/participant/block_rating.h"
#include "app/workbench/participant/device_button.h"
#include "app/workbench/participant/device_check.h"
#include "app/workbench/participant/force_trial.h"
#include "app/workbench/participant/lit_word.h"
#include "app/workbench/participant/own_model_trial.h"
#include "app/workbench/participant/participant_course.h"
#include "app/workbench/participant/participant_plan.h"
#include "app/workbench/participant/participant_state.h"
#include "app/workbench/participant/screen_gate.h"
#include "app/workbench/participant/speed_capture.h"
#include "app/workbench/study/connection/session_proxy.h"
#include "app/workbench/study/connection/study_connection.h"

namespace tactus::workbench {

/// Thread: gui.
class ParticipantController : public QObject {
  Q_OBJECT

 public:
  /// The study must be open. `study` and `device` outlive this. `now`: the clocks.
  ParticipantController(StudyConnection& study, DeviceSession& device, ParticipantPlan plan,
                        std::function<study::Moment()> now = session::systemTools().now, QObject* parent = nullptr);
  ~ParticipantController() override;

  const ParticipantState& state() const { return state_; }
  /// The participant's session, for the researcher's window: what is answered, and a pause of the researcher's own.
  SessionProxy& session() { return proxy_; }

 public slots:
  /// The first frame of `state().serial` is on the screen. Input counts 300 ms later.
  void painted(quint64 serial);
  /// A key, a button or a touch is down, or all are up.
  void setInputHeld(bool held);
  /// By what the next answer is given; stored with it.
  void usesMeans(tactus::session::InputMeans means);

  // kWelcome
  void setLanguage(const QString& language);
  void setTextPercent(int percent);
  void newHere();
  /// A clinical teacher: the usability form in a session of its own.
  void teacherHere();
  void enterCode(const QString& code);
  /// The researcher has chosen who sits down: as `enterCode`, but before anything is painted. A participant without a
  /// session yet is shown the code to write it down.
  void sitDown(const QString& code);
  /// The same for a clinical teacher: a new code for the usability form.
  void sitDownAsTeacher();
  // kConsent: `next` agrees
  void decline();

  // Every screen
  /// The primary button.
  void next();
  void back();
  /// A card: one of the ids that the state offers.
  void choose(const QString& id);

  // kForce
  void feelAgain();
  /// The button of the device: a tap lights one word after another, from one drawn by chance; held, it answers with it.
  void lightNext();
  void answerLit();
  // kReview
  void changeItem(int item);
  // kOwnModel
  void mark();

  /// Esc, the red button, the device's second button: always, at once, whatever is asked. The force falls to zero, then
  /// the overlay opens.
  void forceOff();
  // On the overlay
  void resume();
  void callResearcher();
  void stopForToday();
  void askWithdraw();
  void keepData();
  void withdraw();

 signals:
  void changed();
  /// Along the device's axis, mm: the tube of the picture follows it. At most 60 times a second.
  void handMoved(double position_mm);
  /// One sentence for the researcher: what was refused, and why. Nothing is lost.
  void refused(const QString& sentence);

 private:
  // participant_screens.cpp: what is shown.
  void look();
  std::string asked() const;
  void fill();
  void fillSpeed();
  void fillForce();
  void fillQuestion();
  void fillScale();
  DeviceStep deviceStep() const;

  // participant_steps.cpp: what happens by itself, and what an answer stores.
  void onAsked();
  void onProxy();
  void onRefused(const QString& sentence);
  void onDevice();
  void onSampled(std::span<const haptics::Sample> samples);
  void captureStroke(std::span<const haptics::Sample> samples);
  void startDevice();
  void stopDevice();
  void pressedOnDevice(ButtonPress press);
  void beginSession();
  void meetSession();
  void goOnByItself();
  std::vector<experiments::ForceAnswerOption> forceAnswers() const;
  std::optional<experiments::ForceAnswerOption> answerOf(const QString& id) const;
  std::optional<session::AnswerInput> answerInput() const;
  double responseS() const;
  void judge();
  void correct();
  void answerQuestion();
  void answerScale();
  void rate();
  void endRest();
  void review();
  void followOwnModel();
  void feelOwnModel();
  void goOnOwnModel();
  void leaveFor(StopReason reason);
  void finishLeaving();
  void startAgain();

  /// Features share the device; the runs of others are none of this one's.
  bool hasDevice() const { return device_.isRunning() && device_.user() == this; }
  void giveNoForce();
  bool takesInput() const;
  bool takesOverlay() const;
  const SessionSnapshot* at() const { return proxy_.snapshot().get(); }

  StudyConnection& study_;
  DeviceSession& device_;
  const ParticipantPlan plan_;
  const std::function<study::Moment()> now_;
  SessionProxy proxy_;
  std::mt19937_64 chance_{std::random_device{}()};

  ParticipantState state_;
  std::string asked_;  ///< what the screen asks; another one closes the gate
  ScreenGate gate_;
  CoursePassed passed_;
  std::size_t replies_ = 0;  ///< to questions, not stored yet
  std::optional<StopReason> leaving_;
  bool paused_by_her_ = false;  ///< through the overlay; the researcher has a pause of their own

  Arrival arrival_;
  QString consent_language_;  ///< of the text that she agreed to, until that is noted
  QString consent_text_;      ///< likewise
  bool resumes_ = false;      ///< an earlier session is being continued
  bool met_ = false;          ///< the session was seen
  AboutYou about_;
  DeviceCheck check_;
  bool device_lost_ = false;
  bool restarts_ = false;      ///< the device is started again as soon as it has stopped
  std::uint32_t buttons_ = 0;  ///< of the last sample
  DeviceButton button_;
  SpeedCapture capture_;
  SpeedState::Note capture_note_ = SpeedState::Note::kStart;
  bool at_start_ = false;  ///< the handle is where an insertion begins
  ForceTrial trial_;
  bool correcting_ = false;  ///< the force before is asked for once more, without a force
  std::optional<study::Form> form_;
  QString chosen_;  ///< on the screen, not stored yet
  std::optional<session::InputMeans> means_;
  LitWord lit_;
  bool from_review_ = false;
  BlockRating rating_;
  std::unique_ptr<OwnModelTrial> own_;
};

}  // namespace tactus::workbench
