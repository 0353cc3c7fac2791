// `replay` on the command line: its numbers are those of app/replay, here its words, its JSON and its refusals.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/replay/stroke_replay.h"
#include "core/base/files/file.h"
#include "core/model_io/model_file.h"
#include "core/store/entries.h"
#include "core/store/feel_records.h"
#include "core/store/model_versions.h"
#include "core/store/sessions.h"

#include "tests/app/cli/run_program.h"
#include "tests/app/replay/felt_recording.h"
#include "tests/core/store/sample_records.h"
#include "tests/support/ngt_model.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

using Json = nlohmann::json;

class ReplayCommandTest : public testing::Test {
 protected:
  void SetUp() override {
    fuzzy::ForceModel harder = model_;
    harder.experts[0].rules[2].then = "large";
    ASSERT_TRUE(model_io::writeModel(model_, same_));
    ASSERT_TRUE(model_io::writeModel(harder, harder_));
    store::SampleRecords records;
    store::OpenStudy study = store::makeStudy(study_, records);
    const study::ModelVersion version = records.model(*model_io::modelText(model_, same_));
    ASSERT_TRUE(append(study.file, version));
    study::SessionRecord visit = records.session(study.person.id);
    visit.kind = study::SessionKind::kUsability;
    ASSERT_TRUE(append(study.file, visit));
    study::FeltSetting setting;
    setting.model = model_.name;
    setting.model_version = version.id;
    const auto felt = replay::felt(model_, {{60, .8, well_}, {60, .4, well_}, {60, 1, well_}}, 0);
    ASSERT_TRUE(append(study.file, study::FeelStart{records.entry(visit.id), setting, 1}));
    ASSERT_TRUE(append(study.file, study::FeelPiece{records.entry(visit.id), 1, 1, felt.samples}));
    ASSERT_TRUE(append(study.file, study::FeelEnd{records.entry(visit.id), 1, 1}));
    study::SessionRecord session = records.session(study.person.id);
    ASSERT_TRUE(append(study.file, session));
    study::StrokeRecord movement;
    movement.entry = records.entry(session.id);
    movement.level = "slow";
    movement.number = 2;
    movement.verdict = "accepted";
    movement.recording.channels = {{"time", "s", {}}, {"depth", "mm", {}}};
    for (int i = 0; i < 800; ++i) {
      movement.recording.channels[0].values.push_back(.001 * i);
      movement.recording.channels[1].values.push_back(160 * replay::minimumJerk(i / 799.0));
    }
    movement.last = 800;
    ASSERT_TRUE(append(study.file, movement));
  }

  fuzzy::ForceModel model_ = support::s4FiveRegions();
  std::map<std::string, double> well_{{"lubrication", 1}, {"neck_flexion", 60}};
  support::TempFolder folder_;
  std::string study_ = folder_.file("felt.tactus");
  std::string same_ = folder_.file("same.tactus.json");
  std::string harder_ = folder_.file("harder.tactus.json");
};

TEST_F(ReplayCommandTest, TheWorstStrokeAndWhatIsLeftOut) {
  const ProgramRun run({"replay", study_, harder_});
  ASSERT_EQ(run.status, 0) << run.err;
  const std::string said = unwrapped(run.out);
  EXPECT_NE(said.find("of 3 strokes would feel different"), std::string::npos) << run.out;
  EXPECT_NE(said.find("largest: recording 1, stroke "), std::string::npos) << run.out;
  EXPECT_NE(said.find("Strokes are left out, --at may help: "), std::string::npos)
      << "no lubrication for the movement" << run.out;
  EXPECT_NE(said.find("the last version in the study"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("does not answer to the other force"), std::string::npos) << run.out;
}

// The version that was signed off last, whatever came after it.
TEST_F(ReplayCommandTest, TheLastSignOffIsTheModelBefore) {
  EXPECT_EQ(ProgramRun({"replay", study_, harder_, "--last-sign-off"}).status, 1) << "nothing is signed off";
  {
    auto file = store::StudyFile::open(study_);
    ASSERT_TRUE(file);
    store::SampleRecords records(1000);
    study::ModelVersion approved = records.model(*model_io::modelText(model_, same_));
    approved.label = "sign-off: feels right";
    study::ModelVersion later = records.model(*base::readFile(harder_, 1U << 20U));
    later.label = "edit";
    ASSERT_TRUE(append(*file, approved));
    ASSERT_TRUE(append(*file, later));
  }
  const auto felt = [&](std::vector<std::string> more) {
    std::vector<std::string> arguments{"replay", study_, harder_, "--at", "lubrication=1,neck_flexion=60", "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProgramRun run(arguments);
    EXPECT_EQ(run.status, 0) << run.err;
    return Json::parse(run.out);
  };
  EXPECT_EQ(felt({})["felt"], 0);
  const Json approved = felt({"--last-sign-off"});
  EXPECT_GE(approved["felt"].get<int>(), 1);
  EXPECT_NE(approved["before"].get<std::string>().find("sign-off: feels right"), std::string::npos);
  EXPECT_EQ(approved["felt"], felt({"--before", same_})["felt"]);
}

TEST_F(ReplayCommandTest, JsonHasTheNumbersOfTheCalculation) {
  const ProgramRun run({"replay", study_, harder_, "--at", "lubrication=1,neck_flexion=60", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json json = Json::parse(run.out);
  EXPECT_EQ(json["compared"], 4);
  EXPECT_EQ(json["left_out"], 0);
  ASSERT_EQ(json["strokes"].size(), 4U);
  EXPECT_GE(json["felt"].get<int>(), 1);
  const auto file = store::StudyFile::open(study_, {store::Access::kReadOnly});
  ASSERT_TRUE(file);
  const auto strokes = std::make_shared<const std::vector<replay::RecordedStroke>>(
      replay::recordedStrokes(*replay::storedStrokes(*file)));
  const auto baseline = replay::baselineOf(strokes, *editing::ready(model_), well_);
  const auto after = *editing::ready((*model_io::readModel(harder_)).model);
  const auto found = replay::compareStrokes(baseline, *after);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(json["strokes"][i]["rms_n"].get<double>(), found.strokes[i].numbers->rms_n);
    EXPECT_EQ(json["strokes"][i]["largest_jnd"].get<double>(), found.strokes[i].numbers->noticeable);
  }
  const bool force_off = std::any_of(json["strokes"].begin(), json["strokes"].end(),
                                     [](const Json& one) { return one["use"] == "force_off"; });
  EXPECT_TRUE(force_off);
}

TEST_F(ReplayCommandTest, TheSameModelChangesNothing) {
  const ProgramRun run({"replay", study_, same_, "--before", same_});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_NE(unwrapped(run.out).find("0 of 3 strokes would feel different"), std::string::npos) << run.out;
  EXPECT_NE(unwrapped(run.out).find("No force changes."), std::string::npos) << run.out;
}

TEST_F(ReplayCommandTest, AStudyWithoutStrokesIsRefused) {
  store::SampleRecords records;
  const std::string empty = folder_.file("empty.tactus");
  { const store::OpenStudy study = store::makeStudy(empty, records); }
  const ProgramRun run({"replay", empty, harder_, "--before", same_});
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.err.find("no stroke"), std::string::npos) << run.err;
  const ProgramRun without({"replay", empty, harder_});
  EXPECT_EQ(without.status, 1);
  EXPECT_NE(without.err.find("--before"), std::string::npos) << without.err;
}

TEST_F(ReplayCommandTest, AnUnknownConditionIsRefused) {
  const ProgramRun run({"replay", study_, harder_, "--at", "wetness=1"});
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.err.find("--at"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace tactus::cli
