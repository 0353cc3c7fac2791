#include "app/workbench/views/curves_panel.h"

#include <QDropEvent>
#include <QLabel>
#include <QMimeData>
#include <QSettings>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <gtest/gtest.h>
#include <utility>

#include "app/workbench/models/reading_model.h"
#include "app/workbench/plots/curve_plot.h"
#include "app/workbench/views/curve_legend.h"
#include "app/workbench/views/message_banner.h"
#include "app/workbench/views/plot_menu.h"
#include "app/workbench/views/reference_bar.h"
#include "app/workbench/workbench.h"

#include "tests/gui/sample_models.h"

namespace tactus::workbench {
namespace {

constexpr int kSettled = 60;       // ms, some frames of the screen
constexpr int kPatience = 10'000;  // ms, for a busy machine

class CurvesPanelTest : public testing::Test {
 protected:
  void SetUp() override {
    bench.window.resize(1280, 800);
    bench.window.show();
    bench.models.open(folder.write(tests::twoExperts()));
    bench.window.enter(Stage::kTune);
    settle();
  }

  void settle() {
    QImage last;
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
          QTest::qWait(kSettled);
          const QImage now = bench.window.grab().toImage();
          return std::exchange(last, now) == now;
        },
        kPatience));
  }

  bool drop(const QString& path) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(path)});
    QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    enter.ignore();
    QCoreApplication::sendEvent(&panel, &enter);
    if (!enter.isAccepted()) return false;
    QDropEvent drop({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&panel, &drop);
    settle();
    return true;
  }

  bool says(const QWidget& place, const QString& words) {
    const QList<QLabel*> labels = place.findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) {
      return label->isVisible() && (label->text().contains(words) || label->toolTip().contains(words));
    });
  }

  LegendChip* chip(const QString& name) {
    for (LegendChip* chip : panel.findChildren<LegendChip*>()) {
      if (chip->isVisible() && chip->text() == name) return chip;
    }
    return nullptr;
  }

  QStringList legend() {
    QStringList names;
    for (const LegendEntry& entry : plot.legend()) names << entry.name;
    return names;
  }

  QImage picture() { return plot.grab().toImage(); }

  tests::ModelFolder folder;
  QSettings settings{folder.path(QStringLiteral("settings.ini")), QSettings::IniFormat};
  Workbench bench{settings};
  CurvesPanel& panel = *bench.window.findChild<CurvesPanel*>();
  CurvePlot& plot = *bench.window.findChild<CurvePlot*>();
};

TEST_F(CurvesPanelTest, AClickInTheLegendHidesALine) {
  const QImage before = picture();
  QTest::mouseClick(chip(QStringLiteral("B")), Qt::LeftButton);
  settle();
  EXPECT_FALSE(plot.isExpertShown(1));
  EXPECT_NE(picture(), before);
  EXPECT_EQ(legend(),
            (QStringList{QStringLiteral("Mean"), QStringLiteral("A"), QStringLiteral("Range of the experts")}));
  // Another axis brings new lines, and the line stays hidden.
  bench.scene.setXInput(0);
  settle();
  EXPECT_FALSE(plot.isExpertShown(1));
  QTest::mouseClick(chip(QStringLiteral("B")), Qt::LeftButton);
  bench.scene.setXInput(1);
  settle();
  EXPECT_EQ(picture(), before);
}

TEST_F(CurvesPanelTest, TheRangeCanBeTakenAway) {
  const QImage before = picture();
  QTest::mouseClick(chip(QStringLiteral("Range")), Qt::LeftButton);
  settle();
  EXPECT_NE(picture(), before);
  EXPECT_EQ(chip(QStringLiteral("± 1 SD")), nullptr);  // of two experts nobody offers one
}

TEST_F(CurvesPanelTest, AnEditLeavesAGhostAndSaysHowFarItWent) {
  EXPECT_TRUE(says(panel, QStringLiteral("nothing is edited yet")));
  const QImage fresh = picture();
  fuzzy::ForceModel model = tests::twoExperts();
  model.experts[0].rules[2].then = "low";
  ASSERT_TRUE(bench.edits.apply(editing::finished(model, "far is low")));
  settle();
  EXPECT_TRUE(says(panel, QStringLiteral("max ΔF 0.250 N (3.5 JND) at")));
  EXPECT_TRUE(legend().contains(QStringLiteral("Before the last edit")));
  const QImage with_ghost = picture();
  QTest::mouseClick(chip(QStringLiteral("Before the last edit")), Qt::LeftButton);
  settle();
  EXPECT_NE(picture(), with_ghost);
  EXPECT_FALSE(legend().contains(QStringLiteral("Before the last edit")));
  bench.edits.undo();
  settle();
  EXPECT_EQ(picture(), fresh);
}

TEST_F(CurvesPanelTest, AReferenceIsDroppedComparedAndTakenAway) {
  const QImage before = picture();
  // At depths from 7 to 10 the mean of the sample is 0.5 N, 0.2 N above the reference.
  ASSERT_TRUE(drop(folder.writeText("depth_mm,force_n\n7,0.3\n9,0.3\n", QStringLiteral("method two.csv"))));
  EXPECT_NE(picture(), before);
  EXPECT_TRUE(legend().contains(QStringLiteral("method two")));
  EXPECT_TRUE(says(panel, QStringLiteral("RMS 0.200 N · largest 0.200 N at 7 mm · over 7 to 9 mm")));

  // Expert A says 0.75 N there.
  bench.references.setExpert(0);
  settle();
  EXPECT_TRUE(says(panel, QStringLiteral("RMS 0.450 N")));
  fuzzy::ForceModel model = tests::twoExperts();
  model.experts[0].rules[2].then = "low";
  ASSERT_TRUE(bench.edits.apply(editing::finished(model, "far is low")));
  settle();
  EXPECT_TRUE(says(panel, QStringLiteral("RMS 0.050 N")));
  bench.edits.undo();

  // It belongs to its own axis.
  bench.scene.setXInput(0);
  settle();
  EXPECT_FALSE(legend().contains(QStringLiteral("method two")));
  bench.scene.setXInput(1);
  settle();
  const auto buttons = panel.findChild<ReferenceBar*>()->findChildren<QToolButton*>();
  ASSERT_EQ(buttons.size(), 1);
  QTest::mouseClick(buttons.first(), Qt::LeftButton);
  settle();
  EXPECT_EQ(picture(), before);
}

TEST_F(CurvesPanelTest, ABrokenReferenceGivesASentence) {
  ASSERT_TRUE(drop(folder.writeText("depth_mm,force_n\n9,0.3\n7,0.3\n", QStringLiteral("back.csv"))));
  EXPECT_TRUE(bench.window.banner().isVisible());
  EXPECT_TRUE(bench.window.banner().message().contains(QStringLiteral("line 3, column 'depth_mm'")));
  EXPECT_TRUE(bench.references.all().empty());
  EXPECT_FALSE(drop(folder.writeText("x", QStringLiteral("note.txt"))));
}

TEST_F(CurvesPanelTest, WhatWasSavedCanBeLaidOver) {
  const QString path = folder.path(QStringLiteral("saved.csv"));
  ASSERT_TRUE(panel.plotMenu().saveTable(path).has_value());
  ASSERT_TRUE(drop(path));
  // The model is compared with itself.
  ASSERT_EQ(bench.references.differences().size(), 1U);
  EXPECT_EQ(bench.references.differences().front()->largest_n, 0);
}

}  // namespace
}  // namespace tactus::workbench
