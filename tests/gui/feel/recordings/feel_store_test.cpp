#include "app/workbench/feel/recordings/feel_store.h"

#include <QSignalSpy>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>

#include "app/editing/membership_edits.h"
#include "app/workbench/feel/feel_controller.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/study/study_models.h"
#include "app/workbench/tune/history/compare_controller.h"
#include "core/haptics/servo/servo.h"
#include "core/store/feel_records.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"
#include "core/store/study_info.h"

#include "tests/gui/sample_models.h"
#include "tests/gui/sample_study.h"
#include "tests/gui/stepped_feel.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;

class FeelStoreTest : public testing::Test {
 protected:
  void SetUp() override {
    models.open(folder.write(tests::twoExperts()));
    tests::makeStudyFile(path, [this](store::StudyFile& file, study::RecordIds& ids) {
      tests::addVisit(file, ids, "velvet-otter", false);
      otter = (*store::persons(file))[0].id;
    });
    study.open(path);
    ASSERT_TRUE(comesTrue([this] { return study.isOpen(); }));
    study_models.putModel();
  }

  // Takes the tube, pushes it in two strokes, and lets go.
  void place() {
    time.advance(feel, 20);  // the hand has to be seen open once
    for (const double from_mm : {0.0, 0.0}) {
      time.moveTo(feel, from_mm, 20);
      feel.session().setHeld(true);
      time.advance(feel, 100);
      time.moveTo(feel, 4, 8);
      feel.session().setHeld(false);
      time.advance(feel, 100);
    }
  }
  std::vector<study::PlacementRecord> stored() {
    EXPECT_TRUE(allWritten());
    EXPECT_TRUE(closed());
    return *store::placements(tests::lookInto(path));
  }
  bool allWritten() {
    return comesTrue([this] { return !study.isBusy(); });
  }
  bool closed() {
    study.close();
    return comesTrue([this] { return !study.isOpen(); });
  }
  // The recording runs through the present model; the forces of that.
  std::vector<TracePoint> replayed(const study::RecordId& id) {
    store.replay(id);
    EXPECT_TRUE(comesTrue([this] { return feel.isReplay(); }));
    std::vector<TracePoint> trace;
    while (feel.isReplay() && trace.size() < 10000) {
      time.advance(feel, 4);
      if (feel.isReplay()) trace.push_back(feel.history().trace().back());
    }
    return trace;
  }

  tests::ModelFolder folder;
  QString path = folder.path(QStringLiteral("felt.tactus"));
  study::RecordId otter;
  ModelController models;
  SceneController scene{models};
  tests::SteppedFeel time;
  DeviceSession device_session{time.settings()};
  FeelController feel{scene, device_session};
  EditController edits{models};
  StudyConnection study;
  StudyModels study_models{study, models, edits};
  FeelStore store{feel, scene, study, [this] { return study_models.modelVersion(); }};
};

TEST_F(FeelStoreTest, APlacementIsKeptAsItsPersons) {
  store.setWho(otter);
  feel.start(QStringLiteral("virtual"));
  place();
  feel.stop();
  const auto version = study_models.modelVersion();
  const auto summary = feel.lastPlacement();
  ASSERT_TRUE(summary);
  ASSERT_TRUE(allWritten());
  ASSERT_TRUE(closed());
  const auto file = tests::lookInto(path);
  const auto placements = *store::placements(file);
  ASSERT_EQ(placements.size(), 1U);
  const study::PlacementRecord& kept = placements[0];
  EXPECT_EQ(kept.strokes, 2);
  EXPECT_EQ(kept.strokes, static_cast<int>(summary->strokes));
  EXPECT_EQ(kept.duration_s, summary->duration_s);
  EXPECT_EQ(kept.peak_force_n, summary->peak_force_n);
  EXPECT_EQ(kept.mean_force_n, summary->mean_force_n);
  EXPECT_EQ(kept.depth_mm, summary->depth_mm);
  EXPECT_TRUE(kept.setting.simulated);
  EXPECT_EQ(kept.setting.model_version, version);
  EXPECT_EQ(kept.entry.entered_by, study::EnteredBy::kParticipant);
  const auto sessions = *store::sessions(file, otter);
  ASSERT_EQ(sessions.size(), 2U);
  EXPECT_EQ(sessions[1].id, kept.entry.session);
  EXPECT_EQ(sessions[1].kind, study::SessionKind::kUsability);
  EXPECT_TRUE(store::checkStudy(file)->empty());
}

