// One run of the program with an autosave, and the folder in which the runs keep histories.
#pragma once

#include <QDir>
#include <QSignalSpy>
#include <QTest>
#include <gtest/gtest.h>
#include <vector>

#include "app/editing/membership_edits.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/tune/history/autosave_controller.h"

#include "tests/gui/patience.h"
#include "tests/gui/sample_models.h"

namespace tactus::workbench {

/// One run of the program.
struct AutosavedRun {
  explicit AutosavedRun(const QString& root) : autosave(models, edits, root) {}

  /// Opens `path`, and waits until its earlier history was looked for.
  void open(const QString& path) {
    QSignalSpy looked_up(&autosave, &AutosaveController::lookedUp);
    models.open(path);
    ASSERT_TRUE(looked_up.count() > 0 || looked_up.wait(tests::kPatience));
  }
  void edit(double to) { ASSERT_TRUE(edits.apply(editing::moveVertex(edits.model(), tests::kNearShoulder, to))); }
  double shoulder() const { return edits.model().inputs[1].terms[0].points[2]; }

  ModelController models;
  EditController edits{models};
  AutosaveController autosave;
};

class AutosaveTest : public testing::Test {
 protected:
  QStringList files() const { return QDir(root).entryList({QStringLiteral("*.tactus")}, QDir::Files, QDir::Name); }
  /// The versions in the only history file, which no program has open.
  std::vector<study::ModelVersion> versions() const {
    EXPECT_EQ(files().size(), 1);
    const auto work = HistoryFile::read(QDir(root).filePath(files().value(0)), true);
    EXPECT_TRUE(work) << work.error().message();
    return work ? work->kept.versions : std::vector<study::ModelVersion>();
  }
  /// A run that edits the model and saves it.
  void editAndSave() const {
    AutosavedRun run(root);
    run.open(path);
    run.edit(3);
    run.models.save();
  }

  tests::ModelFolder folder;
  const QString root = folder.path(QStringLiteral("autosave"));
  const QString path = folder.write(tests::twoExperts());
};

}  // namespace tactus::workbench
