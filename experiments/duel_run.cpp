#include "experiments/duel_run.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/check.h"
#include "core/base/random.h"
#include "core/base/text.h"
#include "experiments/seeded_order.h"

namespace tactus::experiments {
namespace {

using study::DuelAnswer;
using study::DuelChoice;
using study::DuelRule;
using study::DuelStart;
using study::DuelTrialKind;

constexpr int kBlock = 4;
constexpr int kLongestRun = 3;
constexpr int kPairsPerCatch = 9;

/// The orders of `trials` pairs.
std::vector<bool> ordersOf(int trials, std::uint64_t seed) {
  base::Random random(blockSeed(seed, "duel/orders"));
  std::vector<bool> out;
  while (static_cast<int>(out.size()) < trials) {
    const int size = std::min(kBlock, trials - static_cast<int>(out.size()));
    std::vector<char> block(static_cast<std::size_t>(size), 0);
    const int ones = size / 2 + (size % 2 == 1 ? random.below(2) : 0);
    std::fill(block.begin(), block.begin() + ones, 1);
    block = shuffled(block, random);
    auto joined = out;
    joined.insert(joined.end(), block.begin(), block.end());
    int run = 0;
    bool too_long = false;
    for (std::size_t i = 0; i < joined.size(); ++i) {
      run = i > 0 && joined[i] == joined[i - 1] ? run + 1 : 1;
      too_long = too_long || run > kLongestRun;
    }
    if (!too_long) out = std::move(joined);  // otherwise the block is drawn again
  }
  return out;
}

/// How the answer of a trial counts for the one that is expected, or heavier.
double scoreOf(const DuelAnswer& answer, bool wanted_is_second) {
  if (answer.choice == DuelChoice::kCantTell) return 0.5;
  const bool wanted_first = answer.second_first == wanted_is_second;
  return (answer.choice == DuelChoice::kFirst) == wanted_first ? 1 : 0;
}

double scoreOf(const DuelStart& start, const DuelAnswer& answer) {
  return scoreOf(answer, answer.kind == DuelTrialKind::kPair ? start.expects_b : true);
}

/// The half of "can't tell" is drawn, because a step of the search needs an answer.
JndTrial jndTrialOf(const DuelStart& start, const DuelAnswer& answer) {
  const double score = scoreOf(answer, true);
  if (score != 0.5) return {answer.difference_jnd, score == 1};
  base::Random random(blockSeed(start.seed, "duel/own/" + std::to_string(answer.trial)));
  return {answer.difference_jnd, random.below(2) == 1};
}

SequentialTest sequentialTestOf(const DuelStart& start) {
  SequentialTest test;
  test.share_right = shareRight(start.sought_jnd);
  test.beta = 1 - start.power;
  test.most_trials = start.trials;
  return test;
}

/// -1: not shown, 1: they differ, 0: not decided yet.
int decisionOf(const DuelStart& start, double right, int trials) {
  const SequentialTest test = sequentialTestOf(start);
  const double sum = right * test.rightStep() + (trials - right) * test.wrongStep();
  return sum >= test.differAt() ? 1 : sum <= test.stopAt() ? -1 : 0;
}

base::Error planError(std::string found, std::string wanted) {
  return {base::ErrorCode::kValue, {}, "duel", std::move(found), std::move(wanted)};
}

}  // namespace

std::vector<DuelTrial> ownJndTrials(int trials, std::uint64_t seed) {
  std::vector<DuelTrial> out;
  for (const bool second_first : ordersOf(trials, seed)) out.push_back({DuelTrialKind::kOwn, second_first});
  return out;
}

std::vector<DuelTrial> duelTrials(int trials, std::uint64_t seed) {
  TACTUS_CHECK(trials >= 1);
  const std::vector<bool> orders = ordersOf(trials, seed);
  base::Random random(blockSeed(seed, "duel/catches"));
  // Each catch trial stands before another pair, and not before the first.
  std::vector<int> places;
  for (int i = 1; i < trials; ++i) places.push_back(i);
  places = shuffled(places, random);
  places.resize(static_cast<std::size_t>(trials / kPairsPerCatch));
  std::sort(places.begin(), places.end());
  std::vector<DuelTrial> out;
  std::size_t catches = 0;
  for (int i = 0; i < trials; ++i) {
    if (catches < places.size() && places[catches] == i) {
      out.push_back({catches % 2 == 0 ? DuelTrialKind::kLarge : DuelTrialKind::kSame, random.below(2) == 1});
      ++catches;
    }
    out.push_back({DuelTrialKind::kPair, orders[static_cast<std::size_t>(i)]});
  }
  return out;
}

std::string_view name(DuelRepeat repeat) noexcept {
  switch (repeat) {
    case DuelRepeat::kNone: return "none";
    case DuelRepeat::kNotWhole: return "not_whole";
    case DuelRepeat::kTooSlow: return "too_slow";
    case DuelRepeat::kTooFast: return "too_fast";
    case DuelRepeat::kPause: return "pause";
  }
  return "none";
}

base::Result<void> validate(const DuelStart& start) {
  if (start.trials < 1 || start.trials > kMostTrials) {
    return tl::unexpected(planError(std::to_string(start.trials) + " trials", "1 to " + std::to_string(kMostTrials)));
  }
  const bool stroke = std::isfinite(start.from_mm) && std::isfinite(start.to_mm) && start.to_mm > start.from_mm &&
                      std::isfinite(start.speed_mm_s) && start.speed_mm_s > 0;
  if (!stroke) {
    return tl::unexpected(planError("a stroke from " + base::formatNumber(start.from_mm) + " to " +
                                        base::formatNumber(start.to_mm) + " mm at " +
                                        base::formatNumber(start.speed_mm_s) + " mm/s",
                                    "a stroke inwards with a speed above 0"));
  }
  if (!(start.sought_jnd > 0) || !std::isfinite(start.sought_jnd) || !(start.power > 0.5) || !(start.power < 1)) {
    return tl::unexpected(planError("a difference of " + base::formatNumber(start.sought_jnd) + " JND with power " +
                                        base::formatNumber(start.power),
                                    "a difference above 0 and a power between 0.5 and 1"));
  }
  return {};
}

base::Result<DuelRun> DuelRun::create(const DuelStart& start, std::span<const DuelAnswer> answers) {
  if (auto ok = validate(start); !ok) return tl::unexpected(ok.error());
  DuelRun run(start, start.rule == DuelRule::kOwnJnd ? ownJndTrials(start.trials, start.seed)
                                                     : duelTrials(start.trials, start.seed));
  for (const DuelAnswer& answer : answers) {
    const auto refused = [&](std::string wanted) {
      return tl::unexpected(planError("an answer to trial " + std::to_string(answer.trial), std::move(wanted)));
    };
    if (run.stage_ == Stage::kFinished) return refused("none after the end of the duel");
    const DuelAnswer planned = run.record();
    if (answer.trial != planned.trial || answer.kind != planned.kind || answer.second_first != planned.second_first) {
      return refused("trial " + std::to_string(planned.trial) + " as the plan has it");
    }
    run.add(answer);
  }
  return run;
}

bool DuelRun::restFirst() const {
  return stage_ == Stage::kFirstStroke && attempt_ == 1 && done_ > 0 && done_ % kRestEvery == 0;
}

DuelForce DuelRun::felt() const {
  TACTUS_CHECK(stage_ == Stage::kFirstStroke || stage_ == Stage::kSecondStroke);
  const bool second = trial().second_first == (stage_ == Stage::kFirstStroke);
  switch (trial().kind) {
    case DuelTrialKind::kPair: return {second, 0};
    case DuelTrialKind::kSame: return {trial().second_first, 0};
    case DuelTrialKind::kLarge:
    case DuelTrialKind::kOwn: return {false, second ? record().difference_jnd : 0};
  }
  return {};
}

DuelAnswer DuelRun::record() const {
  DuelAnswer out;
  out.duel = start_.entry.id;
  out.trial = static_cast<int>(done_) + 1;
  out.attempt = attempt_;
  out.kind = trial().kind;
  out.second_first = trial().second_first;
  if (out.kind == DuelTrialKind::kLarge) out.difference_jnd = kLargeCatchJnd;
  if (out.kind == DuelTrialKind::kOwn) out.difference_jnd = search_.next();
  return out;
}

DuelRepeat DuelRun::wrongWith(const DuelStroke& stroke) const {
  if (stroke.from_mm > start_.from_mm || stroke.to_mm < start_.to_mm) return DuelRepeat::kNotWhole;
  if (!(stroke.mean_mm_s >= (1 - kSpeedTolerance) * start_.speed_mm_s)) return DuelRepeat::kTooSlow;
  if (stroke.mean_mm_s > (1 + kSpeedTolerance) * start_.speed_mm_s) return DuelRepeat::kTooFast;
  if (stage_ == Stage::kSecondStroke && stroke.pause_s > kLongestPauseS) return DuelRepeat::kPause;
  return DuelRepeat::kNone;
}

std::optional<DuelAnswer> DuelRun::stroke(const DuelStroke& stroke) {
  TACTUS_CHECK(stage_ == Stage::kFirstStroke || stage_ == Stage::kSecondStroke);
  const bool is_first = stage_ == Stage::kFirstStroke;
  (is_first ? first_mm_s_ : second_mm_s_) = stroke.mean_mm_s;
  const DuelRepeat wrong = wrongWith(stroke);
  if (wrong == DuelRepeat::kNone) {
    stage_ = is_first ? Stage::kSecondStroke : Stage::kQuestion;
    return std::nullopt;
  }
  DuelAnswer out = record();
  out.repeated = name(wrong);
  out.first_mm_s = first_mm_s_;
  out.second_mm_s = second_mm_s_;
  add(out);
  repeat_ = wrong;
  return out;
}

DuelAnswer DuelRun::answer(DuelChoice choice, double response_s) {
  TACTUS_CHECK(stage_ == Stage::kQuestion);
  DuelAnswer out = record();
  out.choice = choice;
  out.first_mm_s = first_mm_s_;
  out.second_mm_s = second_mm_s_;
  out.response_s = response_s;
  add(out);
  return out;
}

void DuelRun::add(const DuelAnswer& answer) {
  answers_.push_back(answer);
  first_mm_s_ = second_mm_s_ = 0;
  repeat_ = DuelRepeat::kNone;
  stage_ = Stage::kFirstStroke;
  if (!answer.choice) {
    ++attempt_;
    return;
  }
  if (answer.kind == DuelTrialKind::kOwn) search_.add(jndTrialOf(start_, answer));
  attempt_ = 1;
  ++done_;
  if (done_ == plan_.size() || isDecided()) stage_ = Stage::kFinished;
}

bool DuelRun::isDecided() const {
  if (start_.rule != DuelRule::kSequential) return false;
  const DuelVerdict verdict = verdictOf(start_, answers_);
  return decisionOf(start_, verdict.right, verdict.trials) != 0;
}

DuelVerdict verdictOf(const DuelStart& start, std::span<const DuelAnswer> answers) {
  DuelVerdict out;
  OrderedWins wins;
  JndSearch search;
  for (const DuelAnswer& answer : answers) {
    if (!answer.choice) {
      ++out.repeated;
      continue;
    }
    const double score = scoreOf(start, answer);
    switch (answer.kind) {
      case DuelTrialKind::kLarge:
        ++out.large;
        out.large_right += score == 1 ? 1 : 0;
        continue;
      case DuelTrialKind::kSame:
        ++out.same;
        out.same_named += answer.choice == DuelChoice::kCantTell ? 0 : 1;
        continue;
      case DuelTrialKind::kOwn: search.add(jndTrialOf(start, answer)); break;
      case DuelTrialKind::kPair: break;
    }
    ++out.trials;
    out.right += score;
    out.cant_tell += answer.choice == DuelChoice::kCantTell ? 1 : 0;
    const bool wanted_first = answer.second_first == (answer.kind == DuelTrialKind::kOwn || start.expects_b);
    (wanted_first ? wins.wins_first : wins.wins_second) += score;
    ++(wanted_first ? wins.trials_first : wins.trials_second);
  }
  out.marked = out.large > 0 && out.large_right < kLeastLargeShare * out.large;
  if (wins.trials_first > 0 && wins.trials_second > 0) out.order = orderEffectOf(wins);
  if (out.trials > 0) out.share = clopperPearson(out.right, out.trials);
  const bool complete = out.trials == start.trials;
  switch (start.rule) {
    case DuelRule::kFixed: {
      const BinomialTest test = testOf(start.trials, shareRight(start.sought_jnd));
      out.critical = test.critical;
      out.chance = out.trials > 0 ? chanceWithoutDifference(out.right, out.trials) : 1;
      out.detectable_jnd = detectableJnd(test, start.power);
      if (complete) {
        out.outcome = out.right >= test.critical ? DuelVerdict::Outcome::kDiffer : DuelVerdict::Outcome::kNotShown;
      }
      break;
    }
    case DuelRule::kSequential: {
      const int decision = decisionOf(start, out.right, out.trials);
      out.detectable_jnd = start.sought_jnd;
      if (decision > 0) out.outcome = DuelVerdict::Outcome::kDiffer;
      if (decision < 0 || (decision == 0 && complete)) out.outcome = DuelVerdict::Outcome::kNotShown;
      break;
    }
    case DuelRule::kOwnJnd:
      out.own = search.estimate();
      if (complete) out.outcome = DuelVerdict::Outcome::kMeasured;
      break;
  }
  return out;
}

std::string_view name(DuelVerdict::Outcome outcome) noexcept {
  switch (outcome) {
    case DuelVerdict::Outcome::kUnfinished: return "unfinished";
    case DuelVerdict::Outcome::kDiffer: return "differ";
    case DuelVerdict::Outcome::kNotShown: return "not_shown";
    case DuelVerdict::Outcome::kMeasured: return "measured";
  }
  return "unfinished";
}

study::DuelEnd endOf(const DuelRun& run) {
  const DuelVerdict verdict = verdictOf(run.start(), run.answers());
  study::DuelEnd out;
  out.duel = run.start().entry.id;
  out.outcome = name(verdict.outcome);
  out.trials = verdict.trials;
  out.right = verdict.right;
  return out;
}

std::string sentenceOf(const DuelStart& start, const DuelVerdict& verdict) {
  using Outcome = DuelVerdict::Outcome;
  const auto percent = [](double share) { return base::formatFixed(100 * share, 0); };
  const auto jnd = [](double difference) { return base::formatFixed(difference, 1) + " JND"; };
  std::string out;
  switch (verdict.outcome) {
    case Outcome::kUnfinished: return "Not finished: nothing is said of the answers so far.";
    case Outcome::kDiffer:
      out = base::quoted(start.expects_b ? start.b.name : start.a.name) +
            (start.question == study::DuelQuestion::kHeavier ? " is felt as heavier: "
                                                             : " is felt as more like a real insertion: ") +
            base::formatNumber(verdict.right) + " of " + std::to_string(verdict.trials) + " (95 % interval " +
            percent(verdict.share.low) + " to " + percent(verdict.share.high) + " %).";
      break;
    case Outcome::kNotShown:
      out = "Not shown to differ: " + base::formatNumber(verdict.right) + " of " + std::to_string(verdict.trials) +
            "; a difference of " + jnd(verdict.detectable_jnd) + " or more would have been found with " +
            percent(start.power) + " %.";
      break;
    case Outcome::kMeasured:
      out = "The smallest difference that is felt is " + base::formatFixed(verdict.own->factor, 2) +
            " times the usual one (95 % interval " + base::formatFixed(verdict.own->low, 2) + " to " +
            base::formatFixed(verdict.own->high, 2) + "), after " + std::to_string(verdict.trials) + " trials.";
      break;
  }
  if (start.rule == DuelRule::kSequential)
    out += " Sequential: it stopped when the answers sufficed, so the interval is too narrow.";
  if (verdict.marked) {
    out += " Marked: only " + std::to_string(verdict.large_right) + " of " + std::to_string(verdict.large) +
           " large differences were told right.";
  }
  if (!start.gives_force) out += " The device gave no force, so nothing was felt.";
  return out;
}

std::vector<DuelAnswer> simulatedAnswers(const DuelStart& start, const DuelResponder& responder, std::uint64_t seed) {
  auto run = DuelRun::create(start);
  TACTUS_CHECK(run);
  base::Random random(blockSeed(seed, "duel/responder"));
  const auto stroke = [&] {
    const bool fast = responder.off_speed > 0 && random.uniform() < responder.off_speed;
    return DuelStroke{start.from_mm, start.to_mm, (fast ? 1.5 : 1) * start.speed_mm_s, 0.5};
  };
  // How much heavier `force` is than A, in JND.
  const auto weight = [&](const DuelForce& force) {
    if (!force.is_b) return force.heavier_jnd;
    return start.expects_b ? responder.difference_jnd : -responder.difference_jnd;
  };
  while (run->stage() != DuelRun::Stage::kFinished) {
    const double first = weight(run->felt());
    if (run->stroke(stroke())) continue;
    const double second = weight(run->felt());
    if (run->stroke(stroke())) continue;
    const bool untold = random.uniform() < responder.cant_tell;
    const double share_first = shareRight((first - second + responder.order_bias) / responder.own_jnd);
    const bool names_first = random.uniform() < share_first;
    run->answer(untold ? DuelChoice::kCantTell : names_first ? DuelChoice::kFirst : DuelChoice::kSecond, 1);
  }
  return run->answers();
}

}  // namespace tactus::experiments
