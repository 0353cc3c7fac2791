#include "app/session/simulated_study.h"

#include <utility>
#include <vector>

#include "app/session/session.h"
#include "app/session/simulated_clock.h"
#include "app/session/simulated_nurse.h"
#include "app/session/simulated_traits.h"
#include "core/store/batch.h"
#include "core/store/entries.h"
#include "core/store/persons.h"

namespace tactus::session {
namespace {

using base::Result;

constexpr std::int64_t kFirstDayUtcMs = 1'767'603'600'000;  // 2026-01-05 09:00
constexpr double kBetweenSessionsS = 3600;
constexpr std::uint64_t kSeedsOfOne = 1000;  // more numbers than one study uses

class Simulation {
 public:
  Simulation(store::StudyFile& file, study::RecordIds ids, std::uint64_t seed, std::string program)
      : file_(file), ids_(std::move(ids)), clock_(kFirstDayUtcMs), seed_(seed), program_(std::move(program)) {}

  study::RecordId nextId() { return ids_.next(); }

  /// The whole visit of one nurse, all or nothing; `rules` are given instead of a form where there are any.
  Result<void> visit(const NurseTraits& nurse, const std::vector<study::GivenRule>& rules) {
    auto batch = store::Batch::begin(file_);
    if (!batch) return tl::unexpected(batch.error());
    const study::Person person{nextId(), nurse.responder.code, true};
    if (auto ok = store::append(file_, person); !ok) return ok;

    SessionStart start;
    start.person = person.id;
    start.consent_version = "simulated";
    start.seed = ++seed_;
    start.station = "simulated";
    start.program = program_;
    start.device = "simulated, steps of 0.055 mm";
    if (!rules.empty()) start.settings.blocks = {Block::kSpeed, Block::kForce};
    auto session = Session::begin(file_, start, clock_.tools(seed_));
    if (!session) return tl::unexpected(session.error());
    SimulatedNurse simulated(nurse, seed_, [this](double seconds) { clock_.pass(seconds); });
    if (auto ok = simulated.finish(*session); !ok) return ok;
    for (const auto& rule : rules) {
      study::RuleRecord record;
      record.entry = {nextId(), session->record().id, clock_.look(), study::EnteredBy::kProgram, {}, {}};
      record.rule = rule;
      record.rule.participant.clear();
      if (auto ok = store::append(file_, record); !ok) return ok;
    }
    clock_.pass(kBetweenSessionsS);
    return batch->commit();
  }

 private:
  store::StudyFile& file_;
  study::RecordIds ids_;
  SimulatedClock clock_;
  std::uint64_t seed_;
  std::string program_;
};

}  // namespace

Result<store::StudyFile> makeSimulatedNgtStudy(const std::string& path, std::uint64_t seed, std::string_view reading,
                                               const std::string& program) {
  const auto rules = questionnaires::s4Rules(reading);
  if (!rules) return tl::unexpected(rules.error());
  // The numbers after a seed are the seeds of its sessions; those of the next seed must not be among them.
  const std::uint64_t first_seed = seed * kSeedsOfOne;
  study::RecordIds ids(first_seed);
  store::NewStudy study;
  study.id = ids.next();
  study.name = "NGT insertion, four nurses (simulated, except the rules of S4)";
  study.created_utc_ms = kFirstDayUtcMs;
  study.program = program;
  auto file = store::StudyFile::create(path, study);
  if (!file) return file;
  Simulation simulation(*file, std::move(ids), first_seed, program);
  for (const auto& nurse : simulatedNurses(seed)) {
    const bool published = rules->front().participant == nurse.responder.code;
    if (auto ok = simulation.visit(nurse, published ? *rules : std::vector<study::GivenRule>{}); !ok) {
      return tl::unexpected(inFile(ok.error(), path));
    }
  }
  return file;
}

}  // namespace tactus::session
