// kill -9 while a study is edited, a session answered, or a model edited alone: nothing that was acknowledged is lost.
#include <QSignalSpy>
#include <algorithm>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "app/editing/history_versions.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/tune/history/autosave_controller.h"
#include "core/base/random.h"
#include "core/store/entries.h"
#include "core/store/model_versions.h"
#include "core/store/sessions.h"
#include "core/store/study_info.h"

#include "tests/gui/sample_models.h"
#include "tests/gui/sample_study.h"

namespace tactus::workbench {
namespace {

constexpr int kRounds = 5;

// Lets the program work on the study until it has acknowledged something and `milliseconds` more, kills it, and returns
// what it acknowledged, each as `Word`.
template <class Word>
std::vector<Word> acknowledged(const char* program, const QString& path, int milliseconds,
                               const QString& autosaves = {}) {
  int ends[2] = {};
  EXPECT_EQ(::pipe2(ends, O_CLOEXEC), 0);
  const std::string study = path.toStdString();
  const std::string root = autosaves.toStdString();
  const pid_t process = ::fork();
  if (process == 0) {
    ::dup2(ends[1], STDOUT_FILENO);
    // Without a folder the list of arguments ends before it.
    const char* const folder = root.empty() ? nullptr : root.c_str();
    ::execl(program, program, study.c_str(), folder, static_cast<char*>(nullptr));
    ::_exit(127);
  }
  ::close(ends[1]);
  std::vector<Word> out;
  Word word;
  const auto read = [&] { return ::read(ends[0], &word, sizeof word) == static_cast<ssize_t>(sizeof word); };
  if (read()) out.push_back(word);
  std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
  ::kill(process, SIGKILL);
  while (read()) out.push_back(word);
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
    const auto ids = acknowledged<study::RecordId>(TACTUS_STUDY_KILL_CHILD, path, 1 + random.below(150));
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

TEST(StudyKilled, NoAcknowledgedAnswerIsLostAndTheSessionContinues) {
  tests::ModelFolder folder;
  const QString path = folder.path(QStringLiteral("answered.tactus"));
  tests::makeStudyFile(path);
  base::Random random(12);
  std::size_t told = 0;
  for (int round = 1; round <= kRounds; ++round) {
    told += acknowledged<char>(TACTUS_SESSION_KILL_CHILD, path, 1 + random.below(150)).size();
    auto file = store::StudyFile::open(path.toStdString());
    ASSERT_TRUE(file) << file.error().message();
    const auto answers = *store::answers(*file, {{}, {}, true});
    // One answer for each kill may be stored without its acknowledgement having been seen.
    EXPECT_GE(answers.size(), told);
    EXPECT_LE(answers.size(), told + static_cast<std::size_t>(round));
    EXPECT_EQ(store::sessions(*file)->size(), 1U);
    for (std::size_t i = 0; i < std::min<std::size_t>(answers.size(), 45); ++i) {
      EXPECT_EQ(answers[i].item, static_cast<int>(i) + 1);
    }
    EXPECT_TRUE(store::checkStudy(*file)->empty());
  }
  RecordProperty("acknowledged", static_cast<int>(told));
}

TEST(StudyKilled, TheHistoryOfAModelOpenedAloneIsOfferedWithEveryAcknowledgedVersion) {
  tests::ModelFolder folder;
  const QString path = folder.write(tests::twoExperts());
  const QString root = folder.path(QStringLiteral("autosave"));
  base::Random random(13);
  for (int round = 0; round < kRounds; ++round) {
    const auto ids = acknowledged<study::RecordId>(TACTUS_HISTORY_KILL_CHILD, path, 1 + random.below(150), root);
    ASSERT_FALSE(ids.empty());
    EXPECT_EQ(HistoryFile::leftByCrash(root).size(), 1);
    ModelController models;
    EditController edits(models);
    AutosaveController autosave(models, edits, root);
    QSignalSpy looked_up(&autosave, &AutosaveController::lookedUp);
    models.open(path);
    ASSERT_TRUE(looked_up.count() > 0 || looked_up.wait(10'000));
    ASSERT_TRUE(autosave.lost());
    EXPECT_FALSE(models.isModified());
    const auto& events = edits.history().events();
    for (const study::RecordId& id : ids) {
      EXPECT_TRUE(std::any_of(events.begin(), events.end(), [&](const auto& one) { return one.id == id; }));
    }
  }
}

}  // namespace
}  // namespace tactus::workbench
