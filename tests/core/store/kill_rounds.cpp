#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "core/base/check.h"
#include "core/base/random.h"

#include "tests/core/store/disk_rounds.h"
#include "tests/core/store/disk_script.h"
#include "tests/support/temp_folder.h"

namespace tactus::store {
namespace {

/// Runs `child` on the study until it has acknowledged `records` of them, and for `pause` more, within which it may
/// write some others. Kills it, and returns the last number that it acknowledged, or -1.
int lastAcknowledged(const std::string& child, const std::string& path, const std::string& session, int records,
                     std::chrono::microseconds pause) {
  int ends[2] = {};
  TACTUS_CHECK(::pipe2(ends, O_CLOEXEC) == 0);
  const pid_t process = ::fork();
  TACTUS_CHECK(process >= 0);
  if (process == 0) {
    ::dup2(ends[1], STDOUT_FILENO);
    ::execl(child.c_str(), child.c_str(), path.c_str(), session.c_str(), static_cast<char*>(nullptr));
    ::_exit(127);
  }
  ::close(ends[1]);
  int last = -1;
  // Each number is written in one go, so none is cut.
  int number = 0;
  for (int k = 0; k < records && ::read(ends[0], &number, sizeof number) == sizeof number; ++k) last = number;
  std::this_thread::sleep_for(pause);
  ::kill(process, SIGKILL);
  while (::read(ends[0], &number, sizeof number) == sizeof number) last = number;
  ::close(ends[0]);
  int status = 0;
  ::waitpid(process, &status, 0);
  return WIFSIGNALED(status) ? last : -2;
}

}  // namespace

RoundsOutcome killRounds(const std::string& child, int rounds, std::uint64_t seed) {
  const support::TempFolder folder;
  const std::string path = folder.file("study.tactus");
  base::Random random(seed);
  RoundsOutcome outcome;
  SampleRecords ids;
  auto study = makeStudy(path, ids);
  const DiskScript script(study.session.id);
  if (!study.file.close()) outcome.complaint = "the study could not be closed";

  int there = 0;
  for (; outcome.rounds < rounds && outcome.complaint.empty(); ++outcome.rounds) {
    const int records = random.below(8);  // 0: it may be killed while it opens the study
    const std::chrono::microseconds pause(random.below(20'000));
    const int last = lastAcknowledged(child, path, study::toText(study.session.id), records, pause);
    if (last == -2) outcome.complaint = "the child ended by itself";
    const int acknowledged = last < 0 ? there : last + 1;
    const auto start = std::chrono::steady_clock::now();
    auto file = StudyFile::open(path);
    const std::chrono::duration<double> opening = std::chrono::steady_clock::now() - start;
    outcome.slowest_opening_s = std::max(outcome.slowest_opening_s, opening.count());
    if (!file) {
      outcome.complaint = file.error().message();
      break;
    }
    outcome.acknowledged += acknowledged - there;
    there = script.intactRecords(*file, outcome.complaint);
    outcome.unacknowledged_kept += there - acknowledged;
    if (outcome.complaint.empty() && (there < acknowledged || there > acknowledged + 1)) {
      outcome.complaint = std::to_string(acknowledged) + " records acknowledged, " + std::to_string(there) + " there";
    }
  }
  return outcome;
}

}  // namespace tactus::store
