#include "app/workbench/feel/procedure.h"

#include <gtest/gtest.h>

namespace tactus::workbench {
namespace {

TEST(Procedure, OfTheProgramBeginsOutsideAndEndsInTheStomach) {
  const auto steps = ngtProcedure();
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

TEST(Procedure, IsReadFromAText) {
  const auto steps = readProcedure(R"({"steps": [{"title": "A"}, {"title": "B", "text": "b", "from_mm": 10}]})");
  ASSERT_TRUE(steps);
  EXPECT_EQ((*steps)[1].title, QStringLiteral("B"));
  EXPECT_EQ((*steps)[1].from_mm, 10);
  EXPECT_FALSE(stepAt(*steps, 9.9));
  EXPECT_EQ(stepAt(*steps, 10), 1u);
}

TEST(Procedure, RefusesWhatMakesNoSense) {
  for (const char* text : {"{", "{}", R"({"steps": []})", R"({"steps": [{"text": "no title"}]})",
                           R"({"steps": [{"title": "A", "from_mm": 5}, {"title": "B", "from_mm": 5}]})",
                           R"({"steps": [{"title": "A", "from_mm": 5}, {"title": "B"}]})"}) {
    EXPECT_FALSE(readProcedure(text)) << text;
  }
}

}  // namespace
}  // namespace tactus::workbench
