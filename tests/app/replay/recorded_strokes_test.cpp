#include "app/replay/recorded_strokes.h"

#include <cmath>
#include <gtest/gtest.h>

#include "app/replay/stroke_replay.h"
#include "core/store/entries.h"
#include "core/store/feel_records.h"
#include "core/store/model_versions.h"
#include "core/store/sessions.h"

#include "tests/app/replay/felt_recording.h"
#include "tests/core/store/sample_records.h"
#include "tests/support/invented_experts.h"
#include "tests/support/ngt_model.h"
#include "tests/support/temp_folder.h"

namespace tactus::replay {
namespace {

std::vector<RecordedStroke> strokesOf(StoredRecording recording) {
  return recordedStrokes({{std::move(recording)}, {}, {}});
}

std::vector<Push> threePushes() {
  return {{60, .8, {{"lubrication", 1}, {"neck_flexion", 60}}},
          {45, .4, {{"lubrication", .3}, {"neck_flexion", 60}}},
          {80, 2, {{"lubrication", .3}, {"neck_flexion", 5}}}};
}

std::vector<double>& channel(StoredRecording& recording, const std::string& name) {
  for (study::Channel& one : recording.samples.channels) {
    if (one.name == name) return one.values;
  }
  throw std::logic_error(name);
}

TEST(RecordedStrokes, OwnModelGivesTheRecordedForceBitForBit) {
  fuzzy::ForceModel offset = support::s4FiveRegions();
  offset.renderer = fuzzy::RendererParameters{};
  offset.renderer->depth_offset_mm = 100;
  fuzzy::ForceModel punctured = offset;
  punctured.events = {{"nasopharynx", .6}, {"laryngopharynx", .5}};
  for (const fuzzy::ForceModel& model : {support::s4FiveRegions(), support::inventedExperts(), offset, punctured}) {
    const auto recorded = felt(model, threePushes());
    const auto strokes = strokesOf(recorded);
    ASSERT_EQ(strokes.size(), 3U);
    const auto ready = *editing::ready(model);
    for (const RecordedStroke& stroke : strokes) {
      EXPECT_EQ(stroke.use, StrokeUse::kExact);
      const auto run = runStroke(stroke, *ready, {});
      ASSERT_TRUE(run) << run.error().message();
      EXPECT_EQ(run->force_n, stroke.recorded_n) << "stroke " << stroke.number;
    }
    EXPECT_EQ(strokes[1].conditions.at("lubrication"), .3);
    EXPECT_EQ(strokes[0].position_mm.size(), 801U);
    EXPECT_EQ(strokes[0].at_press.depth_mm, 0);
    EXPECT_GT(strokes[1].at_press.depth_mm, 50) << "the tube stays where the first stroke left it";
  }
}

TEST(RecordedStrokes, AForceThatDoesNotComeOutAgainIsSaidAndHasNoEffectOnTheNextStroke) {
  StoredRecording recording = felt(support::s4FiveRegions(), threePushes());
  double& force_n = channel(recording, "source_force")[300 + 500];
  force_n = std::nextafter(force_n, 2);
  const auto strokes = strokesOf(recording);
  ASSERT_EQ(strokes.size(), 3U);
  EXPECT_EQ(strokes[0].use, StrokeUse::kOtherForce);
  EXPECT_NEAR(strokes[0].differs_at_s.value(), .5, 1e-9);
  EXPECT_EQ(strokes[1].use, StrokeUse::kExact);
  EXPECT_EQ(strokes[2].use, StrokeUse::kExact);
}

TEST(RecordedStrokes, AStrokeThatDivergesLeavesTheTubeWhereItWasRecorded) {
  // Another model moves the tube to another depth in the first stroke; the second one starts where it was recorded.
  StoredRecording recording = felt(support::s4FiveRegions(), threePushes(), 100);
  fuzzy::ForceModel other = support::s4FiveRegions();
  other.experts[0].rules[2].then = "large";
  recording.model_text = *model_io::modelText(other, "other.tactus.json");
  const auto strokes = strokesOf(recording);
  ASSERT_EQ(strokes.size(), 3U);
  EXPECT_EQ(strokes[0].use, StrokeUse::kOtherForce);
  const auto honest = strokesOf(felt(support::s4FiveRegions(), threePushes(), 100));
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(strokes[i].at_press.depth_mm, honest[i].at_press.depth_mm) << i;
}

TEST(RecordedStrokes, LostSamplesAreNamed) {
  StoredRecording recording = felt(support::s4FiveRegions(), threePushes());
  for (study::Channel& one : recording.samples.channels) {
    one.values.erase(one.values.begin() + 700, one.values.begin() + 740);
  }
  recording.has_gaps = true;
  const auto strokes = strokesOf(recording);
  ASSERT_EQ(strokes.size(), 3U);
  EXPECT_EQ(strokes[0].use, StrokeUse::kSamplesLost);
  EXPECT_EQ(strokes[1].use, StrokeUse::kExact);
}

TEST(RecordedStrokes, ALateTickIsNoLoss) {
  const auto strokes = strokesOf(felt(support::s4FiveRegions(), threePushes(), 0, .003));
  for (const RecordedStroke& stroke : strokes) EXPECT_EQ(stroke.use, StrokeUse::kExact);
}

TEST(RecordedStrokes, OneExpertAloneIsNotTheKeptModel) {
  StoredRecording recording = felt(support::s4FiveRegions(), threePushes());
  recording.model_name += ": S4 alone";
  for (const RecordedStroke& stroke : strokesOf(recording)) EXPECT_EQ(stroke.use, StrokeUse::kUnknownModel);
  recording.model_text.clear();
  recording.model_name.clear();
  const auto unknown = strokesOf(recording);
  ASSERT_EQ(unknown.size(), 3U) << "they are still listed";
  EXPECT_EQ(unknown[0].use, StrokeUse::kUnknownModel);
}

// A study with a recording in two pieces, one of a model that the study does not keep, and strokes of the speed
// experiment.
class StoredStrokesTest : public testing::Test {
 protected:
  void SetUp() override {
    visit_ = records_.session(study_.person.id);
    visit_.kind = study::SessionKind::kUsability;
    ASSERT_TRUE(append(study_.file, visit_));
    version_ = records_.model(recording_.model_text);
    ASSERT_TRUE(append(study_.file, version_));
  }
  void record(int number, std::optional<study::RecordId> version) {
    study::FeltSetting setting;
    setting.model = recording_.model_name;
    setting.model_version = version;
    ASSERT_TRUE(append(study_.file, study::FeelStart{records_.entry(visit_.id), setting, number}));
    study::Recording halves[2] = {recording_.samples, recording_.samples};
    for (std::size_t c = 0; c < recording_.samples.channels.size(); ++c) {
      auto& first = halves[0].channels[c].values;
      auto& second = halves[1].channels[c].values;
      first.resize(700);
      second.erase(second.begin(), second.begin() + 700);
    }
    for (int piece = 0; piece < 2; ++piece) {
      ASSERT_TRUE(append(study_.file, study::FeelPiece{records_.entry(visit_.id), number, piece + 1, halves[piece]}));
    }
    ASSERT_TRUE(append(study_.file, study::FeelEnd{records_.entry(visit_.id), number, 2}));
  }
  void move(const std::string& verdict, bool practice) {
    study::SessionRecord session = records_.session(study_.person.id);
    ASSERT_TRUE(append(study_.file, session));
    study::StrokeRecord stroke;
    stroke.entry = records_.entry(session.id);
    stroke.level = "slow";
    stroke.number = 4;
    stroke.verdict = verdict;
    stroke.practice = practice;
    stroke.recording.channels = {{"time", "s", {}}, {"depth", "mm", {}}};
    for (int i = 0; i < 100; ++i) {
      stroke.recording.channels[0].values.push_back(.001 * i);
      stroke.recording.channels[1].values.push_back(.05 * i);
    }
    stroke.first = 10;
    stroke.last = 90;
    ASSERT_TRUE(append(study_.file, stroke));
  }

