#include "core/store/migrations.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

#include "core/store/entries.h"
#include "core/store/model_versions.h"
#include "core/store/persons.h"
#include "core/store/record_import.h"
#include "core/store/record_tables.h"
#include "core/store/research_key.h"
#include "core/store/sessions.h"
#include "core/store/study_info.h"
#include "core/store/study_records.h"
#include "core/store/withdrawal.h"

#include "tests/core/store/plain_sql.h"
#include "tests/core/store/sample_records.h"
#include "tests/support/temp_folder.h"

namespace tactus::store {
namespace {

namespace fs = std::filesystem;

/// What the current schema looks like.
constexpr const char* kSchema = "SELECT sql FROM sqlite_schema WHERE sql IS NOT NULL ORDER BY type, name";

class Migrations : public testing::Test {
 protected:
  void SetUp() override {
    auto study = makeStudy(path_, records_);
    ASSERT_TRUE(append(study.file, records_.answer(study.session.id)));
    ASSERT_TRUE(study.file.close());
  }
  /// The error of migrating through `later` steps after that of the program, which every study here has taken.
  std::string migrateTo(const std::vector<std::string>& later) const {
    std::vector<Migration> steps = {{1, "this must not run again"}};
    for (const auto& sql : later) steps.push_back({static_cast<int>(steps.size()) + 1, sql});
    const auto done = migrateFile(path_, steps);
    return done ? "" : done.error().message();
  }

