#include "core/store/study_info.h"

#include <gtest/gtest.h>

#include "core/store/entries.h"
#include "core/store/model_versions.h"
#include "core/store/persons.h"
#include "core/store/record_tables.h"
#include "core/store/sessions.h"

#include "tests/core/store/plain_sql.h"
#include "tests/core/store/sample_records.h"
#include "tests/support/temp_folder.h"

namespace tactus::store {
namespace {

/// What `checkStudy` finds after a change of the file with the guards taken away.
class StudyChecks : public testing::Test {
 protected:
  void SetUp() override {
    auto study = makeStudy(path_, records_);
    for (int item = 1; item <= 4; ++item) {
      ASSERT_TRUE(append(study.file, records_.answer(study.session.id, item)));
      ASSERT_TRUE(append(study.file, records_.judgement(study.session.id)));
    }
    ASSERT_TRUE(append(study.file, records_.stroke(study.session.id)));
    ASSERT_TRUE(append(study.file, records_.model("abc")));
    ASSERT_TRUE(study.file.close());
  }
  /// The tables of `sealed` get checksums that fit what `sql` made of them.
  std::string findingsAfter(const std::string& sql, const std::vector<std::string>& sealed = {}) {
    {
      PlainSql plain(path_);
      std::string all = "PRAGMA foreign_keys = OFF; " + sql + ";";
      for (const auto& table : sealed) all += plain.seal(table);
      EXPECT_EQ(plain.complaintWithoutGuards(all), "");
    }
    const auto file = StudyFile::open(path_);
    if (!file) return file.error().message();
    std::string all;
    const auto findings = checkStudy(*file);
    for (const auto& finding : *findings) all += finding + "\n";
    return all;
  }

  support::TempFolder folder_;
  SampleRecords records_;
  std::string path_ = folder_.file("study.tactus");
};

TEST_F(StudyChecks, CountWhatIsThere) {
  const auto file = StudyFile::open(path_);
  const auto info = studyInfo(*file);
  ASSERT_TRUE(info);
  EXPECT_EQ(info->simulated_persons, 1);
  const std::vector<TableCount> expected = {{"person", 1}, {"session", 1},       {"profile", 0},   {"event", 0},
                                            {"stroke", 1}, {"judgement", 4},     {"answer", 4},    {"rating", 0},
                                            {"rule", 0},   {"model_version", 1}, {"tombstone", 0}, {"import_log", 0}};
  EXPECT_EQ(info->counts, expected);
  EXPECT_TRUE(checkStudy(*file)->empty());
}

TEST_F(StudyChecks, FindALostRecord) {
  EXPECT_NE(findingsAfter("DELETE FROM answer WHERE item = 2").find(": 1 records are missing\n"), std::string::npos);
}

TEST_F(StudyChecks, FindASessionThatWentOnInTwoCopies) {
  EXPECT_NE(findingsAfter("INSERT INTO rating SELECT randomblob(16), session_id, sequence, utc_ms, monotonic_ns,"
                          " entered_by, NULL, '', 'speed', 1, 1, 0 FROM answer WHERE item = 3",
                          {"rating"})
                .find(": 1 records have the number of another"),
            std::string::npos);
}

TEST_F(StudyChecks, FindDamagedRecordingsAndModels) {
  const auto findings = findingsAfter(
      "UPDATE recording SET data = CAST(substr(data, 1, 40) || x'A5' || substr(data, 42) AS BLOB);"
      "UPDATE model_version SET text = 'abd'");
  EXPECT_NE(findings.find(": bytes with another checksum\n"), std::string::npos) << findings;
  EXPECT_NE(findings.find(": its text does not fit its SHA-256\n"), std::string::npos) << findings;
  EXPECT_NE(findingsAfter("DELETE FROM recording").find(": has no recording\n"), std::string::npos);
}

TEST_F(StudyChecks, FindDoubleCodesAndDoubleCorrections) {
  const auto findings = findingsAfter(
      "INSERT INTO person VALUES (randomblob(16), 'velvet-otter', 0, 0);"
      "UPDATE answer SET supersedes = (SELECT id FROM answer WHERE item = 1) WHERE item > 2",
      {"person", "answer"});
  EXPECT_NE(findings.find("2 persons have the code 'velvet-otter' (ids "), std::string::npos) << findings;
  EXPECT_NE(findings.find(": has 2 corrections, the latest counts\n"), std::string::npos) << findings;
  const auto file = StudyFile::open(path_);
  const auto current = answers(*file);
  ASSERT_EQ(current->size(), 2U);
  EXPECT_EQ(current->back().item, 4);
}

TEST_F(StudyChecks, FindChangedRecordsInEveryTable) {
  // Whatever the column: these are not guarded by anything else.
  const std::vector<std::pair<std::string, std::string>> changes = {
      {"study", "name = 'other'"},         {"person", "code = 'other'"},        {"session", "station = 'other'"},
      {"answer", "value = 'other'"},       {"judgement", "commanded_n = 0.11"}, {"stroke", "verdict = 'other'"},
      {"recording", "channels = 'other'"}, {"model_version", "label = 'other'"}};
  for (const auto& [table, change] : changes) {
    const std::string findings = findingsAfter("UPDATE " + table + " SET " + change);
    EXPECT_NE(findings.find(table + " "), std::string::npos) << findings;
    EXPECT_NE(findings.find(": does not fit its CRC-32\n"), std::string::npos) << findings;
    EXPECT_EQ(findingsAfter("SELECT 1", {table}), "");
  }
}

TEST_F(StudyChecks, AChangedRecordIsNotRead) {
  findingsAfter(
      "UPDATE answer SET value = 'other' WHERE item = 2; UPDATE session SET station = 'other';"
      "UPDATE person SET code = 'other'; UPDATE recording SET channels = 'other';"
      "UPDATE model_version SET label = 'other'");
  const auto file = StudyFile::open(path_);
  ASSERT_TRUE(file) << file.error().message();
  const auto read = answers(*file);
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().message().find("study.tactus: answer "), std::string::npos) << read.error().message();
  EXPECT_NE(read.error().message().find("found a record that does not fit its CRC-32"), std::string::npos);
  EXPECT_TRUE(judgements(*file));
  EXPECT_FALSE(sessions(*file));
  EXPECT_FALSE(persons(*file));
  EXPECT_FALSE(strokes(*file));
  EXPECT_TRUE(strokes(*file, {}, Recordings::kLeaveOut));
  EXPECT_FALSE(modelVersions(*file));
  EXPECT_FALSE(latestModelVersion(*file));
  EXPECT_FALSE(writeRecords(*file, folder_.file("tables")));
}

TEST_F(StudyChecks, FindRowsWithoutTheRowTheyBelongTo) {
  EXPECT_NE(findingsAfter("UPDATE answer SET session_id = randomblob(16) WHERE item = 1").find("foreign_key_check: "),
            std::string::npos);
}

}  // namespace
}  // namespace tactus::store
