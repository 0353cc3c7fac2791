// kill -9 while a study is edited: no version that was acknowledged is lost.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "app/editing/history_versions.h"
#include "core/base/random.h"
#include "core/store/model_versions.h"
#include "core/store/study_info.h"

#include "tests/gui/sample_models.h"
#include "tests/gui/sample_study.h"

namespace tactus::workbench {
namespace {

constexpr int kRounds = 5;

// Lets the child work until it has acknowledged something and `milliseconds` more, kills it, and returns the versions
// that it acknowledged.
std::vector<study::RecordId> acknowledged(const QString& path, int milliseconds) {
  int ends[2] = {};
  EXPECT_EQ(::pipe2(ends, O_CLOEXEC), 0);
  const std::string study = path.toStdString();
  const pid_t process = ::fork();
  if (process == 0) {
    ::dup2(ends[1], STDOUT_FILENO);
    ::execl(TACTUS_STUDY_KILL_CHILD, TACTUS_STUDY_KILL_CHILD, study.c_str(), static_cast<char*>(nullptr));
    ::_exit(127);
  }
  ::close(ends[1]);
  std::vector<study::RecordId> out;
  study::RecordId id;
  const auto read = [&] { return ::read(ends[0], id.bytes.data(), id.bytes.size()) == 16; };
  if (read()) out.push_back(id);
  std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
  ::kill(process, SIGKILL);
  while (read()) out.push_back(id);
  ::close(ends[0]);
  int status = 0;
  ::waitpid(process, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status));
  return out;
}

TEST(StudyKilled, NoAcknowledgedVersionIsLost) {
  tests::ModelFolder folder;
  const QString path = folder.path(QStringLiteral("killed.tactus"));
  tests::makeStudyFile(path, [](store::StudyFile& file, study::RecordIds& ids) {
    const auto history = *editing::EditHistory::open(tests::twoExperts(), "Opened", {"", 1}, ids);
    for (const auto& version : editing::unstoredVersions(history)) ASSERT_TRUE(store::append(file, version));
  });
  base::Random random(11);
  std::size_t told = 0;
  for (int round = 0; round < kRounds; ++round) {
    const auto ids = acknowledged(path, 1 + random.below(150));
    ASSERT_FALSE(ids.empty());
    told += ids.size();
    auto file = store::StudyFile::open(path.toStdString());
    ASSERT_TRUE(file) << file.error().message();
    const auto versions = *store::modelVersions(*file);
    for (const study::RecordId& id : ids) {
      EXPECT_TRUE(std::any_of(versions.begin(), versions.end(), [&](const auto& one) { return one.id == id; }));
    }
    EXPECT_TRUE(store::checkStudy(*file)->empty());
  }
  RecordProperty("acknowledged", static_cast<int>(told));
}

}  // namespace
}  // namespace tactus::workbench
