#include "core/store/feel_records.h"

#include <gtest/gtest.h>
#include <limits>

#include "core/store/merge.h"
#include "core/store/persons.h"
#include "core/store/record_import.h"
#include "core/store/record_tables.h"
#include "core/store/sessions.h"
#include "core/store/study_info.h"
#include "core/store/withdrawal.h"

#include "tests/core/store/sample_records.h"
#include "tests/support/temp_folder.h"

namespace tactus::store {
namespace {

using study::SessionKind;

class FeelRecords : public testing::Test {
 protected:
  void SetUp() override {
    felt_ = records_.session(study_.person.id);
    felt_.kind = SessionKind::kUsability;
    ASSERT_TRUE(append(study_.file, felt_));
  }
  study::FeltSetting setting() {
    return {"Virtual device", true, "NGT averaged", records_.id(), {{"lubrication", 0.25}, {"neck_flexion", 45}}};
  }
  study::PlacementRecord placement() { return {records_.entry(felt_.id), setting(), 12.5, 4, 0.75, 0.21, 381.4}; }
  study::FeelStart start(int number = 1) { return {records_.entry(felt_.id), setting(), number}; }
  /// Samples `first`, `first` + 1, … as depths.
  study::FeelPiece piece(int number, std::vector<double> depths, int recording = 1) {
    return {records_.entry(felt_.id), recording, number, {1000, {{"position", "mm", std::move(depths)}}}};
  }
  study::FeelEnd end(int pieces, int recording = 1) { return {records_.entry(felt_.id), recording, pieces}; }
  template <class Record>
  std::string refusal(const Record& record) {
    const auto written = append(study_.file, record);
    return written ? "" : written.error().message();
  }
  /// A recording of 5 samples in two pieces; returns its name.
  study::RecordId record() {
    const auto begun = start();
    EXPECT_EQ(refusal(begun), "");
    EXPECT_EQ(refusal(piece(1, {1, 2, 3})), "");
    EXPECT_EQ(refusal(piece(2, {4, 5})), "");
    EXPECT_EQ(refusal(end(2)), "");
    return begun.entry.id;
  }

