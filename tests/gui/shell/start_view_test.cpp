#include "app/workbench/shell/start_view.h"

#include <QDir>
#include <QFile>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <gtest/gtest.h>

#include "app/workbench/kit/notes.h"
#include "app/workbench/shell/demo_maker.h"
#include "app/workbench/shell/panel_area.h"
#include "app/workbench/shell/recent_files.h"
#include "app/workbench/workbench.h"

#include "tests/gui/sample_models.h"
#include "tests/gui/sample_study.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;

TEST(RecentFiles, KeepTheNameOfTheModelAndTheTime) {
  const QTemporaryDir folder;
  QSettings settings(folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat);
  RecentFiles recent(settings);
  recent.add(QStringLiteral("/a/one.tactus"));
  recent.add(QStringLiteral("/a/two.json"), QStringLiteral("Two"));
  recent.add(QStringLiteral("/a/one.tactus"), QStringLiteral("One"));
  recent.add(QStringLiteral("/a/one.tactus"));
  const QList<RecentFile> files = RecentFiles(settings).files();
  ASSERT_EQ(files.size(), 2);
  EXPECT_EQ(files[0].path, QStringLiteral("/a/one.tactus"));
  EXPECT_EQ(files[0].model, QStringLiteral("One"));
  EXPECT_TRUE(files[0].opened.isValid());
  EXPECT_EQ(files[1].model, QStringLiteral("Two"));
  recent.remove(QStringLiteral("/a/one.tactus"));
  EXPECT_EQ(recent.paths(), QStringList{QStringLiteral("/a/two.json")});
}

TEST(RecentFiles, OfAnOlderProgramAreStillThere) {
  const QTemporaryDir folder;
  QSettings settings(folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat);
  settings.setValue(QStringLiteral("recent_models"), QStringList{QStringLiteral("/a"), QStringLiteral("/b")});
  RecentFiles recent(settings);
  EXPECT_EQ(recent.paths(), (QStringList{QStringLiteral("/a"), QStringLiteral("/b")}));
  recent.add(QStringLiteral("/b"));
  EXPECT_EQ(recent.paths(), (QStringList{QStringLiteral("/b"), QStringLiteral("/a")}));
}

TEST(RecentFiles, SayWhen) {
  const QDateTime now(QDate(2026, 11, 23), QTime(9, 0));
  EXPECT_EQ(whenText(QDateTime(QDate(2026, 11, 23), QTime(7, 5)), now), QStringLiteral("today 07:05"));
  EXPECT_EQ(whenText(QDateTime(QDate(2026, 11, 22), QTime(23, 59)), now), QStringLiteral("yesterday"));
  EXPECT_TRUE(whenText(QDateTime(QDate(2026, 11, 21), QTime(9, 0)), now).contains(QStringLiteral("21")));
  EXPECT_EQ(whenText({}, now), QString());
}

class StartViewTest : public testing::Test {
 protected:
  void SetUp() override {
    bench.window.resize(1280, 720);
    bench.window.show();
    bench.demo.setDocuments(folder.path(QStringLiteral("documents")));
  }
  StartEntry* entry(const QString& name) {
    for (auto* one : bench.views.start->findChildren<StartEntry*>()) {
      if (one->text() == name) return one;
    }
    return nullptr;
  }

  tests::ModelFolder folder;
  QSettings settings{folder.path(QStringLiteral("settings.ini")), QSettings::IniFormat};
  Workbench bench{settings, folder.path(QStringLiteral("autosave"))};
};

// The filled button leads to the demo on the first day, and to what was open last on the days after.
TEST_F(StartViewTest, TheLastFileIsTheWayOnByItsName) {
  EXPECT_TRUE(entry(QStringLiteral("Explore the demo study"))->isPrimary());
  bench.recent.add(folder.path(QStringLiteral("first.tactus")), QStringLiteral("The same model"));
  bench.recent.add(folder.path(QStringLiteral("second.tactus")), QStringLiteral("The same model"));
  EXPECT_FALSE(entry(QStringLiteral("Explore the demo study"))->isPrimary());
  ASSERT_NE(entry(QStringLiteral("second.tactus")), nullptr);
  ASSERT_NE(entry(QStringLiteral("first.tactus")), nullptr);
  EXPECT_TRUE(entry(QStringLiteral("second.tactus"))->isPrimary());
  EXPECT_FALSE(entry(QStringLiteral("first.tactus"))->isPrimary());
}

