// From the Feel layout into a study: without one the card of the recordings offers it, and the recording waits for
// Start.
#include <QApplication>
#include <QFileDialog>
#include <QPushButton>
#include <QSettings>
#include <QTest>
#include <QTimer>
#include <gtest/gtest.h>

#include "app/workbench/features/features.h"
#include "app/workbench/feel/recordings/recordings_card.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/workbench.h"

#include "tests/gui/sample_models.h"
#include "tests/gui/sample_study.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;

class RecordIntoStudy : public testing::Test {
 protected:
  void SetUp() override {
    bench.window.resize(1280, 720);
    bench.window.show();
    bench.models.open(folder.write(tests::twoExperts()));
    bench.window.enter(Stage::kTune);
    bench.window.enterLayout(feelLayout());
    QCoreApplication::processEvents();
  }

  QPushButton* button(const QWidget& place, const QString& words) const {
    for (QPushButton* one : place.findChildren<QPushButton*>()) {
      if (one->isVisible() && one->text() == words) return one;
    }
    return nullptr;
  }
  RecordingsCard& card() { return *bench.window.findChild<RecordingsCard*>(); }
  /// Presses the button and answers the dialog with `path`.
  void choose(const QString& path) {
    QTimer answer;
    QObject::connect(&answer, &QTimer::timeout, &answer, [&] {
      auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      if (dialog == nullptr) return;
      answer.stop();
      dialog->selectFile(path);
      static_cast<QDialog*>(dialog)->accept();
    });
    answer.start(5);
    button(card(), QStringLiteral("Record into a study…"))->click();
  }

  tests::ModelFolder folder;
  QSettings settings{folder.path(QStringLiteral("settings.ini")), QSettings::IniFormat};
  Workbench bench{settings, folder.path(QStringLiteral("autosave"))};
};

TEST_F(RecordIntoStudy, ANewStudyTakesTheRecordingOfTheOpenModel) {
  ASSERT_NE(button(card(), QStringLiteral("Record into a study…")), nullptr);
  const QString path = folder.path(QStringLiteral("strokes.tactus"));
  choose(path);
  ASSERT_TRUE(comesTrue([&] { return bench.study.isOpen() && bench.feel_store.isRecording(); }));
  EXPECT_EQ(bench.study.path(), path);
  // The model stays, and so does the layout.
  EXPECT_EQ(bench.window.layoutBeside(), feelLayout());
  EXPECT_EQ(bench.window.stage(), Stage::kTune);
  EXPECT_EQ(bench.models.current()->path, folder.path(QStringLiteral("sample.tactus.json")));
  EXPECT_NE(button(card(), QStringLiteral("Armed")), nullptr);
  EXPECT_EQ(button(card(), QStringLiteral("Record into a study…")), nullptr);
  EXPECT_FALSE(bench.window.banner().isVisible()) << bench.window.banner().message().toStdString();
}

TEST_F(RecordIntoStudy, AStudyThatIsThereIsOpened) {
  const QString path = folder.path(QStringLiteral("ward.tactus"));
  tests::makeStudyFile(
      path, [](store::StudyFile& file, study::RecordIds& ids) { tests::addVisit(file, ids, "velvet-otter", false); });
  choose(path);
  ASSERT_TRUE(comesTrue([&] { return bench.study.isOpen() && bench.feel_store.isRecording(); }));
  EXPECT_EQ(bench.study.people().size(), 1U);
  EXPECT_EQ(bench.window.layoutBeside(), feelLayout());
}

TEST_F(RecordIntoStudy, AFileThatIsNoStudyOffersAnotherOne) {
  const QString path = folder.writeText("no study", QStringLiteral("notes.tactus"));
  choose(path);
  ASSERT_TRUE(comesTrue([&] { return bench.window.banner().isVisible(); }));
  EXPECT_NE(button(bench.window.banner(), QStringLiteral("Open another file…")), nullptr);
  EXPECT_FALSE(bench.study.isOpen());
}

TEST_F(RecordIntoStudy, AnErrorOfARecordingIsOfferedAgain) {
  choose(folder.path(QStringLiteral("strokes.tactus")));
  ASSERT_TRUE(comesTrue([&] { return bench.feel_store.isRecording(); }));
  // Of a person whom the study does not know.
  bench.feel_store.setWho(study::RecordIds(99).next());
  bench.feel.start(QStringLiteral("virtual"));
  ASSERT_TRUE(comesTrue([&] { return button(bench.window.banner(), QStringLiteral("Record again")) != nullptr; }))
      << bench.window.banner().message().toStdString();
  bench.feel_store.setWho(std::nullopt);
  button(bench.window.banner(), QStringLiteral("Record again"))->click();
  EXPECT_TRUE(bench.feel_store.isRecording());
  ASSERT_TRUE(comesTrue([&] { return !bench.study.recordings().empty(); }));
  bench.feel.stop();
}

}  // namespace
}  // namespace tactus::workbench
