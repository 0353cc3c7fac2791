// At each size of the text, in a window of 1280 x 720 px, no label, button,
// choice or tab is cut.
#include <QSettings>
#include <QTest>
#include <gtest/gtest.h>

#include "app/workbench/base/appearance.h"
#include "app/workbench/shell/panel.h"
#include "app/workbench/shell/panel_area.h"
#include "app/workbench/workbench.h"

#include "tests/gui/cut_texts.h"
#include "tests/gui/sample_study.h"
#include "tests/gui/shown_bench.h"
#include "tests/support/ngt_model.h"

namespace tactus::workbench {
namespace {

fuzzy::ForceModel fourNurses() {
  fuzzy::ForceModel model = support::s4FiveRegions();
  for (const char* id : {"S1", "S2", "S3"}) {
    model.experts.push_back(model.experts.front());
    model.experts.back().id = id;
  }
  return model;
}

class TextSize : public testing::TestWithParam<int> {
 protected:
  void SetUp() override {
    bench.window.resize(1280, 720);
    bench.window.show();
  }
  void TearDown() override { appearance::changeTextSize(*qApp, 100); }

  void openModel() {
    bench.models.open(folder.write(fourNurses()));
    appearance::changeTextSize(*qApp, GetParam());
  }
  void openStudy() {
    const QString path = folder.path(QStringLiteral("ward-7-autumn.tactus"));
    tests::makeStudyFile(path);
    bench.study.open(path);
    ASSERT_TRUE(tests::comesTrue([this] { return bench.study.isOpen() && !bench.study.isOpening(); }));
    bench.window.banner().hide();
  }

  void expectWhole(const QString& screen) {
    tests::settle(bench.window);
    ASSERT_EQ(bench.window.size(), QSize(1280, 720)) << screen.toStdString();
    const QByteArray pictures = qgetenv("TACTUS_PICTURES");
    if (!pictures.isEmpty()) {
      const QString name = QStringLiteral("/%1-%2.png").arg(screen).arg(GetParam());
      EXPECT_TRUE(bench.window.grab().save(QString::fromLocal8Bit(pictures) + name));
    }
    const QStringList cut = tests::cutTexts(bench.window);
    EXPECT_TRUE(cut.isEmpty()) << screen.toStdString() << ":\n  " << cut.join(QStringLiteral("\n  ")).toStdString();
  }
  /// The layout of `stage`, and each panel behind a tab.
  void expectStageWhole(Stage stage) {
    bench.window.enter(stage);
    expectWhole(stageId(stage));
    QList<Panel*> behind;
    for (Panel* panel : bench.window.panels().panels()) {
      if (bench.window.panels().isBehind(*panel)) behind << panel;
    }
    for (Panel* panel : behind) {
      panel->reveal();
      expectWhole(stageId(stage) + QLatin1Char('-') + panel->objectName());
    }
  }

  tests::ModelFolder folder;
  QSettings settings{folder.path(QStringLiteral("settings.ini")), QSettings::IniFormat};
  Workbench bench{settings, folder.path(QStringLiteral("autosave"))};
};

TEST_P(TextSize, NothingIsCutWhereAModelIsUnderstoodAndDelivered) {
  openModel();
  expectStageWhole(Stage::kUnderstand);
  expectStageWhole(Stage::kDeliver);
}

TEST_P(TextSize, NothingIsCutWhereAModelIsTuned) {
  openModel();
  expectStageWhole(Stage::kTune);
}

TEST_P(TextSize, NothingIsCutWhereAModelIsFelt) {
  openModel();
  bench.window.enter(Stage::kTune);
  bench.window.enterLayout(FeelParts::layoutId());
  expectWhole(QStringLiteral("feel"));
  openStudy();
  bench.window.enterLayout(FeelParts::layoutId());
  expectWhole(QStringLiteral("feel-study"));
}

TEST_P(TextSize, NothingIsCutAtTheStartAndInCollect) {
  appearance::changeTextSize(*qApp, GetParam());
  expectWhole(QStringLiteral("start"));
  openStudy();
  bench.window.enter(Stage::kCollect);
  expectWhole(QStringLiteral("collect"));
}

INSTANTIATE_TEST_SUITE_P(Percent, TextSize, testing::Values(90, 100, 110, 130, 150),
                         [](const testing::TestParamInfo<int>& size) { return std::to_string(size.param); });

}  // namespace
}  // namespace tactus::workbench
