// One writer, whatever this process opens and closes, whatever happens to the name, and even where no lock holds.
#include <array>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/base/files/file.h"
#include "core/store/entries.h"
#include "core/store/study_info.h"

#include "tests/core/store/plain_sql.h"
#include "tests/core/store/sample_records.h"
#include "tests/support/temp_folder.h"

namespace tactus::store {
namespace {

namespace fs = std::filesystem;

/// Registered by SQLite: it locks nothing, and neither do we.
constexpr const char* kWithoutLocks = "unix-none";

/// The program second_writer.cpp.
class SecondWriter {
 public:
  explicit SecondWriter(const std::string& study, const std::string& vfs = {}) {
    std::array<int, 2> commands{};
    std::array<int, 2> answers{};
    EXPECT_EQ(::pipe2(commands.data(), O_CLOEXEC), 0);
    EXPECT_EQ(::pipe2(answers.data(), O_CLOEXEC), 0);
    process_ = ::fork();
    if (process_ == 0) {
      ::dup2(commands[0], STDIN_FILENO);
      ::dup2(answers[1], STDOUT_FILENO);
      ::execl(TACTUS_SECOND_WRITER, "second_writer", study.c_str(), vfs.c_str(), nullptr);
      ::_exit(127);
    }
    ::close(commands[0]);
    ::close(answers[1]);
    to_ = ::fdopen(commands[1], "w");
    from_ = ::fdopen(answers[0], "r");
  }
  ~SecondWriter() { finish(); }
  SecondWriter(const SecondWriter&) = delete;
  SecondWriter& operator=(const SecondWriter&) = delete;

  std::string line() {
    std::array<char, 1024> room{};
    if (std::fgets(room.data(), room.size(), from_) == nullptr) return "ended";
    std::string text = room.data();
    return text.substr(0, text.find('\n'));
  }
  std::string goOn() {
    std::fputs("\n", to_);
    std::fflush(to_);
    return line();
  }
  /// Lets it close; its exit status.
  int finish() {
    if (process_ < 0) return -1;
    std::fclose(to_);
    int status = 0;
    ::waitpid(std::exchange(process_, -1), &status, 0);
    std::fclose(from_);
    return WEXITSTATUS(status);
  }

 private:
  pid_t process_ = -1;
  std::FILE* to_ = nullptr;
  std::FILE* from_ = nullptr;
};

class StudyLocks : public testing::Test {
 protected:
  std::string path() const { return folder_.file("a.tactus"); }
  bool add(OpenStudy& study) { return append(study.file, records_.answer(study.session.id)).has_value(); }
  void expectIntact(std::size_t wanted) {
    EXPECT_EQ(PlainSql(path()).text("PRAGMA integrity_check"), "ok");
    const auto study = StudyFile::open(path());
    ASSERT_TRUE(study) << study.error().message();
    EXPECT_EQ(answers(*study)->size(), wanted);
    EXPECT_TRUE(checkStudy(*study)->empty());
  }
  void openAndCloseInEveryWay() const {
    std::ifstream(path()).get();
    ASSERT_TRUE(base::readFile(path(), std::size_t{1} << 30U));
    fs::copy_file(path(), folder_.file("copy"), fs::copy_options::overwrite_existing);
    ::close(::open(path().c_str(), O_RDWR));
    const int mapped = ::open(path().c_str(), O_RDONLY);
    void* const memory = ::mmap(nullptr, 4096, PROT_READ, MAP_SHARED, mapped, 0);
    ::close(mapped);
    ::munmap(memory, 4096);
    EXPECT_FALSE(StudyFile::open(path()));
  }

