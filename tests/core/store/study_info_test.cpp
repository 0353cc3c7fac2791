#include "core/store/study_info.h"

#include <gtest/gtest.h>

#include "core/store/entries.h"
#include "core/store/model_versions.h"

#include "tests/core/store/plain_sql.h"
#include "tests/core/store/sample_records.h"
#include "tests/support/temp_folder.h"

namespace tactus::store {
namespace {

/// What `checkStudy` finds after somebody worked on the file with the guards taken away.
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
  std::string findingsAfter(const std::string& sql) {
    {
      PlainSql plain(path_);
      for (const std::string table : {"answer", "judgement", "recording", "model_version"}) {
        plain.complaint("DROP TRIGGER " + table + "_keep; DROP TRIGGER " + table + "_stay");
      }
      EXPECT_EQ(plain.complaint("PRAGMA foreign_keys = OFF; " + sql), "");
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
                          " entered_by, NULL, '', 'speed', 1, 1 FROM answer WHERE item = 3")
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
      "INSERT INTO person VALUES (randomblob(16), 'velvet-otter', 0);"
      "UPDATE answer SET supersedes = (SELECT id FROM answer WHERE item = 1) WHERE item > 2");
  EXPECT_NE(findings.find("2 persons have the code 'velvet-otter'\n"), std::string::npos) << findings;
  EXPECT_NE(findings.find(": has 2 corrections, the latest counts\n"), std::string::npos) << findings;
  const auto file = StudyFile::open(path_);
  const auto current = answers(*file);
  ASSERT_EQ(current->size(), 2U);
  EXPECT_EQ(current->back().item, 4);
}

TEST_F(StudyChecks, FindRowsWithoutTheRowTheyBelongTo) {
  EXPECT_NE(findingsAfter("UPDATE answer SET session_id = randomblob(16) WHERE item = 1").find("foreign_key_check: "),
            std::string::npos);
}

}  // namespace
}  // namespace tactus::store
