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

template <class Screen, class State>
SampleScreen sample(const QString& name, const State& state) {
  return {name, [state](const Look& look) {
            auto screen = std::make_unique<Screen>(look);
            screen->setState(state);
            return screen;
          }};
}

WelcomeState welcome(WelcomeStep step) {
  WelcomeState state;
  state.step = step;
  state.code = QStringLiteral("thunderstorm marmalade");
  state.kept_answers = 27;
  state.code_unknown = true;
  state.meant = QStringLiteral("thunderstorm marmalade");
  return state;
}

QuestionState asked(const char* condition, const char* term, const char* region, const char* chosen) {
  QuestionState state;
  state.number = 12;
  state.condition = QString::fromLatin1(condition);
  state.term = QString::fromLatin1(term);
  state.region = QString::fromLatin1(region);
  state.chosen = QString::fromLatin1(chosen);
  return state;
}

ReviewState review(bool gaps, bool sealed) {
  const char* words[] = {"very_small", "small", "medium", "large", "very_large", "cant_tell"};
  const struct {
    const char* id;
    const char* terms[3];
  } conditions[] = {{"lubrication", {"poor", "medium", "well"}},
                    {"neck_flexion", {"small", "medium", "large"}},
                    {"speed", {"slow", "medium", "fast"}}};
  ReviewState state;
  state.sealed = sealed;
  for (const auto& condition : conditions) {
    for (const char* term : condition.terms) {
      for (const char* region : {"nasal_cavity", "nasopharynx", "oropharynx", "laryngopharynx", "esophagus"}) {
        const int item = static_cast<int>(state.answers.size()) + 1;
        state.answers.push_back({item, QString::fromLatin1(condition.id), QString::fromLatin1(term),
                                 QString::fromLatin1(region), QString::fromLatin1(words[item % 6])});
      }
    }
  }
  if (gaps) {
    state.answers[3].word.clear();
    state.answers[40].word.clear();
  }
  return state;
}

SampleScreen reviewPage(const QString& name, const ReviewState& state, int page) {
  return {name, [state, page](const Look& look) {
            auto screen = std::make_unique<ReviewScreen>(look);
            screen->setState(state);
            screen->setPage(page);
            return screen;
          }};
}

SampleScreen glossary(int page) {
  return {QStringLiteral("glossary_%1").arg(page + 1), [page](const Look& look) {
            auto screen = std::make_unique<GlossaryScreen>(look);
            screen->setPage(page);
            return screen;
          }};
}

SampleScreen strokes(const QString& name, const StrokeState& state, double depth_mm) {
  return {name, [state, depth_mm](const Look& look) {
            auto screen = std::make_unique<StrokeScreen>(look);
            screen->setState(state);
            screen->setDepth(depth_mm);
            return screen;
          }};
}

template <class Panel>
SampleScreen panel(const QString& name) {
  return {name, [](const Look& look) { return std::make_unique<Panel>(look); }};
}

ForceState force(JudgingPhase step, const char* chosen = "") {
  ForceState state;
  state.step = step;
  state.chosen = QString::fromLatin1(chosen);
  return state;
}

ScaleState rated(const char* question, const char* chosen) {
  const QString id = QString::fromLatin1(question);
  ScaleState state;
  state.title = phrase(QStringLiteral("rate.title"));
  state.sentence = phrase(id);
  state.low = phrase(id + QStringLiteral(".low"));
  state.high = phrase(id + QStringLiteral(".high"));
  state.chosen = QString::fromLatin1(chosen);
  state.may_not_say = true;
  return state;
}

SampleScreen statement(int item) {
  constexpr int kStatements = 6;
  ScaleState state;
  state.title = phrase(QStringLiteral("u.title"), {QString::number(item), QString::number(kStatements)});
  state.instructions = phrase(QStringLiteral("u.instructions"));
  state.sentence = phrase(QStringLiteral("u.%1").arg(item));
  state.low = phrase(QStringLiteral("u.low"));
  state.high = phrase(QStringLiteral("u.high"));
  if (item > 1) state.chosen = QString::number(item);
  state.is_last = item == kStatements;
  return sample<ScaleScreen>(QStringLiteral("usability_%1").arg(item), state);
}

