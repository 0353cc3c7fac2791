// A study with a tuned model, opened in the workbench's controllers.
#pragma once

#include <QString>
#include <atomic>
#include <gtest/gtest.h>
#include <memory>
#include <semaphore>
#include <vector>

#include "app/editing/history_versions.h"
#include "app/editing/membership_edits.h"
#include "app/workbench/study/study_models.h"
#include "core/model_io/model_file.h"
#include "core/store/model_versions.h"

#include "tests/gui/sample_models.h"
#include "tests/gui/sample_study.h"

namespace tactus::workbench {

using tests::kNearShoulder;

class StudyModelsTest : public testing::Test {
 protected:
  StudyModelsTest() {
    const auto on_said = [this](const QString& sentence) { said = sentence; };
    const auto on_failed = [this](const QString&, const QString& sentence) { failed = sentence; };
    QObject::connect(study.get(), &StudyConnection::said, on_said);
    QObject::connect(kept.get(), &StudyModels::said, on_said);
    QObject::connect(kept.get(), &StudyModels::buildOffered, [this](const QString& sentence) { offered = sentence; });
    QObject::connect(study.get(), &StudyConnection::failed, on_failed);
    QObject::connect(kept.get(), &StudyModels::failed, on_failed);
  }

  // A study with the sample model, opened and moved to 3 and 2, then back to 3.
  void makeTuned() {
    tests::makeStudyFile(path, [](store::StudyFile& file, study::RecordIds& ids) {
      auto history = *editing::EditHistory::open(tests::twoExperts(), "Opened", {"anna", 1}, ids);
      for (const double to : {3.0, 2.0}) {
        history.apply(*editing::moveVertex(history.model(), kNearShoulder, to), {"anna", 2});
      }
      ASSERT_TRUE(history.undo({"anna", 3}));
      for (const auto& version : editing::unstoredVersions(history)) ASSERT_TRUE(store::append(file, version));
    });
  }
  void end() {
    kept.reset();
    study.reset();
  }
  bool open(const QString& file) {
    failed.clear();
    study->open(file);
    return tests::comesTrue([this] { return !study->isOpening(); }) && failed.isEmpty();
  }
  // Until `disk` is released, nothing more is written; from the moment on at which the study is left.
  void hangOnLeaving(const std::shared_ptr<std::binary_semaphore>& disk) {
    QObject::connect(study.get(), &StudyConnection::leaving, [this, disk] {
      left = true;
      study->order([disk](store::StudyFile&, study::RecordIds&) -> base::Result<void> {
        disk->acquire();
        return {};
      });
    });
  }
  // Nothing is written until the disk is told not to be full any more.
  std::shared_ptr<std::atomic<bool>> fillDisk() {
    auto full = std::make_shared<std::atomic<bool>>(true);
    study->order([full](store::StudyFile&, study::RecordIds&) -> base::Result<void> {
      if (*full) return base::fail(base::ErrorCode::kIo, "disk", "no space left", "free space");
      return {};
    });
    return full;
  }
  void move(double to) { ASSERT_TRUE(edits.apply(editing::moveVertex(edits.model(), kNearShoulder, to))); }
  double shoulder() const { return models.current()->model.inputs[1].terms[0].points[2]; }
  bool allWritten() {
    return tests::comesTrue([this] { return !study->isBusy(); });
  }
  std::vector<study::ModelVersion> versions(const QString& file) {
    return *store::modelVersions(tests::lookInto(file));
  }
  std::vector<study::ModelVersion> versions() { return versions(path); }
  double storedShoulder() {
    const auto version = *store::latestModelVersion(tests::lookInto(path));
    return model_io::parseModel(version->text, "stored")->model.inputs[1].terms[0].points[2];
  }

  tests::ModelFolder folder;
  QString path = folder.path(QStringLiteral("sample.tactus"));
  ModelController models;
  EditController edits{models};
  std::unique_ptr<StudyConnection> study = std::make_unique<StudyConnection>();
  std::unique_ptr<StudyModels> kept = std::make_unique<StudyModels>(*study, models, edits);
  QString said;
  QString offered;
  QString failed;
  bool left = false;
};

}  // namespace tactus::workbench
