#include "core/store/merge.h"

#include <filesystem>
#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/store/entries.h"
#include "core/store/model_versions.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"
#include "core/store/withdrawal.h"

#include "tests/core/store/faulty_disk.h"
#include "tests/core/store/plain_sql.h"
#include "tests/core/store/sample_records.h"
#include "tests/support/temp_folder.h"

namespace tactus::store {
namespace {

namespace fs = std::filesystem;

/// All that a study says, whatever the order in which it came in: no row numbers, no log of merges.
std::string contentOf(const std::string& path) {
  PlainSql sql(path);
  std::string all;
  for (const std::string table : {"person", "session", "profile", "event", "stroke", "recording", "judgement", "answer",
                                  "rating", "rule", "model_version", "tombstone"}) {
    SQLite::Database database(path);
    SQLite::Statement columns(
        database, "SELECT name FROM pragma_table_info('" + table + "') WHERE name NOT IN ('place', 'crc32')");
    std::string row = "''";
    while (columns.executeStep()) row += " || ' ' || quote(\"" + columns.getColumn(0).getString() + "\")";
    all += table + "\n" + sql.lines("SELECT " + row + " FROM " + table + " ORDER BY 1");
  }
  return all;
}

class Merges : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.file(name + ".tactus"); }

  /// Closes nothing: the files must be closed. Returns the outcome, `into` holds the result.
  Merge mergeInto(const std::string& into, const std::string& from) {
    auto file = StudyFile::open(path(into), fast());
    EXPECT_TRUE(file) << file.error().message();
    const auto merged = mergeStudy(*file, path(from), records_.id(), 1'790'000'000'000);
    EXPECT_TRUE(merged) << merged.error().message();
    EXPECT_TRUE(file->close());
    return merged ? *merged : Merge{};
  }
  void copy(const std::string& from, const std::string& to) const {
    fs::copy_file(path(from), path(to), fs::copy_options::overwrite_existing);
  }

  /// Without waiting for the disk: these tests write hundreds of files.
  OpenOptions fast() const { return {Access::kReadWrite, disk_.name()}; }

  support::TempFolder folder_;
  FaultyDisk disk_{"merging"};
  SampleRecords records_{77};
};

TEST_F(Merges, BringInWhatIsNewAndNothingTwice) {
  SampleRecords north_records(1);
  SampleRecords south_records(2);
  auto north = makeStudy(path("north"), north_records);
  auto south = makeStudy(path("south"), south_records);
  const auto stroke = south_records.stroke(south.session.id);
  auto correction = south_records.answer(south.session.id, 8);
  const auto answer = south_records.answer(south.session.id);
  correction.entry.supersedes = answer.entry.id;
  const auto model = south_records.model("{}");
  ASSERT_TRUE(append(south.file, stroke) && append(south.file, answer) && append(south.file, correction) &&
              append(south.file, model));
  ASSERT_TRUE(north.file.close() && south.file.close());

  const auto first = mergeInto("north", "south");
  EXPECT_EQ(first.added,
            (std::vector<TableCount>{
                {"person", 1}, {"session", 1}, {"stroke", 1}, {"answer", 2}, {"recording", 1}, {"model_version", 1}}));
  // Both stations drew the same code for their person.
  ASSERT_EQ(first.conflicts.size(), 1U);
  EXPECT_EQ(first.conflicts[0], "person: 2 persons have the code 'velvet-otter'");
  const auto content = contentOf(path("north"));
  const auto second = mergeInto("north", "south");
  EXPECT_TRUE(second.added.empty());
  EXPECT_EQ(contentOf(path("north")), content);
  EXPECT_EQ(PlainSql(path("north")).number("SELECT count(*) FROM import_log"), 1);

  const auto file = StudyFile::open(path("north"));
  EXPECT_EQ(*strokes(*file), std::vector{stroke});
  EXPECT_EQ(*answers(*file), std::vector{correction});
  EXPECT_EQ((*latestModelVersion(*file))->id, model.id);
}

TEST_F(Merges, AreRefusedWhereTheyMakeNoSense) {
  SampleRecords records(1);
  auto study = makeStudy(path("a"), records);
  const auto itself = mergeStudy(study.file, path("a"), records.id(), 1);
  ASSERT_FALSE(itself);
  EXPECT_NE(itself.error().message().find("open elsewhere"), std::string::npos);
  EXPECT_FALSE(mergeStudy(study.file, path("nothing"), records.id(), 1));
  SampleRecords others(2);
  ASSERT_TRUE(makeStudy(path("b"), others).file.close());
  PlainSql(path("b")).complaint("PRAGMA user_version = 3");
  const auto newer = mergeStudy(study.file, path("b"), records.id(), 1);
  ASSERT_FALSE(newer);
  EXPECT_EQ(newer.error().code, base::ErrorCode::kVersion);
}

TEST_F(Merges, AChangedRecordIsListedAndNotTakenOver) {
  SampleRecords records(1);
  auto study = makeStudy(path("a"), records);
  ASSERT_TRUE(append(study.file, records.answer(study.session.id)) && study.file.close());
  copy("a", "b");
  ASSERT_EQ(PlainSql(path("b")).complaint("DROP TRIGGER answer_keep; UPDATE answer SET value = 'small'"), "");
  const auto content = contentOf(path("a"));
  const auto merged = mergeInto("a", "b");
  ASSERT_EQ(merged.conflicts.size(), 1U);
  EXPECT_NE(merged.conflicts[0].find("differs in the other file, this file's was kept"), std::string::npos);
  EXPECT_EQ(contentOf(path("a")), content);
}

