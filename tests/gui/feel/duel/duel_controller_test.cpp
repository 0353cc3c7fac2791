#include "app/workbench/feel/duel/duel_controller.h"

#include <QSignalSpy>
#include <gtest/gtest.h>
#include <memory>

#include "app/workbench/feel/feel_controller.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/study/connection/study_connection.h"
#include "core/store/duel_records.h"

#include "tests/gui/patience.h"
#include "tests/gui/sample_models.h"
#include "tests/gui/sample_study.h"
#include "tests/gui/stepped_feel.h"
#include "tests/gui/stylus.h"

namespace tactus::workbench {
namespace {

using experiments::DuelRun;
using experiments::DuelVerdict;
using Phase = DuelController::State;
using tests::comesTrue;

TEST(DuelForecast, ScaledForcesAreScaledEverywhere) {
  const fuzzy::ForceModel model = tests::twoExperts();
  const auto compiled = fuzzy::compile(model);
  const auto scaled = fuzzy::compile(withScaledForce(model, 1.7));
  ASSERT_TRUE(compiled && scaled);
  for (double speed = 0; speed <= 100; speed += 7) {
    for (double depth = 0; depth <= 10; depth += 0.4) {
      const auto before = compiled->evaluate(std::vector{speed, depth});
      const auto after = scaled->evaluate(std::vector{speed, depth});
      EXPECT_EQ(before.fired, after.fired);
      EXPECT_NEAR(after.force_n, 1.7 * before.force_n, 1e-12);
    }
  }
}

/// Plans a duel of the sample model and the same with a larger force, on a study.
class DuelTest : public testing::Test {
 protected:
  void SetUp() override {
    models.open(folder.write(tests::twoExperts()));
    tests::makeStudyFile(path);
    study.open(path);
    ASSERT_TRUE(comesTrue([this] { return study.isOpen(); }));
  }
  void TearDown() override { study.close(); }

  DuelSetup setup(double factor = 2) {
    DuelSetup out;
    out.a = models.current();
    auto ready = editing::ready(withScaledForce(out.a->model, factor));
    EXPECT_TRUE(ready);
    out.b = std::make_shared<const OpenModel>(*std::move(ready));
    out.a_name = {"before", {}, {}};
    out.b_name = {"after", {}, {}};
    out.open_is_b = false;
    out.from_mm = 1;
    out.to_mm = 4;
    out.speed_mm_s = 20;
    return out;
  }
  /// The hand lets go and goes back; then it pushes with `speed_mm_s`.
  void stroke(double speed_mm_s = 20) {
    device.setHeld(false);
    time.advance(device, 50);
    time.moveTo(device, 0, 200);
    ASSERT_EQ(duel.state(), Phase::kPush);
    device.setHeld(true);
    time.advance(device, 50);
    // The hand gives way to the force, so it wishes to go further; it stops where the stroke ends.
    for (double target_mm = 0; duel.state() == Phase::kPush && target_mm < 40; target_mm += speed_mm_s * 0.016) {
      device.setTarget(target_mm);
      time.advance(device, 16);
    }
    device.setHeld(false);
    time.advance(device, 50);
  }
  /// Why the last trial came again.
  std::string lastRepeat() const {
    const auto& answers = duel.run()->answers();
    if (answers.empty()) return "no record";
    return answers.back().repeated + " after " + std::to_string(answers.back().first_mm_s) + " and " +
           std::to_string(answers.back().second_mm_s) + " mm/s";
  }
  /// Both strokes of a trial, and the answer of a person who knows the heavier one.
  void trial() {
    const auto weight = [this] {
      const auto force = duel.run()->felt();
      return force.is_b ? 2 : force.heavier_jnd;
    };
    const double first = weight();
    stroke();
    ASSERT_EQ(duel.run()->stage(), DuelRun::Stage::kSecondStroke) << lastRepeat();
    const double second = weight();
    stroke();
    ASSERT_EQ(duel.state(), Phase::kQuestion) << lastRepeat();
    duel.answer(first > second ? study::DuelChoice::kFirst : study::DuelChoice::kSecond);
  }
  void begin(const DuelSetup& planned) {
    const auto begun = duel.begin(planned, QStringLiteral("virtual"), 5);
    ASSERT_TRUE(begun) << begun.error().message();
    warmUp();
  }
  // The force fades in while the tube is held first; a stroke during that time is made again.
  void warmUp() {
    time.advance(device, 50);
    device.setHeld(true);
    time.advance(device, 1300);
    device.setHeld(false);
    time.advance(device, 50);
  }
  std::vector<store::StoredDuel> stored() {
    EXPECT_TRUE(comesTrue([this] { return !study.isBusy(); }));
    study.close();
    EXPECT_TRUE(comesTrue([this] { return !study.isOpen(); }));
    return *store::duels(tests::lookInto(path));
  }

