// cli_large_study FOLDER: makes a study of 200 participants and prints what opening, listing, reading and building
// take.
#include <chrono>
#include <filesystem>
#include <iostream>
#include <sys/resource.h>

#include "app/cli/commands.h"
#include "app/session/simulated_nurse.h"
#include "app/session/simulated_strokes.h"
#include "app/session/simulated_study.h"
#include "app/session/stroke_capture.h"
#include "app/session/study_view.h"
#include "core/base/text.h"
#include "core/store/batch.h"
#include "core/store/entries.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"
#include "experiments/published_tables.h"
#include "questionnaires/form_file.h"

#include "tests/support/default_procedure.h"

namespace {

using namespace tactus;

constexpr int kPersons = 200;

/// Stops with the sentence where something fails.
template <class T>
T must(base::Result<T> result) {
  if (!result) {
    std::cerr << result.error().message() << '\n';
    std::exit(1);
  }
  if constexpr (!std::is_void_v<T>) return *std::move(result);
}

double peakMb() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

template <class Work>
void timed(const std::string& what, Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  const std::string outcome = work();
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  std::cout << what << ": " << base::formatFixed(taken.count(), 3) << " s, " << outcome << ", peak "
            << base::formatFixed(peakMb(), 0) << " MB" << std::endl;
}

/// The strokes of S1, with entries still to be filled in.
std::vector<study::StrokeRecord> sampleStrokes() {
  std::vector<study::StrokeRecord> records;
  for (const auto& target : experiments::publishedSpeeds()) {
    if (target.participant != "S1") continue;
    const auto level = session::simulatedLevel(target, 1);
    int number = 0;
    for (const auto& stream : level.strokes) {
      session::StrokeCapture capture;
      for (std::size_t i = 0; i < stream.time_s.size(); ++i) capture.add({stream.time_s[i], stream.depth_mm[i]});
      capture.finish();
      auto found = capture.take();
      study::StrokeRecord record;
      record.level = target.level;
      record.number = ++number;
      record.verdict = name(found->stroke.verdict);
      record.first = found->stroke.first - found->recording_first;
      record.last = found->stroke.last - found->recording_first;
      record.recording = std::move(found->recording);
      records.push_back(std::move(record));
    }
  }
  return records;
}

/// 200 participants with the answers and judgements of S1, and the strokes of S1 made a little longer for each.
void fill(store::StudyFile& file, study::RecordIds& ids) {
  const auto strokes = sampleStrokes();
  const auto answers = session::simulatedAnswers(support::ngtForceForm(), 1);
  const auto judgements = session::simulatedJudgements();
  auto batch = must(store::Batch::begin(file));
  for (int i = 0; i < kPersons; ++i) {
    const study::Person person{ids.next(), "P" + std::to_string(1000 + i), true};
    must(store::append(file, person));
    study::SessionRecord session;
    session.id = ids.next();
    session.person = person.id;
    session.started = {1 + i, 0};
    session.consent_version = "simulated";
    must(store::append(file, session));
    const auto entry = [&] {
      return study::Entry{ids.next(), session.id, {1 + i, 0}, study::EnteredBy::kProgram, {}, {}};
    };
    for (auto stroke : strokes) {
      stroke.entry = entry();
      for (double& depth_mm : stroke.recording.channels.back().values) depth_mm *= 1 + 0.001 * i;
      must(store::append(file, stroke));
    }
    for (const auto& judgement : judgements) {
      if (judgement.participant != "S1") continue;
      study::JudgementRecord record;
      record.entry = entry();
      record.series = judgement.series;
      record.step = judgement.step;
      record.commanded_n = judgement.force_n;
      record.kind = judgement.kind;
      record.term = judgement.term;
      must(store::append(file, record));
    }
    for (const auto& answer : answers) {
      if (answer.participant != "S1") continue;
      study::AnswerRecord record;
      record.entry = entry();
      record.form = answer.form;
      record.item = answer.item;
      record.status = answer.status;
      record.value = answer.term;
      must(store::append(file, record));
    }
  }
  must(batch.commit());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::string path = std::string(argv[1]) + "/large_build.tactus";
  std::filesystem::remove(path);
  study::RecordIds ids(1);
  timed("make", [&] {
    auto file = must(store::StudyFile::create(path, {ids.next(), "large (simulated)", 1, "test"}));
    fill(file, ids);
    must(file.close());
    return base::formatFixed(1e-6 * static_cast<double>(std::filesystem::file_size(path)), 1) + " MB";
  });
  timed("open and list", [&] {
    const auto file = must(store::StudyFile::open(path));
    return std::to_string(must(store::sessionList(file)).size()) + " sessions";
  });
  timed("read for elicitation", [&] {
    const auto file = must(store::StudyFile::open(path));
    return std::to_string(must(session::studyForElicitation(file)).study.speeds.size()) + " speeds";
  });
  for (const std::size_t replicates : {std::size_t{0}, cli::BuildOptions{}.replicates}) {
    timed("build with " + std::to_string(replicates) + " replicates", [&] {
      cli::BuildOptions options;
      options.study = path;
      options.out = path + ".json";
      options.replicates = replicates;
      return std::to_string(must(cli::build(options)).text.size()) + " bytes of text";
    });
  }
  std::filesystem::remove(path + ".json");
}