  support::TempFolder folder_;
  SampleRecords records_;
};

TEST_F(StudyLocks, NoCloseInThisProcessLetsASecondWriterIn) {
  auto study = makeStudy(path(), records_);
  ASSERT_TRUE(add(study));
  openAndCloseInEveryWay();
  SecondWriter second(path());
  EXPECT_EQ(second.line(), "opening");
  EXPECT_NE(second.line().find("open elsewhere"), std::string::npos);
  EXPECT_EQ(second.finish(), 1);
  EXPECT_TRUE(add(study));
  EXPECT_TRUE(study.file.close());
  expectIntact(2);
}

TEST_F(StudyLocks, AWriteTakesSqlitesOwnLockAgain) {
  auto study = makeStudy(path(), records_);
  ASSERT_TRUE(add(study));
  openAndCloseInEveryWay();
  ASSERT_TRUE(add(study));
  EXPECT_EQ(SecondWriter(path(), "plain").line(), "busy");
}

TEST_F(StudyLocks, AReaderKeepsWritersOut) {
  makeStudy(path(), records_);
  const auto reader = StudyFile::open(path(), {Access::kReadOnly, {}});
  ASSERT_TRUE(reader);
  std::ifstream(path()).get();
  SecondWriter second(path());
  EXPECT_EQ(second.line(), "opening");
  EXPECT_NE(second.line().find("open elsewhere"), std::string::npos);
}

/// Two writers that no lock holds back: the first program to write wins, the other stops before it writes.
class TwoWriters : public StudyLocks {
 protected:
  TwoWriters() {
    auto made = makeStudy(path(), records_);
    EXPECT_TRUE(add(made));
    EXPECT_TRUE(made.file.close());
    auto file = StudyFile::open(path(), {Access::kReadWrite, kWithoutLocks});
    EXPECT_TRUE(file);
    first_.emplace(OpenStudy{std::move(*file), made.person, made.session});
  }
  void expectFirstStops(const std::string& found) {
    for (int i = 0; i < 2; ++i) {
      const auto written = append(first_->file, records_.answer(first_->session.id));
      ASSERT_FALSE(written);
      EXPECT_NE(written.error().message().find(found), std::string::npos) << written.error().message();
    }
    EXPECT_FALSE(first_->file.close());
    first_.reset();
  }
  std::optional<OpenStudy> first_;
};

TEST_F(TwoWriters, TheOneThatHasWrittenStopsOnceTheOtherHas) {
  ASSERT_TRUE(add(*first_));
  {
    SecondWriter second(path(), kWithoutLocks);
    EXPECT_EQ(second.line(), "opening");
    EXPECT_EQ(second.line(), "open");
    EXPECT_EQ(second.goOn(), "written");
    expectFirstStops("while it was open");
    EXPECT_EQ(second.finish(), 0);
  }
  expectIntact(3);
}

TEST_F(TwoWriters, TheOneThatOnlyOpenedStopsToo) {
  {
    SecondWriter second(path(), kWithoutLocks);
    EXPECT_EQ(second.line(), "opening");
    EXPECT_EQ(second.line(), "open");
    EXPECT_EQ(second.goOn(), "written");
    expectFirstStops("while it was open");
    EXPECT_EQ(second.finish(), 0);
  }
  expectIntact(2);
}

TEST_F(TwoWriters, TheOtherStopsIfItComesSecond) {
  {
    SecondWriter second(path(), kWithoutLocks);
    EXPECT_EQ(second.line(), "opening");
    EXPECT_EQ(second.line(), "open");
    ASSERT_TRUE(add(*first_));
    EXPECT_NE(second.goOn().find("while it was open"), std::string::npos);
    EXPECT_EQ(second.finish(), 1);
  }
  EXPECT_TRUE(add(*first_));
  EXPECT_TRUE(first_->file.close());
  expectIntact(3);
}

// Whoever has waited for the lock writes to the file that has the name then, however the two programs meet.
TEST_F(StudyLocks, WhoHasWaitedHasTheFileOfThatName) {
  for (int round = 0; round < 10; ++round) {
    SampleRecords others(static_cast<std::uint64_t>(100 + round));
    const std::string fresh = folder_.file("fresh" + std::to_string(round));
    ASSERT_TRUE(makeStudy(fresh, others).file.close());
    fs::remove(path());
    SampleRecords olds(static_cast<std::uint64_t>(200 + round));
    ASSERT_TRUE(makeStudy(path(), olds).file.close());
    auto old = StudyFile::open(path(), {Access::kReadOnly, {}});
    ASSERT_TRUE(old) << old.error().message();
    SecondWriter second(path());
    EXPECT_EQ(second.line(), "opening");
    fs::remove(path() + "-wal");
    fs::rename(fresh, path());
    ASSERT_TRUE(old->close());
    ASSERT_EQ(second.line(), "open");
    EXPECT_EQ(second.goOn(), "written");
    EXPECT_EQ(second.finish(), 0);
    expectIntact(1);
  }
}

}  // namespace
}  // namespace tactus::store
