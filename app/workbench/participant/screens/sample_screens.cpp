#include "app/workbench/participant/screens/sample_screens.h"

#include <cmath>

#include "app/workbench/participant/screens/about_you_screen.h"
#include "app/workbench/participant/screens/closing_screens.h"
#include "app/workbench/participant/screens/consent_screen.h"
#include "app/workbench/participant/screens/device_check_screen.h"
#include "app/workbench/participant/screens/force_screen.h"
#include "app/workbench/participant/screens/glossary_screen.h"
#include "app/workbench/participant/screens/own_model_screen.h"
#include "app/workbench/participant/screens/panels.h"
#include "app/workbench/participant/screens/question_screen.h"
#include "app/workbench/participant/screens/review_screen.h"
#include "app/workbench/participant/screens/scale_screen.h"
#include "app/workbench/participant/screens/stroke_screen.h"
#include "app/workbench/participant/screens/welcome_screen.h"

namespace tactus::workbench::nurse {
namespace {

/// Back leads to something, except where it never does.
ParticipantState at(ParticipantScreen screen, bool can_go_back = true) {
  ParticipantState state;
  state.screen = screen;
  state.can_go_back = can_go_back;
  return state;
}

template <class Screen>
SampleScreen sample(
    const QString& name, const ParticipantState& state, const std::function<void(Screen&)>& then = [](Screen&) {}) {
  return {name, [state, then](const Look& look) {
            auto screen = std::make_unique<Screen>(look);
            screen->setState(state);
            then(*screen);
            return screen;
          }};
}

QString code() { return QStringLiteral("thunderstorm marmalade"); }

ParticipantState welcome(WelcomeState::Step step) {
  ParticipantState state = at(ParticipantScreen::kWelcome, step != WelcomeState::Step::kStart);
  state.code = code();
  state.welcome.step = step;
  state.welcome.kept_answers = 27;
  state.welcome.code_unknown = true;
  state.welcome.meant = code();
  state.welcome.minutes = 30;
  return state;
}

ParticipantState asked(const char* condition, const char* term, const char* region, const char* chosen) {
  ParticipantState state = at(ParticipantScreen::kQuestion);
  state.part = 3;
  state.question = {0,
                    12,
                    45,
                    QString::fromLatin1(condition),
                    QString::fromLatin1(term),
                    QString::fromLatin1(region),
                    QString::fromLatin1(chosen),
                    false};
  return state;
}

ParticipantState review(bool gaps, bool sealed) {
  const char* words[] = {"very_small", "small", "medium", "large", "very_large", "cant_tell"};
  const struct {
    const char* id;
    const char* terms[3];
  } conditions[] = {{"lubrication", {"poor", "medium", "well"}},
                    {"neck_flexion", {"small", "medium", "large"}},
                    {"speed", {"slow", "medium", "fast"}}};
  ParticipantState state = at(ParticipantScreen::kReview, !sealed);
  state.review.sealed = sealed;
  auto& answers = state.review.answers;
  for (const auto& condition : conditions) {
    for (const char* term : condition.terms) {
      for (const char* region : {"nasal_cavity", "nasopharynx", "oropharynx", "laryngopharynx", "esophagus"}) {
        const int item = static_cast<int>(answers.size()) + 1;
        answers.push_back({item, QString::fromLatin1(condition.id), QString::fromLatin1(term),
                           QString::fromLatin1(region), QString::fromLatin1(words[item % 6])});
      }
    }
  }
  if (gaps) {
    state.review.gaps = 2;
    answers[3].word.clear();
    answers[40].word.clear();
  }
  return state;
}

SampleScreen reviewPage(const QString& name, const ParticipantState& state, int page) {
  return sample<ReviewScreen>(name, state, [page](ReviewScreen& screen) { screen.setPage(page); });
}

SampleScreen glossary(int page) {
  return sample<GlossaryScreen>(QStringLiteral("glossary_%1").arg(page + 1), at(ParticipantScreen::kGlossary),
                                [page](GlossaryScreen& screen) { screen.setPage(page); });
}

SampleScreen strokes(const QString& name, const ParticipantState& state, double depth_mm) {
  return sample<StrokeScreen>(name, state, [depth_mm](StrokeScreen& screen) { screen.setDepth(depth_mm); });
}

template <class Panel>
SampleScreen panel(const QString& name) {
  return {name, [](const Look& look) { return std::make_unique<Panel>(look); }};
}

SampleScreen choiceAfterForceOff(const QString& name, const ParticipantState& state) {
  return {name, [state](const Look& look) {
            auto choice = std::make_unique<ForceOffPanel>(look, state.languages);
            choice->setState(state);
            return choice;
          }};
}

ParticipantState force(ForceState::Phase phase, const char* chosen = "") {
  ParticipantState state = at(ParticipantScreen::kForce, false);
  state.part = 2;
  state.force.phase = phase;
  state.force.chosen = QString::fromLatin1(chosen);
  return state;
}

ParticipantState rated(const char* question, const char* chosen) {
  ParticipantState state = at(ParticipantScreen::kRating);
  state.scale = {QString::fromLatin1(question), 1, 2, QString::fromLatin1(chosen), true};
  return state;
}

SampleScreen statement(int item) {
  ParticipantState state = at(ParticipantScreen::kScale);
  state.scale = {QStringLiteral("u.%1").arg(item), item, 6, item > 1 ? QString::number(item) : QString(), false};
  return sample<ScaleScreen>(QStringLiteral("usability_%1").arg(item), state);
}

ParticipantState device(DeviceStep step, bool can_go_on, bool simulated) {
  ParticipantState state = at(ParticipantScreen::kDeviceCheck);
  state.device = step;
  state.can_go_on = can_go_on;
  state.simulated = simulated;
  return state;
}

ParticipantState stopped(StopReason reason) {
  ParticipantState state = at(ParticipantScreen::kStopped, false);
  state.stop = reason;
  state.code = code();
  state.can_go_on = true;
  return state;
}

SampleScreen notice(const QString& name, const QString& sentence) {
  return {name, [sentence](const Look& look) { return std::make_unique<NoticePanel>(look, phrase(sentence)); }};
}

ParticipantState prepared(WelcomeState::Step step) {
  ParticipantState state = welcome(step);
  state.welcome.prepared = true;
  if (step == WelcomeState::Step::kWelcomeBack) {
    state.welcome.kept_strokes = 11;
    state.welcome.all_strokes = 12;
  }
  return state;
}

/// The statements `ids`, with a value where they have a place for one.
ParticipantState consent(std::initializer_list<const char*> ids) {
  ParticipantState state = at(ParticipantScreen::kConsent);
  for (const char* id : ids) {
    const bool contact = std::string_view(id) == "con.contact";
    const bool force = std::string_view(id) == "con.force";
    const bool minutes = std::string_view(id) == "con.minutes";
    QStringList values;
    if (contact) values << QStringLiteral("School of Nursing, 2766 0000");
    if (force) values << QStringLiteral("210");
    if (minutes) values << QStringLiteral("25");
    state.consent.paragraphs.push_back(phrase(QString::fromLatin1(id), values));
  }
  return state;
}

}  // namespace

std::vector<SampleScreen> sampleScreens() {
  using Phase = ForceState::Phase;
  using Step = WelcomeState::Step;
  std::vector<SampleScreen> all = {
      sample<WelcomeScreen>("welcome", welcome(Step::kStart)),
      sample<WelcomeScreen>("welcome_new_code", welcome(Step::kNewCode)),
      sample<WelcomeScreen>("welcome_enter_code", welcome(Step::kStart),
                            [](WelcomeScreen& screen) { screen.enterCode(); }),
      sample<WelcomeScreen>("welcome_back", welcome(Step::kWelcomeBack)),
      sample<WelcomeScreen>("welcome_prepared", prepared(Step::kNewCode)),
      sample<WelcomeScreen>("welcome_back_prepared", prepared(Step::kWelcomeBack)),
      sample<ConsentScreen>("consent", consent({"con.purpose", "con.what", "con.minutes", "con.force", "con.voluntary",
                                                "con.stop", "con.data", "con.withdraw", "con.contact"})),
      sample<ConsentScreen>("consent_questions",
                            consent({"con.purpose", "con.what_questions", "con.minutes", "con.force", "con.voluntary",
                                     "con.stop", "con.data_questions", "con.withdraw", "con.contact"})),
      sample<ConsentScreen>("consent_teacher", consent({"u.purpose", "con.voluntary", "con.stop", "u.data",
                                                        "con.withdraw", "con.contact"})),
  };
  int number = 0;
  for (const AboutYouState::Question each :
       {AboutYouState::Question::kYears, AboutYouState::Question::kHand, AboutYouState::Question::kGloves,
        AboutYouState::Question::kHaptic, AboutYouState::Question::kComfort}) {
    ParticipantState state = at(ParticipantScreen::kAboutYou);
    state.about.question = each;
    if (number % 2 == 1) state.about.chosen = answersTo(each).front().id;
    if (each == AboutYouState::Question::kComfort) state.about.chosen = QStringLiteral("no");
    all.push_back(sample<AboutYouScreen>(QStringLiteral("about_you_%1").arg(++number), state));
  }
  ParticipantState hold = device(DeviceStep::kHold, false, true);
  hold.virtual_device = true;
  hold.hold = HoldMeans::kMouse;
  all.push_back(sample<DeviceCheckScreen>("device_hold", hold));
  ParticipantState stylus = device(DeviceStep::kHold, false, false);
  all.push_back(sample<DeviceCheckScreen>("device_hold_stylus", stylus));
  stylus.waits = HoldWait::kHint;
  all.push_back(sample<DeviceCheckScreen>("device_hold_hint", stylus));
  stylus.waits = HoldWait::kStuck;
  stylus.hold = HoldMeans::kPedal;
  all.push_back(sample<DeviceCheckScreen>("device_hold_stuck", stylus));
  all.push_back(sample<DeviceCheckScreen>("device_ready", device(DeviceStep::kReady, true, false)));
  all.push_back(sample<DeviceCheckScreen>("device_wrong", device(DeviceStep::kWrong, true, false)));
  all.push_back(sample<DeviceCheckScreen>("device_lost", device(DeviceStep::kLost, true, false)));

  ParticipantState stroke = at(ParticipantScreen::kPractice);
  stroke.speed = {QStringLiteral("medium"), 0, 4, SpeedState::Note::kStart};
  all.push_back(strokes("practice", stroke, 40));
  stroke.screen = ParticipantScreen::kSpeed;
  stroke.speed.recorded = 2;
  stroke.speed.note = SpeedState::Note::kRecorded;
  all.push_back(strokes("speed", stroke, 110));
  stroke.speed.note = SpeedState::Note::kNotRecorded;
  stroke.left_handed = true;
  stroke.simulated = true;
  stroke.can_go_on = true;
  all.push_back(strokes("speed_left_handed", stroke, 160));

  ParticipantState practice = force(Phase::kFeel);
  practice.screen = ParticipantScreen::kPractice;
  all.push_back(sample<ForceScreen>("force_practice", practice));
  all.push_back(sample<ForceScreen>("force_feel", force(Phase::kFeel)));
  ParticipantState again = force(Phase::kFeel);
  again.force.again = true;
  again.simulated = true;
  all.push_back(sample<ForceScreen>("force_again", again));
  all.push_back(sample<ForceScreen>("force_pause", force(Phase::kPause)));
  all.push_back(sample<ForceScreen>("force_answer", force(Phase::kAnswer)));
  all.push_back(sample<ForceScreen>("force_answer_chosen", force(Phase::kAnswer, "large")));
  ParticipantState left = force(Phase::kAnswer, "beyond_practice");
  left.left_handed = true;
  all.push_back(sample<ForceScreen>("force_answer_left_handed", left));
  ParticipantState sure = force(Phase::kAnswer, "beyond_practice");
  sure.force.sure = true;
  all.push_back(sample<ForceScreen>("force_sure", sure));
  ParticipantState unpushed = force(Phase::kFeel);
  unpushed.force.waits_for_push = true;
  unpushed.waits = HoldWait::kHint;
  all.push_back(sample<ForceScreen>("force_push_hint", unpushed));
  ParticipantState before = force(Phase::kAnswer, "large");
  before.force.before = true;
  all.push_back(sample<ForceScreen>("force_before", before));

  all.push_back(sample<ScaleScreen>("rating_effort", rated("rate.effort", "")));
  all.push_back(sample<ScaleScreen>("rating_comfort", rated("rate.comfort", "6")));
  all.push_back(sample<RestScreen>("rest", at(ParticipantScreen::kRest, false)));
  ParticipantState counts = at(ParticipantScreen::kRest, false);
  counts.begins_to_count = true;
  all.push_back(sample<RestScreen>("now_it_counts", counts));
  for (int page = 0; page < 6; ++page) all.push_back(glossary(page));
  all.push_back(sample<QuestionScreen>("question_lubrication", asked("lubrication", "medium", "laryngopharynx", "")));
  all.push_back(sample<QuestionScreen>("question_neck", asked("neck_flexion", "large", "oropharynx", "large")));
  all.push_back(sample<QuestionScreen>("question_speed", asked("speed", "medium", "nasopharynx", "cant_tell")));
  ParticipantState chest = asked("lubrication", "well", "esophagus", "very_small");
  chest.left_handed = true;
  all.push_back(sample<QuestionScreen>("question_left_handed", chest));
  all.push_back(reviewPage("review_lubrication", review(true, false), 0));
  all.push_back(reviewPage("review_neck", review(false, false), 1));
  all.push_back(reviewPage("review_speed_gaps", review(true, false), 2));
  all.push_back(reviewPage("review_speed", review(false, false), 2));
  all.push_back(sample<ReviewScreen>("review_sealed", review(false, true)));
  ParticipantState own = at(ParticipantScreen::kOwnModel);
  own.own.ready = true;
  own.own.region = QStringLiteral("laryngopharynx");
  own.own.felt = true;
  own.own.chosen = QStringLiteral("right");
  all.push_back(sample<OwnModelScreen>("own_model", own, [](OwnModelScreen& screen) { screen.setDepth(160); }));
  ParticipantState thanks = at(ParticipantScreen::kThanks, false);
  for (int mm = 0; mm <= 440; mm += 2) {
    // Any smooth curve.
    thanks.thanks.curve.emplace_back(
        mm, 0.25 + 0.7 * std::exp(-std::pow((mm - 175.0) / 35, 2)) + 0.2 * std::exp(-std::pow((mm - 65.0) / 25, 2)));
  }
  all.push_back({"thanks", [thanks](const Look& look) {
                   auto screen = std::make_unique<ThanksScreen>(look, true);
                   screen->setState(thanks);
                   return screen;
                 }});
  for (const int item : {1, 4, 6}) all.push_back(statement(item));
  all.push_back(sample<StoppedScreen>("stopped", stopped(StopReason::kForToday)));
  all.push_back(sample<StoppedScreen>("withdrawn", stopped(StopReason::kWithdrawn)));
  all.push_back(notice("paused", QStringLiteral("err.paused")));
  all.push_back(notice("not_saved", QStringLiteral("err.save")));
  all.push_back(choiceAfterForceOff("force_off", {}));
  ParticipantState pause;
  pause.quiet_pause = true;
  all.push_back(choiceAfterForceOff("pause", pause));
  ParticipantState called;
  called.overlay = ForceOffOverlay::kCalled;
  all.push_back(choiceAfterForceOff("force_off_raise_hand", called));
  called.monitored = true;
  called.call_seen = true;
  all.push_back(choiceAfterForceOff("force_off_called", called));
  all.push_back(panel<WithdrawPanel>("withdraw"));
  return all;
}

bool isWithDevice(const QString& name) {
  for (const char* part : {"device", "practice", "speed", "force", "own_model"}) {
    if (name.startsWith(QLatin1String(part))) return true;
  }
  return false;
}

}  // namespace tactus::workbench::nurse
