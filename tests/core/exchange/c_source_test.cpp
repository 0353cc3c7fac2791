// The C source, compiled as C99 with every warning an error, gives the forces of the evaluator.
#include "core/exchange/c_source.h"

#include <cmath>
#include <cstdlib>
#include <dlfcn.h>
#include <fstream>
#include <gtest/gtest.h>
#include <string>

#include "core/base/random.h"
#include "core/fuzzy/compiled_model.h"

#include "tests/support/ngt_model.h"
#include "tests/support/random_model.h"
#include "tests/support/temp_folder.h"

namespace tactus::exchange {
namespace {

/// The source of a model as a loaded library.
class CompiledSource {
 public:
  using Force = double (*)(const double*, int*);
  using ExpertForce = double (*)(std::size_t, const double*, int*);

  CompiledSource(const fuzzy::ForceModel& model, const std::string& options = "-O1") {
    const auto source = cSource(model);
    if (!source) {
      ADD_FAILURE() << source.error().message();
      return;
    }
    std::ofstream(folder_.file("force_model.h")) << source->header;
    std::ofstream(folder_.file("force_model.c")) << source->source;
    const std::string command = TACTUS_CC " -std=c99 -pedantic -Wall -Wextra -Werror " + options + " -shared -fPIC " +
                                folder_.file("force_model.c") + " -o " + folder_.file("force_model.so");
    EXPECT_EQ(std::system(command.c_str()), 0) << source->source;
    library_ = dlopen(folder_.file("force_model.so").c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library_ == nullptr) return;
    force = reinterpret_cast<Force>(dlsym(library_, "force_model"));
    expert_force = reinterpret_cast<ExpertForce>(dlsym(library_, "force_model_expert"));
  }
  ~CompiledSource() {
    if (library_ != nullptr) dlclose(library_);
  }
  CompiledSource(const CompiledSource&) = delete;
  CompiledSource& operator=(const CompiledSource&) = delete;

  Force force = nullptr;
  ExpertForce expert_force = nullptr;

 private:
  support::TempFolder folder_;
  void* library_ = nullptr;
};

/// `points` random points, a third of them on vertices or a few ulps beside one.
void expectSame(const fuzzy::ForceModel& model, base::Random& random, int points) {
  const CompiledSource source(model);
  ASSERT_NE(source.force, nullptr);
  const auto compiled = fuzzy::compile(model);
  ASSERT_TRUE(compiled);
  const double most = 1e-12 * (model.output.max - model.output.min);
  for (int p = 0; p < points; ++p) {
    const auto point = support::randomPoint(random, model);
    int fired = 7;
    const auto wanted = compiled->evaluate(point);
    const double found = source.force(point.data(), &fired);
    ASSERT_EQ(fired != 0, wanted.fired) << p;
    ASSERT_NEAR(found, wanted.force_n, most) << p;
    for (std::size_t e = 0; e < model.experts.size(); ++e) {
      const auto alone = compiled->evaluateExpert(e, point);
      ASSERT_NEAR(source.expert_force(e, point.data(), &fired), alone.force_n, most) << p << ", expert " << e;
      ASSERT_EQ(fired != 0, alone.fired) << p << ", expert " << e;
    }
  }
}

TEST(CSource, HasTheForcesOfTheNgtModels) {
  base::Random random(11);
  for (const auto& model : {support::s4AsPrinted(), support::s4Shifted(), support::s4FiveRegions()}) {
    expectSame(model, random, 20'000);
  }
}

TEST(CSource, HasTheForcesOfRandomModels) {
  base::Random random(12);
  for (int m = 0; m < 40; ++m) {
    SCOPED_TRACE("model " + std::to_string(m));
    expectSame(support::randomModel(random, {.adversarial = false}), random, 500);
    if (HasFatalFailure()) return;
  }
}

TEST(CSource, FiresAsTheEvaluatorWhereMembershipsAreTiny) {
  base::Random random(13);
  for (int m = 0; m < 20; ++m) {
    const auto model = support::randomModel(random);
    const CompiledSource source(model);
    ASSERT_NE(source.force, nullptr);
    const auto compiled = fuzzy::compile(model);
    for (int p = 0; p < 500; ++p) {
      const auto point = support::randomPoint(random, model);
      int fired = 7;
      const double found = source.force(point.data(), &fired);
      const auto wanted = compiled->evaluate(point);
      ASSERT_EQ(fired != 0, wanted.fired) << "model " << m << ", point " << p;
      ASSERT_TRUE(std::isfinite(found));
      ASSERT_GE(found, std::min(model.output.min, model.default_force_n));
      ASSERT_LE(found, std::max(model.output.max, model.default_force_n));
    }
  }
}

TEST(CSource, TakesWhateverTheCallerPasses) {
  const CompiledSource source(support::s4Shifted());
  ASSERT_NE(source.force, nullptr);
  const double nan = std::nan("");
  const double point[] = {1, 45, 30, 30};
  const double odd[] = {1, nan, 30, 30};
  const double far[] = {1, 45, 30, INFINITY};
  int fired = 7;
  EXPECT_NEAR(source.force(point, nullptr), 0.12666666666666668, 1e-15);  // facts of the NGT model
  EXPECT_TRUE(std::isnan(source.force(odd, &fired)));
  EXPECT_EQ(fired, 0);
  EXPECT_TRUE(std::isnan(source.force(far, &fired)));
  EXPECT_EQ(source.expert_force(1, point, &(fired = 7)), 0);
  EXPECT_EQ(fired, 0);
}

TEST(CSource, AGaussianOutputIsRefused) {
  auto model = support::s4Shifted();
  model.output.terms[1] = {"small", "small", fuzzy::Shape::kGaussian, {0.35, 0.1}};
  const auto source = cSource(model);
  ASSERT_FALSE(source);
  EXPECT_EQ(
      source.error().message(),
      "output term 'small': found a Gaussian, wanted trapezoids and triangles, whose centroid has a closed form in C");
}

TEST(CSource, TextOfPeopleCannotLeaveAComment) {
  auto model = support::s4Shifted();
  model.name = "*/ int evil = 1; /* \n #error";
  model.inputs[0].unit = "*/";
  base::Random random(14);
  expectSame(model, random, 10);
}

}  // namespace
}  // namespace tactus::exchange
