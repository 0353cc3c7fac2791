// Tens of thousands of random gestures at the controllers of the tuning bench: never an invalid model, never a crash,
// undo always exact. TACTUS_GESTURES=50000 in the environment plays that many.
#include <QCoreApplication>
#include <QElapsedTimer>
#include <algorithm>
#include <cstdlib>
#include <gtest/gtest.h>

#include "tests/gui/bench_gestures.h"
#include "tests/gui/sample_models.h"
#include "tests/support/ngt_model.h"
#include "tests/support/random_model.h"

namespace tactus::workbench {
namespace {

constexpr int kGestures = 2000;   // some seconds
constexpr int kOfOneModel = 250;  // a model that was torn apart for long has little left to edit

int gestures() {
  const char* const wanted = std::getenv("TACTUS_GESTURES");
  return wanted == nullptr ? kGestures : std::atoi(wanted);
}

void playOn(const fuzzy::ForceModel& start, std::uint64_t seed, std::size_t& states, std::size_t& refusals) {
  const tests::ModelFolder folder;
  tests::BenchControllers bench;
  bench.models.open(folder.write(start));
  ASSERT_NE(bench.models.current(), nullptr);
  tests::BenchGestures gestures(seed, tests::BenchReach(bench));
  for (int k = 0; k < kOfOneModel; ++k) {
    const std::string what = gestures.play();
    if (k % 8 == 0) QCoreApplication::processEvents();
    const std::string wrong = gestures.check(k % 5 == 0);
    ASSERT_EQ(wrong, "") << "gesture " << k << ", " << what;
  }
  bench.edits.commit();
  bench.models.save();
  ASSERT_FALSE(bench.models.isModified());
  ASSERT_EQ(gestures.unwind(), "");
  states += gestures.states();
  refusals += gestures.refusals();
}

TEST(BenchFuzz, GesturesLeaveAModelAndAWayBack) {
  const int runs = std::max(1, gestures() / kOfOneModel);
  base::Random random(17);
  std::size_t states = 0;
  std::size_t refusals = 0;
  for (int run = 0; run < runs; ++run) {
    auto model = support::s4AsPrinted();
    if (run % 3 == 1) {
      model.experts.push_back(support::s4Shifted().experts[0]);
      model.experts[1].id = "S5";
      model.experts[1].overrides = {{"depth", model.inputs[2].terms}};
    }
    if (run % 3 == 2) model = support::randomModel(random, {.gaussians = true, .adversarial = run % 2 == 0});
    playOn(model, static_cast<std::uint64_t>(run) + 1, states, refusals);
    if (HasFatalFailure()) FAIL() << "run " << run;
  }
  RecordProperty("gestures", runs * kOfOneModel);
  RecordProperty("states", static_cast<int>(states));
  RecordProperty("refusals", static_cast<int>(refusals));
  // Gestures that change something are many; the others look, travel or are refused, as they should be.
  EXPECT_GT(states, static_cast<std::size_t>(runs) * kOfOneModel / 4);
}

}  // namespace
}  // namespace tactus::workbench
