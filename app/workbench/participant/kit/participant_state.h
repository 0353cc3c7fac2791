// What the nurse's screens show at one moment: one screen, what may be chosen on it, and what is chosen. No screen gets
// a number that she must not see.
#pragma once

#include <QPointF>
#include <QString>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "app/workbench/participant/kit/wordbook.h"

namespace tactus::workbench {

enum class ParticipantScreen {
  kWelcome,      ///< language, text size, code
  kConsent,      ///< the study's text; agree or not
  kAboutYou,     ///< one question after another
  kDeviceCheck,  ///< hold still, push gently
  kPractice,     ///< of the speed or the force part; not counted
  kSpeed,        ///< part 1: insertions at a named speed
  kForce,        ///< part 2: feel, then choose a word
  kRest,         ///< the force is off, as long as she likes
  kRating,       ///< effort and comfort of the part that is done
  kGlossary,     ///< the words of the questions
  kQuestion,     ///< part 3: one of the questions
  kReview,       ///< her answers as grids; also the page that says they are locked
  kScale,        ///< a clinical teacher: one statement about the simulator
  kOwnModel,     ///< feels the force of her own answers
  kThanks,       ///< the end, with her own curve
  kStopped,      ///< stopped for today, withdrawn, or no consent
};

struct ScreenFacts {
  ParticipantScreen screen;
  const char* id;            ///< `about_you`
  const char* title;         ///< for the researcher, context `ScreenFacts`
  bool uses_device = false;  ///< gives a force, or reads the hand
};

/// In the order of the enumeration.
inline constexpr ScreenFacts kScreenFacts[] = {
    {ParticipantScreen::kWelcome, "welcome", QT_TRANSLATE_NOOP("ScreenFacts", "Welcome")},
    {ParticipantScreen::kConsent, "consent", QT_TRANSLATE_NOOP("ScreenFacts", "Consent")},
    {ParticipantScreen::kAboutYou, "about_you", QT_TRANSLATE_NOOP("ScreenFacts", "About the participant")},
    {ParticipantScreen::kDeviceCheck, "device_check", QT_TRANSLATE_NOOP("ScreenFacts", "Device check"), true},
    {ParticipantScreen::kPractice, "practice", QT_TRANSLATE_NOOP("ScreenFacts", "Practice"), true},
    {ParticipantScreen::kSpeed, "speed", QT_TRANSLATE_NOOP("ScreenFacts", "Speed"), true},
    {ParticipantScreen::kForce, "force", QT_TRANSLATE_NOOP("ScreenFacts", "Forces"), true},
    {ParticipantScreen::kRest, "rest", QT_TRANSLATE_NOOP("ScreenFacts", "Rest")},
    {ParticipantScreen::kRating, "rating", QT_TRANSLATE_NOOP("ScreenFacts", "Effort and comfort")},
    {ParticipantScreen::kGlossary, "glossary", QT_TRANSLATE_NOOP("ScreenFacts", "The words of the questions")},
    {ParticipantScreen::kQuestion, "question", QT_TRANSLATE_NOOP("ScreenFacts", "Questions")},
    {ParticipantScreen::kReview, "review", QT_TRANSLATE_NOOP("ScreenFacts", "Review")},
    {ParticipantScreen::kScale, "scale", QT_TRANSLATE_NOOP("ScreenFacts", "Usability form")},
    {ParticipantScreen::kOwnModel, "own_model", QT_TRANSLATE_NOOP("ScreenFacts", "Own model"), true},
    {ParticipantScreen::kThanks, "thanks", QT_TRANSLATE_NOOP("ScreenFacts", "Done")},
    {ParticipantScreen::kStopped, "stopped", QT_TRANSLATE_NOOP("ScreenFacts", "Stopped")},
};

inline constexpr const ScreenFacts& factsOf(ParticipantScreen screen) {
  return kScreenFacts[static_cast<std::size_t>(screen)];
}
static_assert(std::size(kScreenFacts) == static_cast<std::size_t>(ParticipantScreen::kStopped) + 1);
static_assert(std::all_of(std::begin(kScreenFacts), std::end(kScreenFacts),
                          [](const ScreenFacts& one) { return &factsOf(one.screen) == &one; }));

/// What lies over the screen while the force is off. The force stays off until kNone.
enum class ForceOffOverlay {
  kNone,
  kForceOff,  ///< continue, call the researcher, stop, withdraw
  kCalled,    ///< the same, and the researcher was called
  kWithdraw,  ///< withdraw or keep the data
  kLeaving,   ///< the last answer is being stored, or the data are being deleted
};

struct WelcomeState {
  enum class Step {
    kStart,
    kNewCode,      ///< `code` was made just now: she writes it down
    kWelcomeBack,  ///< `code` is known
  };
  Step step = Step::kStart;
  int kept_answers = 0;  ///< of earlier, with a known code
  int kept_strokes = 0;  ///< likewise, of `all_strokes`
  int all_strokes = 0;
  int kept_forces = 0;
  bool prepared = false;      ///< the researcher said who takes part: no other code is asked for or made
  bool code_unknown = false;  ///< what she typed is no code of this study
  QString meant;              ///< a code of this study that she may have meant; may be empty
  int minutes = 0;            ///< that a session takes, about
};

struct ConsentState {
  QString version;
  std::vector<nurse::Phrase> paragraphs;
  bool usability = false;  ///< of a clinical teacher, without the parts on the device
};

struct AboutYouState {
  enum class Question { kYears, kHand, kGloves, kHaptic, kComfort };
  Question question = Question::kYears;
  QString chosen;  ///< `years_1` … `years_4`; left, right, both; haptic_0 … haptic_2; yes, no; not_say; empty: none
  bool is_first = true;
};

/// How the tube is held on this device.
enum class HoldMeans {
  kButton,  ///< a button of the handle, kept pressed
  kLatch,   ///< a button of the handle: a press holds, another one lets go
  kPedal,   ///< a pedal, kept down
  kMouse,   ///< the mouse or the space bar stands in
};

/// How long the device has waited for a hand.
enum class HoldWait {
  kNot,
  kHint,   ///< long enough for a second sentence
  kStuck,  ///< the researcher is needed
};

/// The device, as far as she must know.
enum class DeviceStep { kWait, kHold, kStill, kPush, kRelease, kReady, kWrong, kLost };

struct SpeedState {
  enum class Note { kStart, kReturn, kRecorded, kTooShort, kNotRecorded, kBackwards, kOutOfRange };
  QString level;     ///< term id: `slow`
  int recorded = 0;  ///< of `wanted` dots
  int wanted = 0;
  Note note = Note::kStart;  ///< about the last insertion, until the handle is back at the start
};

struct ForceState {
  enum class Phase {
    kPause,   ///< without force; the handle goes back to the start
    kFeel,    ///< the force waits for the hand, or rises
    kAnswer,  ///< felt: a word may be chosen, or she feels it again
  };
  Phase phase = Phase::kPause;
  QString chosen;               ///< a term id, `not_felt`, `beyond_practice`; empty: none
  QString lit;                  ///< the word that the button of the device would choose; may be empty
  bool again = false;           ///< the step came again: once more, please
  bool warm = false;            ///< the pause is long because the device rests
  bool before = false;          ///< it is about the force before, whose word may be changed
  bool waits_for_push = false;  ///< a hand holds the handle, but does not push
  bool asks_stop = false;       ///< the procedure asks whether she would stop at this force
  bool stops = false;           ///< she would
  bool sure = false;            ///< asks whether it is larger than all that she meets, before the series ends
};

struct QuestionState {
  int item = 0;      ///< the form's item number
  int position = 1;  ///< of `count`, in the order of this session
  int count = 0;
  std::vector<study::ItemCondition> conditions;  ///< besides the place of the tip
  QString region;                                ///< term id of the place; may be empty
  QString chosen;                                ///< a term id, `cant_tell`; empty: none
  bool from_review = false;                      ///< it is changed from the review and leads back to it
  std::optional<double> unknown_n = {};          ///< ItemPage::unknown_n; the participant does not see it
};

struct ReviewAnswer {
  int item = 0;
  std::vector<study::ItemCondition> conditions;  ///< as of QuestionState
  QString region;
  QString word;  ///< as QuestionState::chosen; empty: open
};

struct ReviewState {
  std::vector<ReviewAnswer> answers;  ///< in the order of the form
  int gaps = 0;                       ///< answers that are still open
  bool sealed = false;                ///< they are locked
};

/// The answer "I would rather not say".
inline constexpr const char* kNotSay = "not_say";

/// A card that answers a screen of text and cards.
struct PageCard {
  QString id;
  nurse::Phrase word;
  bool apart = false;  ///< not on the scale: stands in a row of its own
};

/// A screen that is text and cards. It has no widget of its own: PageScreen shows what its step says here.
struct PageState {
  enum class Picture { kNone, kCup, kPush };