  support::TempFolder folder_;
  SampleRecords records_;
  std::string path_ = folder_.file("study.tactus");
  const std::string later_ = "ALTER TABLE answer ADD COLUMN certainty REAL";
  // The rebuild of a table, as SQLite's manual describes it for what ALTER cannot do.
  const std::string second_later_ =
      "CREATE TABLE person_new (id BLOB NOT NULL PRIMARY KEY, code TEXT NOT NULL, simulated INTEGER NOT NULL,"
      " note TEXT NOT NULL) STRICT, WITHOUT ROWID;"
      "INSERT INTO person_new SELECT id, code, simulated, '' FROM person;"
      "DROP VIEW person_current; DROP TABLE person; ALTER TABLE person_new RENAME TO person;";
};

TEST_F(Migrations, EachStepRunsOnceInOrder) {
  ASSERT_EQ(migrateTo({later_, second_later_}), "");
  {
    PlainSql sql(path_);
    EXPECT_EQ(sql.number("PRAGMA user_version"), 3);
    EXPECT_EQ(sql.number("SELECT count(*) FROM answer WHERE certainty IS NULL"), 1);
    EXPECT_EQ(sql.text("SELECT code || note FROM person"), "velvet-otter");
    EXPECT_EQ(sql.lines("PRAGMA foreign_key_check"), "");
    EXPECT_NE(sql.complaint("UPDATE answer SET certainty = 1"), "");  // new columns are guarded too
  }
  EXPECT_EQ(migrateTo({later_, second_later_}), "");
}

TEST_F(Migrations, ACopyIsMadeBeforeAndOnlyWhenNeeded) {
  ASSERT_EQ(migrateTo({}), "");
  EXPECT_FALSE(fs::exists(path_ + ".before-v2"));
  ASSERT_EQ(migrateTo({later_}), "");
  const auto copy = StudyFile::open(path_ + ".before-v2");
  ASSERT_TRUE(copy) << copy.error().message();
  EXPECT_EQ(copy->version(), 1);
  EXPECT_EQ(answers(*copy)->size(), 1U);
}

TEST_F(Migrations, AFailingStepLeavesTheFileAsItWas) {
  std::string schema;
  schema = PlainSql(path_).lines(kSchema);
  const std::vector<std::pair<std::string, std::string>> failing = {
      {later_ + "; SELECT nonsense FROM nowhere", "no such table"},
      {"INSERT INTO recording VALUES (1, randomblob(16), randomblob(16), 1000, 0, '', zeroblob(24), 0)",
       "found a row of recording without the row it belongs to"},
      {"UPDATE answer SET value = 'small'", "never changed"},
  };
  int copies = 0;
  for (const auto& [sql, complaint] : failing) {
    EXPECT_NE(migrateTo({sql}).find(complaint), std::string::npos) << migrateTo({sql});
    PlainSql plain(path_);
    EXPECT_EQ(plain.number("PRAGMA user_version"), 1);
    EXPECT_EQ(plain.lines(kSchema), schema);
    EXPECT_EQ(plain.number("SELECT count(*) FROM answer WHERE value = 'very_large'"), 1);
    EXPECT_TRUE(fs::exists(path_ + (++copies == 1 ? ".before-v2" : ".before-v2-" + std::to_string(copies))));
  }
  const auto file = StudyFile::open(path_);
  ASSERT_TRUE(file) << file.error().message();
}

TEST_F(Migrations, TheStepsBeforeAFailingOneStay) {
  EXPECT_NE(migrateTo({later_, "nonsense"}), "");
  EXPECT_EQ(PlainSql(path_).number("PRAGMA user_version"), 2);
  ASSERT_EQ(migrateTo({later_, second_later_}), "");
  EXPECT_EQ(PlainSql(path_).number("PRAGMA user_version"), 3);
}

TEST_F(Migrations, OnlyOfStudies) {
  std::ofstream(folder_.file("note.txt")) << "just a note, long enough to be no empty database at all";
  const std::vector<Migration> steps = {{1, "SELECT 1"}};
  EXPECT_FALSE(migrateFile(folder_.file("note.txt"), steps));
  EXPECT_FALSE(migrateFile(folder_.file("nothing"), steps));
}

/// A study of version `name`, from the SQL text under tests/golden/store.
std::string makeFixture(const support::TempFolder& folder, const std::string& name) {
  std::ostringstream script;
  script << std::ifstream(std::string(TACTUS_GOLDEN_DIR) + "/store/" + name + ".sql").rdbuf();
  const std::string path = folder.file(name + ".tactus");
  EXPECT_EQ(PlainSql(path).complaint(script.str()), "");
  return path;
}

/// What every fixture holds, read from `file`.
void expectRecords(const base::Result<StudyFile>& file) {
  ASSERT_TRUE(file) << file.error().message();
  const auto session = sessions(*file)->front();
  EXPECT_EQ(session.seed, 18446744073709551615U);
  EXPECT_EQ(session.device_friction_n, 0.26);
  const auto answer = answers(*file);
  ASSERT_EQ(answer->size(), 1U);  // the second corrects the first
  EXPECT_EQ(answer->front().value, "small");
  EXPECT_EQ(answer->front().entry.entered_by, study::EnteredBy::kResearcher);
  EXPECT_EQ(judgements(*file)->front().commanded_n, 0.1);
  EXPECT_EQ(profiles(*file)->front().insertions_per_month, std::nullopt);
  EXPECT_EQ(rules(*file)->front().rule.conditions,
            (std::vector<study::ItemCondition>{{"speed", "fast"}, {"depth", "esophagus"}}));
  EXPECT_EQ(strokes(*file)->front().recording, (study::Recording{1000, {{"depth", "mm", {1.5, -2}}}}));
  EXPECT_EQ((*latestModelVersion(*file))->text, "abc");
  EXPECT_EQ(events(*file)->front().kind, "finished");
  EXPECT_EQ(ratings(*file)->front().comfort, 6);
  EXPECT_EQ(tombstones(*file)->front().utc_ms, 1770000000900);
}

class Version1 : public testing::TestWithParam<Access> {};

TEST_P(Version1, IsReadInFull) {
  const support::TempFolder folder;
  const auto file = StudyFile::open(makeFixture(folder, "v1"), {GetParam(), {}});
  expectRecords(file);
  EXPECT_EQ(file->version(), 1);
  const auto info = studyInfo(*file);
  ASSERT_TRUE(info) << info.error().message();
  EXPECT_EQ(info->name, "Fixture of version 1");
  EXPECT_EQ(persons(*file)->front().code, "calm-fox-2");
  EXPECT_EQ(answers(*file)->front().wording, "published");
  EXPECT_EQ(judgements(*file)->front().delivered_share, 0.53);
  EXPECT_EQ(profiles(*file)->front().comfort, "good");
  const auto all = protocols(*file);
  ASSERT_TRUE(all) << all.error().message();
  ASSERT_EQ(all->size(), 2U);
  EXPECT_EQ(sessions(*file)->front().protocol, all->front().id);
  EXPECT_EQ(all->back().reason, "shorter");
  EXPECT_EQ(info->protocol_version, 1);
  EXPECT_FALSE(info->protocol_locked) << "only a simulated person follows it";
  EXPECT_TRUE(*opensResearch(*file, "correct horse"));
  EXPECT_FALSE(*opensResearch(*file, "correct house"));
  const auto measured = depthMeasurement(*file);
  ASSERT_TRUE(measured && *measured);
  EXPECT_EQ((*measured)->text, R"({"mm_per_px":0.5})");
  EXPECT_EQ((*measured)->image, "\x89PNG") << "of the record before";
  EXPECT_EQ(*checkStudy(*file),
            std::vector<std::string>{"incident: the journal was missing when the study was opened"});
  EXPECT_TRUE(writeRecords(*file, folder.file("tables")));
}

TEST_P(Version1, ADamagedRecordStaysDamaged) {
  const support::TempFolder folder;
  const auto path = makeFixture(folder, "v1");
  ASSERT_EQ(PlainSql(path).complaintWithoutGuards("UPDATE judgement SET commanded_n = 1.7"), "");
  const auto file = StudyFile::open(path, {GetParam(), {}});
  ASSERT_TRUE(file) << file.error().message();
  EXPECT_FALSE(judgements(*file));
  EXPECT_EQ(answers(*file)->size(), 1U);
}

INSTANTIATE_TEST_SUITE_P(Both, Version1, testing::Values(Access::kReadWrite, Access::kReadOnly));

TEST(StoredVersions, TheTablesFromBeforeTheReleaseComeBack) {
  const support::TempFolder folder;
  ASSERT_TRUE(restoreRecords(std::string(TACTUS_GOLDEN_DIR) + "/store/v5-tables", folder.file("restored.tactus")));
  expectRecords(StudyFile::open(folder.file("restored.tactus")));
}

TEST(StoredVersions, AStudyFromBeforeTheReleaseIsRefusedWithTheWayOutAndStaysAsItIs) {
  const support::TempFolder folder;
  const auto path = makeFixture(folder, "v1");
  ASSERT_EQ(PlainSql(path).complaint("PRAGMA application_id = 0x54414354; PRAGMA user_version = 4"), "");
  const auto bytes = [&path] {
    std::ostringstream all;
    all << std::ifstream(path, std::ios::binary).rdbuf();
    return all.str();
  };
  const std::string before = bytes();
  for (const Access access : {Access::kReadWrite, Access::kReadOnly}) {
    const auto file = StudyFile::open(path, {access, {}});
    ASSERT_FALSE(file);
    EXPECT_EQ(file.error().message(),
              path +
                  ": found a study of a Tactus from before the release (version 4 of its tables), wanted a study of "
                  "version 1; export it with the last Tactus that opens it (tactus study export STUDY FOLDER), and "
                  "import the folder here");
    EXPECT_EQ(bytes(), before);
  }
  EXPECT_FALSE(migrateFile(path, schemaSteps()));
  EXPECT_EQ(std::distance(fs::directory_iterator(fs::path(path).parent_path()), fs::directory_iterator()), 1);
}

TEST(StoredVersions, TheStepOfTheProgramStillMakesTheSameTables) {
  const support::TempFolder folder;
  SampleRecords records;
  auto made = StudyFile::create(folder.file("new.tactus"), records.study());
  ASSERT_TRUE(made && made->close());
  EXPECT_EQ(PlainSql(makeFixture(folder, "v1")).lines(kSchema), PlainSql(folder.file("new.tactus")).lines(kSchema));
}

}  // namespace
}  // namespace tactus::store
