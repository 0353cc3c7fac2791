// The overview of stage Build: each part with the largest effect that is found anywhere for it.
#include <QTemporaryDir>
#include <algorithm>
#include <gtest/gtest.h>

#include "app/workbench/labs/method/method_lab.h"
#include "app/workbench/labs/overview/build_overview.h"

#include "tests/gui/labs/lab_study_file.h"
#include "tests/gui/sample_study.h"

namespace tactus::workbench {
namespace {

using Kind = BuildPart::Kind;
using tests::comesTrue;

class OverviewTest : public testing::Test {
 protected:
  void open(const QString& path) {
    study.open(path);
    ASSERT_TRUE(comesTrue([this] { return study.isOpen(); }));
    overview.setSeen(true);
  }
  const BuildPart& part(Kind kind) const {
    return *std::find_if(found.begin(), found.end(), [kind](const BuildPart& one) { return one.kind == kind; });
  }

  QTemporaryDir folder;
  StudyConnection study;
  LabData data{study};
  LabModel model{data};
  BuildOverview overview{model};
  std::vector<BuildPart> found;
};

// The tab Method takes what the overview has compared already, for the same study and settings, and adds the choices
// that no card shows.
TEST_F(OverviewTest, TheMethodIsStudiedOnce) {
  ASSERT_NO_FATAL_FAILURE(open(tests::demoStudyIn(folder)));
  ASSERT_TRUE(comesTrue([this] { return overview.studied().has_value(); }));
  MethodLab method(data, [this] { return overview.studied(); });
  method.setWanted(true);
  method.compare();
  ASSERT_TRUE(comesTrue([&] { return method.found() != nullptr; }));
  const auto known = overview.studied()->choices;
  EXPECT_EQ(known->factors.size() + 2, method.found()->factors.size()) << "without the shapes and the implication";
  for (const auto& one : known->variants) {
    const auto& all = method.found()->variants;
    const auto same = std::find_if(all.begin(), all.end(), [&](const auto& other) {
      return other.factor == one.factor && other.value == one.value;
    });
    ASSERT_NE(same, all.end()) << one.factor;
    EXPECT_EQ(same->largest_n, one.largest_n);
    EXPECT_EQ(same->at, one.at);
  }
  EXPECT_FALSE(method.isOld());
  // With another setting it is another comparison.
  overview.setSeen(false);
  auto settings = data.settings();
  settings.averaging = elicitation::Averaging::kMedian;
  data.setSettings(settings);
  EXPECT_TRUE(method.isOld());
  method.compare();
  ASSERT_TRUE(comesTrue([&] { return !method.isBusy() && !method.isOld(); }));
  EXPECT_NE(method.found(), overview.studied()->choices.get());
}

TEST_F(OverviewTest, TheStakesAreThoseOfTheMethodStudyAndOfTheExperts) {
  ASSERT_NO_FATAL_FAILURE(open(tests::demoStudyIn(folder)));
  ASSERT_TRUE(comesTrue([this] {
    found = overview.parts();
    return found.size() == 5 && part(Kind::kSpeed).stake_n;
  }));
  const auto built = *model.inputs();
  const auto choices = elicitation::methodStudy(built.study->study, built.study->forms, built.settings, *built.model);
  ASSERT_TRUE(choices);
  double speed_n = 0;
  double force_n = 0;
  for (const auto& variant : choices->variants) {
    if (!variant.unavailable.empty()) continue;
    if (variant.factor == "force_terms") force_n = std::max(force_n, variant.largest_n);
    const bool of_speed = variant.factor == "alpha" || variant.factor == "m" || variant.factor == "trim" ||
                          variant.factor == "centres" || variant.factor == "averaging" || variant.factor == "terms";
    if (of_speed) speed_n = std::max(speed_n, variant.largest_n);
  }
  double apart_n = 0;
  for (const auto& pair : built.model->influences.pairs) apart_n = std::max(apart_n, pair.largest->newtons);
  EXPECT_EQ(part(Kind::kSpeed).stake_n, speed_n);
  EXPECT_EQ(part(Kind::kForce).stake_n, force_n);
  EXPECT_EQ(part(Kind::kRules).stake_n, apart_n);
  EXPECT_TRUE(std::is_sorted(found.begin(), found.end(), [](const auto& one, const auto& other) {
    return one.stake_n.value_or(0) > other.stake_n.value_or(0);
  }));
  EXPECT_FALSE(part(Kind::kSpeed).warnings.isEmpty()) << "two nurses' speeds are hardly apart";
}

TEST_F(OverviewTest, AnEmptyStudyHasNoPartsAndSaysWhy) {
  const QString path = folder.filePath(QStringLiteral("empty.tactus"));
  tests::makeStudyFile(path);
  ASSERT_NO_FATAL_FAILURE(open(path));
  ASSERT_TRUE(comesTrue([this] { return !overview.failure().isEmpty(); }));
  EXPECT_TRUE(overview.parts().empty());
}

}  // namespace
}  // namespace tactus::workbench
