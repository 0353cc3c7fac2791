// A study with two recorded strokes, felt on the open model through the servo and a virtual device.
#pragma once

#include <gtest/gtest.h>

#include "app/workbench/feel/feel_controller.h"
#include "app/workbench/feel/recordings/feel_store.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/ghost_controller.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/study/connection/study_connection.h"
#include "app/workbench/study/study_models.h"
#include "app/workbench/tune/strokes/strokes_controller.h"

#include "tests/gui/sample_models.h"
#include "tests/gui/sample_study.h"
#include "tests/gui/stepped_feel.h"

namespace tactus::workbench {

class StrokesFixture : public testing::Test {
 protected:
  void SetUp() override {
    models.open(folder.write(tests::twoExperts()));
    tests::makeStudyFile(path);
  }
  void openStudy() {
    study.open(path);
    ASSERT_TRUE(tests::comesTrue([this] { return study.isOpen(); }));
    study_models.putModel();
  }
  // Two strokes from the nostril on, recorded.
  void record() {
    store.setRecording(true);
    feel.start(QStringLiteral("virtual"));
    time.advance(feel, 400);
    for (int stroke = 0; stroke < 2; ++stroke) {
      time.moveTo(feel, 0, 20);
      time.advance(feel, 300);
      feel.session().setHeld(true);
      time.advance(feel, 100);
      time.moveTo(feel, 5, 8);
      feel.session().setHeld(false);
      time.advance(feel, 100);
    }
    feel.stop();
    ASSERT_TRUE(tests::comesTrue(
        [this] { return !study.recordings().empty() && study.recordings().back().finished && !study.isBusy(); }));
  }
  bool isShown() {
    return tests::comesTrue([this] { return strokes.state() == StrokesController::State::kShown && !strokes.isOld(); });
  }
  // Near and slow says High.
  void harden() {
    fuzzy::ForceModel harder = edits.model();
    harder.experts[0].rules[0].then = "high";
    ASSERT_TRUE(edits.apply(editing::finished(harder, "Near and slow: High")));
  }

  tests::ModelFolder folder;
  QString path = folder.path(QStringLiteral("felt.tactus"));
  ModelController models;
  SceneController scene{models};
  tests::SteppedFeel time;
  DeviceSession device_session{time.settings()};
  FeelController feel{scene, device_session};
  EditController edits{models};
  GhostController ghost{edits, scene};
  StudyConnection study;
  StudyModels study_models{study, models, edits};
  FeelStore store{feel, scene, study, [this] { return study_models.modelVersion(); }};
  StrokesController strokes{ghost, edits, scene, study};
};

}  // namespace tactus::workbench
