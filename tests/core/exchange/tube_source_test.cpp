// The tube in C: in each scripted insertion, every force, depth, phase and stroke is that of the renderer.
#include "core/exchange/tube_source.h"

#include <bit>
#include <cstdint>
#include <cstdlib>
#include <dlfcn.h>
#include <fstream>
#include <gtest/gtest.h>
#include <iostream>
#include <string>
#include <vector>

#include "core/exchange/c_source.h"
#include "core/fuzzy/compiled_model.h"
#include "core/render/tube_checks.h"

#include "tests/support/ngt_model.h"
#include "tests/support/random_model.h"
#include "tests/support/temp_folder.h"

namespace tactus::exchange {
namespace {

/// What a state says, for a test that does not know its size.
constexpr const char* kProbe = R"(#include "tube.h"
#include <stddef.h>
size_t tube_size(void) { return sizeof(tube_state); }
void tube_look(const tube_state *tube, double *felt) {
  felt[0] = tube->force_n;
  felt[1] = tube->depth_mm;
  felt[2] = tube->phase;
  felt[3] = tube->stroke;
}
)";

class CompiledTube {
 public:
  CompiledTube(const fuzzy::ForceModel& model, const std::string& options, const std::string& compiler) {
    const auto force = cSource(model);
    const auto tube = cTube(model);
    if (!force || !tube) {
      ADD_FAILURE() << (tube ? force.error() : tube.error()).message();
      return;
    }
    std::ofstream(folder_.file("force_model.h")) << force->header;
    std::ofstream(folder_.file("force_model.c")) << force->source;
    std::ofstream(folder_.file("tube.h")) << tube->header;
    std::ofstream(folder_.file("tube.c")) << tube->source;
    std::ofstream(folder_.file("probe.c")) << kProbe;
    const std::string command =
        compiler + " -std=c99 -pedantic -Wall -Wextra -Wconversion -Wno-sign-conversion -Werror " + options +
        " -shared -fPIC -I" + folder_.file("") + " " + folder_.file("tube.c") + " " + folder_.file("probe.c") +
        " -x c " + folder_.file("force_model.c") + " -Wno-conversion -o " + folder_.file("tube.so") + " -lm";
    EXPECT_EQ(std::system(command.c_str()), 0) << tube->source;
    library_ = dlopen(folder_.file("tube.so").c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library_ == nullptr) return;
    start_ = reinterpret_cast<Start>(dlsym(library_, "tube_start"));
    change_ = reinterpret_cast<Change>(dlsym(library_, "tube_change"));
    place_ = reinterpret_cast<Place>(dlsym(library_, "tube_place"));
    step_ = reinterpret_cast<Step>(dlsym(library_, "tube_step"));
    look_ = reinterpret_cast<Look>(dlsym(library_, "tube_look"));
    state_.resize(reinterpret_cast<std::size_t (*)()>(dlsym(library_, "tube_size"))(), '\x7f');
  }
  ~CompiledTube() {
    if (library_ != nullptr) dlclose(library_);
  }
  CompiledTube(const CompiledTube&) = delete;
  CompiledTube& operator=(const CompiledTube&) = delete;

  bool loaded() const { return library_ != nullptr; }
  void start(const std::vector<double>& conditions) {
    start_(state_.data(), conditions.data());
    conditions_ = conditions;
  }
  void place(double depth_mm) { place_(state_.data(), depth_mm); }
  render::TubeFeel step(const render::TubeStep& step) {
    if (step.conditions != conditions_) change_(state_.data(), step.conditions.data(), render::kTraceFadeS);
    conditions_ = step.conditions;
    const double force_n = step_(state_.data(), step.position_mm, step.held ? 1 : 0, step.dt_s);
    double felt[4];
    look_(state_.data(), felt);
    EXPECT_EQ(felt[0], force_n);
    return {felt[0], felt[1], static_cast<int>(felt[2]), static_cast<unsigned>(felt[3])};
  }

 private:
  using Start = void (*)(void*, const double*);
  using Change = void (*)(void*, const double*, double);
  using Place = void (*)(void*, double);
  using Step = double (*)(void*, double, int, double);
  using Look = void (*)(const void*, double*);

