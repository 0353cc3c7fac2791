#include "app/session/simulated_study.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <future>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/session/session.h"
#include "app/session/simulated_nurse.h"
#include "app/session/simulated_strokes.h"
#include "app/session/study_procedure.h"
#include "core/base/check.h"
#include "core/base/error.h"
#include "core/base/random.h"
#include "core/base/text.h"
#include "core/store/batch.h"
#include "core/store/entries.h"
#include "core/store/person_codes.h"
#include "core/store/persons.h"
#include "core/store/study_records.h"
#include "experiments/published_tables.h"

namespace tactus::session {
namespace {

// Levels count the form's terms: 0 is very small, 1 small, 2 medium, 3 large, 4 very large.

struct Region {
  std::string_view term;
  double level;  // before a condition has its effect
};
// The force rises in the nasal cavity, drops, peaks in the oropharynx, and settles in the esophagus near S4's answers.
constexpr std::array<Region, 5> kRegions = {
    {{"nasal_cavity", 2.4}, {"nasopharynx", 1.5}, {"oropharynx", 3.5}, {"laryngopharynx", 2.5}, {"esophagus", 2.7}}};

struct Effect {
  std::string_view input;
  std::string_view term;
  double level;
};
constexpr std::array<Effect, 9> kEffects = {{{"lubrication", "poor", 0.9},
                                             {"lubrication", "medium", 0},
                                             {"lubrication", "well", -0.9},
                                             {"neck_flexion", "small", 0.4},
                                             {"neck_flexion", "medium", -0.4},
                                             {"neck_flexion", "large", -1.2},
                                             {"speed", "slow", -0.8},
                                             {"speed", "medium", 0},
                                             {"speed", "fast", 0.9}}};

struct Nurse {
  std::string_view code;
  std::string_view sensitive_to;  // an input whose effects the nurse feels more
  double sensitivity;
  double oropharynx;  // extra level there
};
constexpr std::array<Nurse, 3> kNurses = {{{"S1", "neck_flexion", 1.15, 0},
                                           {"S2", "lubrication", 1.15, 0.8},  // Fig. 11: "relatively higher"
                                           {"S3", "speed", 1.15, 0}}};

// Deviations are uniform in ± this. Of two answers, regions differ by at most 0.2 and effects by at most 0.2 through
// them: less than the differences above that the statements of the header rest on.
constexpr double kDeviation = 0.1;

/// One nurse's levels.
struct Beliefs {
  std::array<double, kRegions.size()> region;
  std::array<double, kEffects.size()> effect;
};

Beliefs beliefsOf(const Nurse& nurse, base::Random& random) {
  Beliefs beliefs{};
  for (std::size_t i = 0; i < kRegions.size(); ++i) {
    const double extra = kRegions[i].term == "oropharynx" ? nurse.oropharynx : 0;
    beliefs.region[i] = kRegions[i].level + extra + random.uniform(-kDeviation, kDeviation);
  }
  for (std::size_t i = 0; i < kEffects.size(); ++i) {
    const double sensitivity = kEffects[i].input == nurse.sensitive_to ? nurse.sensitivity : 1;
    beliefs.effect[i] = sensitivity * kEffects[i].level + random.uniform(-kDeviation, kDeviation);
  }
  return beliefs;
}

double effectOf(const study::ItemCondition& condition, const Beliefs& beliefs) {
  const auto effect = std::find_if(kEffects.begin(), kEffects.end(), [&condition](const Effect& candidate) {
    return candidate.input == condition.input && candidate.term == condition.term;
  });
  if (effect != kEffects.end()) return beliefs.effect[static_cast<std::size_t>(effect - kEffects.begin())];
  const auto region = std::find_if(kRegions.begin(), kRegions.end(), [&condition](const Region& candidate) {
    return condition.input == "depth" && candidate.term == condition.term;
  });
  TACTUS_CHECK(region != kRegions.end());
  return beliefs.region[static_cast<std::size_t>(region - kRegions.begin())];
}

const std::string& termAt(double level, const std::vector<study::AnswerWord>& answers) {
  TACTUS_CHECK(!answers.empty());
  const double highest = static_cast<double>(answers.size() - 1);
  return answers[static_cast<std::size_t>(std::clamp(std::round(level), 0.0, highest))].term;
}

}  // namespace

std::vector<study::Answer> simulatedAnswers(const study::Form& form, std::uint64_t seed) {
  std::vector<study::Answer> answers;
  base::Random random(seed);
  for (const auto& nurse : kNurses) {
    const Beliefs beliefs = beliefsOf(nurse, random);
    for (const auto& item : form.items) {
      double level = 0;
      for (const auto& condition : item.conditions) level += effectOf(condition, beliefs);
      answers.push_back({std::string(nurse.code), form.id, item.number, termAt(level, form.answers),
                         study::Answer::Status::kAnswered});
    }
  }
  return answers;
}

namespace {

constexpr std::uint64_t kCells = 1000;  // of Table 1, more than there are

/// An expert who judges as `responder` and gives those of the `answers` that are hers; without levels of speed.
NurseTraits nurseWith(ResponderTraits responder, const std::vector<study::Answer>& answers) {
  NurseTraits nurse;
  nurse.profile.category = "expert";
  nurse.profile.handedness = "right";
  nurse.responder = std::move(responder);
  std::copy_if(answers.begin(), answers.end(), std::back_inserter(nurse.answers),
               [&](const study::Answer& answer) { return answer.participant == nurse.responder.code; });
  return nurse;
}

/// The nurses that `wanted` names. Each level of Table 1 takes a second or less; they are computed at the same time.
std::vector<NurseTraits> nursesOf(std::uint64_t seed, const std::function<bool(std::string_view)>& wanted) {
  const auto table = experiments::publishedSpeeds();
  std::vector<std::future<SimulatedLevel>> levels(table.size());
  for (std::size_t cell = 0; cell < table.size(); ++cell) {
    if (!wanted(table[cell].participant)) continue;
    levels[cell] = std::async(std::launch::async, [target = table[cell], own_seed = seed * kCells + cell] {
      return simulatedLevel(target, own_seed);
    });
  }
  const auto answers = simulatedAnswers(procedure::defaultProcedure()->forms.front(), seed);
  std::vector<NurseTraits> nurses;
  for (auto& responder : respondersOfTable2()) {
    if (!wanted(responder.code)) continue;
    responder.noise = 0;
    responder.lapse = 0;
    NurseTraits nurse = nurseWith(std::move(responder), answers);
    for (std::size_t cell = 0; cell < table.size(); ++cell) {
      if (table[cell].participant == nurse.responder.code) nurse.levels[table[cell].level] = levels[cell].get();
    }
    nurses.push_back(std::move(nurse));
  }
  return nurses;
}

}  // namespace

std::vector<NurseTraits> simulatedNurses(std::uint64_t seed) {
  return nursesOf(seed, [](std::string_view) { return true; });
}

NurseTraits simulatedNurseCalled(std::string_view code, std::uint64_t seed) {
  auto nurses = nursesOf(seed, [code](std::string_view each) { return each == code; });
  TACTUS_CHECK(nurses.size() == 1);
  return std::move(nurses.front());
}

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
    TACTUS_TRY(auto batch, store::Batch::begin(file_));
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
    TACTUS_TRY(auto session, Session::begin(file_, start, clock_.tools(seed_)));
    SimulatedNurse simulated(nurse, seed_, [this](double seconds) { clock_.pass(seconds); });
    if (auto ok = simulated.finish(session); !ok) return ok;
    for (const auto& rule : rules) {
      study::RuleRecord record;
      record.entry = {nextId(), session.record().id, clock_.look(), study::EnteredBy::kProgram, {}, {}};
      record.rule = rule;
      record.rule.participant.clear();
      if (auto ok = store::append(file_, record); !ok) return ok;
    }
    clock_.pass(kBetweenSessionsS);
    return batch.commit();
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
  TACTUS_TRY(const auto rules, questionnaires::s4Rules(reading));
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
    const bool published = rules.front().participant == nurse.responder.code;
    if (auto ok = simulation.visit(nurse, published ? rules : std::vector<study::GivenRule>{}); !ok) {
      return tl::unexpected(inFile(ok.error(), path));
    }
  }
  return file;
}

