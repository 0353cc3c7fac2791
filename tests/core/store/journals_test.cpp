// What lies beside a study: journals of other files, journals that were removed, cut or changed, and files that are
// replaced while a study is open.
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

#include "core/store/batch.h"
#include "core/store/copies.h"
#include "core/store/entries.h"
#include "core/store/merge.h"
#include "core/store/model_versions.h"
#include "core/store/record_import.h"
#include "core/store/record_tables.h"
#include "core/store/study_info.h"

#include "tests/core/store/faulty_disk.h"
#include "tests/core/store/sample_records.h"
#include "tests/support/temp_folder.h"

namespace tactus::store {
namespace {

namespace fs = std::filesystem;

/// A study that is open, and pictures of it as a crash would leave it: the file and its journal.
class Journals : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.file(name + ".tactus"); }
  std::string journal(const std::string& name) const { return path(name) + "-wal"; }

  static void add(OpenStudy& study, SampleRecords& records, int count) {
    for (int i = 0; i < count; ++i) ASSERT_TRUE(append(study.file, records.answer(study.session.id)));
  }
  /// Copies file and journal of the open study `from`, as they lie on the disk.
  void crash(const std::string& from, const std::string& to) const {
    fs::copy_file(path(from), path(to), fs::copy_options::overwrite_existing);
    fs::copy_file(journal(from), journal(to), fs::copy_options::overwrite_existing);
  }
  std::string openError(const std::string& name, Access access = Access::kReadWrite) const {
    const auto file = StudyFile::open(path(name), {access, {}});
    return file ? "" : file.error().message();
  }
  /// Opens for writing and says what is there: the number of answers, and what the opening said.
  std::pair<std::size_t, std::vector<std::string>> opened(const std::string& name) const {
    const auto file = StudyFile::open(path(name), {Access::kReadWrite, disk_.name()});
    if (!file) return {0, {file.error().message()}};
    std::vector<std::string> notices;
    for (const auto& notice : file->notices()) {
      EXPECT_EQ(notice.kind, Notice::Kind::kJournal);
      notices.push_back(notice.sentence);
    }
    return {answers(*file)->size(), notices};
  }
  static std::string bytesOf(const std::string& path) {
    std::ostringstream out;
    out << std::ifstream(path, std::ios::binary).rdbuf();
    return out.str();
  }
  static void write(const std::string& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
  }
  /// Bytes of the journal that hold frames: the rest is room.
  static std::size_t framesEnd(const std::string& bytes) {
    const std::string salts = bytes.substr(16, 8);
    std::size_t end = 32;
    while (end + 4120 <= bytes.size() && bytes.compare(end + 8, 8, salts) == 0) end += 4120;
    return end;
  }

  support::TempFolder folder_;
  FaultyDisk disk_{"journals"};  // without waiting for the disk: some of these tests open a hundred files
  SampleRecords records_;
};

using Strings = std::vector<std::string>;

TEST_F(Journals, AfterAKillNothingIsSaidAndAllIsThere) {
  auto study = makeStudy(path("a"), records_);
  add(study, records_, 5);
  crash("a", "b");
  EXPECT_EQ(opened("b"), std::pair(std::size_t{5}, Strings{}));
  EXPECT_EQ(opened("b"), std::pair(std::size_t{5}, Strings{}));
  EXPECT_FALSE(fs::exists(journal("b")));
}

TEST_F(Journals, ForReadingOnlyAJournalIsReadAndStays) {
  auto study = makeStudy(path("a"), records_);
  add(study, records_, 5);
  crash("a", "b");
  const std::string file = bytesOf(path("b"));
  const std::string wal = bytesOf(journal("b"));
  for (int i = 0; i < 2; ++i) {
    const auto read = StudyFile::open(path("b"), {Access::kReadOnly, {}});
    ASSERT_TRUE(read) << read.error().message();
    EXPECT_EQ(answers(*read)->size(), 5U);
    EXPECT_TRUE(read->notices().empty());
  }
  EXPECT_EQ(bytesOf(path("b")), file);
  EXPECT_EQ(bytesOf(journal("b")), wal);
  EXPECT_EQ(opened("b"), std::pair(std::size_t{5}, Strings{}));
}