  nurse::Phrase title;
  Picture picture = Picture::kNone;
  nurse::Phrase instructions;  ///< above the sentence; may be empty, as each of the next three
  nurse::Phrase sentence;      ///< the one of the screen
  nurse::Phrase remark;        ///< below it
  nurse::Phrase low, high;     ///< what the ends of a scale mean; its cards are keys from 1, the one apart is 0
  std::vector<PageCard> cards;
  QString chosen;        ///< the id of a card; empty: none
  nurse::Phrase wanted;  ///< what the primary button says instead while no card is chosen
  nurse::Phrase primary = nurse::phrase(QStringLiteral("nav.next"));
  bool is_end = false;  ///< the primary button leaves the screens, and is there only while it acts
};

/// Of a statement or question: `1` to `7`.
inline constexpr int kScalePoints = 7;

struct OwnModelState {
  bool ready = false;   ///< the model is built, and in the device
  bool felt = false;    ///< she pushed under the force: the words may be chosen
  QString unavailable;  ///< one sentence why there is none; empty: there is, or it is being built
  QString region;       ///< term id of the region that is felt
  int number = 1;       ///< of `count` regions
  int count = 0;
  double from_mm = 0;  ///< depth at which the region begins
  QString chosen;      ///< lighter, right, heavier, cant_tell; empty: none
  int marks = 0;       ///< moments that she marked in this region
};

struct ThanksState {
  std::vector<QPointF> curve;  ///< depth in mm, share of the largest force: her own; empty: none
};

enum class StopReason { kForToday, kWithdrawn, kNoConsent };

struct ParticipantState {
  /// Rises whenever something else is asked. A view reports its first painted frame of each number.
  std::uint64_t serial = 0;
  ParticipantScreen screen = ParticipantScreen::kWelcome;
  ForceOffOverlay overlay = ForceOffOverlay::kNone;