TEST_F(FeelStoreTest, TheResearcherBecomesOnePersonOfTheStudy) {
  for (int run = 0; run < 2; ++run) {
    feel.start(QStringLiteral("virtual"));
    place();
    feel.newPlacement();
    place();
    feel.stop();
  }
  ASSERT_TRUE(allWritten());
  ASSERT_TRUE(comesTrue([this] { return study.people().size() == 2; }));
  ASSERT_TRUE(closed());
  const auto file = tests::lookInto(path);
  EXPECT_EQ(store::placements(file)->size(), 4U);
  EXPECT_EQ(store::sessions(file)->size(), 3U);  // one for each start of the device
  EXPECT_EQ(store::persons(file)->size(), 2U);
}

TEST_F(FeelStoreTest, WhatGoesOnBelongsToThePersonBefore) {
  store.setWho(otter);
  feel.start(QStringLiteral("virtual"));
  place();
  store.setWho(std::nullopt);
  place();
  feel.stop();
  auto placements = stored();
  ASSERT_EQ(placements.size(), 2U);
  std::sort(placements.begin(), placements.end(), [](const auto& one, const auto& other) {
    return one.entry.when.monotonic_ns < other.entry.when.monotonic_ns;
  });
  EXPECT_EQ(placements[0].entry.entered_by, study::EnteredBy::kParticipant);
  EXPECT_EQ(placements[0].strokes, 2);
  EXPECT_EQ(placements[1].entry.entered_by, study::EnteredBy::kResearcher);
  EXPECT_NE(placements[0].entry.session, placements[1].entry.session);
}

TEST_F(FeelStoreTest, ThePlacementThatGoesOnStaysInItsStudy) {
  store.setWho(otter);
  feel.start(QStringLiteral("virtual"));
  place();
  const QString other = folder.path(QStringLiteral("other.tactus"));
  study.create(other);
  ASSERT_TRUE(comesTrue([&] { return study.path() == other; }));
  feel.stop();
  ASSERT_TRUE(allWritten());
  ASSERT_TRUE(closed());
  EXPECT_EQ(store::placements(tests::lookInto(path))->size(), 1U);
  EXPECT_TRUE(store::placements(tests::lookInto(other))->empty());
}

TEST_F(FeelStoreTest, APlacementOnAnotherVersionSaysWhich) {
  const study::RecordId before = *study_models.modelVersion();
  ASSERT_TRUE(edits.apply(editing::moveVertex(edits.model(), {{"depth", ""}, "near", 2}, 3)));
  const study::RecordId now = *study_models.modelVersion();
  CompareController compare(models, edits);
  compare.show(CompareSide::kB);  // the state before
  feel.start(QStringLiteral("virtual"));
  place();
  feel.newPlacement();
  compare.show(CompareSide::kA);
  place();
  feel.newPlacement();
  compare.choose(CompareSide::kB, {CompareChoice::Kind::kExpert, 0, "A"});
  compare.show(CompareSide::kB);
  place();
  feel.stop();
  const auto placements = stored();
  ASSERT_EQ(placements.size(), 3U);
  EXPECT_EQ(placements[0].setting.model_version, before);
  EXPECT_EQ(placements[1].setting.model_version, now);
  EXPECT_EQ(placements[2].setting.model_version, now);
  EXPECT_EQ(placements[1].setting.model, models.current()->model.name);
  EXPECT_EQ(placements[2].setting.model, models.current()->model.name + ": A alone");
}

TEST_F(FeelStoreTest, ARefusedPlacementIsNotSaidToBeStored) {
  store.setWho(study::RecordIds(99).next());  // nobody of this study
  QSignalSpy said(&store, &FeelStore::said);
  QSignalSpy failed(&store, &FeelStore::failed);
  feel.start(QStringLiteral("virtual"));
  place();
  feel.stop();
  ASSERT_TRUE(allWritten());
  EXPECT_EQ(said.count(), 0);
  ASSERT_EQ(failed.count(), 1);
  EXPECT_TRUE(failed[0][0].toString().contains(QStringLiteral("placement"))) << failed[0][0].toString().toStdString();
}

TEST_F(FeelStoreTest, WithoutAStudyNothingIsKept) {
  ASSERT_TRUE(closed());
  EXPECT_FALSE(store.canRecord());
  store.setRecording(true);
  EXPECT_FALSE(store.isRecording());
  feel.start(QStringLiteral("virtual"));
  place();
  feel.stop();
  EXPECT_TRUE(feel.lastPlacement());
}

