#include "app/workbench/deliver/bundle_maker.h"

#include <QDir>
#include <QFile>
#include <QTest>
#include <gtest/gtest.h>

#include "app/bundle/file_errors.h"
#include "app/editing/step_fixes.h"
#include "app/workbench/deliver/readiness.h"
#include "core/fuzzy/compiled_model.h"

#include "tests/gui/bench_controllers.h"
#include "tests/gui/sample_models.h"

namespace tactus::workbench {
namespace {

constexpr int kMakingMs = 60'000;

class BundleMakerTest : public testing::Test {
 protected:
  void SetUp() override {
    bench.models.open(folder.write(tests::twoExperts()));
    ASSERT_TRUE(bench.edits.isOpen());
  }

  void acceptHole() { ASSERT_TRUE(bench.edits.apply(editing::acceptHole(bench.edits.model(), "depth 5 to 6 mm"))); }
  void waitForEnd() {
    ASSERT_TRUE(QTest::qWaitFor([this] { return maker.doing() == BundleMaker::Doing::kNothing; }, kMakingMs));
  }

  tests::ModelFolder folder;
  tests::BenchControllers bench;
  BundleMaker maker{bench.edits};
  const QString place = folder.path(QStringLiteral("new/bundle"));
};

TEST_F(BundleMakerTest, MakesTheBundleAndReadsItBack) {
  acceptHole();
  maker.make(place);
  EXPECT_TRUE(maker.mayCancel());
  waitForEnd();
  ASSERT_TRUE(maker.delivered()) << maker.failure().toStdString();
  EXPECT_TRUE(maker.delivered()->ok);
  EXPECT_TRUE(maker.delivered()->made);
  EXPECT_FALSE(maker.isOld());
  const auto check = bundle::verifyBundle(place.toStdString(), "another program");
  ASSERT_TRUE(check) << check.error().message();
  EXPECT_EQ(QString(maker.delivered()->fingerprint).remove(QLatin1Char(' ')).toStdString(), check->fingerprint);
  ASSERT_EQ(check->files.size(), maker.delivered()->files.size());
  // Each file of forces says its largest error.
  for (std::size_t i = 0; i < check->files.size(); ++i) {
    const DeliveredFile& file = maker.delivered()->files[i];
    EXPECT_EQ(file.path.toStdString(), check->files[i].file.path);
    EXPECT_EQ(file.error_n.has_value(), check->files[i].file.promise.has_value());
    if (file.error_n) {
      EXPECT_LE(*file.error_n, file.tolerance_n) << file.path.toStdString();
    }
  }
}

TEST_F(BundleMakerTest, TheSignOffsOfTheStateGoAlong) {
  acceptHole();
  bench.edits.setFelt({2, "Touch", false, {"A"}});
  bench.edits.signOff(QStringLiteral("S4"));
  maker.make(place);
  waitForEnd();
  const auto check = bundle::verifyBundle(place.toStdString(), "another program");
  ASSERT_TRUE(check) << check.error().message();
  ASSERT_EQ(check->approvals.size(), 1U);
  EXPECT_EQ(check->approvals[0].author, "S4");
  EXPECT_EQ(check->approvals[0].text, "feels right, after 1 edit: 2 strokes on Touch, A");
}

TEST_F(BundleMakerTest, IsOldOnceTheForcesOfTheOpenModelAreOthers) {
  acceptHole();
  maker.make(place);
  waitForEnd();
  ASSERT_TRUE(maker.delivered());
  auto other = bench.edits.model();
  other.name = "another name";
  bench.edits.apply(editing::finished(other, "name"));
  EXPECT_FALSE(maker.isOld());
  other.experts[0].rules[0].weight = 0.5;
  bench.edits.apply(editing::finished(other, "weight"));
  EXPECT_TRUE(maker.isOld());
  bench.edits.undo();
  EXPECT_FALSE(maker.isOld());
}

TEST_F(BundleMakerTest, AHoleThatNobodyAcceptedIsRefusedWithItsName) {
  maker.make(place);
  waitForEnd();
  EXPECT_FALSE(maker.delivered());
  EXPECT_TRUE(maker.failure().contains(QStringLiteral("depth 5 to 6 mm"))) << maker.failure().toStdString();
  EXPECT_FALSE(QDir(place).exists());
}

TEST_F(BundleMakerTest, CanceledItLeavesNothing) {
  acceptHole();
  maker.make(place);
  maker.cancel();
  EXPECT_FALSE(maker.mayCancel());
  waitForEnd();
  EXPECT_EQ(maker.failure(), QStringLiteral("Canceled: nothing was written."));
  EXPECT_FALSE(QDir(folder.path(QStringLiteral("new"))).exists());
}

TEST_F(BundleMakerTest, ItsEndCancelsTheWork) {
  acceptHole();
  {
    BundleMaker leaving(bench.edits);
    leaving.make(place);
  }
  EXPECT_FALSE(QDir(place).exists());
}

TEST_F(BundleMakerTest, AFolderWithOtherFilesIsLeftAlone) {
  acceptHole();
  const QString taken = folder.path(QString());
  maker.make(taken);
  waitForEnd();
  EXPECT_FALSE(maker.delivered());
  EXPECT_TRUE(maker.failure().contains(QStringLiteral("a new or empty folder"))) << maker.failure().toStdString();
  EXPECT_TRUE(QFile::exists(folder.path(QStringLiteral("sample.tactus.json"))));
}

TEST_F(BundleMakerTest, SaysWhatIsWrongWithABundle) {
  maker.readBack(place);
  waitForEnd();
  EXPECT_TRUE(maker.failure().contains(QStringLiteral("wanted the folder of a bundle")))
      << maker.failure().toStdString();
  acceptHole();
  maker.make(place);
  waitForEnd();
  QFile checks(place + QStringLiteral("/checks.csv"));
  ASSERT_TRUE(checks.open(QIODevice::Append));
  checks.write("\n");
  checks.close();
  maker.readBack(place);
  waitForEnd();
  ASSERT_TRUE(maker.delivered());
  EXPECT_FALSE(maker.delivered()->made);
  EXPECT_FALSE(maker.delivered()->ok);
}

TEST_F(BundleMakerTest, GoesIntoAFolderOfItsOwn) {
  const QString model = folder.path(QStringLiteral("sample.tactus.json"));
  EXPECT_EQ(bundleFolder(folder.path(QStringLiteral("free")), model), folder.path(QStringLiteral("free")));
  const QString taken = QDir(folder.path(QStringLiteral("."))).canonicalPath();
  EXPECT_EQ(bundleFolder(taken, model), taken + QStringLiteral("/sample-bundle"));
  EXPECT_EQ(bundleFolder(taken, QStringLiteral("/a/ngt.tactus")), taken + QStringLiteral("/ngt-bundle"));
}

TEST_F(BundleMakerTest, ReadinessCountsTheEditsSinceASignOff) {
  ReadinessController readiness(bench.models, bench.edits, maker);
  const auto sign_off = [&] { return readiness.lines()[static_cast<std::size_t>(ReadinessTopic::kSignOff)]; };
  acceptHole();
  auto other = bench.edits.model();
  other.experts[0].rules[0].weight = 0.5;
  bench.edits.apply(editing::finished(other, "weight"));
  EXPECT_TRUE(sign_off().sentence.contains(QStringLiteral("2 edit"))) << sign_off().sentence.toStdString();
  bench.edits.signOff(QStringLiteral("S4"));
  EXPECT_EQ(sign_off().sentence, QStringLiteral("S4 approved this state without feeling it."));
  bench.edits.setFelt({1, "Touch", false, {}});
  bench.edits.signOff(QStringLiteral("S4"));
  EXPECT_EQ(sign_off().state, Readiness::kReady);
  EXPECT_TRUE(sign_off().sentence.startsWith(QStringLiteral("S4")));
  other.experts[0].rules[0].weight = 0.25;
  bench.edits.apply(editing::finished(other, "weight"));
  EXPECT_TRUE(sign_off().sentence.contains(QStringLiteral("the last"))) << sign_off().sentence.toStdString();
}

}  // namespace
}  // namespace tactus::workbench
