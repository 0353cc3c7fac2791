// The conformance set of docs/conformance: every check is exact, and each model shows the mistake that it is made for.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <map>
#include <string>

#include "core/analysis/centroid_bound.h"
#include "core/analysis/check_points.h"
#include "core/model_io/model_file.h"

#include "tests/reference/exact_model.h"

namespace tactus {
namespace {

fuzzy::ForceModel conformanceModel(const std::string& name) {
  const auto read = model_io::readModel(TACTUS_SOURCE_DIR "/docs/conformance/" + name + ".tactus.json");
  EXPECT_TRUE(read) << (read ? "" : read.error().message());
  return read ? read->model : fuzzy::ForceModel{};
}

const std::map<std::string, std::string> kMistakes = {{"scale", ""},
                                                      {"gaussian", ""},
                                                      {"disabled_rule", "disabled rules read"},
                                                      {"rule_weights", "rule weights taken as 1"},
                                                      {"expert_weights", "experts weighted equally"},
                                                      {"own_terms", ""},
                                                      {"default_force", "default force taken as 0"},
                                                      {"clamping", "inputs not clamped"}};

bool isGaussian(const fuzzy::ForceModel& model) { return model.name.find("Gaussian") != std::string::npos; }

TEST(Conformance, EveryCheckIsExact) {
  for (const auto& [name, mistake] : kMistakes) {
    const auto model = conformanceModel(name);
    ASSERT_GT(model.checks.size(), 20U) << name;
    const auto compiled = fuzzy::compile(model);
    ASSERT_TRUE(compiled);
    for (const fuzzy::Check& check : model.checks) {
      if (isGaussian(model)) {
        // A midpoint rule of so many cells is good to 1e-9 for these smooth sets.
        const auto sampled =
            analysis::evaluateSampled(*compiled, check.in, {analysis::Sampling::Rule::kMidpoint, 200'000});
        ASSERT_NEAR(sampled.force_n, check.force, 1e-8) << name;
        continue;
      }
      const auto exact = reference::exactForce(model, check.in);
      ASSERT_EQ(exact.has_value(), check.fired) << name;
      ASSERT_NEAR(exact ? exact->get_d() : model.default_force_n, check.force, 1e-12) << name;
    }
  }
}

TEST(Conformance, EachModelShowsItsMistake) {
  std::size_t shown = 0;
  for (const auto& [name, mistake] : kMistakes) {
    const auto model = conformanceModel(name);
    for (const analysis::WrongReader& reader : analysis::wrongReaders(model)) {
      if (reader.mistake != mistake) continue;
      ++shown;
      double largest_n = 0;
      for (const fuzzy::Check& check : model.checks) {
        largest_n = std::max(largest_n, std::abs(reader.force(check.in).force_n - check.force));
      }
      EXPECT_GT(largest_n, 0.01) << name;
    }
  }
  EXPECT_EQ(shown, 5U);
}

TEST(Conformance, NoModelIsMissing) {
  std::size_t models = 0;
  for (const auto& entry : std::filesystem::directory_iterator(TACTUS_SOURCE_DIR "/docs/conformance")) {
    models += entry.path().extension() == ".json" ? 1 : 0;
  }
  EXPECT_EQ(models, kMistakes.size());
}

}  // namespace
}  // namespace tactus