namespace {

constexpr double kLargestSpread = 0.25;  // of the logarithms of speeds and thresholds: twice that of Table 1's nurses
constexpr std::array<std::string_view, 3> kModels = {"S1", "S2", "S3"};  // those with answers

NurseTraits likeOneOfThem(std::string_view model, double spread, std::uint64_t seed, std::uint64_t answers_seed) {
  base::Random random(seed);
  const double speeds = std::exp(spread * random.normal());
  const double forces = std::exp(spread * random.normal());
  ResponderTraits responder;
  for (auto& each : respondersOfTable2()) {
    if (each.code == model) responder = std::move(each);
  }
  for (double& threshold : responder.threshold_n) threshold *= forces;
  responder.beyond_from_n *= forces;
  responder.noise = spread / kLargestSpread;
  responder.lapse *= spread / kLargestSpread;
  NurseTraits nurse =
      nurseWith(std::move(responder), simulatedAnswers(procedure::defaultProcedure()->forms.front(), answers_seed));
  std::uint64_t cell = 0;
  for (auto target : experiments::publishedSpeeds()) {
    ++cell;
    if (target.participant != model) continue;
    const double share = target.sd_mm_s / target.mean_mm_s;
    target.mean_mm_s = std::clamp(target.mean_mm_s * speeds, 30.0, 300.0);
    target.sd_mm_s = share * target.mean_mm_s;
    nurse.levels[target.level] = simulatedLevel(target, seed + cell);
  }
  return nurse;
}

Result<void> canSimulate(const SessionSettings& settings) {
  constexpr int kMostStrokes = 4;
  if (settings.speed.strokes > kMostStrokes) {
    return base::fail(base::ErrorCode::kValue, "protocol",
                      std::to_string(settings.speed.strokes) + " strokes of a speed", "at most 4 for simulated nurses");
  }
  if (std::find(settings.blocks.begin(), settings.blocks.end(), Block::kSpeed) == settings.blocks.end()) return {};
  for (const std::string& level : settings.speed.levels) {
    const auto* const rate = settings.about().rateInput();
    if (rate == nullptr || fuzzy::findTerm(rate->terms, level) == nullptr)
      return base::fail(base::ErrorCode::kValue, "protocol", "the speed " + base::quoted(level),
                        "the words of the procedure for simulated nurses");
  }
  return {};
}

}  // namespace

