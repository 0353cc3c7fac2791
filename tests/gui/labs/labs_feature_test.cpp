// Stage Build in the window: where its labs lead.
#include <QFile>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <gtest/gtest.h>

#include "app/workbench/features/features.h"
#include "app/workbench/labs/experts/experts_lab.h"
#include "app/workbench/labs/experts/experts_lab_view.h"
#include "app/workbench/labs/frame/lab_screen.h"
#include "app/workbench/workbench.h"

#include "tests/gui/labs/lab_study_file.h"
#include "tests/gui/sample_study.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;

constexpr int kReportMs =
    300'000;  // a few seconds on a quiet machine; the work of a report gives way to everything else

class LabsFeatureTest : public testing::Test {
 protected:
  void SetUp() override {
    bench.window.resize(1280, 720);
    bench.window.show();
    bench.files.open(path);
    ASSERT_TRUE(comesTrue([this] { return bench.study.isOpen() && !bench.study.isOpening(); }));
  }

  QTemporaryDir folder;
  QString path = tests::demoStudyIn(folder);
  QSettings settings{folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat};
  Workbench bench{settings, folder.filePath(QStringLiteral("autosave"))};
};

TEST_F(LabsFeatureTest, TheAveragedModelWithTheLabsSettingsOpensInTheBench) {
  bench.window.enter(Stage::kBuild);
  auto wanted = bench.labs.data.settings();
  wanted.force_terms = elicitation::ForceTermsFrom::kThresholds;
  bench.labs.data.setSettings(wanted);
  auto* const experts = bench.views.labs->findChild<ExpertsLabView*>();
  ASSERT_NE(experts, nullptr);
  bench.views.labs->reveal(experts);
  emit experts->benchAsked();
  ASSERT_TRUE(comesTrue([this] { return bench.window.stage() == Stage::kTune; }));
  // elicitation.md 3, Table 2's split: the mean limits are .2 .325 .55 .775 N, with ramps of .05 N to both sides.
  const auto& small = bench.models.current()->model.output.terms[1].points;
  ASSERT_EQ(small.size(), 4U);
  EXPECT_NEAR(small[0], 0.15, 1e-9);
  EXPECT_NEAR(small[1], 0.25, 1e-9);
  EXPECT_NEAR(small[2], 0.275, 1e-9);
  EXPECT_NEAR(small[3], 0.375, 1e-9);
  EXPECT_TRUE(bench.study_models.keepsModel());
}

// The lab of the experts and the bench look at one place.
TEST_F(LabsFeatureTest, TheExpertsAreShownAtTheOperatingPointOfTheBench) {
  bench.study_models.buildModel();
  ASSERT_TRUE(comesTrue([this] { return bench.scene.model() != nullptr; }));
  const auto neck = inputNamed(bench.scene.model()->model, "neck_flexion");
  const auto speed = inputNamed(bench.scene.model()->model, "speed");
  ASSERT_TRUE(neck && speed);
  bench.scene.setValue(*neck, 82);
  bench.window.enter(Stage::kBuild);
  auto* const view = bench.views.labs->findChild<ExpertsLabView*>();
  bench.views.labs->reveal(view);
  auto* const lab = bench.views.labs->findChild<ExpertsLab*>();
  ASSERT_NE(lab, nullptr);
  ASSERT_TRUE(comesTrue([&] { return lab->built() != nullptr; }));
  const auto in_lab = [&](const char* id) { return lab->values()[*inputNamed(lab->built()->model, id)]; };
  EXPECT_EQ(in_lab("neck_flexion"), 82);
  bench.scene.setValue(*speed, 21);
  EXPECT_EQ(in_lab("speed"), 21);
  lab->setValueOf("neck_flexion", 40);
  EXPECT_EQ(bench.scene.value(*neck), 40);
  // What the lab's model cannot show stays where it is, there and in the bench.
  lab->setValueOf("neck_flexion", 1000);
  EXPECT_EQ(bench.scene.value(*neck), 40);
}

// By the paper's numbers, in the words that people type.
TEST_F(LabsFeatureTest, TheSearchLeadsToTheTablesAndFiguresOfThePaper) {
  const auto first = [this](const QString& typed) {
    QList<SearchEntry> all;
    for (const SearchSource& source : bench.search->sources()) all << source();
    const auto found = foundEntries(all, typed);
    if (!found.isEmpty()) found.front().run();
    return found.isEmpty() ? QString() : found.front().text;
  };
  const auto inFront = [this](const char* name) {
    auto* const widget = bench.views.labs->findChild<QWidget*>(QLatin1String(name));
    return widget != nullptr && widget->isVisible();
  };
  EXPECT_TRUE(first(QStringLiteral("table 3")).startsWith(QStringLiteral("Table 3")));
  EXPECT_EQ(bench.window.stage(), Stage::kBuild);
  EXPECT_TRUE(inFront("usability"));
  EXPECT_TRUE(first(QStringLiteral("fig. 6")).startsWith(QStringLiteral("Fig. 6")));
  EXPECT_TRUE(inFront("strokes"));
  EXPECT_TRUE(first(QStringLiteral("figure 7")).startsWith(QStringLiteral("Fig. 7")));
  EXPECT_FALSE(inFront("strokes"));
  EXPECT_TRUE(inFront("speed"));
  for (const char* number : {"table 1", "table 2", "figure 3d", "figure 3e", "figure 4", "figure 8"}) {
    EXPECT_FALSE(first(QLatin1String(number)).isEmpty()) << number;
  }
}

TEST_F(LabsFeatureTest, TheReportOfTheStudyIsWrittenWhole) {
  const QString report = folder.filePath(QStringLiteral("report.html"));
  QSignalSpy written(bench.report, &ReportFeature::written);
  bench.report->write(report);
  EXPECT_TRUE(bench.report->isBusy());
  ASSERT_TRUE(QTest::qWaitFor([&] { return written.size() == 1; }, kReportMs));
  QFile file(report);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const QByteArray page = file.readAll();
  EXPECT_TRUE(page.startsWith("<!"));
  EXPECT_TRUE(page.contains("</html>"));
  QSignalSpy failed(bench.report, &ReportFeature::failed);
  bench.report->write(folder.filePath(QStringLiteral("no/such/folder.html")));
  ASSERT_TRUE(QTest::qWaitFor([&] { return failed.size() == 1; }, kReportMs));
}

}  // namespace
}  // namespace tactus::workbench
