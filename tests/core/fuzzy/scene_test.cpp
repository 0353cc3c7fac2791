// One point of a scene has the bits of the same point of the model, whatever is fixed.
#include "core/fuzzy/scene.h"

#include <bit>
#include <cstdint>
#include <gtest/gtest.h>
#include <optional>
#include <vector>

#include "core/base/random.h"

#include "tests/support/ngt_model.h"
#include "tests/support/random_model.h"

namespace tactus::fuzzy {
namespace {

/// Random scenes of `model`: each input is fixed or not, at a point that randomPoint gives.
void expectSameBits(const ForceModel& model, base::Random& random, int scenes, int points) {
  const auto compiled = compile(model);
  ASSERT_TRUE(compiled.has_value()) << compiled.error().message();
  for (int s = 0; s < scenes; ++s) {
    const auto at = support::randomPoint(random, model);
    std::vector<std::optional<double>> fixed(at.size());
    for (std::size_t i = 0; i < at.size(); ++i) {
      if (random.below(2) == 0) fixed[i] = at[i];
    }
    const auto scene = Scene::specialize(*compiled, fixed);
    ASSERT_TRUE(scene.has_value()) << scene.error().message();
    for (int p = 0; p < points; ++p) {
      auto point = support::randomPoint(random, model);
      std::vector<double> free_inputs;
      for (std::size_t i = 0; i < point.size(); ++i) {
        if (fixed[i]) {
          point[i] = *fixed[i];
        } else {
          free_inputs.push_back(point[i]);
        }
      }
      const Evaluation whole = compiled->evaluate(point);
      const Evaluation part = scene->evaluate(free_inputs);
      ASSERT_EQ(part.fired, whole.fired);
      ASSERT_EQ(std::bit_cast<std::uint64_t>(part.force_n), std::bit_cast<std::uint64_t>(whole.force_n))
          << part.force_n << " instead of " << whole.force_n;
    }
  }
}

TEST(Scene, OnePointHasTheBitsOfTheModel) {
  base::Random random(11);
  for (const auto& model : {support::s4AsPrinted(), support::s4Shifted(), support::s4FiveRegions()}) {
    expectSameBits(model, random, 60, 60);
  }
  for (int m = 0; m < 400; ++m) expectSameBits(support::randomModel(random), random, 8, 20);
  for (int m = 0; m < 100; ++m) {
    expectSameBits(support::randomModel(random, {.gaussians = true, .adversarial = false}), random, 4, 20);
  }
}

TEST(Scene, RulesOfEveryWeightHaveTheBitsOfTheModel) {
  base::Random random(12);
  for (int m = 0; m < 200; ++m) {
    auto model = support::s4Shifted();
    // Weights of 0, 1 and between, some rules off; up to eight experts of a team and more.
    const auto expert = model.experts.front();
    const int experts = 1 + static_cast<int>(random.below(6));
    for (int e = 1; e < experts; ++e) {
      model.experts.push_back(expert);
      model.experts.back().id += std::to_string(e);
    }
    for (auto& some : model.experts) {
      for (auto& rule : some.rules) {
        const auto kind = random.below(4);
        rule.weight = kind == 0 ? random.uniform() : 1;
        rule.enabled = kind != 1;
        rule.then = model.output.terms[random.below(model.output.terms.size())].id;
      }
    }
    expectSameBits(model, random, 6, 30);
  }
}

}  // namespace
}  // namespace tactus::fuzzy