Result<std::vector<std::string>> addSimulatedNurses(store::StudyFile& file, const SimulatedGroup& group,
                                                    std::int64_t now_utc_ms, const std::string& program,
                                                    const std::function<bool()>& goes_on) {
  using base::ErrorCode;
  if (group.count < 1 || group.count > SimulatedGroup::kMost) {
    return base::fail(ErrorCode::kValue, "simulated nurses", std::to_string(group.count), "1 to 50");
  }
  if (!(group.alike >= 0 && group.alike <= 1)) {
    return base::fail(ErrorCode::kValue, "how alike", base::formatNumber(group.alike), "0 to 1");
  }
  if (group.seed < 1 || group.seed > kLargestSeed) {
    return base::fail(ErrorCode::kValue, "seed", std::to_string(group.seed), "1 to 10^16");
  }
  TACTUS_TRY(const auto state, store::protocolState(file));
  SessionStart start;
  if (state.current) {
    TACTUS_TRY(auto protocol, protocolOf(file, *state.current));
    // The simulated nurses of the paper speak English, whatever languages the study offers.
    if (protocol.settings.about().id != procedure::defaultProcedure()->id) start.language = protocol.languages.front();
    start.settings = std::move(protocol.settings);
    start.protocol = state.current->id;
  }
  if (auto ok = canSimulate(start.settings); !ok) return tl::unexpected(ok.error());
  start.consent_version = "simulated";
  start.station = "simulated";
  start.program = program;
  start.device = "simulated, steps of 0.055 mm";

  constexpr std::int64_t kVisitMs = 45 * 60'000;
  const double spread = kLargestSpread * (1 - group.alike);
  store::PersonCodes codes;
  std::vector<std::string> added;
  for (int i = 0; i < group.count; ++i) {
    if (goes_on && !goes_on()) break;
    const std::uint64_t seed = (group.seed * SimulatedGroup::kMost + static_cast<std::uint64_t>(i)) * kSeedsOfOne;
    const procedure::Procedure& about = start.settings.about();
    const study::Form* const form = about.form(start.settings.form);
    const auto nurse = about.id == procedure::defaultProcedure()->id
                           ? likeOneOfThem(kModels[static_cast<std::size_t>(i) % kModels.size()], spread, seed,
                                           spread > 0 ? seed : group.seed)
                           : simulatedExpert(about, form != nullptr ? *form : about.forms.front(), seed, spread);
    TACTUS_TRY(auto batch, store::Batch::begin(file));
    TACTUS_TRY(const auto code, store::unusedCode(file, codes));
    study::RecordIds ids;
    const study::Person person{ids.next(), code, true};
    if (auto ok = store::append(file, person); !ok) return tl::unexpected(ok.error());
    start.person = person.id;
    start.seed = seed;
    const SimulatedClock clock(now_utc_ms - (group.count - i) * kVisitMs);
    SessionTools tools{[clock] { return clock.look(); }, study::RecordIds()};
    TACTUS_TRY(auto session, Session::begin(file, start, std::move(tools)));
    SimulatedNurse simulated(nurse, seed, [clock](double seconds) { clock.pass(seconds); });
    if (auto ok = simulated.finish(session); !ok) return tl::unexpected(ok.error());
    if (auto ok = batch.commit(); !ok) return tl::unexpected(ok.error());
    added.push_back(code);
  }
  return added;
}

}  // namespace tactus::session