TEST_F(Journals, OneOfADeletedStudyIsNotTakenOver) {
  auto old = makeStudy(path("old"), records_);
  add(old, records_, 7);
  SampleRecords others(2);
  auto study = makeStudy(path("a"), others);
  add(study, others, 2);
  ASSERT_TRUE(backUp(study.file, path("backup")));
  ASSERT_TRUE(study.file.close());
  // The journal of a deleted study beside: a study, its copy by hand, and its backup.
  for (const char* name : {"a", "backup"}) {
    fs::copy_file(journal("old"), journal(name));
    const std::string wal = bytesOf(journal(name));
    for (const Access access : {Access::kReadWrite, Access::kReadOnly}) {
      EXPECT_NE(openError(name, access).find("found the journal of another file, or of another state of this one"),
                std::string::npos)
          << openError(name, access);
    }
    EXPECT_EQ(bytesOf(journal(name)), wal);
    fs::remove(journal(name));
    EXPECT_EQ(opened(name), std::pair(std::size_t{2}, Strings{}));
  }
}

TEST_F(Journals, OneOfTheSameStudyIsNotTakenOverByItsBackup) {
  auto study = makeStudy(path("a"), records_);
  add(study, records_, 2);
  ASSERT_TRUE(backUp(study.file, path("backup")));
  add(study, records_, 3);
  crash("a", "b");
  fs::copy_file(path("backup"), path("b"), fs::copy_options::overwrite_existing);  // restored by hand
  EXPECT_NE(openError("b").find("found the journal of another file"), std::string::npos) << openError("b");
  fs::remove(journal("b"));
  EXPECT_EQ(opened("b"), std::pair(std::size_t{2}, Strings{}));
}

TEST_F(Journals, OneOfALaterOpeningIsNotTakenOverByAnEarlierCopy) {
  {
    auto study = makeStudy(path("a"), records_);
    add(study, records_, 2);
    ASSERT_TRUE(study.file.close());
  }
  fs::copy_file(path("a"), path("copy"));
  {
    auto file = StudyFile::open(path("a"));
    ASSERT_TRUE(file);
    for (int i = 0; i < 3; ++i) ASSERT_TRUE(append(*file, records_.model("{}")));
    crash("a", "b");
  }
  fs::copy_file(path("copy"), path("b"), fs::copy_options::overwrite_existing);
  EXPECT_NE(openError("b").find("found the journal of another file"), std::string::npos) << openError("b");
}

TEST_F(Journals, NamesBesideWhichSomethingIsLeftAreRefused) {
  auto study = makeStudy(path("a"), records_);
  ASSERT_TRUE(writeRecords(study.file, folder_.file("tables")));
  for (const std::string tail : {"-wal", "-journal", "-shm"}) {
    const std::string rest = path("new") + tail;
    write(rest, "left");
    const std::string wanted =
        "found what another study of this name left ('" + rest + "'), wanted a name beside which ";
    const auto made = StudyFile::create(path("new"), records_.study());
    ASSERT_FALSE(made);
    EXPECT_NE(made.error().message().find(wanted), std::string::npos) << made.error().message();
    const auto copied = backUp(study.file, path("new"));
    ASSERT_FALSE(copied);
    EXPECT_NE(copied.error().message().find(wanted), std::string::npos) << copied.error().message();
    const auto restored = restoreRecords(folder_.file("tables"), path("new"));
    ASSERT_FALSE(restored);
    EXPECT_NE(restored.error().message().find(wanted), std::string::npos) << restored.error().message();
    EXPECT_FALSE(fs::exists(path("new")));
    EXPECT_EQ(bytesOf(rest), "left");
    fs::remove(rest);
  }
}

TEST_F(Journals, ARollbackJournalIsNotPlayedBack) {
  ASSERT_TRUE(makeStudy(path("a"), records_).file.close());
  write(path("a") + "-journal", "hot");
  for (const Access access : {Access::kReadWrite, Access::kReadOnly}) {
    EXPECT_NE(openError("a", access).find("found the journal of another program beside the study"), std::string::npos);
  }
  fs::remove(path("a") + "-journal");
  EXPECT_EQ(openError("a"), "");
}