TEST_F(FeelStoreTest, ARecordingIsStoredInPiecesWhileItGoesOn) {
  feel.start(QStringLiteral("virtual"));
  store.setRecording(true);
  place();
  time.advance(feel, 5000);
  ASSERT_TRUE(allWritten());
  ASSERT_TRUE(comesTrue([this] { return study.recordings().size() == 1; }));
  const double length_s = store.recordedS();
  study.refresh();
  // All but the last two seconds are in the file.
  ASSERT_TRUE(comesTrue([&] { return study.recordings()[0].length_s >= length_s - FeelStore::kPieceS - 0.016; }));
  EXPECT_FALSE(study.recordings()[0].finished);
  store.setRecording(false);
  ASSERT_TRUE(comesTrue([this] { return study.recordings()[0].finished; }));
  EXPECT_EQ(study.recordings()[0].code.find('-') != std::string::npos, true);
  ASSERT_TRUE(closed());
  const auto file = tests::lookInto(path);
  const auto list = *store::feelRecordings(file);
  const auto samples = *store::feelRecording(file, list[0].start.entry.id);
  EXPECT_NEAR(static_cast<double>(samples.size()) / 1000, length_s, 0.002);
  const auto& times = *channelOf(samples, "time");
  for (std::size_t i = 1; i < times.size(); ++i) ASSERT_NEAR(times[i] - times[i - 1], 0.001, 1e-9);
  EXPECT_TRUE(store::checkStudy(file)->empty());
}

TEST_F(FeelStoreTest, ARecordingWithAGapEndsItsPieceAndSaysSo) {
  const QSignalSpy failed(&store, &FeelStore::failed);
  feel.start(QStringLiteral("virtual"));
  store.setRecording(true);
  time.advance(feel, 500);
  constexpr int kLostMs = 250;
  time.hang(static_cast<int>(haptics::SampleRing::kDefaultCapacity) + kLostMs);
  time.advance(feel, 500);
  store.setRecording(false);
  feel.stop();
  ASSERT_EQ(failed.count(), 1);
  EXPECT_TRUE(failed[0][0].toString().contains(QStringLiteral("lost")));
  ASSERT_TRUE(allWritten());
  ASSERT_TRUE(closed());
  const auto file = tests::lookInto(path);
  const auto list = *store::feelRecordings(file);
  ASSERT_EQ(list.size(), 1U);
  EXPECT_EQ(list[0].gaps, 1);
  const auto samples = *store::feelRecording(file, list[0].start.entry.id);
  const auto& times = *channelOf(samples, "time");
  std::vector<double> jumps;
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (times[i] - times[i - 1] > 0.0015) jumps.push_back(times[i] - times[i - 1]);
  }
  ASSERT_EQ(jumps.size(), 1U);
  // The ring keeps what it has and drops what comes, until the next beat empties it 16 ms later.
  EXPECT_NEAR(jumps[0], 0.001 * (kLostMs + 16 + 1), 1e-9);
  const auto findings = *store::checkStudy(file);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_NE(findings[0].find("samples were lost behind piece"), std::string::npos);
}

TEST_F(FeelStoreTest, ARecordingEndsWithTheConditionsThatItBeganWith) {
  feel.start(QStringLiteral("virtual"));
  store.setRecording(true);
  place();
  fuzzy::ForceModel warm = tests::twoExperts();
  warm.inputs.push_back({"warmth", "Warmth", "1", 0, 1, {{"cool", "Cool", fuzzy::Shape::kTrapezoid, {0, 0, 1, 1}}}});
  models.open(folder.write(warm, QStringLiteral("warm.tactus.json")));
  EXPECT_FALSE(store.isRecording());
  place();
  feel.stop();
  ASSERT_TRUE(comesTrue([this] { return study.recordings().size() == 1 && study.recordings()[0].finished; }));
  ASSERT_TRUE(closed());
  const auto file = tests::lookInto(path);
  const auto samples = *store::feelRecording(file, (*store::feelRecordings(file))[0].start.entry.id);
  for (const study::Channel& channel : samples.channels) EXPECT_EQ(channel.values.size(), samples.size());
  EXPECT_EQ(channelOf(samples, "warmth"), nullptr);
}

