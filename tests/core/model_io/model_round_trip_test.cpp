#include <clocale>
#include <gtest/gtest.h>
#include <string>

#include "core/base/random.h"
#include "core/model_io/model_file.h"

#include "tests/support/ngt_model.h"
#include "tests/support/random_model.h"

namespace tactus::model_io {
namespace {

void expectRoundTrip(const fuzzy::ForceModel& model) {
  const std::string text = formatModel(model);
  const auto read = parseModel(text, "m.json");
  ASSERT_TRUE(read.has_value()) << read.error().message();
  EXPECT_TRUE(read->warnings.empty());
  EXPECT_EQ(read->model, model);
  EXPECT_EQ(formatModel(read->model), text);
}

fuzzy::ForceModel handMadeModel() {
  fuzzy::ForceModel model = support::s4FiveRegions();
  model.name = "Nährsonde „Ä“ \"quoted\" \\ back\nline\ttab \x01 深さ 🙂";
  model.created_utc = "2026-11-21T08:00:00Z";
  model.generator = "test";
  model.provenance =
      fuzzy::Provenance{"study", {{"alpha", "0.95"}, {"nested", "[{ \"a\": [1, null] }, {}, []]"}}, {}, ""};
  model.implication = fuzzy::Implication::kScale;
  model.default_force_n = -0.1;
  model.accepted_holes = {"oropharynx", "a/b~c"};
  model.experts[0].overrides = {{"speed",
                                 {{"slow", "Slow", fuzzy::Shape::kTriangle, {-10, 0, 100}},
                                  {"medium", "Medium", fuzzy::Shape::kGaussian, {110, 20.5}},
                                  {"fast", "Fast", fuzzy::Shape::kTrapezoid, {120, 163, 400, 500}}}},
                                {"force", model.output.terms}};
  model.experts[0].rules[3].weight = 1.0 / 3;
  model.experts[0].rules[4].enabled = false;
  model.experts.push_back({"no rules/~", "", -0.0, {}, {}});
  model.renderer.emplace();
  model.renderer->stiffness_n_mm = 0.1 + 0.2;
  model.checks = {{{1, 45, 600.5, -30}, -0.1, false}};
  model.experts[0].rules.resize(2);
  using Kind = fuzzy::Contract::Kind;
  model.contracts = {{"a", Kind::kNeverRaises, "lubrication", "", "", 0, 0, false, {{"speed", "slow"}}},
                     {"b", Kind::kNeverHarder, "depth", "nasal_cavity", "gone", 0, 0, false, {}},
                     {"c", Kind::kNoStep, "depth", "", "", 1, 0.1, true, {}},
                     {"d", Kind::kNeverBelow, "", "", "", 0, -0.3, false, {}},
                     {"e", Kind::kNeverSilent, "", "", "", 0, 0, false, {}}};
  model.events = {{"nasopharynx", 1.0 / 3}, {"nasal_cavity", 0.1 + 0.2}};
  model.extra = {{"extra", "{ \"a\": 1e5 }"}, {"another", "\"text\""}};
  return model;
}

TEST(ModelRoundTrip, HandMadeModels) {
  expectRoundTrip(support::s4AsPrinted());
  expectRoundTrip(handMadeModel());
}

TEST(ModelRoundTrip, RandomModels) {
  base::Random random(20);
  for (int i = 0; i < 300; ++i) {
    fuzzy::ForceModel model = support::randomModel(random, {.gaussians = i % 2 == 0});
    ASSERT_NO_FATAL_FAILURE(expectRoundTrip(model)) << "model " << i;
  }
}

TEST(ModelRoundTrip, NumbersWithACommaInTheLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr && std::setlocale(LC_ALL, "de_DE.utf8") == nullptr) {
    GTEST_SKIP() << "the locale de_DE.UTF-8 is not installed here";
  }
  ASSERT_STREQ(std::localeconv()->decimal_point, ",");
  expectRoundTrip(handMadeModel());
  const auto broken = parseModel(R"({ "format": 1.5e999 })", "m.json");
  std::setlocale(LC_ALL, before.c_str());
  ASSERT_FALSE(broken.has_value());
  EXPECT_EQ(broken.error().place, "/format");
}

}  // namespace
}  // namespace tactus::model_io
