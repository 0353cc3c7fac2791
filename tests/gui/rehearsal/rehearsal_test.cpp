// A simulated nurse on the screens: her whole session is in the file, and the model that is built of it gives the
// forces that she answered.
#include <QApplication>
#include <QLabel>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <set>

#include "app/session/simulated_study.h"
#include "app/workbench/participant/kit/pages.h"
#include "app/workbench/participant/participant_controller.h"
#include "app/workbench/participant/participant_window.h"
#include "app/workbench/participant/screens/page_screen.h"
#include "app/workbench/rehearsal/screen_nurse.h"
#include "app/workbench/session/rehearse_start.h"
#include "core/fuzzy/compiled_model.h"
#include "core/model_io/model_file.h"
#include "core/store/entries.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"
#include "core/store/study_info.h"
#include "questionnaires/form_file.h"

#include "tests/gui/sample_study.h"
#include "tests/support/default_procedure.h"

namespace tactus::workbench {
namespace {

constexpr double kFast = 1000;
constexpr std::uint64_t kSeed = 2;  // of the rehearsal

/// The screens that were shown, and those of them without the mark.
struct Seen {
  std::set<ParticipantScreen> screens;
  std::set<ParticipantScreen> unmarked;
};

void lookAt(const ParticipantController& course, Seen& seen) {
  const ParticipantScreen screen = course.state().screen;
  seen.screens.insert(screen);
  for (const QWidget* window : QApplication::topLevelWidgets()) {
    const auto labels = window->findChildren<QLabel*>();
    const bool marked = std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
      return label->isVisible() && label->text() == QStringLiteral("SIMULATED");
    });
    if (window->isVisible() && !marked) seen.unmarked.insert(screen);
  }
}

// The simulated nurse knows nothing of this screen: she takes the first card, and goes on.
TEST(ScreenNurse, PassesAnyScreenOfTextAndCards) {
  nurse::Look look;
  ParticipantWindow window(look, [] {});
  window.resize(1280, 720);
  auto* const screen = new nurse::PageScreen(look);
  ParticipantState state;
  state.screen = ParticipantScreen::kGlossary;
  state.page = aboutYouPage({});
  screen->setState(state);
  window.setScreen(screen);
  window.show();
  bool passed = false;
  QObject::connect(screen, &nurse::ScreenFrame::picked, screen, [&](const QString& id) {
    state.page.chosen = id;
    screen->setState(state);
  });
  QObject::connect(screen, &nurse::ScreenFrame::primary, screen, [&passed] { passed = true; });
  ScreenHands hands(window, look);
  ScreenNurse nurse(hands, session::simulatedNurses(kSeed).front(), kSeed);
  for (double now_s = 0; !passed && now_s < 60; now_s += 0.1) nurse.live(state, {}, now_s);
  EXPECT_TRUE(passed);
  EXPECT_EQ(state.page.chosen, QStringLiteral("years_1"));
  window.leave();
}

