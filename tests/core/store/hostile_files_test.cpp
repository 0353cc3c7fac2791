// Study files made to mislead or to stop a program.
#include <filesystem>
#include <gtest/gtest.h>

#include "core/store/entries.h"
#include "core/store/merge.h"
#include "core/store/study_info.h"

#include "tests/core/store/plain_sql.h"
#include "tests/core/store/sample_records.h"
#include "tests/support/temp_folder.h"

namespace tactus::store {
namespace {

class HostileFiles : public testing::Test {
 protected:
  void SetUp() override {
    auto study = makeStudy(path_, records_);
    for (int item = 1; item <= 4; ++item) ASSERT_TRUE(append(study.file, records_.answer(study.session.id, item)));
    ASSERT_TRUE(study.file.close());
  }
  void change(const std::string& sql) const { ASSERT_EQ(PlainSql(path_).complaintWithoutGuards(sql), ""); }
  std::string openError(Access access) const {
    const auto file = StudyFile::open(path_, {access, {}});
    return file ? "" : file.error().message();
  }

  support::TempFolder folder_;
  SampleRecords records_;
  std::string path_ = folder_.file("study.tactus");
};

TEST_F(HostileFiles, AnotherSchemaIsNotBelieved) {
  const std::string endless = "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT * FROM answer, n";
  const std::vector<std::pair<std::string, std::string>> changes = {
      {"DROP VIEW answer_current; CREATE VIEW answer_current AS " + endless, "another view answer_current"},
      {"CREATE VIEW extra AS " + endless, "a foreign object"},
      {"CREATE TABLE extra (a)", "a foreign object"},
      {"CREATE INDEX extra ON answer (item)", "a foreign object"},
      {"CREATE TRIGGER extra AFTER INSERT ON answer BEGIN DELETE FROM judgement; END", "a foreign object"},
      {"DROP TRIGGER answer_keep", "no trigger answer_keep"},
      {"ALTER TABLE answer ADD COLUMN more TEXT", "another table answer"},
      {"PRAGMA writable_schema = ON; UPDATE sqlite_schema SET sql = replace(sql, 'response_s >= 0', 'response_s >= 1')"
       " WHERE name = 'answer'; UPDATE sqlite_schema SET sql = sql || ' ' WHERE name = 'rating'",
       "another table rating"},
  };
  for (const auto& [change, found] : changes) {
    SCOPED_TRACE(change);
    const std::string good = folder_.file("good.tactus");
    std::filesystem::copy_file(path_, good, std::filesystem::copy_options::overwrite_existing);
    ASSERT_EQ(PlainSql(path_).complaint(change), "");
    for (const Access access : {Access::kReadWrite, Access::kReadOnly}) {
      EXPECT_NE(openError(access).find("found " + found), std::string::npos) << openError(access);
      EXPECT_NE(openError(access).find("as Tactus makes them"), std::string::npos);
    }
    auto into = StudyFile::open(good);
    ASSERT_TRUE(into);
    EXPECT_FALSE(mergeStudy(*into, path_, records_.id(), 1));
    ASSERT_TRUE(into->close());
    std::filesystem::rename(good, path_);
  }
  EXPECT_EQ(openError(Access::kReadWrite), "");
}

TEST_F(HostileFiles, ViewsOfANewerVersionDoNotRun) {
  PlainSql(path_).complaint(
      "PRAGMA user_version = 99; DROP VIEW answer_current;"
      "CREATE VIEW answer_current AS WITH RECURSIVE n(i) AS"
      " (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT answer.* FROM answer, n");
  const auto file = StudyFile::open(path_, {Access::kReadOnly, {}});
  ASSERT_TRUE(file) << file.error().message();
  EXPECT_EQ(answers(*file)->size(), 4U);
}

TEST_F(HostileFiles, ARingOfCorrectionsEnds) {
  change(
      "PRAGMA foreign_keys = OFF;"
      "UPDATE answer SET supersedes = (SELECT id FROM answer WHERE item = 2) WHERE item = 1;"
      "UPDATE answer SET supersedes = (SELECT id FROM answer WHERE item = 1) WHERE item = 2;" +
      PlainSql(path_).seal("answer"));
  auto file = StudyFile::open(path_, {Access::kReadOnly, {}});
  ASSERT_TRUE(file) << file.error().message();
  EXPECT_EQ(answers(*file)->size(), 2U);
  const auto findings = checkStudy(*file);
  ASSERT_TRUE(findings) << findings.error().message();
  EXPECT_EQ(findings->size(), 2U);
  for (const auto& finding : *findings) {
    EXPECT_NE(finding.find(": its corrections go in a circle, so none of them counts"), std::string::npos) << finding;
  }
  ASSERT_TRUE(file->close());
  SampleRecords others(5);
  auto into = makeStudy(folder_.file("into.tactus"), others);
  const auto merged = mergeStudy(into.file, path_, records_.id(), 1);
  ASSERT_TRUE(merged) << merged.error().message();
  EXPECT_EQ(answers(into.file)->size(), 2U);
  EXPECT_TRUE(checkStudy(into.file).has_value());
}

TEST_F(HostileFiles, ALongChainOfCorrectionsEnds) {
  change(
      "PRAGMA foreign_keys = OFF;"
      "WITH RECURSIVE n(i) AS (SELECT 10 UNION ALL SELECT i + 1 FROM n WHERE i < 30000)"
      " INSERT INTO answer SELECT CAST(printf('%016d', i) AS BLOB), session_id, i, utc_ms, monotonic_ns,"
      " entered_by, iif(i = 10, NULL, CAST(printf('%016d', i - 1) AS BLOB)), '', form, form_version, item,"
      " position, status, value, response_s, wording, 0 FROM answer, n WHERE item = 1 ORDER BY i;" +
      PlainSql(path_).seal("answer"));
  auto file = StudyFile::open(path_, {Access::kReadOnly, {}});
  ASSERT_TRUE(file) << file.error().message();
  EXPECT_EQ(answers(*file)->size(), 5U);
  ASSERT_TRUE(file->close());
  SampleRecords others(5);
  auto into = makeStudy(folder_.file("into.tactus"), others);
  const auto merged = mergeStudy(into.file, path_, records_.id(), 1);
  ASSERT_TRUE(merged) << merged.error().message();
  EXPECT_EQ(answers(into.file)->size(), 5U);
}

}  // namespace
}  // namespace tactus::store
