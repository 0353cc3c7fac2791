// The course of the nurse's screens, without any widget: which screen is shown, what may be done on it, and what is
// stored; before it, how her input counts: strokes out of samples, the button of the device, the gate that keeps a key
// from answering the next screen. The views show `state()` and call the slots; the records are made by the session
// (app/session) in the thread of the study, and the next screen opens on the acknowledged commit.
#pragma once

#include <QObject>
#include <QString>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "app/session/stroke_capture.h"
#include "app/workbench/device/device_session.h"
#include "app/workbench/participant/check_in.h"
#include "app/workbench/participant/kit/participant_state.h"
#include "app/workbench/participant/participant_course.h"
#include "app/workbench/participant/questions.h"
#include "app/workbench/study/connection/session_proxy.h"
#include "app/workbench/study/connection/study_connection.h"
#include "core/haptics/servo/sample.h"
#include "experiments/force_protocol.h"

namespace tactus::workbench {

// The insertions of the speed part, cut out of the samples of the device.

/// Looks only while it is open: from the moment at which the screen takes input to the first stroke. What the hand did
/// before is never an insertion.
class SpeedCapture {
 public:
  /// Another insertion is asked for.
  void open(const experiments::StrokeSettings& settings);
  void close() { capture_.reset(); }
  bool isOpen() const { return capture_.has_value(); }

  /// All samples, oldest first. Returns the stroke that ends in them, and closes; ignores them while closed.
  std::optional<session::CapturedStroke> add(std::span<const haptics::Sample> samples);

 private:
  std::optional<session::StrokeCapture> capture_;
  std::optional<std::uint64_t> last_tick_;
  std::int64_t first_ns_ = 0;
};

/// What to say about a stroke with this verdict. Nothing of a speed: a stroke that was too brief was `not recorded`.
SpeedState::Note noteOf(experiments::StrokeVerdict verdict);

/// The button of the device as an answer: a tap, or a press that is held. While the same button holds the tube it
/// answers nothing.
enum class ButtonPress {
  kTap,   ///< let go within kTapS
  kHeld,  ///< down for kHeldS; once
};

/// Plain state. Thread: gui.
class DeviceButton {
 public:
  static constexpr double kTapS = 0.4;     ///< longer presses move something
  static constexpr double kHeldS = 0.8;    ///< confirms
  static constexpr double kSettleS = 0.3;  ///< open for so long before a press counts, as on the screen

  /// Another question: a button that is down belongs to the one before.
  void reset() { *this = {}; }
  /// The next sample. Returns a press that ended or was held long enough with it.
  std::optional<ButtonPress> add(const haptics::Sample& sample);

 private:
  std::optional<std::int64_t> open_since_ns_;
  std::optional<std::int64_t> down_since_ns_;
  bool told_ = false;  ///< of this press
};

// When input counts on a screen that has just opened: a key that is still held, a double click, or a click that was
// meant for the screen before never answers it.

/// A screen takes input once its first frame is painted, every key, button and touch has been up since, and 300 ms have
/// passed. Times: ns of one monotonic clock. Plain state. Thread: any.
class ScreenGate {
 public:
  static constexpr std::int64_t kSettleNs = 300'000'000;

  /// Another screen or another question is about to be shown.
  void close() { painted_ = false; }
  /// Its first frame is on the screen. Later frames change nothing.
  void painted(std::int64_t now_ns);
  /// Whether a key, a button or a touch is down.
  void held(bool held, std::int64_t now_ns);

  bool takesInput(std::int64_t now_ns) const;
  /// The same for the hand on the device, which may hold it all the time.
  bool isSettled(std::int64_t now_ns) const { return painted_ && now_ns - painted_ns_ >= kSettleNs; }
  /// Of the first painted frame; response times count from here.
  std::int64_t paintedNs() const { return painted_ns_; }

