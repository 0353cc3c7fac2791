// What another program can do to a study file with plain SQL: add, but not change and not remove.
#include <algorithm>
#include <gtest/gtest.h>
#include <memory>

#include "core/store/entries.h"
#include "core/store/model_versions.h"
#include "core/store/study_info.h"

#include "tests/core/store/plain_sql.h"
#include "tests/core/store/sample_records.h"
#include "tests/support/temp_folder.h"

namespace tactus::store {
namespace {

/// A study with a row in every table but those of withdrawal and import, closed.
class Guards : public testing::Test {
 protected:
  Guards() {
    fill();
    sql_ = std::make_unique<PlainSql>(path_);
    sql_->complaint("INSERT INTO import_log VALUES (randomblob(16), 1, 'merge', 'b.tactus', '', '', 0)");
    sql_->complaint("INSERT INTO tombstone VALUES (randomblob(16), 1, NULL, NULL, 0)");
    sql_->complaint("INSERT INTO person_code SELECT randomblob(16), id, 1, 'calm-fox', 0 FROM person");
    sql_->complaint("INSERT INTO incident VALUES (randomblob(16), 1, 'journal_missing', '', 0)");
    sql_->complaint("INSERT INTO protocol VALUES (randomblob(16), 1, 1, '', '', '{}', 0)");
    sql_->complaint("INSERT INTO depth_measurement VALUES (randomblob(16), 1, '', '{}', NULL, NULL, 0)");
    sql_->complaint("INSERT INTO research_key VALUES (1, 1, '', 0)");
  }

  void fill() {
    auto study = makeStudy(path_, records_);
    const auto session = study.session.id;
    const bool written =
        append(study.file, records_.profile(session)) && append(study.file, records_.event(session)) &&
        append(study.file, records_.stroke(session)) && append(study.file, records_.judgement(session)) &&
        append(study.file, records_.answer(session)) && append(study.file, records_.rating(session)) &&
        append(study.file, records_.rule(session)) && append(study.file, records_.model("{}")) && study.file.close();
    ASSERT_TRUE(written);
  }

  support::TempFolder folder_;
  SampleRecords records_;
  std::string path_ = folder_.file("study.tactus");
  std::unique_ptr<PlainSql> sql_;

  const std::vector<std::string> tables_ = {
      "study",    "person",       "session",          "profile",   "event",     "stroke",     "recording",   "answer",
      "rating",   "rule",         "model_version",    "judgement", "tombstone", "import_log", "person_code", "incident",
      "protocol", "research_key", "depth_measurement"};
  const std::vector<std::string> no_records_ = {"opening", "erasure"};
};

TEST_F(Guards, EveryTableIsNamedHere) {
  std::string expected;
  auto names = tables_;
  names.insert(names.end(), no_records_.begin(), no_records_.end());
  std::sort(names.begin(), names.end());
  for (const auto& name : names) expected += name + "\n";
  EXPECT_EQ(sql_->lines("SELECT name FROM pragma_table_list WHERE schema = 'main' AND type = 'table'"
                        " AND name NOT LIKE 'sqlite_%' ORDER BY name"),
            expected);
}

TEST_F(Guards, NothingIsChanged) {
  sql_->complaint("PRAGMA foreign_keys = OFF");
  for (const auto& table : tables_) {
    ASSERT_EQ(sql_->number("SELECT count(*) FROM " + table), 1) << table;
    SQLite::Database reading(path_);
    SQLite::Statement columns(reading, "SELECT name FROM pragma_table_info('" + table + "')");
    while (columns.executeStep()) {
      const std::string column = columns.getColumn(0).getString();
      for (const std::string verb : {"UPDATE ", "UPDATE OR REPLACE ", "UPDATE OR IGNORE "}) {
        EXPECT_EQ(sql_->complaint(verb + table + " SET \"" + column + "\" = \"" + column + "\""),
                  table + ": what was recorded is never changed");
      }
    }
  }
}

TEST_F(Guards, NothingIsRemoved) {
  sql_->complaint("PRAGMA foreign_keys = OFF");
  for (const auto& table : tables_) {
    EXPECT_TRUE(sql_->complaint("DELETE FROM " + table).starts_with(table + ": ")) << table;
    EXPECT_EQ(sql_->number("SELECT count(*) FROM " + table), 1) << table;
  }
}

TEST_F(Guards, NothingIsReplaced) {
  sql_->complaint("PRAGMA foreign_keys = OFF");
  // Without the setting, REPLACE removes rows without asking the triggers for it.
  for (const std::string setting : {"OFF", "ON"}) {
    sql_->complaint("PRAGMA recursive_triggers = " + setting);
    for (const auto& table : tables_) {
      const std::string complaint = sql_->complaint("INSERT OR REPLACE INTO " + table + " SELECT * FROM " + table);
      EXPECT_TRUE(complaint.starts_with(table + ": ")) << table << " " << complaint;
      EXPECT_NE(sql_->complaint("INSERT INTO " + table + " SELECT * FROM " + table +
                                " WHERE true ON CONFLICT DO UPDATE SET " +
                                (table == "tombstone" ? "person_id = excluded.person_id" : "rowid = 1")),
                "");
    }
    // By another key than the id.
    EXPECT_EQ(
        sql_->complaint("INSERT OR REPLACE INTO recording SELECT place, randomblob(16), session_id, sample_rate_hz,"
                        " samples, channels, data, crc32 FROM recording"),
        "recording: this record is there already");
    EXPECT_EQ(sql_->complaint("INSERT OR REPLACE INTO model_version SELECT place, randomblob(16), sequence, parent,"
                              " utc_ms, author, label, sha256, text, cleaned_utc_ms, crc32 FROM model_version"),
              "model_version: this record is there already");
  }
}

TEST_F(Guards, WhatIsNoNumberDoesNotSlipIn) {
  const std::string begin =
      "INSERT INTO judgement SELECT randomblob(16), session_id, 99, 1, 1, 'program', NULL, '', 'ascending', 1, 1, ";
  const std::string end = ", NULL, 'not_felt', '', 1, 0, 0, 1, 1, 1, NULL, 0 FROM judgement LIMIT 1";
  EXPECT_EQ(sql_->complaint(begin + "0.5" + end), "");
  for (const std::string value : {"NULL", "9e999", "-9e999", "9e999 - 9e999", "-0.1", "'many'"}) {
    EXPECT_NE(sql_->complaint(begin + value + end), "") << value;
  }
}

TEST_F(Guards, APersonWhoWithdrewNeverComesBack) {
  EXPECT_EQ(sql_->complaint("INSERT INTO person SELECT person_id, 'calm-fox', 0, 0 FROM tombstone"),
            "person: this participant withdrew");
}

TEST_F(Guards, OnlyAnErasureThatIsNotFinishedLetsModelVersionsBeCleaned) {
  EXPECT_EQ(sql_->complaint("INSERT INTO erasure SELECT id, 1 FROM person"),
            "erasure: only of a participant who withdrew");
  ASSERT_EQ(sql_->complaint("INSERT INTO erasure SELECT person_id, 1 FROM tombstone"), "");
  EXPECT_EQ(sql_->complaint("UPDATE model_version SET label = ''"), "");
  EXPECT_EQ(sql_->complaint("UPDATE erasure SET utc_ms = 2"), "erasure: what was recorded is never changed");
  ASSERT_EQ(sql_->complaint("DELETE FROM erasure"), "");
  EXPECT_EQ(sql_->complaint("UPDATE model_version SET label = 'x'"),
            "model_version: what was recorded is never changed");
}

}  // namespace
}  // namespace tactus::store
