#include "app/workbench/labs/plan/plan_lab.h"

#include <QTemporaryDir>
#include <gtest/gtest.h>

#include "app/session/study_procedure.h"
#include "core/procedure/procedure.h"

#include "tests/gui/labs/lab_study_file.h"
#include "tests/gui/sample_study.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;

class PlanLabTest : public testing::Test {
 protected:
  void wantFewStudies() {
    PlanWish wish;
    wish.studies = 20;
    wish.most_nurses = 4;
    lab.setWish(wish);
  }

  QTemporaryDir folder;
  StudyConnection study;
  LabData data{study};
  LabModel model{data};
  PlanLab lab{data, model};
};

TEST_F(PlanLabTest, WithoutAStudyItPlansOneToCome) {
  wantFewStudies();
  EXPECT_FALSE(lab.work().isBusy()) << "nothing is simulated while the lab is hidden";
  lab.setWanted(true);
  ASSERT_TRUE(comesTrue([this] { return lab.plan() != nullptr; }));
  EXPECT_FALSE(lab.plan()->now);
  EXPECT_EQ(planRows(*lab.plan()).size(), 9U);  // 2 to 4 nurses by 15, 30 and 45 questions
  // Another precision needs no other studies.
  lab.setPrecisionN(5);
  EXPECT_FALSE(lab.work().isBusy());
  ASSERT_TRUE(lab.plan()->plan.cheapest);
  EXPECT_EQ(*lab.plan()->plan.cheapest, 0U) << "two nurses and the fewest questions cost the fewest hours";
  EXPECT_EQ(planRows(*lab.plan())[0].note, QStringLiteral("the cheapest"));
  lab.setPrecisionN(1e-6);
  EXPECT_FALSE(lab.plan()->plan.cheapest);
}

TEST_F(PlanLabTest, AStudyThatRunsIsTheStart) {
  wantFewStudies();
  study.open(tests::demoStudyIn(folder));
  lab.setWanted(true);
  ASSERT_TRUE(comesTrue([this] { return lab.plan() != nullptr && lab.plan()->now; }));
  EXPECT_EQ(lab.plan()->now->nurses, static_cast<int>(model.built()->model.experts.size()));
  EXPECT_EQ(lab.plan()->settings.most_nurses, lab.plan()->now->nurses + 2);
  EXPECT_FALSE(planning::gainsOf(*lab.plan()).empty());
  // What the command says with the same numbers.
  planning::PlanSettings settings;
  settings.most_nurses = 4;
  settings.studies = 20;
  auto again = planning::planDuring(data.study()->study, *model.built(), data.settings(), settings);
  ASSERT_TRUE(again);
  ASSERT_TRUE(planning::simulate(*again, {}));
  ASSERT_EQ(again->plan.designs.size(), lab.plan()->plan.designs.size());
  for (std::size_t i = 0; i < again->plan.designs.size(); ++i)
    EXPECT_EQ(again->plan.designs[i].error_n, lab.plan()->plan.designs[i].error_n);
}

TEST_F(PlanLabTest, AStudyOfAnotherProcedureHasItsRegions) {
  wantFewStudies();
  const auto swab = procedure::builtIn("nasopharyngeal-swab");
  const QString path = folder.filePath(QStringLiteral("swab.tactus"));
  tests::makeStudyFile(path, [&swab](store::StudyFile& file, study::RecordIds& ids) {
    session::SessionTools tools{[] { return study::Moment{1, 1}; }, ids};
    ASSERT_TRUE(session::keepProcedure(file, swab, tools));
  });
  lab.setWanted(true);
  study.open(path);
  ASSERT_TRUE(comesTrue([&] { return lab.plan() != nullptr && lab.plan()->questions.about->id == swab->id; }));
  EXPECT_EQ(lab.plan()->settings.questions, (std::vector<int>{6, 12, 18}));
  EXPECT_EQ(lab.regions(), swab->wayInput().terms);
  PlanWish wish = lab.wish();
  wish.region = swab->wayInput().terms.back().id;
  lab.setWish(wish);
  ASSERT_TRUE(comesTrue([&] { return lab.plan() != nullptr && lab.plan()->settings.region == wish.region; }));
}

}  // namespace
}  // namespace tactus::workbench
