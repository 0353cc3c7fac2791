#include "core/store/study_file.h"

#include <csignal>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/store/entries.h"
#include "core/store/study_info.h"

#include "tests/core/store/plain_sql.h"
#include "tests/core/store/sample_records.h"
#include "tests/support/as_nobody.h"
#include "tests/support/temp_folder.h"

namespace tactus::store {
namespace {

namespace fs = std::filesystem;
using base::ErrorCode;
using support::AsNobody;

class StudyFiles : public testing::Test {
 protected:
  std::string path() const { return folder_.file("a study.tactus"); }
  void writeText(const std::string& text) const { std::ofstream(path()) << text; }
  void makeClosedStudy() {
    auto study = makeStudy(path(), records_);
    ASSERT_TRUE(append(study.file, records_.answer(study.session.id)));
    ASSERT_TRUE(study.file.close());
  }
  std::string openError(Access access = Access::kReadWrite) const {
    const auto file = StudyFile::open(path(), {access, {}});
    return file ? "" : file.error().message();
  }

  support::TempFolder folder_;
  SampleRecords records_;
};

TEST_F(StudyFiles, ANewOneIsThereWholeAndAlone) {
  auto file = StudyFile::create(path(), records_.study());
  ASSERT_TRUE(file) << file.error().message();
  const auto info = studyInfo(*file);
  ASSERT_TRUE(info) << info.error().message();
  EXPECT_EQ(info->name, "Tube study");
  EXPECT_EQ(info->program, "tactus 0.1.0");
  EXPECT_EQ(info->created_utc_ms, 1'760'000'000'000);
  EXPECT_EQ(info->version, 1);
  for (const auto& count : info->counts) EXPECT_EQ(count.rows, 0) << count.table;
  ASSERT_TRUE(file->close());
  EXPECT_EQ(std::distance(fs::directory_iterator(fs::path(path()).parent_path()), {}), 1);
}

TEST_F(StudyFiles, FollowsTheRules) {
  makeClosedStudy();
  PlainSql sql(path());
  EXPECT_EQ(sql.number("PRAGMA application_id"), 0x54414353);
  EXPECT_EQ(sql.number("PRAGMA user_version"), 1);
  EXPECT_EQ(sql.text("PRAGMA journal_mode"), "wal");
  EXPECT_EQ(sql.text("PRAGMA integrity_check"), "ok");
  EXPECT_EQ(sql.number("SELECT count(*) FROM pragma_table_list WHERE schema = 'main' AND type = 'table'"
                       " AND strict = 0 AND name NOT LIKE 'sqlite_%'"),
            0);
}

TEST_F(StudyFiles, OneIsNeverPutOverAnotherFile) {
  writeText("precious");
  const auto file = StudyFile::create(path(), records_.study());
  ASSERT_FALSE(file);
  EXPECT_NE(file.error().message().find("found a file of this name"), std::string::npos);
  EXPECT_EQ(fs::file_size(path()), 8U);
}

TEST_F(StudyFiles, OpensAgainWithWhatWasWritten) {
  makeClosedStudy();
  for (const Access access : {Access::kReadWrite, Access::kReadOnly}) {
    const auto file = StudyFile::open(path(), {access, {}});
    ASSERT_TRUE(file) << file.error().message();
    EXPECT_EQ(file->access(), access);
    EXPECT_EQ(answers(*file)->size(), 1U);
  }
}

TEST_F(StudyFiles, ForReadingOnlyRefusesToWrite) {
  makeClosedStudy();
  auto file = StudyFile::open(path(), {Access::kReadOnly, {}});
  ASSERT_TRUE(file);
  const auto written = append(*file, records_.answer(records_.id()));
  ASSERT_FALSE(written);
  EXPECT_NE(written.error().message().find("open for reading only"), std::string::npos);
}

TEST_F(StudyFiles, SaysWhatIsThereInsteadOfAStudy) {
  EXPECT_NE(openError().find("found no such file"), std::string::npos);
  fs::create_directory(path());
  EXPECT_NE(openError().find("found a folder"), std::string::npos);
  fs::remove(path());
  writeText("participant,years\nP1,3\n");
  EXPECT_NE(openError().find("found a file of another kind, wanted a Tactus study file"), std::string::npos);
  writeText("");
  EXPECT_NE(openError().find("found an empty file, wanted a Tactus study file"), std::string::npos);
  EXPECT_EQ(fs::file_size(path()), 0U);
  fs::remove(path());
  PlainSql(path()).complaint("CREATE TABLE bookmarks (url TEXT)");
  EXPECT_NE(openError().find("found a database of another program"), std::string::npos);
  EXPECT_EQ(PlainSql(path()).text("PRAGMA journal_mode"), "delete");  // it was not touched
}

TEST_F(StudyFiles, ANewerVersionCanOnlyBeRead) {
  makeClosedStudy();
  PlainSql(path()).complaint("PRAGMA user_version = 2");
  const auto file = StudyFile::open(path());
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().code, ErrorCode::kVersion);
  EXPECT_NE(
      file.error().message().find("found a study of version 2, wanted at most version 1: a newer Tactus wrote it, "
                                  "and this one can open it for reading only"),
      std::string::npos);
  const auto reading = StudyFile::open(path(), {Access::kReadOnly, {}});
  ASSERT_TRUE(reading) << reading.error().message();
  EXPECT_EQ(reading->version(), 2);
  EXPECT_EQ(answers(*reading)->size(), 1U);
}

TEST_F(StudyFiles, OneAtATime) {
  makeClosedStudy();
  auto first = StudyFile::open(path());
  ASSERT_TRUE(first);
  EXPECT_NE(openError().find("found a study that is open elsewhere"), std::string::npos);
  EXPECT_NE(openError(Access::kReadOnly).find("found a study that is open elsewhere"), std::string::npos);
  EXPECT_EQ(PlainSql(path()).complaint("SELECT count(*) FROM answer"), "database is locked");
  // The attempts have not loosened the lock of the first.
  EXPECT_EQ(answers(*first)->size(), 1U);
  EXPECT_EQ(PlainSql(path()).complaint("SELECT count(*) FROM answer"), "database is locked");
  ASSERT_TRUE(first->close());
  EXPECT_EQ(openError(), "");
}

TEST_F(StudyFiles, WhatMayNotBeWrittenIsSaidAndCanBeRead) {
  makeClosedStudy();
  const fs::path folder = fs::path(path()).parent_path();
  EXPECT_FALSE(readOnlyReason(path()));
  fs::permissions(path(), fs::perms(0444));
  fs::permissions(folder, fs::perms(0755));
  {
    const AsNobody nobody;
    EXPECT_NE(openError().find("found a file that may not be written to"), std::string::npos) << openError();
    EXPECT_EQ(openError(Access::kReadOnly), "");
    EXPECT_EQ(readOnlyReason(path())->found, "a file that may not be written to");
    EXPECT_FALSE(readOnlyReason(folder_.file("nowhere.tactus")));
  }
  fs::permissions(path(), fs::perms(0666));
  fs::permissions(folder, fs::perms(0555));
  {
    const AsNobody nobody;
    EXPECT_NE(openError().find("found a folder that may not be written to"), std::string::npos) << openError();
    const auto reading = StudyFile::open(path(), {Access::kReadOnly, {}});
    ASSERT_TRUE(reading) << reading.error().message();
    EXPECT_EQ(answers(*reading)->size(), 1U);
    const auto made = StudyFile::create(folder_.file("new.tactus"), records_.study());
    ASSERT_FALSE(made);
    EXPECT_NE(made.error().message().find("wanted a folder in which files can be made"), std::string::npos);
  }
  fs::permissions(folder, fs::perms(0755));
}

TEST_F(StudyFiles, ADamagedOneIsRefused) {
  makeClosedStudy();
  const auto bytes = fs::file_size(path());
  {
    std::fstream file(path(), std::ios::in | std::ios::out | std::ios::binary);
    for (std::streamoff at = 5000; at < static_cast<std::streamoff>(bytes); at += 4096) {
      file.seekp(at);
      file.write("\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF", 8);
      file.seekp(at - 5000 + 4096);
      file.write("\x00\x01\x02\x03", 4);
    }
  }
  EXPECT_NE(openError().find("found a damaged file ("), std::string::npos) << openError();
  fs::remove(path());
  makeClosedStudy();
  fs::resize_file(path(), fs::file_size(path()) / 2);
  EXPECT_NE(openError().find("found a damaged file ("), std::string::npos) << openError();
}

TEST_F(StudyFiles, ALimitOnTheSizeOfFilesIsToldAsTheReason) {
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);  // as the programs do
    const rlimit limit{100'000, 100'000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    SampleRecords records;
    const auto made = StudyFile::create(folder_.file("limited.tactus"), records.study());
    const bool said = !made && made.error().message().find("(ulimit -f)") != std::string::npos;
    ::_exit(said ? 0 : 1);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  EXPECT_FALSE(std::filesystem::exists(folder_.file("limited.tactus")));
}

}  // namespace
}  // namespace tactus::store
