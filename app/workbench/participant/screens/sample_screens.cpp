#include "app/workbench/participant/screens/sample_screens.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "app/workbench/participant/kit/pages.h"
#include "app/workbench/participant/screens/arrival_screens.h"
#include "app/workbench/participant/screens/device_screens.h"
#include "app/workbench/participant/screens/page_screen.h"
#include "app/workbench/participant/screens/panels.h"
#include "app/workbench/participant/screens/question_screens.h"
#include "app/workbench/participant/screens/review_screen.h"
#include "app/workbench/participant/screens/thanks_screen.h"

namespace tactus::workbench::nurse {
namespace {

/// Back leads to something, except where it never does.
ParticipantState at(ParticipantScreen screen, bool can_go_back = true) {
  ParticipantState state;
  state.screen = screen;
  state.can_go_back = can_go_back;
  return state;
}

/// The languages of the procedure.
ParticipantState offering(ParticipantState state, const Look& look) {
  state.languages = languagesOf(*look.about());
  return state;
}

template <class Screen>
SampleScreen sample(
    const QString& name, const ParticipantState& state, const std::function<void(Screen&)>& then = [](Screen&) {}) {
  return {name, state.screen, factsOf(state.screen).uses_device, [state, then](const Look& look) {
            auto screen = std::make_unique<Screen>(look);
            screen->setState(offering(state, look));
            then(*screen);
            return screen;
          }};
}

/// Of text and cards.
SampleScreen sample(const QString& name, ParticipantState state, PageState page) {
  state.page = std::move(page);
  return sample<PageScreen>(name, state);
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

/// What the samples are about.
struct Subject {
  const procedure::Procedure& procedure;
  const study::Form& form;

  /// The conditions besides the way about which the form asks, in its order.
  std::vector<std::string> inputs() const;
  /// Word `place` of the force, or the last one.
  QString word(std::size_t place) const;
};

std::vector<std::string> Subject::inputs() const {
  std::vector<std::string> out;
  for (const study::FormItem& item : form.items) {
    for (const study::ItemCondition& condition : item.conditions) {
      const bool known = std::find(out.begin(), out.end(), condition.input) != out.end();
      if (condition.input != procedure.wayInput().id && !known) out.push_back(condition.input);
    }
  }
  return out;
}

QString Subject::word(std::size_t place) const {
  const auto& terms = procedure.output.terms;
  return QString::fromStdString(terms[std::min(place, terms.size() - 1)].id);
}

/// A name of a file for something of `input`; `neck` for `neck_flexion`, where no other begins so.
QString nameOf(const Subject& about, const QString& input) {
  const QString first = input.section(QLatin1Char('_'), 0, 0);
  const auto& inputs = about.procedure.inputs;
  const auto alike = std::count_if(inputs.begin(), inputs.end(), [&](const fuzzy::Variable& one) {
    return QString::fromStdString(one.id).section(QLatin1Char('_'), 0, 0) == first;
  });
  return alike > 1 ? input : first;
}

ReviewAnswer situationOf(const Subject& about, const study::FormItem& item) {
  ReviewAnswer out;
  out.item = item.number;
  for (const study::ItemCondition& condition : item.conditions) {
    if (condition.input == about.procedure.wayInput().id) {
      out.region = QString::fromStdString(condition.term);
    } else {
      out.conditions.push_back(condition);
    }
  }
  return out;
}

/// The question about word `term` of `input` in region `region`, or the last ones; another one about the input if the
/// form has none.
ParticipantState asked(const Subject& about, const std::string& input, std::size_t term, std::size_t region,
                       const QString& chosen) {
  const auto variable = std::find_if(about.procedure.inputs.begin(), about.procedure.inputs.end(),
                                     [&](const fuzzy::Variable& one) { return one.id == input; });
  const auto regions = procedure::regionsOf(about.procedure, about.form);
  const study::ItemCondition wanted =
      variable == about.procedure.inputs.end()
          ? study::kWayOut
          : study::ItemCondition{input, variable->terms[std::min(term, variable->terms.size() - 1)].id};
  const QString place =
      regions.empty() ? QString() : QString::fromStdString(regions[std::min(region, regions.size() - 1)]);
  ReviewAnswer best;
  int most = -1;
  for (const study::FormItem& item : about.form.items) {
    ReviewAnswer one = situationOf(about, item);
    const auto& conditions = one.conditions;
    const bool about_it =
        std::any_of(conditions.begin(), conditions.end(), [&](const auto& c) { return c.input == input; });
    const bool same = std::find(conditions.begin(), conditions.end(), wanted) != conditions.end();
    const int fits = about_it ? 1 + 2 * (same ? 1 : 0) + (one.region == place ? 1 : 0) : 0;
    if (fits <= most) continue;
    most = fits;
    best = std::move(one);
  }
  ParticipantState state = at(ParticipantScreen::kQuestion);
  state.part = 3;
  const int count = static_cast<int>(about.form.items.size());
  state.question = {best.item, std::min(12, count), count, std::move(best.conditions), best.region, chosen, false};
  return state;
}

ParticipantState review(const Subject& about, bool gaps, bool sealed) {
  QStringList words;
  for (const study::AnswerWord& answer : about.form.answers) words << QString::fromStdString(answer.term);
  words << QStringLiteral("cant_tell");
  ParticipantState state = at(ParticipantScreen::kReview, !sealed);
  state.review.sealed = sealed;
  auto& answers = state.review.answers;
  for (const study::FormItem& item : about.form.items) {
    answers.push_back(situationOf(about, item));
    answers.back().word = words[static_cast<qsizetype>(answers.size()) % words.size()];
  }
  if (gaps) {
    for (const std::size_t open : {std::min<std::size_t>(3, answers.size() - 1), answers.size() * 8 / 9}) {
      if (!answers[open].word.isEmpty()) ++state.review.gaps;
      answers[open].word.clear();
    }
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

SampleScreen choiceAfterForceOff(const QString& name, const ParticipantState& state) {
  return {name, std::nullopt, !state.quiet_pause, [state](const Look& look) {
            const ParticipantState shown = offering(state, look);
            auto choice = std::make_unique<ForceOffPanel>(look, shown.languages);
            choice->setState(shown);
            return choice;
          }};
}

ParticipantState force(const Subject& about, ForceState::Phase phase, const QString& chosen = {}) {
  ParticipantState state = at(ParticipantScreen::kForce, false);
  state.part = 2;
  state.force.phase = phase;
  state.force.chosen = chosen;
  state.force.asks_stop = about.procedure.stop_question;
  return state;
}

SampleScreen rating(const QString& name, const QString& question, const QString& chosen) {
  return sample(name, at(ParticipantScreen::kRating), ratingPage(question, chosen));
}

SampleScreen statement(int item) {
  const QString chosen = item > 1 ? QString::number(item) : QString();
  return sample(QStringLiteral("usability_%1").arg(item), at(ParticipantScreen::kScale),
                statementPage(item, item, 6, chosen));
}

ParticipantState device(DeviceStep step, bool can_go_on, bool simulated) {
  ParticipantState state = at(ParticipantScreen::kDeviceCheck);
  state.device = step;
  state.can_go_on = can_go_on;
  state.simulated = simulated;
  return state;
}

SampleScreen stopped(const QString& name, StopReason reason) {
  ParticipantState state = at(ParticipantScreen::kStopped, false);
  state.can_go_on = true;
  return sample(name, state, stoppedPage(reason, code()));
}

SampleScreen notice(const QString& name, const QString& sentence) {
  return {name, std::nullopt, false,
          [sentence](const Look& look) { return std::make_unique<NoticePanel>(look, phrase(sentence)); }};
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

namespace {

void addArrival(std::vector<SampleScreen>& all) {
  using Step = WelcomeState::Step;
  all = {
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
    AboutYouState about{each, {}, false};
    if (number % 2 == 1) about.chosen = aboutYouPage(about).cards.front().id;
    if (each == AboutYouState::Question::kComfort) about.chosen = QStringLiteral("no");
    const QString name = QStringLiteral("about_you_%1").arg(++number);
    all.push_back(sample(name, at(ParticipantScreen::kAboutYou), aboutYouPage(about)));
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
}

void addStrokes(const Subject& about, std::vector<SampleScreen>& all) {
  const fuzzy::Variable* const rate = about.procedure.rateInput();
  if (rate == nullptr) return;
  const fuzzy::Variable& way = about.procedure.wayInput();
  // As far as a hand reaches, and no farther than the way.
  const auto depth_mm = [&](double mm) { return way.min + mm * std::min(1.0, (way.max - way.min) / 200); };
  ParticipantState stroke = at(ParticipantScreen::kPractice);
  const std::size_t level = std::min<std::size_t>(1, rate->terms.size() - 1);
  stroke.speed = {QString::fromStdString(rate->terms[level].id), 0, 4, SpeedState::Note::kStart};
  all.push_back(strokes("practice", stroke, depth_mm(40)));
  stroke.screen = ParticipantScreen::kSpeed;
  stroke.speed.recorded = 2;
  stroke.speed.note = SpeedState::Note::kRecorded;
  all.push_back(strokes("speed", stroke, depth_mm(110)));
  stroke.speed.note = SpeedState::Note::kNotRecorded;
  stroke.left_handed = true;
  stroke.simulated = true;
  stroke.can_go_on = true;
  all.push_back(strokes("speed_left_handed", stroke, depth_mm(160)));
}

void addForces(const Subject& about, std::vector<SampleScreen>& all) {
  using Phase = ForceState::Phase;
  const QString large = about.word(3);
  ParticipantState practice = force(about, Phase::kFeel);
  practice.screen = ParticipantScreen::kPractice;
  all.push_back(sample<ForceScreen>("force_practice", practice));
  all.push_back(sample<ForceScreen>("force_feel", force(about, Phase::kFeel)));
  ParticipantState again = force(about, Phase::kFeel);
  again.force.again = true;
  again.simulated = true;
  all.push_back(sample<ForceScreen>("force_again", again));
  all.push_back(sample<ForceScreen>("force_pause", force(about, Phase::kPause)));
  all.push_back(sample<ForceScreen>("force_answer", force(about, Phase::kAnswer)));
  all.push_back(sample<ForceScreen>("force_answer_chosen", force(about, Phase::kAnswer, large)));
  ParticipantState left = force(about, Phase::kAnswer, QStringLiteral("beyond_practice"));
  left.left_handed = true;
  left.force.stops = about.procedure.stop_question;
  all.push_back(sample<ForceScreen>("force_answer_left_handed", left));
  ParticipantState sure = force(about, Phase::kAnswer, QStringLiteral("beyond_practice"));
  sure.force.sure = true;
  all.push_back(sample<ForceScreen>("force_sure", sure));
  ParticipantState unpushed = force(about, Phase::kFeel);
  unpushed.force.waits_for_push = true;
  unpushed.waits = HoldWait::kHint;
  all.push_back(sample<ForceScreen>("force_push_hint", unpushed));
  ParticipantState before = force(about, Phase::kAnswer, large);
  before.force.before = true;
  all.push_back(sample<ForceScreen>("force_before", before));
}

void addQuestions(const Subject& about, std::vector<SampleScreen>& all) {
  all.push_back(rating("rating_effort", "rate.effort", ""));
  all.push_back(rating("rating_comfort", "rate.comfort", "6"));
  all.push_back(sample("rest", at(ParticipantScreen::kRest, false), restPage(false)));
  all.push_back(sample("now_it_counts", at(ParticipantScreen::kRest, false), restPage(true)));
  const int words = static_cast<int>(about.procedure.inputs.size()) - 1;
  for (int page = 0; page < 3 + words; ++page) all.push_back(glossary(page));

  // One question about each condition.
  const std::vector<std::string> inputs = about.inputs();
  const struct {
    std::size_t term, region;
    QString chosen;
  } questions[] = {{1, 3, {}}, {2, 2, about.word(3)}, {1, 1, QStringLiteral("cant_tell")}};
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const auto& [term, region, chosen] = questions[i % std::size(questions)];
    const QString name = QStringLiteral("question_") + nameOf(about, QString::fromStdString(inputs[i]));
    all.push_back(sample<QuestionScreen>(name, asked(about, inputs[i], term, region, chosen)));
  }
  if (!inputs.empty()) {
    constexpr std::size_t kLast = 99;
    ParticipantState left = asked(about, inputs.front(), kLast, kLast, about.word(0));
    left.left_handed = true;
    all.push_back(sample<QuestionScreen>("question_left_handed", left));
  }

  const auto pages = reviewPages(about.procedure, about.form, review(about, false, false).review.answers);
  for (std::size_t i = 0; i < pages.size(); ++i) {
    const int page = static_cast<int>(i);
    const bool last = i + 1 == pages.size();
    const auto again = std::count_if(pages.begin(), pages.begin() + page,
                                     [&](const ReviewPage& one) { return one.input == pages[i].input; });
    QString name = QStringLiteral("review_") + nameOf(about, QString::fromStdString(pages[i].input));
    if (again > 0) name += QStringLiteral("_%1").arg(again + 1);
    if (last) all.push_back(reviewPage(name + QStringLiteral("_gaps"), review(about, true, false), page));
    all.push_back(reviewPage(name, review(about, i == 0 && !last, false), page));
  }
  all.push_back(sample<ReviewScreen>("review_sealed", review(about, false, true)));
}

void addEnd(const Look& look, const Subject& about, std::vector<SampleScreen>& all) {
  const auto regions = regionNames(look);
  const QString region = regions[std::min<std::size_t>(3, regions.size() - 1)].id;
  const auto range = anatomy::rangeOf(about.procedure, region.toStdString());
  const auto first = anatomy::rangeOf(about.procedure, regions.front().id.toStdString());
  const auto last = anatomy::rangeOf(about.procedure, regions.back().id.toStdString());
  ParticipantState own = at(ParticipantScreen::kOwnModel);
  own.own.ready = true;
  own.own.region = region;
  own.own.felt = true;
  own.own.chosen = QStringLiteral("right");
  const double tip_mm = range->from_mm + 0.2 * (range->to_mm - range->from_mm);
  all.push_back(
      sample<OwnModelScreen>("own_model", own, [tip_mm](OwnModelScreen& screen) { screen.setDepth(tip_mm); }));
  ParticipantState thanks = at(ParticipantScreen::kThanks, false);
  for (int place = 0; place <= 440; place += 2) {
    // Any smooth curve.
    thanks.thanks.curve.emplace_back(
        first->from_mm + (last->to_mm - first->from_mm) * place / 440,
        0.25 + 0.7 * std::exp(-std::pow((place - 175.0) / 35, 2)) + 0.2 * std::exp(-std::pow((place - 65.0) / 25, 2)));
  }
  all.push_back({"thanks", thanks.screen, false, [thanks](const Look& shown_in) {
                   auto screen = std::make_unique<ThanksScreen>(shown_in, true);
                   screen->setState(thanks);
                   return screen;
                 }});
  for (const int item : {1, 4, 6}) all.push_back(statement(item));
  all.push_back(stopped("stopped", StopReason::kForToday));
  all.push_back(stopped("withdrawn", StopReason::kWithdrawn));
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
  all.push_back({"withdraw", std::nullopt, false,
                 [](const Look& shown_in) { return std::make_unique<WithdrawPanel>(shown_in); }});
}

}  // namespace

std::vector<SampleScreen> sampleScreens(const Look& look) {
  const Subject about{*look.about(), look.form()};
  std::vector<SampleScreen> all;
  addArrival(all);
  addStrokes(about, all);
  addForces(about, all);
  addQuestions(about, all);
  addEnd(look, about, all);
  return all;
}

}  // namespace tactus::workbench::nurse
