// The C source, compiled as C99 with every warning an error, gives the forces of the evaluator.
#include "core/exchange/c_source.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <dlfcn.h>
#include <fstream>
#include <gtest/gtest.h>
#include <iostream>
#include <span>
#include <string>
#include <vector>

#include "core/base/random.h"
#include "core/fuzzy/compiled_model.h"

#include "tests/support/ngt_model.h"
#include "tests/support/random_model.h"
#include "tests/support/temp_folder.h"

namespace tactus::exchange {
namespace {

int wantedCount(const char* variable, int usual) {
  const char* const set = std::getenv(variable);
  return set != nullptr ? std::atoi(set) : usual;
}

/// The source of a model as a loaded library.
class CompiledSource {
 public:
  using Batch = void (*)(const double*, std::size_t, double*, unsigned char*);
  using Force = double (*)(const double*, int*);
  using ExpertForce = double (*)(std::size_t, const double*, int*);

  /// `unknown`: parts of the processor that the source is told are missing.
  CompiledSource(const fuzzy::ForceModel& model, const std::string& options = "-O1",
                 std::span<const FixedInput> fixed = {}, const std::string& compiler = TACTUS_CC,
                 std::span<const std::string> unknown = {}) {
    auto source = cSource(model, fixed, {std::string(64, 'a'), "2026 */ x", "tactus 1.2"});
    if (!source) {
      ADD_FAILURE() << source.error().message();
      return;
    }
    for (const std::string& part : unknown) {
      const std::string question = "__builtin_cpu_supports(\"" + part + "\")";
      const std::size_t at = source->source.find(question);
      if (at == std::string::npos) {
        ADD_FAILURE() << "the source does not ask " << question;
        return;
      }
      source->source.replace(at, question.size(), "0");
    }
    std::ofstream(folder_.file("force_model.h")) << source->header;
    std::ofstream(folder_.file("force_model.c")) << source->source;
    const std::string command = compiler + " -std=c99 -pedantic -Wall -Wextra -Werror " + options + " -shared -fPIC " +
                                folder_.file("force_model.c") + " -o " + folder_.file("force_model.so") + " -lm";
    EXPECT_EQ(std::system(command.c_str()), 0) << source->source;
    library_ = dlopen(folder_.file("force_model.so").c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library_ == nullptr) return;
    force = reinterpret_cast<Force>(dlsym(library_, "force_model"));
    batch = reinterpret_cast<Batch>(dlsym(library_, "force_model_batch"));
    expert_force = reinterpret_cast<ExpertForce>(dlsym(library_, "force_model_expert"));
  }
  ~CompiledSource() {
    if (library_ != nullptr) dlclose(library_);
  }
  CompiledSource(const CompiledSource&) = delete;
  CompiledSource& operator=(const CompiledSource&) = delete;

  Force force = nullptr;
  ExpertForce expert_force = nullptr;
  Batch batch = nullptr;

