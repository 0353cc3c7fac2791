#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "app/workbench/understand/curves/reference_controller.h"

#include "tests/gui/sample_models.h"

namespace tactus::workbench {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

class ReferenceFile : public testing::Test {
 protected:
  base::Result<std::vector<ReferenceCurve>> read(const QByteArray& text) {
    return readReferences(folder.writeText(text, QStringLiteral("fem.csv")), tests::twoExperts());
  }
  /// The sentence of the error without the folder.
  std::string refusal(const QByteArray& text) {
    const auto curves = read(text);
    if (curves) return "nothing refused";
    const std::string message = curves.error().message();
    return message.substr(message.find("fem.csv"));
  }

  tests::ModelFolder folder;
};

TEST_F(ReferenceFile, HoldsOneCurveOrASeriesOfThem) {
  const auto one = read("# a comment\ndepth,force\n0,0.1\n4,0.3\n");
  ASSERT_TRUE(one.has_value()) << one.error().message();
  ASSERT_EQ(one->size(), 1U);
  EXPECT_EQ(one->front().name, QStringLiteral("fem"));
  EXPECT_EQ(one->front().input, "depth");
  EXPECT_EQ(one->front().x, (std::vector<double>{0, 4}));
  EXPECT_EQ(one->front().force_n, (std::vector<double>{0.1, 0.3}));

  const auto two = read("series,force_n,depth_mm,note\nA,1,0,x\nB,2,1,\nA,3,2,\nB,,3,\nB,4,5,\n");
  ASSERT_TRUE(two.has_value()) << two.error().message();
  ASSERT_EQ(two->size(), 2U);
  EXPECT_EQ(two->at(1).name, QStringLiteral("B"));
  EXPECT_EQ(two->at(1).x, (std::vector<double>{1, 3, 5}));
  EXPECT_TRUE(std::isnan(two->at(1).force_n[1]));
}

TEST_F(ReferenceFile, MayRunOverAnyInput) {
  const auto curves = read("speed_mm_s,force_n\n0,0\n100,1\n");
  ASSERT_TRUE(curves.has_value());
  EXPECT_EQ(curves->front().input, "speed");
}

TEST_F(ReferenceFile, AMistakeGivesOneClearSentence) {
  EXPECT_EQ(refusal("x,force\n0,1\n"), "fem.csv: header: found columns x, force, wanted one of speed_mm_s, depth_mm");
  EXPECT_EQ(refusal("depth,speed,force\n0,1,1\n"),
            "fem.csv: header: found columns speed, depth, wanted one input alone, which is the x axis of the curve");
  EXPECT_EQ(refusal("depth,newton\n0,1\n"), "fem.csv: header: found columns depth, newton, wanted a column force_n");
  EXPECT_EQ(refusal("depth,force\n0,1\n2,1\n2,1\n"),
            "fem.csv: line 4, column 'depth': found '2', wanted more than 2, the place before it in this curve");
  EXPECT_NE(refusal("depth,force\n0,one\n").find("line 2, column 'force'"), std::string::npos);
  EXPECT_EQ(refusal("depth,force\n0,1\n1,\n"), "fem.csv: 'fem': found 1 points with a force, wanted two or more");
  EXPECT_EQ(refusal("depth,force\n"), "fem.csv: found no rows, wanted points");
  QByteArray many("depth,force,series\n");
  for (int i = 0; i < 7; ++i) many += "0,1," + QByteArray::number(i) + "\n1,1," + QByteArray::number(i) + "\n";
  EXPECT_EQ(refusal(many), "fem.csv: found 7 curves, wanted at most 6 curves");
}

TEST(ReferenceDifference, OfTwoStraightLinesIsTheIntegral) {
  // The model says 0.5 everywhere, the reference rises from 0 to 1: the difference runs from 0.5 to -0.5, and the mean
  // of its square is 1/12. The largest is at both ends; the first one counts.
  const ReferenceCurve reference{{}, QStringLiteral("R"), "depth", {0, 10}, {0, 1}, 0};
  const std::vector<double> x{0, 2, 10};
  const std::vector<double> force(3, 0.5);
  const auto difference = compare(reference, {x, force});
  ASSERT_TRUE(difference.has_value());
  EXPECT_NEAR(difference->rms_n, std::sqrt(1.0 / 12), 1e-15);
  EXPECT_EQ(difference->largest_n, 0.5);
  EXPECT_EQ(difference->largest_at, 0);
  EXPECT_EQ(difference->from, 0);
  EXPECT_EQ(difference->to, 10);
}

TEST(ReferenceDifference, DoesNotDependOnHowDenselyTheReferenceWasSampled) {
  ReferenceCurve coarse{{}, QStringLiteral("R"), "depth", {0, 4, 10}, {0, 1, 0.25}, 0};
  ReferenceCurve dense{{}, QStringLiteral("R"), "depth", {0, 0.5, 1, 2, 4, 10}, {0, 0.125, 0.25, 0.5, 1, 0.25}, 0};
  const std::vector<double> x{0, 0.5, 1, 2, 4, 10};
  const std::vector<double> force{0.2, 0.2, 0.2, 0.2, 0.2, 0.2};
  const auto a = compare(coarse, {x, force});
  const auto b = compare(dense, {x, force});
  EXPECT_NEAR(a->rms_n, b->rms_n, 1e-15);
  EXPECT_EQ(a->largest_n, 0.8);
  EXPECT_EQ(a->largest_at, 4);
}

TEST(ReferenceDifference, ComparesOnlyWhereBothHaveAForce) {
  // The reference has a gap from 4 to 6 and ends at 8; the model is silent at 2 and begins at 1.
  const ReferenceCurve reference{{}, QStringLiteral("R"), "depth", {0, 4, 5, 6, 8}, {0, 0, kNone, 1, 1}, 0};
  const std::vector<double> x{1, 2, 3, 4, 5, 6, 7, 8, 9};
  const std::vector<double> force{1, kNone, 0.25, 0.25, 9, 1.5, 1.5, 1.5, 7};
  const auto difference = compare(reference, {x, force});
  ASSERT_TRUE(difference.has_value());
  // From 3 to 4 off by 0.25, from 6 to 8 off by 0.5.
  EXPECT_NEAR(difference->rms_n, std::sqrt((0.0625 + 2 * 0.25) / 3), 1e-15);
  EXPECT_EQ(difference->largest_n, 0.5);
  EXPECT_EQ(difference->largest_at, 6);
  EXPECT_EQ(difference->from, 3);
  EXPECT_EQ(difference->to, 8);
  const ReferenceCurve apart{{}, QStringLiteral("R"), "depth", {20, 30}, {0, 1}, 0};
  EXPECT_FALSE(compare(apart, {x, force}).has_value());
}

}  // namespace
}  // namespace tactus::workbench
