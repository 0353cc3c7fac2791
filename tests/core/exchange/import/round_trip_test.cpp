// What Tactus writes for other programs, it reads back with the same forces.
#include "core/base/random.h"
#include "core/exchange/dialect.h"

#include "tests/core/exchange/import/imported.h"
#include "tests/support/ngt_model.h"
#include "tests/support/random_model.h"

namespace tactus::exchange {
namespace {

constexpr Dialect kRead[] = {Dialect::kFll, Dialect::kFclIec, Dialect::kFclFuzzylite, Dialect::kFis};

bool isInside(const fuzzy::ForceModel& model, const std::vector<double>& point) {
  for (std::size_t i = 0; i < point.size(); ++i) {
    if (point[i] < model.inputs[i].min || point[i] > model.inputs[i].max) return false;
  }
  return true;
}

/// The forces of one expert, written and read again. IEC's FCL states no ranges of inputs, so there only the points
/// count that lie in those of the terms. Returns how many points were compared.
int expectSame(const fuzzy::ForceModel& model, std::size_t expert, Dialect dialect, base::Random& random, int points) {
  // Nothing that a model may say of its time ends the comment that holds it.
  const auto text =
      format(model, expert, dialect, {std::string(64, 'a'), "2026 *) --> ' \" // # %\n[Rules]\nrule: if", "tactus"});
  if (!text) return 0;  // no Gaussians in IEC's FCL
  const auto from = imported(*text, "a" + std::string(suffix(dialect)));
  if (from.refusal.find("no rule") != std::string::npos) return 0;
  EXPECT_TRUE(from.model) << from.refusal << "\n" << *text;
  if (!from.model) return 0;
  if (from.model->inputs.size() != model.inputs.size()) {
    ADD_FAILURE() << "inputs were left out\n" << *text;
    return 0;
  }
  const auto before = fuzzy::compile(model);
  const auto after = fuzzy::compile(*from.model);
  EXPECT_TRUE(before && after);
  int compared = 0;
  for (int p = 0; p < points; ++p) {
    const auto point = support::randomPoint(random, model);
    if (dialect == Dialect::kFclIec && !(isInside(model, point) && isInside(*from.model, point))) continue;
    const auto wanted = before->evaluateExpert(expert, point);
    const auto found = after->evaluate(point);
    EXPECT_EQ(found.fired, wanted.fired) << name(dialect) << ", point " << p << "\n" << *text;
    if (wanted.fired && found.fired) {
      EXPECT_NEAR(found.force_n, wanted.force_n, 1e-12 * (model.output.max - model.output.min)) << name(dialect) << "\n"
                                                                                                << *text;
    }
    if (testing::Test::HasFailure()) return compared;
    ++compared;
  }
  return compared;
}

TEST(ImportRoundTrip, TheNgtModels) {
  base::Random random(21);
  for (auto model : {support::s4AsPrinted(), support::s4Shifted(), support::s4FiveRegions()}) {
    for (const auto implication : {fuzzy::Implication::kClip, fuzzy::Implication::kScale}) {
      model.implication = implication;
      for (const Dialect dialect : kRead) EXPECT_GT(expectSame(model, 0, dialect, random, 3000), 2000);
    }
  }
}

TEST(ImportRoundTrip, TheExpertKeepsItsName) {
  const auto model = support::s4Shifted();
  for (const Dialect dialect : kRead) {
    const auto from = imported(format(model, 0, dialect).value_or(""), "a");
    ASSERT_TRUE(from.model) << from.refusal;
    EXPECT_EQ(from.model->experts.front().id, model.experts.front().id);
    EXPECT_EQ(from.model->inputs[2].id, "depth");
  }
}

TEST(ImportRoundTrip, RandomModels) {
  base::Random random(22);
  int compared[4] = {};
  for (int m = 0; m < 300; ++m) {
    SCOPED_TRACE("model " + std::to_string(m));
    const auto model = support::randomModel(random, {.gaussians = m % 3 == 0, .adversarial = m % 2 == 0});
    for (std::size_t e = 0; e < model.experts.size(); ++e) {
      for (int d = 0; d < 4; ++d) compared[d] += expectSame(model, e, kRead[d], random, 60);
    }
    if (HasFailure()) return;
  }
  for (const int count : compared) EXPECT_GT(count, 5000);
}

}  // namespace
}  // namespace tactus::exchange
