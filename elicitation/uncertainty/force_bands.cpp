#include "elicitation/uncertainty/force_bands.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/analysis/force_difference.h"
#include "core/base/error.h"
#include "core/base/statistics.h"
#include "core/fuzzy/compiled_model.h"
#include "elicitation/force/force_thresholds.h"
#include "elicitation/force/noticeable_force.h"
#include "elicitation/speed/participant_speeds.h"
#include "elicitation/speed/stroke_bootstrap.h"

namespace tactus::elicitation {
namespace {

constexpr double kManyDegrees = 1e6;  // Student's t is the normal distribution
constexpr double kEdge = 0.25;        // of a standard deviation

constexpr std::array<Drawn, 4> kOfPeople = {Drawn::kPeople, Drawn::kWhoMoved, Drawn::kWhoJudged, Drawn::kWhoAnswered};

/// The first of them then stand for all of them, as far as they go: in the order of the enumeration the first ones
/// would all hold the same few people.
std::vector<WeightedResample> inAnyOrder(std::vector<WeightedResample> resamples) {
  constexpr std::uint64_t kSeed = 1;
  base::Random random(kSeed);
  for (std::size_t left = resamples.size(); left > 1; --left)
    std::swap(resamples[left - 1], resamples[static_cast<std::size_t>(random.below(static_cast<int>(left)))]);
  return resamples;
}

}  // namespace

std::string_view name(BandKind kind) noexcept {
  switch (kind) {
    case BandKind::kAgain: return "again";
    case BandKind::kOthers: return "others";
    case BandKind::kNext: return "next";
    case BandKind::kWords: return "words";
  }
  return "";
}

std::string_view name(Drawn drawn) noexcept {
  switch (drawn) {
    case Drawn::kPeople: return "people";
    case Drawn::kWhoMoved: return "who_moved";
    case Drawn::kWhoJudged: return "who_judged";
    case Drawn::kWhoAnswered: return "who_answered";
    case Drawn::kOwnStrokes: return "own_strokes";
    case Drawn::kOwnJudgements: return "own_judgements";
  }
  return "";
}

ForceBands::ForceBands(ResampledStudy study, BandSettings settings)
    : study_(std::move(study)), settings_(std::move(settings)), random_(settings_.seed) {}

base::Result<ForceBands> ForceBands::of(const study::Study& study, const BuiltModel& built,
                                        const BuildSettings& settings, BandSettings bands) {
  TACTUS_TRY(const auto compiled, fuzzy::compile(built.model));
  ForceBands out(ResampledStudy(study, built, settings), std::move(bands));
  for (const auto& point : out.settings_.points) {
    const auto force = compiled.evaluate(point);
    out.own_.push_back(force.fired ? std::optional(force.force_n) : std::nullopt);
    auto& experts = out.experts_.emplace_back();
    for (std::size_t e = 0; e < built.model.experts.size(); ++e) {
      const auto own = compiled.evaluateExpert(e, point);
      experts.push_back(own.fired ? std::optional(own.force_n) : std::nullopt);
    }
  }
  // Not what this model can reach: others say other words of other forces.
  out.lowest_n_ = built.model.output.min;
  out.highest_n_ = built.model.output.max;
  if (out.settings_.words) {
    if (auto ok = out.prepareWords(study, built); !ok) return tl::unexpected(ok.error());
  }
  if (out.settings_.again) {
    out.prepareStrokes(study, built);
    out.prepareThresholds(built);
  }
  out.plan();
  return out;
}

void ForceBands::prepareStrokes(const study::Study& study, const BuiltModel& built) {
  if (!study_.hasSpeeds()) return;
  const fuzzy::Variable& speed = built.model.inputs[fuzzy::rateOf(built.model.inputs).value()];
  std::vector<std::string> levels;
  for (const auto& term : speed.terms) levels.push_back(term.id);
  strokes_.resize(study_.people());
  const ParticipantSamples samples(study.speeds);
  std::vector<DrawSpread> spreads;
  for (std::size_t who = 0; who < study_.people(); ++who) {
    const auto speeds = std::find_if(built.speeds.begin(), built.speeds.end(),
                                     [&](const auto& one) { return one.participant == study_.codes()[who]; });
    if (speeds == built.speeds.end()) continue;
    std::vector<study::SpeedSample> room;
    const auto kept = keptSamples(samples.of(study_.codes()[who]), study_.settings().speed.trim, room);
    auto drawn = StrokeBootstrap::of(kept, levels, speeds->centres, study_.settings().speed, settings_.seed + who);
    if (!drawn) {
      no_strokes_ = drawn.error().message();
      return;
    }
    for (const auto& spread : drawn->rampSpreads()) spreads.insert(spreads.end(), {spread.p, spread.q});
    strokes_[who] = std::move(*drawn);
  }
  if (spreads.empty()) return;
  stroke_spread_ = pooledSpread(std::vector<double>(spreads.size(), 1), spreads);
}

void ForceBands::prepareThresholds(const BuiltModel& built) {
  if (!study_.hasJudgements()) return;
  std::vector<study::ForceJudgement> all;
  for (const auto& own : study_.judged()) all.insert(all.end(), own.begin(), own.end());
  const auto terms = thresholdTerms(study_.defaultOutput(), all, study_.settings().series, built.votes);
  if (!terms) return;
  thresholds_n_.resize(study_.people());
  for (const auto& one : terms->participants) {
    for (std::size_t who = 0; who < study_.people(); ++who) {
      if (study_.codes()[who] == one.participant) thresholds_n_[who] = one.threshold_n;
    }
  }
}

base::Result<void> ForceBands::prepareWords(const study::Study& study, const BuiltModel& built) {
  words_ = elicitation::ownWords(study, built, study_.settings());
  for (const auto& own : words_) {
    auto& forces = under_words_.emplace_back(settings_.points.size());
    const auto model = underWords(built.model, own);
    if (!model) continue;
    TACTUS_TRY(const auto compiled, fuzzy::compile(*model));
    for (std::size_t p = 0; p < forces.size(); ++p) {
      const auto force = compiled.evaluate(settings_.points[p]);
      if (force.fired) forces[p] = force.force_n;
    }
  }
  return {};
}

void ForceBands::plan() {
  const auto people = study_.people();
  const bool enumerated = people <= kMostEnumerated;
  for (const Drawn drawn : kOfPeople) {
    if (people < 2 || !settings_.others || (drawn != Drawn::kPeople && !settings_.split) ||
        (drawn == Drawn::kWhoMoved && !study_.hasSpeeds()) || (drawn == Drawn::kWhoJudged && !study_.hasJudgements())) {
      continue;
    }
    auto& plan = plans_.emplace_back();
    plan.drawn = drawn;
    if (enumerated) plan.resamples = inAnyOrder(everyResample(people));
    plan.planned = enumerated ? plan.resamples.size() : settings_.replicates;
  }
  if (stroke_spread_) plans_.push_back({Drawn::kOwnStrokes, settings_.replicates, {}, {}, {}});
  if (!thresholds_n_.empty()) plans_.push_back({Drawn::kOwnJudgements, settings_.replicates, {}, {}, {}});
}

std::vector<study::ForceJudgement> ForceBands::judgedAgain(std::size_t who) {
  auto judged = study_.judged()[who];
  const auto& thresholds_n = thresholds_n_[who];
  if (thresholds_n.empty()) return judged;
  const auto& terms = study_.defaultOutput().terms;
  for (auto& one : judged) {
    if (one.kind != study::ForceJudgement::Kind::kTerm) continue;
    const double felt_n = one.force_n + justNoticeableDifference(one.force_n) * random_.normal();
    const auto level = std::upper_bound(thresholds_n.begin(), thresholds_n.end(), felt_n) - thresholds_n.begin();
    one.term = terms[static_cast<std::size_t>(level)].id;
  }
  return judged;
}

Resample ForceBands::nextOf(const Plan& plan, double& weight) {
  const ResampleCounts all = everyPerson(study_.people());
  Resample resample{all, all, all};
  if (plan.drawn == Drawn::kOwnStrokes) {
    for (auto& strokes : strokes_) {
      if (strokes) strokes->add(1);
      resample.ramps.push_back(strokes ? strokes->ramps().back() : std::vector<Ramp>{});
    }
    return resample;
  }
  if (plan.drawn == Drawn::kOwnJudgements) {
    for (std::size_t who = 0; who < study_.people(); ++who) resample.judged.push_back(judgedAgain(who));
    return resample;
  }
  ResampleCounts counts;
  if (plan.resamples.empty()) {
    counts = drawResample(study_.people(), random_);
  } else {
    counts = plan.resamples[plan.forces.size()].counts;
    weight = plan.resamples[plan.forces.size()].weight;
  }
  if (plan.drawn == Drawn::kPeople) return {counts, counts, counts};
  (plan.drawn == Drawn::kWhoMoved    ? resample.speeds
   : plan.drawn == Drawn::kWhoJudged ? resample.judgements
                                     : resample.rules) = counts;
  return resample;
}

void ForceBands::addOne(Plan& plan) {
  double weight = 1;
  const Resample resample = nextOf(plan, weight);
  plan.forces.push_back(study_.forces(resample, settings_.points));
  plan.weights.push_back(weight);
}

bool ForceBands::add(std::size_t replicates) {
  // Each plan at the same share of its way, so that all of them can be shown at any time.
  while (replicates > 0) {
    const auto next = std::min_element(plans_.begin(), plans_.end(), [](const Plan& a, const Plan& b) {
      return a.forces.size() * b.planned < b.forces.size() * a.planned;
    });
    if (next == plans_.end() || next->forces.size() >= next->planned) return false;
    addOne(*next);
    --replicates;
  }
  return done() < planned();
}

std::size_t ForceBands::done() const {
  return std::accumulate(plans_.begin(), plans_.end(), std::size_t{0},
                         [](std::size_t sum, const Plan& plan) { return sum + plan.forces.size(); });
}

std::size_t ForceBands::planned() const {
  return std::accumulate(plans_.begin(), plans_.end(), std::size_t{0},
                         [](std::size_t sum, const Plan& plan) { return sum + plan.planned; });
}

const ForceBands::Plan* ForceBands::find(Drawn drawn) const {
  const auto plan = std::find_if(plans_.begin(), plans_.end(), [drawn](const Plan& one) { return one.drawn == drawn; });
  return plan == plans_.end() ? nullptr : &*plan;
}

std::vector<DrawnForce> ForceBands::drawn(Drawn drawn) const {
  const Plan* plan = find(drawn);
  if (plan == nullptr || plan->forces.empty()) return {};
  std::vector<DrawnForce> out(settings_.points.size());
  for (std::size_t p = 0; p < out.size(); ++p) {
    double all = 0;
    double given = 0;
    double sum = 0;
    for (std::size_t i = 0; i < plan->forces.size(); ++i) {
      all += plan->weights[i];
      if (!plan->forces[i][p]) continue;
      given += plan->weights[i];
      sum += plan->weights[i] * *plan->forces[i][p];
    }
    auto& one = out[p];
    one.abstains = all > 0 ? std::max(0.0, 1 - given / all) : 0;
    if (!(given > 0)) continue;
    one.mean_n = sum / given;
    double squares = 0;
    for (std::size_t i = 0; i < plan->forces.size(); ++i) {
      if (!plan->forces[i][p]) continue;
      const double off_n = *plan->forces[i][p] - one.mean_n;
      squares += plan->weights[i] * off_n * off_n;
    }
    one.sd_n = std::sqrt(squares / given);
    one.on_edge = own_[p] && std::abs(one.mean_n - *own_[p]) > kEdge * one.sd_n;
  }
  return out;
}

std::optional<double> ForceBands::drawnQuantile(Drawn drawn, std::size_t point, double share) const {
  const Plan* plan = find(drawn);
  if (plan == nullptr) return std::nullopt;
  std::vector<std::pair<double, double>> forces;
  double all = 0;
  for (std::size_t i = 0; i < plan->forces.size(); ++i) {
    if (!plan->forces[i][point]) continue;
    forces.emplace_back(*plan->forces[i][point], plan->weights[i]);
    all += plan->weights[i];
  }
  std::sort(forces.begin(), forces.end());
  double below = 0;
  for (const auto& [force_n, weight] : forces) {
    below += weight;
    if (below >= share * all) return force_n;
  }
  return std::nullopt;
}

void ForceBands::setHalfWidths(BandKind kind, ForceBand& band) const {
  const auto n = static_cast<double>(study_.people());
  const double share = 0.5 + settings_.coverage / 2;
  if (kind == BandKind::kOthers) {
    const auto people = drawn(Drawn::kPeople);
    const double factor = studentQuantile(share, n - 1) * std::sqrt(n / (n - 1));
    for (std::size_t p = 0; p < people.size(); ++p) {
      band.points[p].half_width_n = factor * people[p].sd_n;
      band.points[p].abstains = people[p].abstains;
      band.points[p].on_edge = people[p].on_edge;
    }
    return;
  }
  if (kind == BandKind::kNext) {
    for (std::size_t p = 0; p < band.points.size(); ++p) {
      std::vector<double> forces;
      for (const auto& force : experts_[p]) {
        if (force) forces.push_back(*force);
      }
      band.points[p].abstains = 1 - static_cast<double>(forces.size()) / static_cast<double>(experts_[p].size());
      if (forces.size() < 2) {
        band.points[p].force_n.reset();
        continue;
      }
      const auto count = static_cast<double>(forces.size());
      band.points[p].half_width_n =
          studentQuantile(share, count - 1) * base::standardDeviation(forces) * std::sqrt(1 + 1 / count);
    }
    return;
  }
  const auto strokes = drawn(Drawn::kOwnStrokes);
  const auto judgements = drawn(Drawn::kOwnJudgements);
  for (std::size_t p = 0; p < band.points.size(); ++p) {
    double variance = 0;
    double degrees = kManyDegrees;
    if (!judgements.empty()) {
      variance += judgements[p].sd_n * judgements[p].sd_n;
      band.points[p].abstains = judgements[p].abstains;
      band.points[p].on_edge = judgements[p].on_edge;
    }
    if (!strokes.empty()) {
      const double widened = stroke_spread_->widening * strokes[p].sd_n * strokes[p].sd_n;
      variance += widened;
      // Welch and Satterthwaite: only the strokes are few.
      if (widened > 0) {
        degrees = std::min(kManyDegrees, stroke_spread_->degrees * variance * variance / (widened * widened));
      }
      band.points[p].abstains = std::max(band.points[p].abstains, strokes[p].abstains);
    }
    band.points[p].half_width_n = studentQuantile(share, degrees) * std::sqrt(variance);
  }
}

ForceBand ForceBands::wordBand() const {
  ForceBand band{BandKind::kWords, {}, {}, missingWordNotes(words_, study_.model().output)};
  if (words_.empty()) return band;
  for (std::size_t p = 0; p < own_.size(); ++p) {
    std::vector<double> forces;
    for (const auto& one : under_words_) {
      if (one[p]) forces.push_back(*one[p]);
    }
    auto& point = band.points.emplace_back(BandPoint{own_[p], 0, 0, 0, 0, false});
    point.abstains = 1 - static_cast<double>(forces.size()) / static_cast<double>(words_.size());
    if (forces.empty()) {
      point.force_n.reset();
      continue;
    }
    const auto [lowest, highest] = std::minmax_element(forces.begin(), forces.end());
    point.low_n = *lowest;
    point.high_n = *highest;
    point.half_width_n = (*highest - *lowest) / 2;
  }
  return band;
}

ForceBand ForceBands::band(BandKind kind) const {
  if (kind == BandKind::kWords) return wordBand();
  ForceBand band{kind, {}, {}, {}};
  const bool again = kind == BandKind::kAgain;
  const bool can = again ? find(Drawn::kOwnStrokes) != nullptr || find(Drawn::kOwnJudgements) != nullptr
                         : study_.people() > 1 && (kind == BandKind::kNext ? study_.model().experts.size() > 1
                                                                           : find(Drawn::kPeople) != nullptr);
  if (again) {
    if (find(Drawn::kOwnJudgements) != nullptr) {
      band.assumed.push_back(
          "Judgements: each force is felt with the noise of one just-noticeable difference and judged by the "
          "participant’s own thresholds; the study holds no repeated judgements to measure it.");
    } else {
      band.not_included.push_back("Judgements: there are none to repeat.");
    }
    if (find(Drawn::kOwnStrokes) == nullptr) {
      band.not_included.push_back("Strokes: " +
                                  (no_strokes_.empty() ? "there are none to draw from." : no_strokes_ + "."));
    }
    band.not_included.push_back("Answers: how often a participant would answer otherwise was not measured.");
  }
  if (kind == BandKind::kNext) {
    band.not_included.push_back("The experts share words and terms, so this band is too narrow.");
  }
  if (!can) return band;
  for (const auto& force : own_) band.points.push_back({force, 0, 0, 0, 0, false});
  setHalfWidths(kind, band);
  for (auto& point : band.points) {
    if (!point.force_n) continue;
    point.low_n = std::max(*point.force_n - point.half_width_n, std::min(lowest_n_, *point.force_n));
    point.high_n = std::min(*point.force_n + point.half_width_n, std::max(highest_n_, *point.force_n));
  }
  return band;
}

}  // namespace tactus::elicitation