TEST_F(Journals, AMissingOneIsSaidAndNoted) {
  auto study = makeStudy(path("a"), records_);
  add(study, records_, 5);
  crash("a", "b");
  fs::remove(journal("b"));
  const auto first = opened("b");
  ASSERT_EQ(first.second.size(), 1U);
  EXPECT_NE(first.second[0].find("the journal of a study that was not closed was missing"), std::string::npos);
  // Said once, and listed by the check from then on.
  EXPECT_EQ(opened("b").second, Strings{});
  const auto file = StudyFile::open(path("b"));
  EXPECT_EQ(*checkStudy(*file), Strings{"incident: " + first.second[0]});
  const auto past = pastIncidents(*file);
  ASSERT_EQ(past->size(), 1U);
  EXPECT_EQ(past->at(0).sentence, first.second[0]);
  EXPECT_GT(past->at(0).utc_ms, 0);
}

TEST_F(Journals, ACutOneIsSaidWhereverItWasCut) {
  auto study = makeStudy(path("a"), records_);
  add(study, records_, 8);
  crash("a", "b");
  const std::string file = bytesOf(path("b"));
  const std::string wal = bytesOf(journal("b"));
  const std::size_t end = framesEnd(wal);
  ASSERT_GT(end, std::size_t{8 * 4120});
  ASSERT_LT(end, wal.size());
  for (std::size_t cut = 1; cut < wal.size(); cut += cut < end ? 1777 : 2'000'003) {
    write(path("b"), file);
    write(journal("b"), wal.substr(0, cut));
    const auto [records, notices] = opened("b");
    ASSERT_EQ(notices.size(), 1U) << cut;
    EXPECT_NE(notices[0].find("the journal was cut to " + std::to_string(cut) + " of "), std::string::npos)
        << notices[0];
    const bool may_be_gone = notices[0].find("what was saved last may be gone") != std::string::npos;
    const bool none_gone = notices[0].find("no record was in the part that is missing") != std::string::npos;
    EXPECT_TRUE(may_be_gone || (none_gone && records == 8U)) << cut << ": " << notices[0];
    EXPECT_TRUE(records == 8U || may_be_gone);
    EXPECT_EQ(bytesOf(path("b") + ".damaged-journal").size(), cut);
    fs::remove(path("b") + ".damaged-journal");
  }
}

TEST_F(Journals, AChangedByteInOneIsSaidWithTheNumberOfRecords) {
  auto study = makeStudy(path("a"), records_);
  add(study, records_, 8);
  crash("a", "b");
  const std::string file = bytesOf(path("b"));
  const std::string wal = bytesOf(journal("b"));
  const std::size_t end = framesEnd(wal);
  std::size_t lost_most = 0;
  for (std::size_t at = 5; at < end; at += 1531) {
    write(path("b"), file);
    std::string changed = wal;
    changed[at] = static_cast<char>(changed[at] ^ 0x20);
    write(journal("b"), changed);
    const auto [records, notices] = opened("b");
    ASSERT_EQ(notices.size(), 1U) << at;
    const std::size_t lost = 8 - records;
    lost_most = std::max(lost_most, lost);
    ASSERT_GT(lost, 0U) << at << notices[0];
    // The commits of person and session came before the answers.
    const std::size_t gone = std::stoul(notices[0].substr(notices[0].find(": ") + 2));
    EXPECT_TRUE(gone == lost || (records == 0 && gone > 8)) << at << ": " << notices[0];
    EXPECT_EQ(bytesOf(path("b") + ".damaged-journal"), changed);
    fs::remove(path("b") + ".damaged-journal");
  }
  EXPECT_EQ(lost_most, 8U);
}