 private:
  bool painted_ = false;
  bool held_ = false;
  bool let_go_ = false;  ///< nothing was down at one moment since the first frame
  std::int64_t painted_ns_ = 0;
  std::int64_t free_ns_ = 0;  ///< of that moment
};

// The answer word that the button of the device highlights. Each press highlights the next word. The first one is drawn
// by chance: a fixed first word would need the fewest presses and would be chosen too often.

/// Plain state. Thread: gui.
class HighlightedWord {
 public:
  void reset() { presses_ = 0; }
  /// Highlights the next of `words`, which is not empty and stays the same until `reset`.
  void next(const std::vector<experiments::ForceAnswerOption>& words, std::mt19937_64& chance) {
    if (presses_ == 0) first_ = std::uniform_int_distribution<std::size_t>(0, words.size() - 1)(chance);
    first_word_ = words[first_].id;
    id_ = QString::fromStdString(words[(first_ + static_cast<std::size_t>(presses_)) % words.size()].id);
    ++presses_;
  }

  /// The highlighted word; empty: none.
  QString id() const { return presses_ > 0 ? id_ : QString(); }
  int presses() const { return presses_; }
  /// The word that the first press highlighted.
  const std::string& firstWord() const { return first_word_; }

 private:
  int presses_ = 0;
  std::size_t first_ = 0;
  std::string first_word_;
  QString id_;
};

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
  /// The quiet way to the same choices; where a device is armed, it is `forceOff`.
  void pause();
  /// The researcher sees the monitor of this session.
  void setMonitored(bool monitored);
  /// The researcher answered her call at the monitor.
  void acknowledgeCall();
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
  class Step;          // participant_steps.h: what one screen shows, takes and stores
  struct PlainSteps;   // participant_steps.cpp: those of the screens without the device
  struct DeviceSteps;  // device_steps.cpp
  using Steps = std::map<ParticipantScreen, std::unique_ptr<Step>>;
  static Steps allSteps(ParticipantController& course);
  static void addDeviceSteps(ParticipantController& course, Steps& steps);

  Step& step() const;
  /// Brings the state up to date, and asks anew where something else is asked.
  void look();
  void askAnew();
  std::string asked() const;
  DeviceStep deviceStep() const;
  HoldMeans holdMeans() const;

  // participant_events.cpp: what happens by itself, and what the steps share.
  void onAsked();
  void onProxy();
  void onRefused(const QString& sentence);
  void onDevice();
  void onSampled(std::span<const haptics::Sample> samples);
  void takeGrip();
  void startDevice();
  void stopDevice();
  void meetSession();
  void noteCircumstances();
  void goOnByItself();
  std::vector<experiments::ForceAnswerOption> forceAnswers() const;
  std::optional<experiments::ForceAnswerOption> answerOf(const QString& id) const;
  std::optional<session::AnswerInput> answerInput() const;
  double responseS() const;
  void followOwnModel();
  void feelOwnModel();
  void leaveFor(StopReason reason);
  void finishLeaving();
  void startAgain();

  /// Features share the device; the runs of others are none of this one's.
  bool hasDevice() const { return device_.isRunning() && device_.user() == this; }
  void giveNoForce();
  bool takesInput() const;
  bool takesOverlay() const;
  const SessionSnapshot* at() const { return proxy_.snapshot().get(); }
  const procedure::Procedure& about() const { return plan_.settings.about(); }

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

  CheckIn check_in_;
  QString consent_language_;                     ///< of the text that she agreed to, until that is noted
  QString consent_text_;                         ///< likewise
  bool resumes_ = false;                         ///< an earlier session is being continued
  bool met_ = false;                             ///< the session was seen
  std::optional<session::Circumstances> noted_;  ///< since she sat down
  DeviceCheck check_;
  bool device_lost_ = false;
  bool restarts_ = false;      ///< the device is started again as soon as it has stopped
  std::uint32_t buttons_ = 0;  ///< of the last sample
  DeviceButton button_;
  DeviceGrip grip_before_;  ///< the researcher's own
  ForceTrial trial_;
  bool correcting_ = false;  ///< the force before is asked for once more, without a force
  std::optional<study::Form> form_;
  QString chosen_;  ///< on the screen, not stored yet
  std::optional<session::InputMeans> means_;
  HighlightedWord lit_;
  bool from_review_ = false;
  BlockRating rating_;
  bool ended_ = false;  ///< she is done; the next participant may sit down
  std::unique_ptr<OwnModelTrial> own_;
  Steps steps_;
};

}  // namespace tactus::workbench