  tests::ModelFolder folder;
  QString path = folder.path(QStringLiteral("felt.tactus"));
  ModelController models;
  SceneController scene{models};
  tests::SteppedFeel time;
  DeviceSession device{time.settings()};
  FeelController feel{scene, device};
  StudyConnection study;
  FeelStore store{feel, scene, study, [] { return std::optional<study::RecordId>(); }};
  DuelController duel{device, study, store};
};

TEST_F(DuelTest, GoesFromThePlanToTheVerdictAndIsKept) {
  const DuelSetup planned = setup();
  const auto forecast = duelForecast(planned);
  ASSERT_TRUE(forecast && forecast->test);
  EXPECT_GT(forecast->difference.mean_n, 0);
  const std::vector<double> place = scene.values();
  begin(planned);
  while (duel.state() != Phase::kDone) trial();
  // Nothing of it on the bench: its screens show the runs of FeelController alone.
  EXPECT_FALSE(feel.isRunning());
  EXPECT_FALSE(feel.device());
  EXPECT_EQ(scene.values(), place);

  const DuelVerdict verdict = duel.verdict();
  EXPECT_EQ(verdict.outcome, DuelVerdict::Outcome::kDiffer);
  EXPECT_EQ(verdict.right, forecast->test->trials);
  EXPECT_TRUE(duel.isKept());
  EXPECT_FALSE(duel.feltOpenModel()) << "the virtual device is no hand on a device";

  const auto kept = stored();
  ASSERT_EQ(kept.size(), 1U);
  EXPECT_EQ(kept[0].start.seed, 5U);
  EXPECT_EQ(kept[0].start.trials, forecast->test->trials);
  EXPECT_TRUE(kept[0].start.setting.simulated);
  EXPECT_FALSE(kept[0].start.gives_force);
  EXPECT_EQ(kept[0].start.predicted_jnd, forecast->difference.rms_jnd);
  ASSERT_TRUE(kept[0].end);
  EXPECT_EQ(kept[0].end->outcome, "differ");
  const auto again = experiments::verdictOf(kept[0].start, kept[0].answers);
  EXPECT_EQ(again.right, verdict.right);
}

TEST_F(DuelTest, AStrokeThatIsTooFastComesAgain) {
  begin(setup());
  stroke(40);
  EXPECT_EQ(duel.run()->repeat(), experiments::DuelRepeat::kTooFast);
  EXPECT_EQ(duel.run()->done(), 0);
  trial();
  EXPECT_EQ(duel.run()->done(), 1);
  // A hand that lets go on the way.
  device.setHeld(false);
  time.advance(device, 50);
  time.moveTo(device, 0, 200);
  device.setHeld(true);
  time.advance(device, 50);
  time.moveTo(device, 7, 20);
  device.setHeld(false);
  time.advance(device, 50);
  EXPECT_EQ(duel.run()->repeat(), experiments::DuelRepeat::kNotWhole);
  // A long way back to the second stroke.
  stroke();
  time.advance(device, 3000);
  stroke();
  EXPECT_EQ(duel.run()->repeat(), experiments::DuelRepeat::kPause);
}

TEST_F(DuelTest, AStrokeWithoutTheWholeForceIsMadeAgain) {
  const auto begun = duel.begin(setup(), QStringLiteral("virtual"), 5);
  ASSERT_TRUE(begun);
  time.advance(device, 50);
  stroke();
  EXPECT_TRUE(duel.wasHeldBack());
  EXPECT_EQ(duel.run()->stage(), DuelRun::Stage::kFirstStroke);
  EXPECT_TRUE(duel.run()->answers().empty());
  warmUp();
  trial();
  EXPECT_FALSE(duel.wasHeldBack());
  EXPECT_EQ(duel.run()->done(), 1);
}

TEST_F(DuelTest, GoesOnAfterAnInterruption) {
  begin(setup());
  trial();
  trial();
  const auto answers = duel.run()->answers();
  duel.stop();
  EXPECT_EQ(duel.state(), Phase::kIdle);
  EXPECT_FALSE(device.isRunning());
  ASSERT_TRUE(comesTrue([this] { return !study.isBusy(); }));

  std::vector<store::StoredDuel> found;
  study.read(study, [&found](const store::StudyFile& file) -> StudyConnection::Deliver {
    found = *store::duels(file);
    return {};
  });
  ASSERT_TRUE(comesTrue([&found] { return !found.empty(); }));
  EXPECT_FALSE(found[0].end);
  DuelSetup other = setup();
  other.to_mm = 9;  // the stroke is that of the plan
  ASSERT_TRUE(duel.resume(other, found[0], QStringLiteral("virtual")));
  warmUp();
  EXPECT_EQ(duel.run()->done(), 2);
  EXPECT_EQ(duel.run()->start().to_mm, 4);
  while (duel.state() != Phase::kDone) trial();
  const auto kept = stored();
  ASSERT_EQ(kept.size(), 1U) << "one plan";
  EXPECT_TRUE(kept[0].end);
  EXPECT_GT(kept[0].answers.size(), answers.size());
  EXPECT_TRUE(DuelRun::create(kept[0].start, kept[0].answers));
}

TEST_F(DuelTest, RefusesWhatCannotBeFelt) {
  EXPECT_FALSE(duel.begin(setup(1), QStringLiteral("virtual"), 1)) << "no difference";
  EXPECT_FALSE(duel.begin(setup(1.0001), QStringLiteral("virtual"), 1));
  EXPECT_EQ(duel.state(), Phase::kIdle);
  feel.start(QStringLiteral("virtual"));
  EXPECT_FALSE(duel.begin(setup(), QStringLiteral("virtual"), 1)) << "the device is in use";
  feel.stop();
  study.close();
  ASSERT_TRUE(comesTrue([this] { return !study.isOpen(); }));
  begin(setup());
  EXPECT_FALSE(duel.isKept());
  while (duel.state() != Phase::kDone) trial();
  EXPECT_EQ(duel.verdict().outcome, DuelVerdict::Outcome::kDiffer);
}

TEST_F(DuelTest, AnOwnJndGrowsTheForceOfA) {
  DuelSetup planned = setup(1);
  planned.rule = study::DuelRule::kOwnJnd;
  begin(planned);
  for (int i = 0; i < 3; ++i) trial();
  EXPECT_EQ(duel.run()->done(), 3);
  for (const auto& answer : duel.run()->answers()) {
    EXPECT_EQ(answer.kind, study::DuelTrialKind::kOwn);
    EXPECT_GT(answer.difference_jnd, 0);
  }
  EXPECT_LT(duel.verdict().own->factor, 1) << "all were told right";
}

// A stylus that the program takes for a real device.
TEST(DuelOnADevice, CountsAsFelt) {
  tests::ModelFolder folder;
  ModelController models;
  models.open(folder.write(tests::twoExperts()));
  SceneController scene{models};
  VirtualTime time;
  tests::Stylus stylus;
  DeviceSession device{stylus.access(time)};
  FeelController feel{scene, device};
  StudyConnection study;
  FeelStore store{feel, scene, study, [] { return std::optional<study::RecordId>(); }};
  DuelController duel{device, study, store};
  DuelSetup setup;
  setup.a = setup.b = models.current();
  setup.b = std::make_shared<const OpenModel>(*editing::ready(withScaledForce(setup.a->model, 3)));
  setup.a_name.name = "before";
  setup.b_name.name = "after";
  setup.open_is_b = false;
  setup.from_mm = 1;
  setup.to_mm = 4;
  setup.speed_mm_s = 20;
  ASSERT_TRUE(duel.begin(setup, QStringLiteral("stylus"), 5));
  time.advance(device, 50);
  double target_mm = 0;
  const auto move = [&](double to_mm, double speed_mm_s) {
    const double step_mm = (to_mm > target_mm ? 1 : -1) * speed_mm_s * 0.004;
    while (std::abs(to_mm - target_mm) > std::abs(step_mm) && (to_mm == 0 || duel.state() == Phase::kPush)) {
      stylus.moveTo(target_mm += step_mm);
      time.advance(device, 4);
    }
  };
  for (int strokes = 0; strokes < 100 && duel.state() != Phase::kDone; ++strokes) {
    if (duel.state() == Phase::kQuestion) {
      duel.answer(study::DuelChoice::kCantTell);
      continue;
    }
    stylus.press(false);
    time.advance(device, 50);
    move(0, 200);
    stylus.press(true);
    time.advance(device, 50);
    move(30, 20);
    time.advance(device, 100);
  }
  ASSERT_EQ(duel.state(), Phase::kDone);
  EXPECT_EQ(duel.verdict().outcome, DuelVerdict::Outcome::kNotShown);
  EXPECT_TRUE(duel.run()->start().gives_force);
  const auto felt = duel.feltOpenModel();
  ASSERT_TRUE(felt);
  EXPECT_EQ(felt->strokes, static_cast<unsigned>(duel.verdict().trials)) << "one on each model in each trial";
  EXPECT_FALSE(felt->simulated);
  EXPECT_EQ(felt->regions, std::vector<std::string>{"Near"});
  EXPECT_FALSE(duel.isKept());
}

}  // namespace
}  // namespace tactus::workbench