TEST_F(Journals, WhatTheFileHoldsAlreadyIsNotTakenBackByADamagedOne) {
  auto study = makeStudy(path("a"), records_);
  // More than the pages after which SQLite works the journal in: the file holds all of it, and so does the journal.
  ASSERT_TRUE(append(study.file, records_.stroke(study.session.id, 330'000)));
  crash("a", "b");
  std::string wal = bytesOf(journal("b"));
  wal[4000] = static_cast<char>(wal[4000] ^ 1);
  write(journal("b"), wal);
  const auto file = StudyFile::open(path("b"));
  ASSERT_TRUE(file) << file.error().message();
  EXPECT_EQ(strokes(*file)->size(), 1U);
  EXPECT_TRUE(checkStudy(*file)->empty());
}

TEST_F(Journals, DamagedIsSaidOnlyOfTheFileThatIs) {
  auto study = makeStudy(path("a"), records_);
  add(study, records_, 8);
  crash("a", "b");
  std::string file = bytesOf(path("b"));
  for (std::size_t at = 4096; at + 100 < file.size(); at += 4096) file.replace(at, 100, 100, '\xA5');
  write(path("b"), file);
  fs::remove(journal("b"));
  EXPECT_NE(openError("b").find("restore a backup"), std::string::npos) << openError("b");
}

/// What happens to a study while it is open.
class OpenStudies : public Journals {
 protected:
  OpenStudies() { add(study_, records_, 2); }
  /// The next record is not acknowledged, nor is any after it, and all of them can be saved elsewhere.
  void expectNoMore(const std::string& found, std::size_t there = 4) {
    const auto written = append(study_.file, records_.answer(study_.session.id));
    ASSERT_FALSE(written);
    EXPECT_NE(written.error().message().find(found), std::string::npos) << written.error().message();
    EXPECT_NE(written.error().message().find("back the open study up under a new name"), std::string::npos);
    {
      auto batch = Batch::begin(study_.file);
      ASSERT_TRUE(batch);
      ASSERT_TRUE(append(study_.file, records_.answer(study_.session.id)));
      EXPECT_FALSE(batch->commit());
    }
    const auto copied = backUp(study_.file, path("rescued"));
    ASSERT_TRUE(copied) << copied.error().message();
    const auto rescued = StudyFile::open(path("rescued"));
    ASSERT_TRUE(rescued);
    EXPECT_EQ(answers(*rescued)->size(), there);
    EXPECT_TRUE(checkStudy(*rescued)->empty());
    EXPECT_FALSE(study_.file.close());
  }
  OpenStudy study_ = makeStudy(path("a"), records_);
};

TEST_F(OpenStudies, ThatAreDeletedAcknowledgeNothingMore) {
  fs::remove(path("a"));
  expectNoMore("found the study file gone");
}

TEST_F(OpenStudies, ThatAreMovedAcknowledgeNothingMore) {
  fs::rename(path("a"), path("b"));
  expectNoMore("found the study file gone");
}

TEST_F(OpenStudies, ThatAreReplacedAcknowledgeNothingMore) {
  fs::copy_file(path("a"), path("b"));
  fs::rename(path("b"), path("a"));
  expectNoMore("found another file in the place of the study");
}

TEST_F(OpenStudies, WhoseJournalIsDeletedAcknowledgeNothingMore) {
  fs::remove(journal("a"));
  expectNoMore("found the study's journal gone");
}

TEST_F(OpenStudies, WhoseJournalIsReplacedAcknowledgeNothingMore) {
  fs::copy_file(journal("a"), journal("b"));
  fs::rename(journal("b"), journal("a"));
  expectNoMore("found another file in the place of the study's journal");
}

TEST_F(OpenStudies, ThatAreOverwrittenInPlaceAcknowledgeNothingMore) {
  SampleRecords others(9);
  auto other = makeStudy(path("other"), others);
  add(other, others, 100);
  ASSERT_TRUE(other.file.close());
  const std::string bytes = bytesOf(path("other"));
  {
    std::fstream out(path("a"), std::ios::binary | std::ios::in | std::ios::out);
    out << bytes;
  }
  fs::last_write_time(path("a"), fs::file_time_type::clock::now() + std::chrono::seconds(5));
  const auto written = append(study_.file, records_.answer(study_.session.id));
  ASSERT_FALSE(written);
  EXPECT_NE(written.error().message().find("overwritten while it was open"), std::string::npos)
      << written.error().message();
}

TEST_F(OpenStudies, ThatAreOnlyTouchedGoOn) {
  fs::last_write_time(path("a"), fs::file_time_type::clock::now() + std::chrono::hours(1));
  EXPECT_TRUE(append(study_.file, records_.answer(study_.session.id)));
  // Nor has the look at it loosened the lock.
  EXPECT_NE(openError("a").find("open elsewhere"), std::string::npos);
  EXPECT_TRUE(study_.file.close());
}

}  // namespace
}  // namespace tactus::store
