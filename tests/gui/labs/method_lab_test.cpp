#include "app/workbench/labs/method/method_lab.h"

#include <QTemporaryDir>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "app/workbench/base/display_text.h"

#include "tests/gui/labs/lab_study_file.h"
#include "tests/gui/sample_study.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;

class MethodLabTest : public testing::Test {
 protected:
  void SetUp() override {
    study.open(path);
    lab.setWanted(true);
    ASSERT_TRUE(comesTrue([this] { return lab.isPossible(); }));
  }
  std::size_t variant(const std::string& factor, const std::string& value) const {
    const auto& all = lab.found()->variants;
    return static_cast<std::size_t>(
        std::find_if(all.begin(), all.end(),
                     [&](const auto& one) { return one.factor == factor && one.value == value; }) -
        all.begin());
  }

  QTemporaryDir folder;
  QString path = tests::demoStudyIn(folder);
  StudyConnection study;
  LabData data{study};
  MethodLab lab{data};
};

TEST_F(MethodLabTest, ComparesOnRequestAndDrawsTheCurvesWhereTheyDifferMost) {
  EXPECT_EQ(lab.found(), nullptr);
  EXPECT_FALSE(lab.isBusy()) << "nothing is computed before the button";
  lab.compare();
  EXPECT_TRUE(lab.isBusy());
  lab.setWanted(false);  // the run continues behind another tab
  ASSERT_TRUE(comesTrue([this] { return lab.found() != nullptr; }));
  lab.setWanted(true);
  EXPECT_FALSE(lab.isBusy());

  struct FactorTable {
    enum { kSentence = kVerdictColumn };
  };
  Columns<FactorRow> factors(factorColumns());
  factors.setRows(factorRows(*lab.found()));
  EXPECT_EQ(factors.rowCount(), static_cast<int>(lab.found()->factors.size()));
  for (int row = 0; row < factors.rowCount(); ++row) {
    const QModelIndex at = factors.index(row, FactorTable::kSentence);
    const QString verdict = at.data().toString();
    EXPECT_TRUE(verdict.startsWith(QStringLiteral("Yes: ")) || verdict.startsWith(QStringLiteral("No: ")))
        << verdict.toStdString();
    EXPECT_TRUE(at.data(Qt::ToolTipRole).toString().contains(QStringLiteral("here")));
    EXPECT_FALSE(verdict.contains(QLatin1Char('_'))) << verdict.toStdString();
    // The largest of all values of the choice, also where another one is felt at more places.
    const FactorRow& shown = factors.rows()[static_cast<std::size_t>(row)];
    double largest_n = 0;
    for (const auto& one : lab.found()->variants) {
      if (one.factor == lab.found()->factors[shown.index].factor) largest_n = std::max(largest_n, one.largest_n);
    }
    if (lab.found()->factors[shown.index].worst) {
      EXPECT_EQ(shown.largest, quantityText(largest_n, "N", 3));
    }
  }
  Columns<VariantRow> variants(variantColumns());
  variants.setRows(variantRows(*lab.found(), "force_terms", lab.model()));
  ASSERT_EQ(variants.rowCount(), 3) << "frequency, thresholds and probit beside the vote";

  const std::size_t thresholds = variant("force_terms", "thresholds");
  EXPECT_TRUE(std::any_of(variants.rows().begin(), variants.rows().end(),
                          [&](const VariantRow& row) { return row.index == thresholds; }));
  lab.choose(thresholds);
  ASSERT_TRUE(comesTrue([this] { return lab.curves() != nullptr; }));
  // Both curves pass through the largest difference.
  const MethodCurves& curves = *lab.curves();
  const auto& found = lab.found()->variants[thresholds];
  EXPECT_EQ(curves.at, found.at);
  const double depth_mm = found.at[curves.x_input];
  const auto forceAt = [&](const figures::ForceCurves& one) {
    const auto right = std::lower_bound(one.x.begin(), one.x.end(), depth_mm);
    const auto i = static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(right - one.x.begin(), 0, static_cast<std::ptrdiff_t>(one.x.size()) - 1));
    return one.mean[i].force_n;
  };
  // The curves are sampled every 1.2 mm and between; forces change by less than 0.02 N there.
  EXPECT_NEAR(std::abs(forceAt(curves.now) - forceAt(curves.other)), found.largest_n, 0.02);
}

TEST_F(MethodLabTest, AChangedSettingMakesItOldAndCancelEndsIt) {
  lab.compare();
  lab.cancel();
  EXPECT_FALSE(lab.isBusy());
  EXPECT_EQ(lab.found(), nullptr);
  lab.compare();
  ASSERT_TRUE(comesTrue([this] { return lab.found() != nullptr; }));
  EXPECT_FALSE(lab.isOld());
  auto settings = data.settings();
  settings.speed.alpha = 0.9;
  data.setSettings(settings);
  EXPECT_TRUE(lab.isOld());
  EXPECT_FALSE(lab.isBusy()) << "only the button starts it";
  lab.compare();
  ASSERT_TRUE(comesTrue([this] { return !lab.isOld(); }));
  const auto& factors = lab.found()->factors;
  const auto alpha =
      std::find_if(factors.begin(), factors.end(), [](const auto& one) { return one.factor == "alpha"; });
  EXPECT_EQ(alpha->unchanged, "0.9");
  study.close();
  ASSERT_TRUE(comesTrue([this] { return lab.found() == nullptr; }));
  EXPECT_FALSE(lab.isPossible());
}

}  // namespace
}  // namespace tactus::workbench
