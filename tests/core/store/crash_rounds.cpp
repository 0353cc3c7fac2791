#include <chrono>
#include <filesystem>

#include "core/base/random.h"

#include "tests/core/store/disk_rounds.h"
#include "tests/core/store/disk_script.h"
#include "tests/core/store/faulty_disk.h"
#include "tests/support/temp_folder.h"

namespace tactus::store {
namespace {

namespace fs = std::filesystem;

/// Seconds to open the study at `path` after the crash, and what is in it.
void inspect(const std::string& path, const std::string& vfs, const DiskScript& script, int acknowledged,
             RoundsOutcome& outcome) {
  const auto start = std::chrono::steady_clock::now();
  const auto file = StudyFile::open(path, {Access::kReadWrite, vfs});
  const std::chrono::duration<double> opening = std::chrono::steady_clock::now() - start;
  outcome.slowest_opening_s = std::max(outcome.slowest_opening_s, opening.count());
  if (!file) {
    outcome.complaint = file.error().message();
    return;
  }
  const int there = script.intactRecords(*file, outcome.complaint);
  outcome.acknowledged += acknowledged;
  outcome.unacknowledged_kept += there - acknowledged;
  if (outcome.complaint.empty() && (there < acknowledged || there > acknowledged + 1)) {
    outcome.complaint = std::to_string(acknowledged) + " records acknowledged, " + std::to_string(there) + " there";
  }
}

}  // namespace

RoundsOutcome crashRounds(int rounds, int records, std::size_t samples, std::uint64_t seed) {
  const support::TempFolder folder;
  const std::string original = folder.file("original.tactus");
  const std::string path = folder.file("study.tactus");
  const std::string after = folder.file("after");
  FaultyDisk disk("crashing-" + std::to_string(seed));
  base::Random random(seed);
  RoundsOutcome outcome;

  SampleRecords ids;
  auto study = makeStudy(original, ids);
  const DiskScript script(study.session.id, samples);
  if (!study.file.close()) outcome.complaint = "the study could not be closed";
  long long operations = 0;
  for (; outcome.rounds <= rounds && outcome.complaint.empty(); ++outcome.rounds) {
    fs::remove_all(after);
    fs::create_directory(after);
    fs::copy_file(original, path, fs::copy_options::overwrite_existing);
    // The first round crashes nowhere and counts.
    const long long at = outcome.rounds == 0 ? 0 : 1 + static_cast<long long>(random.uniform() * operations);
    disk.pictureAt(at, after, random.next());
    int acknowledged = 0;
    auto file = StudyFile::open(path, {Access::kReadWrite, disk.name()});
    if (!file) outcome.complaint = file.error().message();
    for (int number = 0; file && number < records; ++number) {
      if (auto written = script.write(*file, number); !written) outcome.complaint = written.error().message();
      if (!disk.struck()) ++acknowledged;
    }
    if (file && !file->close()) outcome.complaint = "the study could not be closed";
    if (outcome.rounds == 0) operations = disk.operations();
    const bool struck = disk.struck();
    disk.heal();
    if (struck && outcome.complaint.empty()) {
      inspect(after + "/study.tactus", disk.name(), script, acknowledged, outcome);
    }
    if (outcome.rounds > 0 && !struck) outcome.complaint = "no crash at operation " + std::to_string(at);
  }
  --outcome.rounds;
  return outcome;
}

}  // namespace tactus::store