TEST_F(Merges, WhatBothCorrectedIsListedAndTheLaterCounts) {
  SampleRecords records(1);
  auto study = makeStudy(path("a"), records);
  const auto answer = records.answer(study.session.id);
  ASSERT_TRUE(append(study.file, answer) && study.file.close());
  copy("a", "b");
  const auto correct = [&](const std::string& name, const std::string& value, std::int64_t utc_ms) {
    auto file = StudyFile::open(path(name));
    auto correction = records_.answer(study.session.id);
    correction.value = value;
    correction.entry.when.utc_ms = utc_ms;
    correction.entry.supersedes = answer.entry.id;
    ASSERT_TRUE(append(*file, correction) && file->close());
  };
  correct("a", "small", 1'800'000'000'000);
  correct("b", "medium", 1'700'000'000'000);
  const auto merged = mergeInto("a", "b");
  ASSERT_EQ(merged.conflicts.size(), 2U);  // the double correction, and the session that went on in two copies
  const auto file = StudyFile::open(path("a"));
  ASSERT_EQ(answers(*file)->size(), 1U);
  EXPECT_EQ(answers(*file)->front().value, "small");
  EXPECT_EQ(answers(*file, {.history = true})->size(), 3U);
}

/// Three stations that began with copies of one study, went on by themselves, and exchange their files.
class MergeProperties : public Merges, public testing::WithParamInterface<int> {
 protected:
  void SetUp() override {
    SampleRecords shared(1);
    auto study = makeStudy(path("origin"), shared);
    for (const char* code : {"calm-fox", "misty-lake", "quiet-drum"}) {
      const auto person = shared.person(code);
      const auto session = shared.session(person.id);
      ASSERT_TRUE(append(study.file, person) && append(study.file, session));
      ASSERT_TRUE(append(study.file, shared.answer(session.id)) && append(study.file, shared.stroke(session.id)));
    }
    ASSERT_TRUE(append(study.file, shared.model("first")) && study.file.close());
    base::Random random(static_cast<std::uint64_t>(GetParam()));
    for (const char* name : {"a", "b", "c"}) goOn(name, random);
  }

  void goOn(const std::string& name, base::Random& random) {
    copy("origin", name);
    SampleRecords records(random.next());
    auto opened = StudyFile::open(path(name), fast());
    ASSERT_TRUE(opened);
    StudyFile& file = *opened;
    for (int step = 0; step < 10; ++step) {
      const auto there = *sessions(file);
      const auto session = there.empty() ? study::RecordId() : there[random.below(static_cast<int>(there.size()))].id;
      const int choice = random.below(there.empty() ? 1 : 6);
      if (choice == 0) {
        const auto person = records.person(random.uniform() < 0.3 ? "the-same" : study::toText(records.id()));
        const bool is_new = append(file, person).has_value();
        ASSERT_TRUE(!is_new || append(file, records.session(person.id)));
      } else if (choice == 1) {
        ASSERT_TRUE(append(file, records.stroke(session)));
      } else if (choice == 2) {
        const auto before = *answers(file, {.session = session});
        auto answer = records.answer(session);
        if (!before.empty()) answer.entry.supersedes = before.back().entry.id;
        EXPECT_TRUE(append(file, answer));
      } else if (choice == 3) {
        ASSERT_TRUE(append(file, records.judgement(session)));
      } else if (choice == 4) {
        auto model = records.model(std::to_string(step));
        model.parent = (*latestModelVersion(file))->id;
        ASSERT_TRUE(append(file, model));
      } else if (random.uniform() < 0.5) {
        const auto persons_there = *persons(file);
        ASSERT_TRUE(withdraw(file, persons_there[random.below(static_cast<int>(persons_there.size()))].id, 5));
      }
    }
    ASSERT_TRUE(file.close());
  }
};

TEST_P(MergeProperties, OrderAndRepetitionDoNotMatter) {
  copy("a", "ab");
  mergeInto("ab", "b");
  copy("ab", "ab_c");
  mergeInto("ab_c", "c");
  copy("b", "bc");
  mergeInto("bc", "c");
  copy("a", "a_bc");
  mergeInto("a_bc", "bc");
  copy("c", "cba");
  mergeInto("cba", "b");
  mergeInto("cba", "a");
  const auto content = contentOf(path("ab_c"));
  EXPECT_EQ(contentOf(path("a_bc")), content);
  EXPECT_EQ(contentOf(path("cba")), content);
  for (const char* again : {"a", "b", "c", "ab", "bc", "cba"}) {
    const auto repeated = mergeInto("ab_c", again);
    EXPECT_TRUE(repeated.added.empty() || (repeated.added.size() == 1 && repeated.added[0].table == "import_log"));
  }
  EXPECT_EQ(contentOf(path("ab_c")), content);
}

TEST_P(MergeProperties, WhoWithdrewNeverComesBack) {
  mergeInto("a", "b");
  mergeInto("a", "c");
  mergeInto("a", "origin");
  PlainSql sql(path("a"));
  EXPECT_EQ(sql.number("SELECT count(*) FROM person WHERE id IN (SELECT person_id FROM tombstone)"), 0);
  EXPECT_EQ(sql.number("SELECT count(*) FROM session WHERE person_id IN (SELECT person_id FROM tombstone)"), 0);
  EXPECT_EQ(sql.lines("PRAGMA foreign_key_check"), "");
  EXPECT_EQ(sql.text("PRAGMA integrity_check"), "ok");
  // Each withdrawal of any station counts here.
  for (const char* name : {"b", "c"}) {
    EXPECT_EQ(sql.complaint("ATTACH '" + path(name) + "' AS other"), "");
    EXPECT_EQ(
        sql.number("SELECT count(*) FROM other.tombstone WHERE person_id NOT IN (SELECT person_id FROM tombstone)"), 0);
    sql.complaint("DETACH other");
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, MergeProperties, testing::Range(1, 9));

}  // namespace
}  // namespace tactus::store