  support::TempFolder folder_;
  void* library_ = nullptr;
  Start start_ = nullptr;
  Change change_ = nullptr;
  Place place_ = nullptr;
  Step step_ = nullptr;
  Look look_ = nullptr;
  std::vector<char> state_;
  std::vector<double> conditions_;
};

std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x); }

/// `within_n` 0: bit for bit.
void expectSameTube(const fuzzy::ForceModel& model, const std::string& options, const std::string& compiler,
                    double within_n = 0) {
  SCOPED_TRACE(compiler + " " + options);
  CompiledTube tube(model, options, compiler);
  ASSERT_TRUE(tube.loaded());
  const auto inputs = render::tubeInputs(model);
  const auto compiled = fuzzy::compile(model);
  ASSERT_TRUE(inputs && compiled);
  for (const render::TubeTrace& trace : render::tubeTraces(model, *inputs)) {
    SCOPED_TRACE(trace.name);
    render::TubeRun run(model, *inputs, *compiled);
    tube.start(trace.steps.front().conditions);
    for (std::size_t i = 0; i < trace.steps.size(); ++i) {
      const auto wanted = run.step(trace.steps[i]);
      ASSERT_TRUE(wanted);
      const render::TubeFeel found = tube.step(trace.steps[i]);
      if (within_n > 0) {
        ASSERT_NEAR(found.force_n, wanted->force_n, within_n) << i;
        ASSERT_NEAR(found.depth_mm, wanted->depth_mm, within_n) << i;
      } else {
        ASSERT_EQ(bits(found.force_n), bits(wanted->force_n)) << i;
        ASSERT_EQ(bits(found.depth_mm), bits(wanted->depth_mm)) << i;
      }
      ASSERT_EQ(found.phase, wanted->phase) << i;
      ASSERT_EQ(found.stroke, wanted->stroke) << i;
    }
  }
}

/// Four experts, two of whom do not know every place, on a scale that is not that of the renderer.
fuzzy::ForceModel fourExperts() {
  auto model = support::s4AsPrinted();
  for (int e = 1; e < 4; ++e) {
    auto expert = model.experts.front();
    expert.id = "E" + std::to_string(e);
    expert.weight = 0.3 * e;
    for (std::size_t r = 0; r < expert.rules.size(); ++r)
      expert.rules[r].enabled = r % static_cast<std::size_t>(e + 4) != 0;
    model.experts.push_back(std::move(expert));
  }
  model.renderer.emplace();
  model.renderer->stiffness_n_mm = 0.4;
  model.renderer->depth_offset_mm = 20;
  model.renderer->withdrawal_ratio = 0.5;
  return model;
}

TEST(TubeSource, IsTheRendererBitForBitUnderEachOption) {
  for (const char* const options : {"-O0", "-O2", "-O3"}) {
    expectSameTube(support::s4FiveRegions(), options, TACTUS_CC);
    expectSameTube(fourExperts(), options, TACTUS_CC);
    if (HasFatalFailure()) return;
  }
}

TEST(TubeSource, IsTheRendererUnderClangToo) {
  if (std::system("clang --version >/dev/null 2>&1") != 0) {
    std::cout << "SKIPPED: clang is not installed, so only gcc compiled the tube\n";
    return;
  }
  for (const char* const options : {"-O0", "-O3 -march=native"}) expectSameTube(fourExperts(), options, "clang");
}

/// Punctures at terms of each shape, one of them where the passage ends.
fuzzy::ForceModel withPunctures() {
  auto model = fourExperts();
  fuzzy::Variable& depth = model.inputs[2];
  depth.terms.push_back({"bell", "Bell", fuzzy::Shape::kGaussian, {140, 9.5}});
  depth.terms.push_back({"peak", "Peak", fuzzy::Shape::kTriangle, {90, 101.25, 130}});
  model.events = {{"peak", 0.3}, {depth.terms[1].id, 0.6}, {depth.terms[4].id, 0.5}, {"bell", 0.9}};
  return model;
}