  support::TempFolder folder_;
  store::SampleRecords records_;
  store::OpenStudy study_ = store::makeStudy(folder_.file("strokes.tactus"), records_);
  study::SessionRecord visit_;
  study::ModelVersion version_;
  StoredRecording recording_ = felt(support::s4FiveRegions(), threePushes());
};

TEST_F(StoredStrokesTest, TheStudyGivesWhatWasStored) {
  record(1, version_.id);
  record(2, std::nullopt);
  move("accepted", false);
  move("accepted", true);
  move("too_slow", false);
  const auto stored = storedStrokes(study_.file);
  ASSERT_TRUE(stored) << stored.error().message();
  EXPECT_TRUE(stored->unreadable.empty());
  const auto strokes = recordedStrokes(*stored);
  ASSERT_EQ(strokes.size(), 3U + 3U + 1U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(strokes[i].use, StrokeUse::kExact);
    EXPECT_EQ(strokes[i].recording_number, 1);
    EXPECT_EQ(strokes[i].number, static_cast<int>(i) + 1);
    EXPECT_EQ(strokes[i].person, study_.person.code);
    EXPECT_EQ(strokes[i + 3].use, StrokeUse::kUnknownModel);
  }
  const RecordedStroke& movement = strokes.back();
  EXPECT_EQ(movement.use, StrokeUse::kForceOff);
  EXPECT_EQ(movement.level, "slow");
  EXPECT_EQ(movement.number, 4);
  EXPECT_TRUE(movement.conditions.empty());
  ASSERT_EQ(movement.position_mm.size(), 80U);
  EXPECT_EQ(movement.position_mm.front(), .5);
  EXPECT_EQ(movement.at_press.depth_mm, .05 * 9);
}

TEST_F(StoredStrokesTest, ARecordingWithoutTheChannelsIsSaid) {
  std::erase_if(recording_.samples.channels, [](const study::Channel& one) { return one.name == "source_force"; });
  record(1, version_.id);
  const auto stored = storedStrokes(study_.file);
  ASSERT_TRUE(stored);
  EXPECT_TRUE(stored->recordings.empty());
  ASSERT_EQ(stored->unreadable.size(), 1U);
  EXPECT_NE(stored->unreadable[0].find("recording 1"), std::string::npos) << stored->unreadable[0];
}

}  // namespace
}  // namespace tactus::replay