  std::shared_ptr<const procedure::Procedure> procedure;  ///< what the study is about; null: the default one
  QString form;                                           ///< id of the form that is asked
  /// Offered, in this order: those of the study's protocol, else all that the screens have.
  std::vector<QString> languages = {QStringLiteral("en"), QStringLiteral("zh-Hant"), QStringLiteral("zh-Hans")};
  QString language = QStringLiteral("en");  ///< one of them
  int text_percent = 100;                   ///< 100, 125, 150
  QString code;                             ///< of the participant; empty: not known yet
  bool left_handed = false;
  bool simulated = false;       ///< no device is connected, or a program is the participant
  bool virtual_device = false;  ///< no device is connected: mouse and keyboard stand in
  int part = 1;                 ///< of `parts`, in the order of the study's protocol
  int parts = 3;

  bool can_go_on = false;  ///< the primary button acts
  bool can_go_back = false;
  bool saving = false;  ///< slow enough to be said
  bool failed = false;  ///< the disk refuses
  bool paused = false;  ///< by the researcher: nothing is taken

  WelcomeState welcome;
  ConsentState consent;
  AboutYouState about;
  DeviceStep device = DeviceStep::kWait;
  bool armed = false;  ///< a device runs for her: it may give a force
  HoldMeans hold = HoldMeans::kButton;
  HoldWait waits = HoldWait::kNot;
  bool quiet_pause = false;  ///< of kForceOff: she paused where no device was armed
  bool monitored = false;    ///< the researcher sees the monitor
  bool call_seen = false;    ///< the researcher answered her call there
  SpeedState speed;          ///< of kSpeed, and of kPractice without `feels_force`
  ForceState force;          ///< of kForce, and of kPractice with `feels_force`
  bool feels_force = false;  ///< the practice is one of the force part
  QuestionState question;
  ReviewState review;
  PageState page;  ///< of a screen of text and cards
  OwnModelState own;
  ThanksState thanks;
  StopReason stop = StopReason::kForToday;
};

}  // namespace tactus::workbench