TEST(TubeSource, HasThePuncturesBitForBit) {
  for (const char* const options : {"-O0", "-O3"}) {
    expectSameTube(withPunctures(), options, TACTUS_CC);
    if (HasFatalFailure()) return;
  }
  auto only_bell = fourExperts();
  only_bell.inputs[2].terms[1] = {only_bell.inputs[2].terms[1].id, "", fuzzy::Shape::kGaussian, {100, 20}};
  only_bell.events = {{only_bell.inputs[2].terms[1].id, 0.5}};
  // The force of a model with a Gaussian is the same within 1e-12 N alone.
  expectSameTube(only_bell, "-O2", TACTUS_CC, 1e-12);
}

TEST(TubeSource, AModelWithoutPuncturesHasNoTextOfThem) {
  const auto tube = cTube(fourExperts());
  ASSERT_TRUE(tube);
  for (const char* const word : {"EVENT", "deepest_mm", "trapezoid", "math.h", "@"}) {
    EXPECT_EQ((tube->header + tube->source).find(word), std::string::npos) << word;
  }
}

/// The traces show what they are for.
TEST(TubeSource, TheTracesReachEveryPhaseAndEveryEnd) {
  const auto model = support::s4FiveRegions();
  const auto inputs = render::tubeInputs(model);
  const auto compiled = fuzzy::compile(model);
  ASSERT_TRUE(inputs && compiled);
  bool seen[3] = {};
  double deepest_mm = 0;
  double least_n = 0;
  unsigned strokes = 0;
  bool let_go_in_hand = false;
  std::size_t changes = 0;
  for (const auto& trace : render::tubeTraces(model, *inputs)) {
    render::TubeRun run(model, *inputs, *compiled);
    const std::vector<double>* before = nullptr;
    for (const auto& step : trace.steps) {
      const auto felt = run.step(step);
      ASSERT_TRUE(felt);
      seen[felt->phase] = true;
      deepest_mm = std::max(deepest_mm, felt->depth_mm);
      least_n = std::min(least_n, felt->force_n);
      strokes = std::max(strokes, felt->stroke);
      let_go_in_hand = let_go_in_hand || (step.held && felt->phase == 0);
      changes += before != nullptr && *before != step.conditions ? 1 : 0;
      before = &step.conditions;
    }
  }
  EXPECT_TRUE(seen[0] && seen[1] && seen[2] && let_go_in_hand);
  EXPECT_EQ(deepest_mm, model.inputs[inputs->depth].max);
  EXPECT_LT(least_n, -0.05);  // withdrawal
  EXPECT_GE(strokes, 3U);
  EXPECT_GE(changes, 5U);
}

TEST(TubeSource, IsPlacedAnewAsTheRendererIs) {
  const auto model = support::s4FiveRegions();
  CompiledTube tube(model, "-O2", TACTUS_CC);
  ASSERT_TRUE(tube.loaded());
  const std::vector<double> conditions = {0.5, 45};
  tube.start(conditions);
  double force_n = 0;
  for (int i = 0; i < 300; ++i) force_n = tube.step({i * 0.1, true, 0.001, conditions}).force_n;
  EXPECT_GT(force_n, 0.1);
  tube.place(120);
  const auto after = tube.step({30, false, 0.001, conditions});
  EXPECT_EQ(after.depth_mm, 120);
  EXPECT_EQ(after.stroke, 0U);
  // Within 30 ms it is gone, evenly.
  EXPECT_NEAR(after.force_n, force_n * 29 / 30, 1e-12);
  render::TubeFeel last;
  for (int i = 0; i < 30; ++i) last = tube.step({30, false, 0.001, conditions});
  EXPECT_EQ(last.force_n, 0);
  tube.place(std::nan(""));
  EXPECT_EQ(tube.step({30, false, 0.001, conditions}).depth_mm, 120);
}

TEST(TubeSource, IsRefusedWhereAModelHasNoTube) {
  auto model = support::s4FiveRegions();
  model.inputs[2].role = fuzzy::Role::kCondition;
  EXPECT_EQ(cTube(model).error().message(),
            "inputs: found none that is the way of the tip, wanted an input of the role 'way', or called 'depth'");
}

}  // namespace
}  // namespace tactus::exchange
