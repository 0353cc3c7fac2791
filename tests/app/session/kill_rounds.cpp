#include "tests/app/session/kill_rounds.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <iterator>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include "app/session/simulated_nurse.h"
#include "app/session/simulated_study.h"
#include "core/base/check.h"
#include "core/store/batch.h"
#include "core/store/entries.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"
#include "core/store/study_info.h"
#include "questionnaires/form_file.h"

#include "tests/support/default_procedure.h"
#include "tests/support/temp_folder.h"

namespace tactus::session {
namespace {

using study::RecordId;

constexpr int kMostAcknowledged = 20;   // before a kill
constexpr int kLongestWaitUs = 40'000;  // after that: about two strokes

NurseTraits killedNurse() {
  NurseTraits nurse;
  nurse.profile.years_experience = 12;
  nurse.levels["medium"] = simulatedLevel({"S1", "medium", 106, 25}, 1);
  nurse.responder = {"S1", {0.2, 0.4, 0.6, 0.8}};
  for (const auto& answer : simulatedAnswers(support::ngtForceForm(), 1)) {
    if (answer.participant == "S1") nurse.answers.push_back(answer);
  }
  nurse.stops_early = nurse.holds_still = nurse.second_thoughts = 0.25;
  return nurse;
}

/// Everything of one session that the participant did, and the ids, kind by kind.
struct Recorded {
  std::vector<study::ProfileRecord> profiles;
  std::vector<study::StrokeRecord> strokes;
  std::vector<study::JudgementRecord> judgements;
  std::vector<study::AnswerRecord> answers;
  std::vector<study::RatingRecord> ratings;
  std::vector<std::vector<RecordId>> ids;