 private:
  support::TempFolder folder_;
  void* library_ = nullptr;
};

/// `points` random points, a third of them on vertices or a few ulps beside one, one by one and as a batch.
void expectSame(const fuzzy::ForceModel& model, base::Random& random, int points, const std::string& options = "-O1",
                const std::string& compiler = TACTUS_CC, std::span<const std::string> unknown = {}) {
  const CompiledSource source(model, options, {}, compiler, unknown);
  ASSERT_NE(source.force, nullptr);
  ASSERT_NE(source.batch, nullptr);
  const auto compiled = fuzzy::compile(model);
  ASSERT_TRUE(compiled);
  const double most = 1e-12 * (model.output.max - model.output.min);
  std::vector<double> inputs;
  std::vector<fuzzy::Evaluation> wanted;
  for (int p = 0; p < points; ++p) {
    const auto point = support::randomPoint(random, model);
    inputs.insert(inputs.end(), point.begin(), point.end());
    int fired = 7;
    wanted.push_back(compiled->evaluate(point));
    const double found = source.force(point.data(), &fired);
    ASSERT_EQ(fired != 0, wanted.back().fired) << p;
    ASSERT_NEAR(found, wanted.back().force_n, most) << p;
    for (std::size_t e = 0; e < model.experts.size(); ++e) {
      const auto alone = compiled->evaluateExpert(e, point);
      ASSERT_NEAR(source.expert_force(e, point.data(), &fired), alone.force_n, most) << p << ", expert " << e;
      ASSERT_EQ(fired != 0, alone.fired) << p << ", expert " << e;
    }
  }
  std::vector<double> forces(wanted.size(), -7);
  std::vector<unsigned char> fired(wanted.size(), 7);
  source.batch(inputs.data(), wanted.size(), forces.data(), fired.data());
  for (std::size_t p = 0; p < wanted.size(); ++p) {
    ASSERT_EQ(fired[p], wanted[p].fired ? 1 : 0) << p;
    ASSERT_NEAR(forces[p], wanted[p].force_n, most) << p;
  }
  source.batch(inputs.data(), wanted.size(), forces.data(), nullptr);
}

TEST(CSource, HasTheForcesOfTheNgtModels) {
  base::Random random(11);
  for (const auto& model : {support::s4AsPrinted(), support::s4Shifted(), support::s4FiveRegions()}) {
    expectSame(model, random, 20'000);
  }
}

/// One by one: the same bits as the evaluator's, whatever the compiler and its options.
void expectSameBits(const fuzzy::ForceModel& model, base::Random& random, int points, const std::string& options,
                    const std::string& compiler = TACTUS_CC) {
  const CompiledSource source(model, options, {}, compiler);
  ASSERT_NE(source.force, nullptr);
  const auto compiled = fuzzy::compile(model);
  ASSERT_TRUE(compiled);
  for (int p = 0; p < points; ++p) {
    const auto point = support::randomPoint(random, model);
    ASSERT_EQ(std::bit_cast<std::uint64_t>(source.force(point.data(), nullptr)),
              std::bit_cast<std::uint64_t>(compiled->evaluate(point).force_n))
        << p << ", " << options;
    for (std::size_t e = 0; e < model.experts.size(); ++e) {
      ASSERT_EQ(std::bit_cast<std::uint64_t>(source.expert_force(e, point.data(), nullptr)),
                std::bit_cast<std::uint64_t>(compiled->evaluateExpert(e, point).force_n))
          << p << ", expert " << e;
    }
  }
}

/// Four experts and one more of the same terms: a team and one alone.
fuzzy::ForceModel severalExperts(std::size_t count, base::Random& random) {
  auto model = support::s4FiveRegions();
  while (model.experts.size() < count) {
    auto expert = model.experts.front();
    expert.id = "E" + std::to_string(model.experts.size());
    expert.weight = random.uniform(0.1, 2);
    for (fuzzy::Rule& rule : expert.rules) {
      rule.weight = random.uniform(0.2, 1);
      rule.enabled = random.uniform(0, 1) < 0.8;
    }
    model.experts.push_back(std::move(expert));
  }
  return model;
}

TEST(CSource, HasTheBitsOfTheEvaluatorWhateverTheCompiler) {
  base::Random random(23);
  constexpr const char* kOptions[] = {"-O0", "-O2", "-O3", "-O1 -march=native"};
  int next = 0;
  for (const std::size_t experts : {1, 2, 3, 4, 5, 9}) {
    SCOPED_TRACE(experts);
    auto model = severalExperts(experts, random);
    model.implication = next % 2 == 0 ? fuzzy::Implication::kClip : fuzzy::Implication::kScale;
    for (int k = 0; k < (experts == 4 ? 4 : 1); ++k) expectSameBits(model, random, 2000, kOptions[next++ % 4]);
    if (HasFatalFailure()) return;
  }
}

TEST(CSource, HasTheForcesOfRandomModels) {
  base::Random random(12);
  const int models = wantedCount("TACTUS_C_MODELS", 24);
  const int points = wantedCount("TACTUS_C_POINTS", 2000);
  for (int m = 0; m < models; ++m) {
    SCOPED_TRACE("model " + std::to_string(m));
    expectSame(support::randomModel(random, {.gaussians = m % 4 == 3, .adversarial = false}), random,
               m % 4 == 3 ? points / 10 : points, m % 2 == 0 ? "-O1" : "-O2");
    if (HasFatalFailure()) return;
  }
}

TEST(CSource, HasTheForcesOfWeightsHoweverFarApartTheyAre) {
  base::Random random(17);
  for (int m = 0; m < 12; ++m) {
    SCOPED_TRACE("model " + std::to_string(m));
    auto model = support::randomModel(random, {.gaussians = false, .adversarial = false});
    support::takeExtremeWeights(random, model);
    expectSame(model, random, 300);
    if (HasFatalFailure()) return;
  }
}

/// An average of two experts, one of whom leaves out rules.
fuzzy::ForceModel twoExperts() {
  auto model = support::s4Shifted();
  fuzzy::Expert second = model.experts.front();
  second.id = "S2";
  second.weight = 3;
  second.rules.front().weight = 0.25;
  second.rules.erase(second.rules.begin() + 3, second.rules.begin() + 20);
  model.experts.push_back(second);
  return model;
}

TEST(CSource, IsTheSameForOtherCompilersAndOptions) {
  base::Random random(15);
  for (const auto* const options : {"-O0", "-O2", "-O3 -march=native"}) {
    SCOPED_TRACE(options);
    expectSame(support::s4Shifted(), random, 2000, options);
  }
  if (std::system("clang --version >/dev/null 2>&1") != 0) {
    std::cout << "SKIPPED: clang is not installed, so only gcc compiled the C source\n";
    return;
  }
  expectSame(support::s4Shifted(), random, 2000, "-O2", "clang");
  expectSame(twoExperts(), random, 2000, "-O2", "clang");
  expectSameBits(severalExperts(5, random), random, 2000, "-O2 -march=native", "clang");
}

/// The source has code of its own for each stretch of depth between the ends of the terms of all experts.
TEST(CSource, HasTheForcesAtBothSidesOfEachEnd) {
  auto model = support::s4FiveRegions();
  auto& regions = model.inputs[2].terms;
  regions[1].points[0] = regions[1].points[1];  // a vertical edge, which belongs to the term
  fuzzy::Expert second = model.experts.front();
  second.id = "S2";
  second.rules.front().weight = 0.25;
  second.rules.erase(second.rules.begin() + 3);
  model.experts.push_back(second);
  base::Random random(19);
  for (const std::size_t experts : {2U, 1U}) {
    model.experts.resize(experts);
    const CompiledSource source(model, "-O2");
    ASSERT_NE(source.force, nullptr);
    const auto compiled = fuzzy::compile(model);
    ASSERT_TRUE(compiled);
    for (const fuzzy::Term& region : regions) {
      for (const double end : region.points) {
        for (const double depth_mm : {std::nextafter(end, -1e9), end, std::nextafter(end, 1e9)}) {
          auto point = support::randomPoint(random, model);
          point[2] = depth_mm;
          int fired = 7;
          const auto wanted = compiled->evaluate(point);
          ASSERT_NEAR(source.force(point.data(), &fired), wanted.force_n, 1e-12) << depth_mm;
          ASSERT_EQ(fired != 0, wanted.fired) << depth_mm;
        }
      }
    }
  }
}

TEST(CSource, ABatchTakesWhateverTheCallerPasses) {
  const CompiledSource source(support::s4Shifted(), "-O3");
  ASSERT_NE(source.batch, nullptr);
  // More than a block, with one odd point in it.
  std::vector<double> inputs;
  for (int p = 0; p < 70; ++p) inputs.insert(inputs.end(), {1, 45, 30, 30});
  inputs[4 * 20 + 1] = std::nan("");
  inputs[4 * 69] = -INFINITY;
  std::vector<double> forces(70);
  std::vector<unsigned char> fired(70, 7);
  source.batch(inputs.data(), 70, forces.data(), fired.data());
  for (std::size_t p = 0; p < 70; ++p) {
    const bool odd = p == 20 || p == 69;
    EXPECT_EQ(std::isnan(forces[p]), odd) << p;
    EXPECT_EQ(fired[p], odd ? 0 : 1) << p;
    if (!odd) {
      EXPECT_NEAR(forces[p], 0.12666666666666668, 1e-15) << p;
    }
  }
}

TEST(CSource, ABatchHasTheForcesOnEveryProcessor) {
  base::Random random(20);
  const std::vector<std::string> older[] = {{}, {"avx512f"}, {"avx512f", "avx2"}};
  for (const auto& unknown : older) {
    SCOPED_TRACE(unknown.size());
    expectSame(twoExperts(), random, 3000, "-O2", TACTUS_CC, unknown);
  }
}

TEST(CSource, ABatchOfMembershipsThatVanishIsComputedPointByPoint) {
  auto model = support::s4Shifted();
  model.inputs[0].min = -1;
  model.inputs[0].terms[0].points = {-1, -1, -0.4, -0.2};  // poor
  model.inputs[0].terms[1].points = {0, 1e5, 2e5, 3e5};    // medium: rises slowly from 0
  model.inputs[0].max = 1e6;
  std::erase_if(model.experts[0].rules, [](const fuzzy::Rule& rule) {
    return std::none_of(rule.conditions.begin(), rule.conditions.end(),
                        [](const auto& condition) { return condition.input == "lubrication"; });
  });
  for (fuzzy::Rule& rule : model.experts[0].rules) rule.weight = 1e-9;
  const CompiledSource source(model, "-O2");
  ASSERT_NE(source.batch, nullptr);
  const auto compiled = fuzzy::compile(model);
  ASSERT_TRUE(compiled);
  std::vector<double> inputs;
  std::vector<fuzzy::Evaluation> wanted;
  for (int p = 0; p < 64; ++p) {
    // The last block is calm.
    const double point[] = {p < 32 ? std::ldexp(1.0, -35 * p) : 5e4, 45, 150, 60};
    inputs.insert(inputs.end(), std::begin(point), std::end(point));
    wanted.push_back(compiled->evaluate(point));
  }
  std::vector<double> forces(64);
  std::vector<unsigned char> fired(64, 7);
  source.batch(inputs.data(), 64, forces.data(), fired.data());
  for (std::size_t p = 0; p < 64; ++p) {
    EXPECT_EQ(fired[p] != 0, wanted[p].fired) << p;
    EXPECT_NEAR(forces[p], wanted[p].force_n, 1e-12) << p;
  }
}

TEST(CSource, FoldsFixedInputsIn) {
  base::Random random(16);
  for (int m = 0; m < 12; ++m) {
    SCOPED_TRACE("model " + std::to_string(m));
    const auto model = support::randomModel(random, {.adversarial = false});
    if (model.inputs.size() < 2) continue;
    const auto compiled = fuzzy::compile(model);
    const auto at = support::randomPoint(random, model);
    const FixedInput fixed[] = {{static_cast<std::size_t>(m) % model.inputs.size(), 0}};
    std::vector<FixedInput> chosen(std::begin(fixed), std::end(fixed));
    chosen[0].value = at[chosen[0].input];
    const CompiledSource source(model, "-O1", chosen);
    ASSERT_NE(source.force, nullptr);
    const double most = 1e-12 * (model.output.max - model.output.min);
    std::vector<double> all_free;
    std::vector<fuzzy::Evaluation> all_wanted;
    for (int p = 0; p < 500; ++p) {
      auto point = support::randomPoint(random, model);
      point[chosen[0].input] = chosen[0].value;
      auto free = point;
      free.erase(free.begin() + static_cast<std::ptrdiff_t>(chosen[0].input));
      int fired = 7;
      const auto wanted = compiled->evaluate(point);
      ASSERT_NEAR(source.force(free.data(), &fired), wanted.force_n, most) << p;
      ASSERT_EQ(fired != 0, wanted.fired) << p;
      all_free.insert(all_free.end(), free.begin(), free.end());
      all_wanted.push_back(wanted);
    }
    std::vector<double> forces(all_wanted.size());
    std::vector<unsigned char> fired(all_wanted.size(), 7);
    source.batch(all_free.data(), forces.size(), forces.data(), fired.data());
    for (std::size_t p = 0; p < forces.size(); ++p) {
      ASSERT_EQ(fired[p] != 0, all_wanted[p].fired) << p;
      ASSERT_NEAR(forces[p], all_wanted[p].force_n, most) << p;
    }
  }
}

TEST(CSource, NamesTheModelThatItIsOf) {
  const std::string sha256(64, 'a');
  const auto source = cSource(support::s4Shifted(), {}, {sha256, "2026-11-21T08:00:00Z", "tactus 1.2"});
  ASSERT_TRUE(source);
  EXPECT_NE(source->header.find("#define FORCE_MODEL_SHA256 \"" + sha256 + "\"\n"), std::string::npos);
  for (const std::string& text : {source->header, source->source}) {
    EXPECT_NE(text.substr(0, 400).find("Model SHA-256 " + sha256 + ", of 2026-11-21T08:00:00Z; exported by tactus 1.2"),
              std::string::npos)
        << text.substr(0, 400);
  }
  EXPECT_EQ(cSource(support::s4Shifted())->header.find("SHA256"), std::string::npos);
}

TEST(CSource, RefusesToFixWhatCannotBeFixed) {
  const auto model = support::s4Shifted();
  const auto message = [&](std::vector<FixedInput> fixed) {
    const auto source = cSource(model, fixed);
    return source ? std::string() : source.error().message();
  };
  EXPECT_EQ(message({{0, std::nan("")}}), "input 'lubrication': found nan, wanted a finite number to fix it at");
  EXPECT_EQ(message({{0, 1}, {0, 0.5}}), "input 'lubrication': found two values to fix it at, wanted one");
  EXPECT_EQ(message({{0, 1}, {1, 45}, {2, 30}, {3, 30}}),
            "inputs: found all of them fixed, wanted one at least that varies");
  EXPECT_EQ(message({{0, 1}, {1, 45}}), "");
}

TEST(CSource, FiresAsTheEvaluatorWhereMembershipsAreTiny) {
  base::Random random(13);
  for (int m = 0; m < 20; ++m) {
    const auto model = support::randomModel(random);
    const CompiledSource source(model);
    ASSERT_NE(source.force, nullptr);
    const auto compiled = fuzzy::compile(model);
    std::vector<double> inputs;
    std::vector<bool> all_fired;
    for (int p = 0; p < 500; ++p) {
      const auto point = support::randomPoint(random, model);
      int fired = 7;
      const double found = source.force(point.data(), &fired);
      const auto wanted = compiled->evaluate(point);
      inputs.insert(inputs.end(), point.begin(), point.end());
      all_fired.push_back(wanted.fired);
      ASSERT_EQ(fired != 0, wanted.fired) << "model " << m << ", point " << p;
      ASSERT_TRUE(std::isfinite(found));
      ASSERT_GE(found, std::min(model.output.min, model.default_force_n));
      ASSERT_LE(found, std::max(model.output.max, model.default_force_n));
    }
    std::vector<double> forces(all_fired.size());
    std::vector<unsigned char> told(all_fired.size(), 7);
    source.batch(inputs.data(), told.size(), forces.data(), told.data());
    for (std::size_t p = 0; p < told.size(); ++p) ASSERT_EQ(told[p] != 0, all_fired[p]) << "model " << m << ", " << p;
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

/// By the bits, whatever this program is compiled with.
bool isNan(double value) { return (std::bit_cast<std::uint64_t>(value) << 1U) > 0xFFE0000000000000ULL; }

// Compilers that may take every number for a finite one leave out what compares with NaN.
TEST(CSource, WhatIsNotFiniteGivesNanUnderFastMathToo) {
  for (const char* options : {"-O2 -ffast-math", "-O3 -ffast-math -march=native", "-O1 -ffinite-math-only", "-O0"}) {
    const CompiledSource source(support::s4Shifted(), options);
    ASSERT_NE(source.force, nullptr);
    for (std::size_t input = 0; input < 4; ++input) {
      for (const double odd : {std::nan(""), -std::nan(""), double{INFINITY}, -double{INFINITY}}) {
        double point[] = {1, 45, 30, 30};
        point[input] = odd;
        int fired = 7;
        EXPECT_TRUE(isNan(source.force(point, &fired))) << options << ": input " << input << " = " << odd;
        EXPECT_EQ(fired, 0) << options;
        EXPECT_TRUE(isNan(source.expert_force(0, point, &(fired = 7)))) << options;
        EXPECT_EQ(fired, 0) << options;
        std::vector<double> points;
        for (int p = 0; p < 40; ++p) points.insert(points.end(), {1, 45, 30, 30});
        points[4 * 17 + input] = odd;
        std::vector<double> forces(40);
        std::vector<unsigned char> all_fired(40, 7);
        source.batch(points.data(), 40, forces.data(), all_fired.data());
        for (std::size_t p = 0; p < 40; ++p) {
          EXPECT_EQ(isNan(forces[p]), p == 17) << options << ": " << p;
          EXPECT_EQ(all_fired[p], p == 17 ? 0 : 1) << options << ": " << p;
        }
      }
    }
    const double usual[] = {1, 45, 30, 30};
    EXPECT_NEAR(source.force(usual, nullptr), 0.12666666666666668, 1e-12) << options;
  }
}

TEST(CSource, HasTheForcesOfGaussianOutputs) {
  auto model = support::s4Shifted();
  model.output.terms[1] = {"small", "small", fuzzy::Shape::kGaussian, {0.35, 0.1}};
  base::Random random(17);
  expectSame(model, random, 2000);
  model.implication = fuzzy::Implication::kScale;
  expectSame(model, random, 2000);
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