TEST_F(FeelStoreTest, EverySampleOfARecordingBelongsToItsPlacement) {
  feel.start(QStringLiteral("virtual"));
  store.setRecording(true);
  place();
  time.advance(feel, 7);
  feel.newPlacement();
  time.advance(feel, 7);
  place();
  store.setRecording(false);
  ASSERT_TRUE(comesTrue([this] { return study.recordings().size() == 1 && study.recordings()[0].finished; }));
  ASSERT_TRUE(closed());
  const auto file = tests::lookInto(path);
  const auto samples = *store::feelRecording(file, (*store::feelRecordings(file))[0].start.entry.id);
  const auto& placements = *channelOf(samples, "placement");
  const auto& strokes = *channelOf(samples, "stroke");
  EXPECT_EQ(placements.back(), 2);
  // A placement begins with the tube out of the hand and no stroke.
  for (std::size_t i = 1; i < placements.size(); ++i) {
    if (placements[i] != placements[i - 1]) {
      EXPECT_EQ(strokes[i], 0) << i;
    }
  }
}

TEST_F(FeelStoreTest, AReplayOnTheSameModelGivesTheRecordedForce) {
  store.setRecording(true);  // begins with the run
  feel.start(QStringLiteral("virtual"));
  place();
  feel.stop();
  EXPECT_FALSE(store.isRecording());
  ASSERT_TRUE(comesTrue([this] { return study.recordings().size() == 1 && study.recordings()[0].finished; }));
  const auto trace = replayed(study.recordings()[0].start.entry.id);
  double most_n = 0;
  double worst_n = 0;
  for (const TracePoint& point : trace) {
    if (!point.recorded_n) continue;
    most_n = std::max(most_n, *point.recorded_n);
    worst_n = std::max(worst_n, std::abs(*point.recorded_n - point.force_n));
  }
  EXPECT_GT(most_n, 0.05);
  // Another damping is assumed of a replay than of the virtual device, which the limits see; less than a tenth of a
  // just noticeable difference.
  EXPECT_LT(worst_n, 0.003) << "of " << most_n << " N";
  // A replay is nobody's placement.
  ASSERT_TRUE(feel.lastPlacement());
  EXPECT_TRUE(feel.lastPlacement()->replay);
  ASSERT_TRUE(closed());
  EXPECT_EQ(store::placements(tests::lookInto(path))->size(), 1U);
}

TEST_F(FeelStoreTest, AReplayOnAHarderModelGivesMoreForce) {
  store.setRecording(true);
  feel.start(QStringLiteral("virtual"));
  place();
  feel.stop();
  ASSERT_TRUE(comesTrue([this] { return study.recordings().size() == 1 && study.recordings()[0].finished; }));
  fuzzy::ForceModel harder = scene.model()->model;
  harder.experts[0].rules[0].then = "high";  // near and slow
  ASSERT_TRUE(models.edit(harder));
  double recorded_n = 0;
  double present_n = 0;
  for (const TracePoint& point : replayed(study.recordings()[0].start.entry.id)) {
    recorded_n = std::max(recorded_n, point.recorded_n.value_or(0));
    present_n = std::max(present_n, point.force_n);
  }
  // Low to high: three times the fuzzy force; the hand that moves as before does not follow it all the way.
  EXPECT_GT(present_n, 1.3 * recorded_n);
}

TEST_F(FeelStoreTest, AReplayWaitsForADeviceThatTakesItsTimeToStop) {
  store.setRecording(true);
  feel.start(QStringLiteral("virtual"));
  place();
  feel.stop();
  ASSERT_TRUE(comesTrue([this] { return study.recordings().size() == 1 && study.recordings()[0].finished; }));
  std::atomic<bool> lets_go = true;
  DeviceSession slow_device{time.slowSettings(lets_go)};
  FeelController slow{scene, slow_device};
  FeelStore other(slow, scene, study, [this] { return study_models.modelVersion(); });
  slow.start(QStringLiteral("virtual"));
  ASSERT_TRUE(comesTrue([&] { return slow.state() == FeelController::State::kRunning; }));
  lets_go = false;
  other.replay(study.recordings()[0].start.entry.id);
  ASSERT_TRUE(comesTrue([&] { return slow.state() == FeelController::State::kStopping; }));
  EXPECT_FALSE(other.replayed());
  lets_go = true;
  lets_go.notify_all();
  ASSERT_TRUE(comesTrue([&] { return slow.isReplay(); }));
  EXPECT_EQ(other.replayed(), study.recordings()[0].start.entry.id);
  slow.stop();
}

TEST_F(FeelStoreTest, ClosingTheStudyEndsTheRecordingInIt) {
  feel.start(QStringLiteral("virtual"));
  store.setRecording(true);
  time.advance(feel, 500);
  ASSERT_TRUE(closed());
  EXPECT_FALSE(store.isRecording());
  const auto file = tests::lookInto(path);
  EXPECT_TRUE((*store::feelRecordings(file))[0].finished);
}

}  // namespace
}  // namespace tactus::workbench
