
#include <QTemporaryDir>
#include <gtest/gtest.h>

#include "app/workbench/labs/experts/experts_lab.h"

#include "tests/gui/labs/lab_study_file.h"
#include "tests/gui/sample_study.h"

namespace tactus::workbench {
namespace {

using elicitation::BandKind;
using tests::comesTrue;

class BandLabTest : public testing::Test {
 protected:
  void SetUp() override {
    study.open(path);
    lab.setWanted(true);
    ASSERT_TRUE(comesTrue([this] { return lab.built() != nullptr; }));
  }

  QTemporaryDir folder;
  QString path = tests::demoStudyIn(folder);
  StudyConnection study;
  LabData data{study};
  LabModel model{data};
  ExpertsLab lab{data, model};
};

TEST_F(BandLabTest, LiesAroundTheAveragedForceAndIsWidestForAnotherParticipant) {
  BandLab& bands = lab.bands();
  EXPECT_EQ(bands.shown(), nullptr);
  bands.choose(BandKind::kNext);
  ASSERT_TRUE(comesTrue([&] { return bands.shown() != nullptr && !bands.work().isBusy(); }));
  const ShownBand next = *bands.shown();
  ASSERT_EQ(next.x.size(), 121U);
  EXPECT_EQ(next.x.front(), 0);
  EXPECT_EQ(next.x.back(), 600);
  for (const auto& point : next.band.points) {
    if (!point.force_n) continue;
    EXPECT_LE(point.low_n, *point.force_n);
    EXPECT_GE(point.high_n, *point.force_n);
  }
  EXPECT_TRUE(bandText(next).contains(QStringLiteral("95 %")));
  EXPECT_FALSE(bandText(next).contains(QStringLiteral("Unfinished")));
  ShownBand some = next;
  some.done = 200;
  some.planned = 6435;
  EXPECT_TRUE(bandText(some).startsWith(QStringLiteral("Unfinished: 200 of 6435 draws.")));
  bands.choose(std::nullopt);
  EXPECT_EQ(bands.shown(), nullptr);
  EXPECT_FALSE(bands.work().isBusy());
}

TEST_F(BandLabTest, OwnWordsAreOneLineForEachPersonAndNeedNoDraws) {
  BandLab& bands = lab.bands();
  bands.choose(BandKind::kWords);
  ASSERT_TRUE(comesTrue([&] { return bands.shown() != nullptr && !bands.work().isBusy(); }));
  const ShownBand& shown = *bands.shown();
  EXPECT_EQ(shown.planned, 0U);
  ASSERT_EQ(shown.own_words.size(), 4U);
  for (std::size_t p = 0; p < shown.x.size(); ++p) {
    for (const OwnWordCurve& curve : shown.own_words) {
      if (!curve.forces_n[p]) continue;
      EXPECT_LE(shown.band.points[p].low_n, *curve.forces_n[p]);
      EXPECT_GE(shown.band.points[p].high_n, *curve.forces_n[p]);
    }
  }
  const QString text = bandText(shown);
  EXPECT_FALSE(text.contains(QStringLiteral("95 %"))) << "a range, no interval";
  EXPECT_TRUE(text.contains(QStringLiteral("S1"))) << "who never used the lowest word";
}

}  // namespace
}  // namespace tactus::workbench
