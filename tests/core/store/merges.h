// Study files that are copied, changed and merged; what a study says whatever the order. For tests of merges.
#pragma once

#include <filesystem>
#include <gtest/gtest.h>
#include <string>

#include "core/store/merge.h"

#include "tests/core/store/faulty_disk.h"
#include "tests/core/store/plain_sql.h"
#include "tests/core/store/sample_records.h"
#include "tests/support/temp_folder.h"

namespace tactus::store {

/// All that a study says, whatever the order in which it came in: no row numbers, no log of merges, not when a model
/// was cleaned.
inline std::string contentOf(const std::string& path) {
  PlainSql sql(path);
  std::string all;
  for (const std::string table : {"person", "person_code", "session", "profile", "event", "stroke", "recording",
                                  "judgement", "answer", "rating", "rule", "model_version", "tombstone"}) {
    SQLite::Database database(path);
    SQLite::Statement columns(database, "SELECT name FROM pragma_table_info('" + table +
                                            "') WHERE name NOT IN ('place', 'crc32', 'cleaned_utc_ms')");
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
  base::Result<Merge> tryMerge(const std::string& into, const std::string& from) {
    auto file = StudyFile::open(path(into), fast());
    EXPECT_TRUE(file) << file.error().message();
    auto merged = mergeStudy(*file, path(from), records_.id(), 1'790'000'000'000);
    EXPECT_TRUE(file->close());
    return merged;
  }
  Merge mergeInto(const std::string& into, const std::string& from) {
    const auto merged = tryMerge(into, from);
    EXPECT_TRUE(merged) << merged.error().message();
    return merged ? *merged : Merge{};
  }
  void copy(const std::string& from, const std::string& to) const {
    std::filesystem::copy_file(path(from), path(to), std::filesystem::copy_options::overwrite_existing);
  }

  /// Without waiting for the disk: these tests write hundreds of files.
  OpenOptions fast() const { return {Access::kReadWrite, disk_.name()}; }

  support::TempFolder folder_;
  FaultyDisk disk_{"merging"};
  SampleRecords records_{77};
};

}  // namespace tactus::store