class RehearsalTest : public testing::Test {
 protected:
  QString rehearse() {
    RehearseStart start({path, kFast});
    QString sentence = QStringLiteral("not ended");
    QObject::connect(&start, &RehearseStart::succeeded, [&sentence] { sentence.clear(); });
    QObject::connect(&start, &RehearseStart::failed, [&sentence](const QString& why) { sentence = why; });
    bool watched = false;
    QObject::connect(&start, &RehearseStart::raised, [&](ParticipantController* course) {
      watched = true;
      QObject::connect(course, &ParticipantController::changed, course, [this, course] { lookAt(*course, seen); });
    });
    start.begin();
    EXPECT_TRUE(QTest::qWaitFor([&sentence] { return sentence != QStringLiteral("not ended"); }, 120'000));
    EXPECT_TRUE(watched);
    return sentence;
  }

  QTemporaryDir folder;
  QString path = folder.filePath(QStringLiteral("rehearsed.tactus"));
  Seen seen;
};

/// Midpoint rule over the universe: the textbook's centroid of terms that are all fully true.
double centroidOf(const fuzzy::Variable& output, const std::set<std::string>& terms) {
  constexpr int kSteps = 200'000;
  double area = 0;
  double moment = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double x = output.min + (output.max - output.min) * (i + 0.5) / kSteps;
    double height = 0;
    for (const fuzzy::Term& term : output.terms) {
      if (!terms.contains(term.id)) continue;
      const auto& p = term.points;
      const double b = p.size() == 4 ? p[2] : p[1];
      double up = x < p[0] || x > p.back() ? 0 : 1;
      if (up > 0 && x < p[1]) up = (x - p[0]) / (p[1] - p[0]);
      if (up > 0 && x > b) up = (p.back() - x) / (p.back() - b);
      height = std::max(height, up);
    }
    area += height;
    moment += height * x;
  }
  return moment / area;
}

/// In the middle of what belongs wholly to the term.
double coreOf(const fuzzy::Variable& input, const std::string& id) {
  const auto term = std::find_if(input.terms.begin(), input.terms.end(), [&](const auto& one) { return one.id == id; });
  return std::clamp((term->points[1] + term->points[2]) / 2, input.min, input.max);
}

TEST_F(RehearsalTest, AWholeSessionIsInTheFileAndItsModelGivesTheAnswers) {
  ASSERT_EQ(rehearse(), QString());
  for (const ScreenFacts& facts : kScreenFacts) {
    const bool hers = facts.screen != ParticipantScreen::kScale && facts.screen != ParticipantScreen::kStopped;
    EXPECT_EQ(seen.screens.contains(facts.screen), hers) << facts.id;
    EXPECT_FALSE(seen.unmarked.contains(facts.screen)) << facts.id;
  }

  const auto nurse = session::simulatedNurseCalled("S3", kSeed);
  std::map<int, std::string> answers;
  for (const study::Answer& answer : nurse.answers) answers[answer.item] = answer.term;
  std::string code;
  {
    const auto file = tests::lookInto(path);
    EXPECT_TRUE(store::checkStudy(file)->empty());
    const auto persons = *store::persons(file);
    ASSERT_EQ(persons.size(), 1U);
    EXPECT_TRUE(persons[0].simulated);
    code = persons[0].code;
    const auto stored = *store::answers(file);
    ASSERT_EQ(stored.size(), 45U);
    for (const auto& one : stored) EXPECT_EQ(one.value, answers[one.item]) << one.item;
    // Without noise S3 repeats the votes of Table 2: two words each up to 0.6 N, then three large and two very large.
    const std::vector<std::string> words = {"very_small", "very_small", "small", "small",      "medium",     "medium",
                                            "large",      "large",      "large", "very_large", "very_large", ""};
    std::vector<std::string> judged;
    const auto judgements = *store::judgements(file);
    for (const auto& one : judgements) {
      if (one.scored) judged.push_back(one.term);
    }
    EXPECT_EQ(judged, words) << "at 1.2 N beyond practice";
  }

  const QString model_path = folder.filePath(QStringLiteral("model.tactus.json"));
  QProcess build;
  build.start(QStringLiteral(TACTUS_PROGRAM), {QStringLiteral("build"), path, QStringLiteral("--out"), model_path});
  ASSERT_TRUE(build.waitForFinished(60'000));
  ASSERT_EQ(build.exitCode(), 0) << build.readAllStandardError().toStdString();
  const auto read = model_io::readModel(model_path.toStdString());
  ASSERT_TRUE(read.has_value()) << read.error().message();
  const fuzzy::ForceModel& model = read->model;
  ASSERT_EQ(model.experts.size(), 1U);
  EXPECT_EQ(model.experts[0].id, code);
  EXPECT_EQ(model.experts[0].rules.size(), 45U);
  const auto compiled = fuzzy::compile(model);
  ASSERT_TRUE(compiled.has_value());

  // Where one term of each condition is fully true, three of her answers speak, each with its whole word.
  const study::Form form = support::ngtForceForm();
  const std::map<std::string, std::string> conditions = {
      {"lubrication", "well"}, {"neck_flexion", "large"}, {"speed", "slow"}};
  int places = 0;
  for (const fuzzy::Term& region : model.inputs[2].terms) {
    std::set<std::string> words;
    for (const study::FormItem& item : form.items) {
      bool speaks = true;
      for (const auto& condition : item.conditions) {
        const auto wanted = condition.input == "depth" ? region.id : conditions.at(condition.input);
        speaks = speaks && condition.term == wanted;
      }
      if (speaks) words.insert(answers[item.number]);
    }
    if (words.empty()) continue;
    ++places;
    std::vector<double> inputs;
    for (const fuzzy::Variable& input : model.inputs) {
      inputs.push_back(coreOf(input, input.id == "depth" ? region.id : conditions.at(input.id)));
    }
    const auto force = compiled->evaluate(inputs);
    EXPECT_TRUE(force.fired);
    EXPECT_NEAR(force.force_n, centroidOf(model.output, words), 1e-5) << region.id;  // the midpoint rule's own error
  }
  EXPECT_EQ(places, 5);
}

TEST_F(RehearsalTest, WithoutAPlaceForTheStudyItEndsWithOneSentence) {
  RehearseStart start({folder.filePath(QStringLiteral("no such folder/x.tactus")), kFast});
  QString sentence;
  QObject::connect(&start, &RehearseStart::failed, [&sentence](const QString& why) { sentence = why; });
  start.begin();
  ASSERT_TRUE(QTest::qWaitFor([&sentence] { return !sentence.isEmpty(); }, 10'000));
  EXPECT_EQ(sentence.count(QLatin1Char('\n')), 0);
}

}  // namespace
}  // namespace tactus::workbench
