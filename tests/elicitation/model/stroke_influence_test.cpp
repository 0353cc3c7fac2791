#include <cmath>
#include <gtest/gtest.h>

#include "app/session/study_source.h"
#include "core/fuzzy/compiled_model.h"
#include "elicitation/model/record_influence.h"

#include "tests/support/default_procedure.h"
#include "tests/support/table_study.h"

namespace tactus::elicitation {
namespace {

// The same stroke taken out of the study, and everything built again: the same force at the point of the largest
// difference, for averaged and for own terms.
TEST(StrokeInfluence, IsThatOfTheStudyBuiltAgainWithoutTheStroke) {
  const auto study = support::tableStudy(1, {.nurses = 2, .rows_per_s = 30});
  auto reduced = study;
  std::erase_if(reduced.speeds,
                [](const auto& one) { return one.participant == "N1" && one.level == "fast" && one.stroke == 2; });
  for (const auto terms : {SpeedTermsOf::kAveraged, SpeedTermsOf::kOwn}) {
    BuildSettings settings;
    settings.terms = terms;
    const auto built = buildModel(study, session::knownForms(support::defaultProcedure()), settings).value();
    const auto influence = withoutStroke(built, study, settings, "N1", "fast", 2);
    ASSERT_TRUE(influence) << influence.error().message();
    const auto& difference = influence->difference;
    EXPECT_GT(difference.largest_n, 0);
    EXPECT_GT(influence->noticeable, 0);
    EXPECT_LE(difference.rms_n, difference.largest_n);
    const auto again = buildModel(reduced, session::knownForms(support::defaultProcedure()), settings).value();
    EXPECT_NEAR(fuzzy::compile(again.model)->evaluate(difference.at).force_n, difference.second_n, 1e-12);
  }
}

TEST(StrokeInfluence, RefusesAStrokeThatIsNotThere) {
  const auto study = support::tableStudy(1, {.nurses = 1, .rows_per_s = 30});
  const auto built = buildModel(study, session::knownForms(support::defaultProcedure()), {}).value();
  EXPECT_FALSE(withoutStroke(built, study, {}, "N1", "fast", 99));
  EXPECT_FALSE(withoutStroke(built, study, {}, "N9", "fast", 1));
}

}  // namespace
}  // namespace tactus::elicitation