// From the first start to a model on the screen: one click.
TEST_F(StartViewTest, TheDemoStudyIsOneClickAway) {
  StartEntry* explore = entry(QStringLiteral("Explore the demo study"));
  ASSERT_NE(explore, nullptr);
  EXPECT_FALSE(entry(QStringLiteral("Make a fresh copy of the demo"))->isVisible());
  QTest::mouseClick(explore, Qt::LeftButton);
  EXPECT_TRUE(bench.demo.isMaking());
  EXPECT_FALSE(explore->isEnabled());
  // Sessions and model take seconds, on a busy machine more.
  ASSERT_TRUE(QTest::qWaitFor([this] { return bench.models.current() != nullptr; }, 60'000));
  EXPECT_EQ(bench.window.stage(), Stage::kUnderstand);
  const QString study = folder.path(QStringLiteral("documents/Tactus demo/study/ngt-demo.tactus"));
  EXPECT_TRUE(QFile::exists(study));
  EXPECT_EQ(bench.study.path(), study);
  EXPECT_TRUE(bench.models.current()->simulated);
  EXPECT_EQ(bench.recent.files().value(0).path, study);
  EXPECT_EQ(bench.recent.files().value(0).model, QString::fromStdString(bench.models.current()->model.name));
  // The copy is the user's: it is opened again, not made again.
  QSignalSpy ready(&bench.demo, &DemoMaker::ready);
  bench.demo.explore();
  EXPECT_EQ(ready.size(), 1);
  // What follows the study is written in the background.
  ASSERT_TRUE(QTest::qWaitFor([this] { return !bench.demo.isMaking(); }, 60'000));
  EXPECT_TRUE(QFile::exists(folder.path(QStringLiteral("documents/Tactus demo/report.html"))));
}

TEST_F(StartViewTest, ADemoThatCannotBeMadeIsASentence) {
  QFile file(folder.path(QStringLiteral("documents")));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));  // a file in the place of the folder
  file.close();
  bench.demo.explore();
  ASSERT_TRUE(comesTrue([this] { return !bench.demo.isMaking(); }));
  EXPECT_TRUE(bench.window.banner().message().startsWith(QStringLiteral("The demo study was not made.")))
      << bench.window.banner().message().toStdString();
}

TEST_F(StartViewTest, ANewModelHasTheInputsOfTheProcedureAndNoRules) {
  StartEntry* make = entry(QStringLiteral("New model from the template"));
  ASSERT_NE(make, nullptr);
  QTest::keyClick(make, Qt::Key_Return);
  ASSERT_NE(bench.models.current(), nullptr);
  const fuzzy::ForceModel& model = bench.models.current()->model;
  ASSERT_EQ(model.inputs.size(), 4U);
  EXPECT_EQ(model.inputs[2].id, "depth");
  ASSERT_EQ(model.experts.size(), 1U);
  EXPECT_TRUE(model.experts[0].rules.empty());
  EXPECT_TRUE(bench.models.isModified());
  EXPECT_EQ(bench.window.stage(), Stage::kTune);
  EXPECT_TRUE(bench.panels.rule_editor->isVisible());
  EXPECT_FALSE(bench.window.panels().isBehind(*bench.panels.rule_editor));
}

TEST_F(StartViewTest, TablesBecomeAStudy) {
  const QString tables = folder.path(QStringLiteral("tables"));
  ASSERT_TRUE(QDir().mkpath(tables));
  QFile people(tables + QStringLiteral("/participants.csv"));
  ASSERT_TRUE(people.open(QIODevice::WriteOnly));
  people.write("participant,years_experience,category,handedness,weight,simulated\nS1,12,,right,1,1\n");
  people.close();
  QFile speeds(tables + QStringLiteral("/speeds.csv"));
  ASSERT_TRUE(speeds.open(QIODevice::WriteOnly));
  speeds.write("participant,level,stroke,time_s,depth_mm,speed_mm_s\nS1,slow,1,0,10,40\nS1,fast,1,0,10,200\n");
  speeds.close();
  const QString path = folder.path(QStringLiteral("made.tactus"));
  bench.tables.run(tables, path, true);
  ASSERT_TRUE(comesTrue([this] { return bench.study.isOpen(); })) << bench.window.banner().message().toStdString();
  EXPECT_EQ(bench.study.path(), path);
  ASSERT_EQ(bench.study.people().size(), 1U);
}

TEST_F(StartViewTest, TablesThatCannotBeReadLeaveNothing) {
  const QString path = folder.path(QStringLiteral("made.tactus"));
  bench.tables.run(folder.path(QStringLiteral("nowhere")), path, false);
  ASSERT_TRUE(comesTrue([this] { return !bench.tables.isRunning(); }));
  EXPECT_TRUE(bench.window.banner().message().startsWith(QStringLiteral("The tables were not imported.")));
  EXPECT_FALSE(QFile::exists(path));
}

}  // namespace
}  // namespace tactus::workbench
