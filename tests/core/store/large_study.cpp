// store_large_study FOLDER: makes a study of 200 participants and prints how long opening, listing and reading take.
#include <chrono>
#include <filesystem>
#include <functional>
#include <iostream>

#include "core/base/text.h"
#include "core/store/batch.h"
#include "core/store/copies.h"
#include "core/store/entries.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"
#include "core/store/study_info.h"

#include "tests/core/store/sample_records.h"

namespace {

using namespace tactus;
using namespace tactus::store;

constexpr int kPersons = 200;
constexpr int kStrokes = 12;
constexpr int kAnswers = 45;
constexpr int kJudgements = 17;
constexpr std::size_t kSamples = 1500;  // 1.5 s at 1 kHz

/// Runs `work` five times and prints the fastest.
template <class Work>
void timed(const char* what, Work&& work) {
  double fastest_s = 1e9;
  for (int round = 0; round < 5; ++round) {
    const auto start = std::chrono::steady_clock::now();
    const std::string outcome = work();
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    if (taken.count() < fastest_s) fastest_s = taken.count();
    if (round == 4) std::cout << what << ": " << base::formatFixed(1000 * fastest_s, 1) << " ms, " << outcome << '\n';
  }
}

/// Stops with the sentence where something fails.
template <class T>
T must(base::Result<T> result) {
  if (!result) {
    std::cerr << result.error().message() << '\n';
    std::exit(1);
  }
  if constexpr (!std::is_void_v<T>) return *std::move(result);
}

void fill(StudyFile& file, SampleRecords& records) {
  PersonCodes codes(1);
  auto batch = must(Batch::begin(file));
  for (int i = 0; i < kPersons; ++i) {
    const auto person = records.person(must(unusedCode(file, codes)));
    const auto session = records.session(person.id);
    must(append(file, person));
    must(append(file, session));
    must(append(file, records.profile(session.id)));
    for (int n = 0; n < kStrokes; ++n) must(append(file, records.stroke(session.id, kSamples)));
    for (int n = 0; n < kAnswers; ++n) must(append(file, records.answer(session.id, n)));
    for (int n = 0; n < kJudgements; ++n) must(append(file, records.judgement(session.id)));
  }
  must(batch.commit());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::string path = std::string(argv[1]) + "/large.tactus";
  const std::string copy = path + ".copy";
  std::filesystem::remove(path);
  SampleRecords records;
  {
    auto file = must(StudyFile::create(path, records.study()));
    fill(file, records);
    must(file.close());
  }
  std::cout << kPersons << " persons, " << base::formatFixed(1e-6 * double(std::filesystem::file_size(path)), 1)
            << " MB, SQLite " << sqliteVersion() << '\n';
  timed("open and close", [&] { return std::to_string(must(StudyFile::open(path)).version()); });

  auto file = must(StudyFile::open(path));
  timed("list persons", [&] { return std::to_string(must(persons(file)).size()); });
  timed("list sessions", [&] { return std::to_string(must(sessionList(file)).size()); });
  timed("counts", [&] { return std::to_string(must(studyInfo(file)).counts.size()); });
  timed("all answers", [&] { return std::to_string(must(answers(file)).size()); });
  timed("all judgements", [&] { return std::to_string(must(judgements(file)).size()); });
  timed("strokes without samples",
        [&] { return std::to_string(must(strokes(file, {}, Recordings::kLeaveOut)).size()); });
  timed("strokes with samples", [&] { return std::to_string(must(strokes(file)).size()); });
  timed("check all", [&] { return std::to_string(must(checkStudy(file)).size()); });
  const auto last = must(sessions(file)).back().id;
  timed("add an answer", [&] { return must(append(file, records.answer(last))), std::string("committed"); });
  timed("add a stroke", [&] { return must(append(file, records.stroke(last, kSamples))), std::string("committed"); });
  timed("back up", [&] {
    std::filesystem::remove(copy);
    must(backUp(file, copy));
    return std::string("done");
  });
  std::filesystem::remove(copy);
}
