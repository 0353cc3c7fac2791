#include "app/workbench/feel/procedure.h"

#include <gtest/gtest.h>

#include "app/workbench/model/shown_procedure.h"
#include "app/workbench/plot/landmarks.h"

#include "tests/support/french_probe.h"
#include "tests/support/ngt_model.h"

namespace tactus::workbench {
namespace {

TEST(Procedure, OfTheProgramBeginsOutsideAndEndsInTheStomach) {
  const auto steps = stepsOf(procedure::defaultProcedure().get());
  ASSERT_GE(steps.size(), 2u);
  EXPECT_FALSE(steps.front().from_mm);
  EXPECT_FALSE(stepAt(steps, 0));
  EXPECT_EQ(stepAt(steps, 1), 1u);
  EXPECT_EQ(stepAt(steps, 600), steps.size() - 1);
  for (const ProcedureStep& step : steps) {
    EXPECT_FALSE(step.title.isEmpty());
    EXPECT_FALSE(step.text.isEmpty());
  }
}

TEST(Procedure, OfAnotherPackHasItsOwnSteps) {
  procedure::Procedure probe = *support::frenchProbe();
  EXPECT_TRUE(stepsOf(&probe).empty());
  EXPECT_TRUE(stepsOf(nullptr).empty());
  probe.steps.push_back({{{"fr", "Entrer"}}, {{"fr", "Doucement."}, {"en", "Gently."}}, 5});
  const auto steps = stepsOf(&probe);
  ASSERT_EQ(steps.size(), 1u);
  EXPECT_EQ(steps[0].title, QStringLiteral("Entrer")) << "the first language where the program's is missing";
  EXPECT_EQ(steps[0].text, QStringLiteral("Gently."));
  EXPECT_EQ(stepAt(steps, 5), 0u);
}

/// A model as one that is built under the procedure.
fuzzy::ForceModel modelOf(const procedure::Procedure& about) {
  fuzzy::ForceModel model;
  model.inputs = about.inputs;
  model.output = about.output;
  model.provenance.emplace();
  model.provenance->settings.push_back(procedure::modelSetting(about));
  return model;
}

TEST(ShownProcedure, IsThatOfTheStudyOrTheOneThatTheModelNames) {
  const ProcedurePtr probe = support::frenchProbe();
  const ProcedurePtr swab = procedure::builtIn("nasopharyngeal-swab");
  EXPECT_EQ(procedureFor(modelOf(*probe), probe), probe);
  EXPECT_EQ(procedureFor(modelOf(*probe), nullptr), nullptr) << "its pack is not at hand";
  EXPECT_EQ(procedureFor(modelOf(*swab), probe), swab);
}

TEST(ShownProcedure, IsTheDefaultOneForItsInputsAlone) {
  fuzzy::ForceModel model = support::ngtVariables();
  EXPECT_EQ(procedureFor(model, support::frenchProbe()), procedure::defaultProcedure());
  model.inputs[0].id = "angle";
  EXPECT_EQ(procedureFor(model, nullptr), nullptr);
}

TEST(ShownProcedure, OnlyAPackWithWordsForTheGestureHasOne) {
  const fuzzy::ForceModel ngt = support::ngtVariables();
  EXPECT_EQ(posedInput(procedure::defaultProcedure().get(), ngt), 1u);
  EXPECT_EQ(posedInput(nullptr, ngt), std::nullopt);
  const ProcedurePtr catheter = procedure::builtIn("male-urethral-catheter");
  EXPECT_EQ(posedInput(catheter.get(), modelOf(*catheter)), std::nullopt);
}

TEST(ShownProcedure, HasItsLandmarksBesideItsWay) {
  auto probe = std::make_shared<procedure::Procedure>(*support::frenchProbe());
  probe->landmarks.push_back({{{"fr", "Pli"}}, {{"fr", "Un pli"}}, 10, 12, "Manuel"});
  showProcedure(probe);
  EXPECT_EQ(landmarksFor(probe->wayInput()).size(), 1u);
  EXPECT_EQ(landmarksFor(probe->wayInput()).front().name, QStringLiteral("Pli"));
  EXPECT_TRUE(landmarksFor(procedure::defaultProcedure()->wayInput()).empty());
  showProcedure(nullptr);
  EXPECT_TRUE(landmarksFor(probe->wayInput()).empty());
  showProcedure(procedure::defaultProcedure());
}

}  // namespace
}  // namespace tactus::workbench