/// The statements `ids`, with a value where they have a place for one.
ConsentState consent(std::initializer_list<const char*> ids) {
  ConsentState state;
  for (const char* id : ids) {
    const bool contact = std::string_view(id) == "con.contact";
    const bool force = std::string_view(id) == "con.force";
    const bool minutes = std::string_view(id) == "con.minutes";
    QStringList values;
    if (contact) values << QStringLiteral("School of Nursing, 2766 0000");
    if (force) values << QStringLiteral("210");
    if (minutes) values << QStringLiteral("25");
    state.paragraphs.push_back(phrase(QString::fromLatin1(id), values));
  }
  return state;
}

}  // namespace

std::vector<SampleScreen> sampleScreens() {
  std::vector<SampleScreen> all = {
      sample<WelcomeScreen>("welcome", welcome(WelcomeStep::kStart)),
      sample<WelcomeScreen>("welcome_new_code", welcome(WelcomeStep::kNewCode)),
      sample<WelcomeScreen>("welcome_enter_code", welcome(WelcomeStep::kEnterCode)),
      sample<WelcomeScreen>("welcome_back", welcome(WelcomeStep::kWelcomeBack)),
      sample<ConsentScreen>("consent", consent({"con.purpose", "con.what", "con.minutes", "con.force", "con.voluntary",
                                                "con.stop", "con.data", "con.withdraw", "con.contact"})),
      sample<ConsentScreen>("consent_questions",
                            consent({"con.purpose", "con.what_questions", "con.minutes", "con.force", "con.voluntary",
                                     "con.stop", "con.data_questions", "con.withdraw", "con.contact"})),
      sample<ConsentScreen>("consent_teacher", consent({"u.purpose", "con.voluntary", "con.stop", "u.data",
                                                        "con.withdraw", "con.contact"})),
  };
  int number = 0;
  for (const AboutQuestion each : {AboutQuestion::kYears, AboutQuestion::kHand, AboutQuestion::kGloves,
                                   AboutQuestion::kHaptic, AboutQuestion::kComfort}) {
    AboutYouState state;
    state.question = each;
    if (number % 2 == 1) state.chosen = answersTo(each).front().id;
    all.push_back(sample<AboutYouScreen>(QStringLiteral("about_you_%1").arg(++number), state));
  }
  all.push_back(sample<DeviceCheckScreen>("device_hold", DeviceCheckState{DeviceStep::kHold, true, false, true}));
  all.push_back(sample<DeviceCheckScreen>("device_ready", DeviceCheckState{DeviceStep::kReady, false, true, false}));
  all.push_back(sample<DeviceCheckScreen>("device_wrong", DeviceCheckState{DeviceStep::kWrong, false, true, false}));
  all.push_back(sample<DeviceCheckScreen>("device_lost", DeviceCheckState{DeviceStep::kLost, false, true, false}));

  StrokeState stroke;
  stroke.practice = true;
  stroke.speed = SpeedWord::kMedium;
  all.push_back(strokes("practice", stroke, 40));
  stroke.practice = false;
  stroke.recorded = 2;
  stroke.note = StrokeNote::kRecorded;
  all.push_back(strokes("speed", stroke, 110));
  stroke.note = StrokeNote::kNotRecorded;
  stroke.left_handed = true;
  stroke.simulated = true;
  stroke.may_go_on = true;
  all.push_back(strokes("speed_left_handed", stroke, 160));

  ForceState practice = force(JudgingPhase::kFeel);
  practice.practice = true;
  all.push_back(sample<ForceScreen>("force_practice", practice));
  all.push_back(sample<ForceScreen>("force_feel", force(JudgingPhase::kFeel)));
  ForceState again = force(JudgingPhase::kFeel);
  again.again = true;
  again.simulated = true;
  all.push_back(sample<ForceScreen>("force_again", again));
  all.push_back(sample<ForceScreen>("force_pause", force(JudgingPhase::kPause)));
  all.push_back(sample<ForceScreen>("force_answer", force(JudgingPhase::kAnswer)));
  all.push_back(sample<ForceScreen>("force_answer_chosen", force(JudgingPhase::kAnswer, "large")));
  ForceState left = force(JudgingPhase::kAnswer, "beyond_practice");
  left.left_handed = true;
  all.push_back(sample<ForceScreen>("force_answer_left_handed", left));

  ForceState before = force(JudgingPhase::kAnswer, "large");
  before.before = true;
  all.push_back(sample<ForceScreen>("force_before", before));

  all.push_back(sample<ScaleScreen>("rating_effort", rated("rate.effort", "")));
  all.push_back(sample<ScaleScreen>("rating_comfort", rated("rate.comfort", "6")));
  all.push_back(panel<RestScreen>("rest"));
  for (int page = 0; page < 6; ++page) all.push_back(glossary(page));
  all.push_back(sample<QuestionScreen>("question_lubrication", asked("lubrication", "medium", "laryngopharynx", "")));
  all.push_back(sample<QuestionScreen>("question_neck", asked("neck_flexion", "large", "oropharynx", "large")));
  all.push_back(sample<QuestionScreen>("question_speed", asked("speed", "medium", "nasopharynx", "cant_tell")));
  QuestionState chest = asked("lubrication", "well", "esophagus", "very_small");
  chest.left_handed = true;
  all.push_back(sample<QuestionScreen>("question_left_handed", chest));
  all.push_back(reviewPage("review_lubrication", review(true, false), 0));
  all.push_back(reviewPage("review_neck", review(false, false), 1));
  all.push_back(reviewPage("review_speed_gaps", review(true, false), 2));
  all.push_back(reviewPage("review_speed", review(false, false), 2));
  all.push_back(sample<ReviewScreen>("review_sealed", review(false, true)));
  OwnModelState own;
  own.region = QStringLiteral("laryngopharynx");
  own.chosen = QStringLiteral("right");
  all.push_back({"own_model", [own](const Look& look) {
                   auto screen = std::make_unique<OwnModelScreen>(look);
                   screen->setState(own);
                   screen->setDepth(160);
                   return screen;
                 }});
  ThanksState thanks;
  for (int mm = 0; mm <= 440; mm += 2) {
    // Any smooth curve.
    thanks.curve.emplace_back(
        mm, 0.25 + 0.7 * std::exp(-std::pow((mm - 175.0) / 35, 2)) + 0.2 * std::exp(-std::pow((mm - 65.0) / 25, 2)));
  }
  all.push_back(sample<ThanksScreen>("thanks", thanks));
  for (const int item : {1, 4, 6}) all.push_back(statement(item));
  for (const auto& [name, reason] :
       {std::pair{"stopped", StopReason::kForToday}, std::pair{"withdrawn", StopReason::kWithdrawn},
        std::pair{"paused", StopReason::kPaused}, std::pair{"not_saved", StopReason::kNotSaved}}) {
    all.push_back(sample<StoppedScreen>(
        QString::fromLatin1(name),
        StoppedState{reason, QStringLiteral("thunderstorm marmalade"),
                     reason == StopReason::kForToday || reason == StopReason::kWithdrawn, false}));
  }
  all.push_back(panel<ForceOffPanel>("force_off"));
  all.push_back({"force_off_called", [](const Look& look) {
                   auto force_off = std::make_unique<ForceOffPanel>(look);
                   force_off->setCalled(true);
                   return force_off;
                 }});
  all.push_back(panel<WithdrawPanel>("withdraw"));
  return all;
}

}  // namespace tactus::workbench::nurse