  bool operator==(const Recorded&) const = default;
};

/// Moves the entries out of the records, which then can be compared with those of another run.
template <class Record>
std::vector<Record> withoutEntries(base::Result<std::vector<Record>> records, std::vector<std::vector<RecordId>>& ids) {
  TACTUS_CHECK(records.has_value());
  ids.emplace_back();
  for (auto& record : *records) {
    ids.back().push_back(record.entry.id);
    record.entry = {};
  }
  return *std::move(records);
}

Recorded recordsOf(const store::StudyFile& file) {
  const store::Selection all{{}, {}, true};
  Recorded out;
  out.profiles = withoutEntries(store::profiles(file, all), out.ids);
  out.strokes = withoutEntries(store::strokes(file, all), out.ids);
  out.judgements = withoutEntries(store::judgements(file, all), out.ids);
  out.answers = withoutEntries(store::answers(file, all), out.ids);
  out.ratings = withoutEntries(store::ratings(file, all), out.ids);
  return out;
}

RecordId lastId(const store::StudyFile& file, const RecordId& session, SessionPart part) {
  const store::Selection own{{}, session, true};
  const auto last = [](const auto& records) { return records->back().entry.id; };
  if (part == SessionPart::kProfile) return last(store::profiles(file, own));
  if (part == SessionPart::kSpeed) return last(store::strokes(file, own, store::Recordings::kLeaveOut));
  if (part == SessionPart::kForce) return last(store::judgements(file, own));
  if (part == SessionPart::kForm) return last(store::answers(file, own));
  // After the form the nurse may still correct an answer instead of rating it.
  const auto answers = store::answers(file, own);
  const auto ratings = store::ratings(file, own);
  const bool corrected = !answers->empty() && (ratings->empty() || answers->back().entry.when.monotonic_ns >
                                                                       ratings->back().entry.when.monotonic_ns);
  return corrected ? answers->back().entry.id : last(ratings);
}

base::Result<Session> beginOrResume(store::StudyFile& file) {
  const auto sessions = store::sessions(file);
  if (!sessions) return tl::unexpected(sessions.error());
  if (!sessions->empty()) return Session::resume(file, sessions->front().id, systemTools());
  const auto persons = store::persons(file);
  if (!persons) return tl::unexpected(persons.error());
  SessionStart start;
  start.person = persons->front().id;
  start.consent_version = "simulated";
  start.seed = 5;
  start.settings.speed.levels = {"medium"};
  start.settings.force.familiarisation_n = {};
  start.settings.item_order = questionnaires::ItemOrder::kShuffled;
  return Session::begin(file, start, systemTools());
}

/// What the child does; returns its exit status.
int runSession(const std::string& path, const NurseTraits& traits, int out) {
  auto file = store::StudyFile::open(path);
  if (!file) return 2;
  auto session = beginOrResume(*file);
  if (!session) return 3;
  const auto judged = store::judgements(*file, {{}, session->record().id, true});
  if (!judged) return 4;
  SimulatedNurse nurse(traits, 9, {}, *judged);
  while (session->part() != SessionPart::kFinished) {
    const SessionPart part = session->part();
    if (!nurse.doNext(*session)) return 5;
    const RecordId id = lastId(*file, session->record().id, part);
    if (::write(out, id.bytes.data(), id.bytes.size()) != static_cast<ssize_t>(id.bytes.size())) return 6;
  }
  return file->close() ? 0 : 7;
}

struct ChildEnd {
  std::vector<RecordId> acknowledged;
  bool killed = false;
  int status = 0;  ///< where it ended by itself
};

/// Runs a child until it has said `count` ids and `wait_us` longer, and kills it.
ChildEnd runAndKill(const std::string& path, const NurseTraits& traits, int count, int wait_us) {
  int ends[2] = {};
  TACTUS_CHECK(::pipe2(ends, O_CLOEXEC) == 0);
  const pid_t child = ::fork();
  TACTUS_CHECK(child >= 0);
  if (child == 0) ::_exit(runSession(path, traits, ends[1]));
  ::close(ends[1]);
  ChildEnd end;
  RecordId id;
  const auto next = [&] {
    // Each id is written in one go, so none is cut.
    if (::read(ends[0], id.bytes.data(), id.bytes.size()) != static_cast<ssize_t>(id.bytes.size())) return false;
    end.acknowledged.push_back(id);
    return true;
  };
  while (static_cast<int>(end.acknowledged.size()) < count && next()) continue;
  std::this_thread::sleep_for(std::chrono::microseconds(wait_us));
  ::kill(child, SIGKILL);
  while (next()) continue;
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  end.killed = WIFSIGNALED(status);
  end.status = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
  return end;
}

void makeStudy(const std::string& path) {
  study::RecordIds ids;
  auto file = store::StudyFile::create(path, {ids.next(), "killed", 1, "test"});
  TACTUS_CHECK(file.has_value());
  TACTUS_CHECK(store::append(*file, study::Person{ids.next(), "S1", true}).has_value());
  TACTUS_CHECK(file->close().has_value());
}

Recorded undisturbed(const NurseTraits& traits, const std::string& path) {
  makeStudy(path);
  auto file = store::StudyFile::open(path);
  TACTUS_CHECK(file.has_value());
  auto batch = store::Batch::begin(*file);
  TACTUS_CHECK(batch.has_value());
  auto session = beginOrResume(*file);
  TACTUS_CHECK(session.has_value());
  SimulatedNurse nurse(traits, 9);
  TACTUS_CHECK(nurse.finish(*session).has_value());
  TACTUS_CHECK(batch->commit().has_value());
  auto records = recordsOf(*file);
  records.ids.clear();
  return records;
}

bool contains(const std::vector<RecordId>& ids, const RecordId& id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

std::vector<RecordId> common(const std::vector<RecordId>& ids, const std::vector<RecordId>& others) {
  std::vector<RecordId> out;
  std::copy_if(ids.begin(), ids.end(), std::back_inserter(out),
               [&](const RecordId& id) { return contains(others, id); });
  return out;
}

/// Empty where every id that was said is there once and in order, with at most one more record for each kill.
std::string losses(const std::vector<RecordId>& said, const std::vector<std::vector<RecordId>>& there, int kills) {
  std::size_t found = 0;
  std::size_t count = 0;
  for (const auto& kind : there) {
    const auto said_of_kind = common(said, kind);
    if (common(kind, said) != said_of_kind) return "the acknowledged records are there in another order, or twice";
    found += said_of_kind.size();
    count += kind.size();
  }
  if (found != said.size()) return std::to_string(said.size() - found) + " acknowledged records are lost";
  if (count > said.size() + static_cast<std::size_t>(kills)) return "there are records that were not given";
  return {};
}

std::size_t recordCount(const Recorded& records) {
  std::size_t count = 0;
  for (const auto& kind : records.ids) count += kind.size();
  return count;
}

}  // namespace

KillOutcome sessionKillRounds(int rounds, std::uint64_t seed) {
  const support::TempFolder folder;
  const auto traits = killedNurse();
  const Recorded expected = undisturbed(traits, folder.file("undisturbed.tactus"));
  base::Random random(seed);
  KillOutcome outcome;
  while (outcome.rounds < rounds && outcome.complaint.empty()) {
    const std::string path = folder.file("killed" + std::to_string(outcome.sessions) + ".tactus");
    makeStudy(path);
    std::vector<RecordId> said;
    int kills = 0;
    for (bool finished = false; !finished && outcome.complaint.empty();) {
      const int count = random.below(kMostAcknowledged);
      const auto end = runAndKill(path, traits, count, random.below(kLongestWaitUs));
      said.insert(said.end(), end.acknowledged.begin(), end.acknowledged.end());
      kills += end.killed ? 1 : 0;
      finished = !end.killed;
      if (end.status != 0) outcome.complaint = "the child ended with status " + std::to_string(end.status);
      const auto file = store::StudyFile::open(path);
      if (!file) {
        outcome.complaint = file.error().message();
        break;
      }
      auto records = recordsOf(*file);
      std::string complaint = losses(said, records.ids, kills);
      const auto faults = store::checkStudy(*file);
      if (complaint.empty() && (!faults || !faults->empty())) complaint = faults ? faults->front() : "check failed";
      if (complaint.empty() && store::sessions(*file)->size() > 1) complaint = "a second session";
      if (complaint.empty() && finished) {
        outcome.unacknowledged_kept += static_cast<long long>(recordCount(records) - said.size());
        records.ids.clear();
        if (records != expected) complaint = "the session differs from one without kills";
      }
      if (outcome.complaint.empty()) outcome.complaint = complaint;
    }
    outcome.acknowledged += static_cast<long long>(said.size());
    outcome.rounds += kills;
    ++outcome.sessions;
  }
  return outcome;
}

}  // namespace tactus::session