  support::TempFolder folder_;
  SampleRecords records_;
  std::string path_ = folder_.file("study.tactus");
  OpenStudy study_ = makeStudy(path_, records_);
  study::SessionRecord felt_;
};

TEST_F(FeelRecords, APlacementComesBackAsItWasWritten) {
  auto first = placement();
  auto second = placement();
  second.setting.model_version.reset();
  second.setting.simulated = false;
  second.setting.device.clear();
  second.setting.conditions.clear();
  ASSERT_EQ(refusal(first), "");
  ASSERT_EQ(refusal(second), "");
  EXPECT_EQ(*placements(study_.file), (std::vector{first, second}));
  EXPECT_TRUE(checkStudy(study_.file)->empty());
}

TEST_F(FeelRecords, PiecesAreJoinedInTheirOrder) {
  const auto name = record();
  const auto samples = feelRecording(study_.file, name);
  ASSERT_TRUE(samples) << samples.error().message();
  EXPECT_EQ(*samples, (study::Recording{1000, {{"position", "mm", {1, 2, 3, 4, 5}}}}));
  const auto list = *feelRecordings(study_.file);
  ASSERT_EQ(list.size(), 1U);
  EXPECT_EQ(list[0].start.entry.id, name);
  EXPECT_EQ(list[0].code, study_.person.code);
  EXPECT_EQ(list[0].pieces, 2);
  EXPECT_DOUBLE_EQ(list[0].length_s, 0.005);
  EXPECT_TRUE(list[0].finished);
  EXPECT_TRUE(checkStudy(study_.file)->empty());
}

TEST_F(FeelRecords, ARecordingThatACrashEndedHoldsWhatWasStored) {
  const auto begun = start();
  ASSERT_EQ(refusal(begun), "");
  ASSERT_EQ(refusal(piece(1, {1, 2})), "");
  EXPECT_FALSE((*feelRecordings(study_.file))[0].finished);
  EXPECT_EQ(feelRecording(study_.file, begun.entry.id)->size(), 2U);
  EXPECT_TRUE(checkStudy(study_.file)->empty());
}

TEST_F(FeelRecords, RefusesWhatDoesNotBelong) {
  auto elsewhere = placement();
  elsewhere.entry.session = study_.session.id;
  EXPECT_NE(refusal(elsewhere).find("wanted one of the kind usability"), std::string::npos);
  auto piece_elsewhere = piece(1, {1});
  piece_elsewhere.entry.session = study_.session.id;
  EXPECT_NE(refusal(piece_elsewhere).find("wanted one of the kind usability"), std::string::npos);
  auto not_finite = placement();
  not_finite.peak_force_n = std::numeric_limits<double>::infinity();
  EXPECT_NE(refusal(not_finite).find("peak_force_n"), std::string::npos);
  auto negative = placement();
  negative.duration_s = -1;
  EXPECT_NE(refusal(negative).find("duration_s"), std::string::npos);
  EXPECT_TRUE(events(study_.file)->empty());
  EXPECT_FALSE(feelRecording(study_.file, records_.id()));
}

TEST_F(FeelRecords, TheCheckFindsWhatIsMissing) {
  ASSERT_EQ(refusal(start()), "");
  ASSERT_EQ(refusal(piece(2, {1})), "");
  ASSERT_EQ(refusal(piece(1, {1}, 7)), "");
  ASSERT_EQ(refusal(start(2)), "");
  ASSERT_EQ(refusal(end(3, 2)), "");
  auto event = records_.event(felt_.id);
  event.kind = "placement";
  event.detail = "{}";
  ASSERT_EQ(refusal(event), "");
  const auto findings = *checkStudy(study_.file);
  ASSERT_EQ(findings.size(), 4U);
  EXPECT_NE(findings[0].find("placement"), std::string::npos) << findings[0];
  EXPECT_NE(findings[1].find("piece 2 where piece 1 was to come"), std::string::npos) << findings[1];
  EXPECT_NE(findings[2].find("tells of 3 pieces, there are 0"), std::string::npos) << findings[2];
  EXPECT_NE(findings[3].find("whose beginning is missing"), std::string::npos) << findings[3];
}

TEST_F(FeelRecords, InfoCountsThem) {
  record();
  ASSERT_EQ(refusal(placement()), "");
  const auto info = *studyInfo(study_.file);
  EXPECT_EQ(info.placements, 1);
  EXPECT_EQ(info.feel_recordings, 1);
}

TEST_F(FeelRecords, AMergeAndAFullExportTakeThemAlong) {
  const auto name = record();
  ASSERT_EQ(refusal(placement()), "");
  const auto felt = *placements(study_.file);
  const auto samples = *feelRecording(study_.file, name);
  ASSERT_TRUE(writeRecords(study_.file, folder_.file("tables")));
  ASSERT_TRUE(study_.file.close());

  ASSERT_TRUE(restoreRecords(folder_.file("tables"), folder_.file("again.tactus")));
  const auto again = StudyFile::open(folder_.file("again.tactus"));
  ASSERT_TRUE(again) << again.error().message();
  EXPECT_EQ(*placements(*again), felt);
  EXPECT_EQ(*feelRecording(*again, name), samples);

  SampleRecords others(2);
  auto merged = makeStudy(folder_.file("merged.tactus"), others);
  ASSERT_TRUE(mergeStudy(merged.file, path_, others.id(), 0));
  EXPECT_EQ(*placements(merged.file), felt);
  EXPECT_EQ(*feelRecording(merged.file, name), samples);
  EXPECT_EQ(feelRecordings(merged.file)->size(), 1U);
}

TEST_F(FeelRecords, AWithdrawalRemovesThem) {
  record();
  ASSERT_EQ(refusal(placement()), "");
  ASSERT_TRUE(withdraw(study_.file, study_.person.id, 0));
  EXPECT_TRUE(placements(study_.file)->empty());
  EXPECT_TRUE(feelRecordings(study_.file)->empty());
  EXPECT_TRUE(checkStudy(study_.file)->empty());
}

TEST_F(FeelRecords, MarkedMomentsAreReadAsWritten) {
  const study::FeelMark first{records_.entry(felt_.id), setting(), 132.5, 48, 0.42, 0.4};
  study::FeelMark second{records_.entry(felt_.id), setting(), -2, 0, 0, 0};
  second.setting.model_version.reset();
  ASSERT_EQ(refusal(first), "");
  ASSERT_EQ(refusal(second), "");
  EXPECT_EQ(feelMarks(study_.file).value(), (std::vector{first, second}));
  EXPECT_TRUE(checkFeelRecords(study_.file)->empty());
  study::FeelMark wrong = first;
  wrong.entry = records_.entry(study_.session.id);  // of an elicitation
  EXPECT_NE(refusal(wrong), "");
  wrong.entry = records_.entry(felt_.id);
  wrong.force_n = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(refusal(wrong), "");
  EXPECT_EQ(feelMarks(study_.file)->size(), 2U);
}

}  // namespace
}  // namespace tactus::store
