// What the window offers where the history of the edits is not kept or not read.
#include <QDir>
#include <QFile>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTest>
#include <gtest/gtest.h>

#include "app/editing/membership_edits.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/workbench.h"

#include "tests/gui/sample_models.h"
#include "tests/gui/sample_study.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;

/// A window of the program, with the folder of the histories.
struct HistoryWindow {
  explicit HistoryWindow(const QString& root) : settings(root + QStringLiteral(".ini"), QSettings::IniFormat) {
    bench = std::make_unique<Workbench>(settings, root);
    bench->window.show();
  }
  QPushButton* act(const QString& words) const {
    for (QPushButton* button : bench->window.banner().findChildren<QPushButton*>()) {
      if (button->isVisible() && button->text() == words) return button;
    }
    return nullptr;
  }
  void edit(double to) const {
    ASSERT_TRUE(bench->edits.apply(editing::moveVertex(bench->edits.model(), tests::kNearShoulder, to)));
  }
  void openAndLook(const QString& path) const {
    const QSignalSpy looked(&bench->autosave, &AutosaveController::lookedUp);
    bench->files.open(path);
    ASSERT_TRUE(comesTrue([&] { return !looked.isEmpty(); }));
  }

  QSettings settings;
  std::unique_ptr<Workbench> bench;
};

class RecoveryFeatureTest : public testing::Test {
 protected:
  /// A run that leaves a history with one edit.
  void leaveHistory() const {
    const HistoryWindow run(root);
    run.openAndLook(path);
    run.edit(3);
    run.bench->models.save();
  }
  QString historyFile() const {
    const QStringList files = QDir(root).entryList({QStringLiteral("*.tactus")}, QDir::Files);
    EXPECT_EQ(files.size(), 1);
    return QDir(root).filePath(files.value(0));
  }

  tests::ModelFolder folder;
  const QString root = folder.path(QStringLiteral("autosave"));
  const QString path = folder.write(tests::twoExperts());
};

TEST_F(RecoveryFeatureTest, WhereNothingIsAutosavedTheModelCanBeSavedAndALaterSuccessEndsTheMessage) {
  folder.writeText("", QStringLiteral("autosave"));  // a file stands where the folder has to be
  const HistoryWindow run(root);
  run.openAndLook(path);
  run.edit(3);
  run.bench->autosave.flush();
  ASSERT_TRUE(comesTrue([&] { return run.act(QStringLiteral("Save the model")) != nullptr; }));
  EXPECT_TRUE(run.bench->window.banner().message().startsWith(QStringLiteral("Autosave failed")));
  ASSERT_TRUE(QFile::remove(root));
  run.edit(2);
  run.bench->autosave.flush();
  EXPECT_TRUE(comesTrue([&] { return !run.bench->window.banner().isVisible(); }));
  run.bench->models.save();
}

TEST_F(RecoveryFeatureTest, TheModelIsSavedByTheButtonBesideTheMessage) {
  folder.writeText("", QStringLiteral("autosave"));
  const HistoryWindow run(root);
  run.openAndLook(path);
  run.edit(3);
  run.bench->autosave.flush();
  ASSERT_TRUE(comesTrue([&] { return run.act(QStringLiteral("Save the model")) != nullptr; }));
  run.act(QStringLiteral("Save the model"))->click();
  EXPECT_FALSE(run.bench->models.isModified());
}

TEST_F(RecoveryFeatureTest, AHistoryThatWasNotReadIsLookedForAgain) {
  leaveHistory();
  const QString file = historyFile();
  ASSERT_TRUE(QFile::copy(file, folder.path(QStringLiteral("good"))));
  QFile damaged(file);
  ASSERT_TRUE(damaged.open(QIODevice::WriteOnly));
  damaged.write(QByteArray(5000, 'x'));
  damaged.close();
  const HistoryWindow run(root);
  run.openAndLook(path);
  ASSERT_NE(run.act(QStringLiteral("Open the model again")), nullptr)
      << run.bench->window.banner().message().toStdString();
  EXPECT_TRUE(run.bench->window.banner().message().startsWith(QStringLiteral("The earlier history of ")));
  // The file comes back from a backup.
  ASSERT_TRUE(QFile::remove(file));
  ASSERT_TRUE(QFile::copy(folder.path(QStringLiteral("good")), file));
  run.act(QStringLiteral("Open the model again"))->click();
  EXPECT_TRUE(comesTrue([&] { return run.bench->edits.history().states().size() == 2; }));
}

TEST_F(RecoveryFeatureTest, AHistoryThatDoesNotFitOpensAsAStudy) {
  leaveHistory();
  fuzzy::ForceModel other = tests::twoExperts();
  other.inputs.push_back(other.inputs.back());
  other.inputs.back().id = "angle";
  folder.write(other);
  const HistoryWindow run(root);
  run.openAndLook(path);
  ASSERT_NE(run.act(QStringLiteral("Open the earlier history")), nullptr)
      << run.bench->window.banner().message().toStdString();
  run.act(QStringLiteral("Open the earlier history"))->click();
  ASSERT_TRUE(comesTrue([&] { return run.bench->study.isOpen() && !run.bench->study.isOpening(); }));
  EXPECT_TRUE(run.bench->study.path().contains(QStringLiteral("-before-1.tactus")));
}

}  // namespace
}  // namespace tactus::workbench
