#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/base/check.h"
#include "core/base/error.h"
#include "core/fuzzy/compiled_model.h"
#include "core/procedure/procedure.h"
#include "elicitation/force/force_terms_from.h"
#include "elicitation/uncertainty/force_bands.h"

namespace tactus::elicitation {
namespace {

double factorial(std::size_t n) { return n < 2 ? 1 : static_cast<double>(n) * factorial(n - 1); }

void fill(std::size_t place, std::size_t left, WeightedResample& one, std::vector<WeightedResample>& out) {
  if (place + 1 == one.counts.size()) {
    one.counts[place] = left;
    const auto n = one.counts.size();
    one.weight = factorial(n) / std::pow(static_cast<double>(n), static_cast<double>(n));
    for (const std::size_t times : one.counts) one.weight /= factorial(times);
    out.push_back(one);
    return;
  }
  for (std::size_t times = left + 1; times-- > 0;) {
    one.counts[place] = times;
    fill(place + 1, left - times, one, out);
  }
}

}  // namespace

ResampleCounts everyPerson(std::size_t people) { return ResampleCounts(people, 1); }

ResampleCounts drawResample(std::size_t people, base::Random& random) {
  ResampleCounts counts(people, 0);
  for (std::size_t i = 0; i < people; ++i) ++counts[static_cast<std::size_t>(random.below(static_cast<int>(people)))];
  return counts;
}

std::vector<WeightedResample> everyResample(std::size_t people) {
  TACTUS_CHECK(people >= 1 && people <= kMostEnumerated);
  std::vector<WeightedResample> out;
  WeightedResample one{ResampleCounts(people, 0), 1};
  fill(0, people, one, out);
  return out;
}

namespace {

using base::ErrorCode;
using base::fail;
using base::Result;

template <class List, class Code>
std::size_t indexOf(const List& list, const std::string& code, Code codeOf) {
  return static_cast<std::size_t>(
      std::find_if(list.begin(), list.end(), [&](const auto& one) { return codeOf(one) == code; }) - list.begin());
}

}  // namespace

ResampledStudy::ResampledStudy(const study::Study& study, const BuiltModel& built, const BuildSettings& settings)
    : settings_(settings),
      built_(built.model),
      default_output_(procedure::of(study).output),
      has_speeds_(!built.averaged_ramps.empty()),
      has_judgements_(built.force_terms.has_value()) {
  built_.checks.clear();
  built_.accepted_holes.clear();
  for (const auto& one : study.participants) {
    codes_.push_back(one.code);
    const auto speeds = indexOf(built.speeds, one.code, [](const auto& each) { return each.participant; });
    ramps_.push_back(speeds < built.speeds.size() ? built.speeds[speeds].ramps : std::vector<Ramp>{});
    speed_weights_.push_back(speeds < built.speed_weights.size() ? built.speed_weights[speeds] : 1);
    expert_of_.push_back(indexOf(built_.experts, one.code, [](const auto& each) { return each.id; }));
    auto& judged = judged_.emplace_back();
    for (const auto& judgement : study.judgements) {
      if (judgement.participant == one.code && judgement.series == settings.series) judged.push_back(judgement);
    }
  }
}

Result<fuzzy::Variable> ResampledStudy::outputOf(const Resample& resample) const {
  const auto& judged = resample.judged.empty() ? judged_ : resample.judged;
  std::vector<study::ForceJudgement> all;
  for (std::size_t who = 0; who < people(); ++who) {
    for (std::size_t time = 0; time < resample.judgements[who]; ++time) {
      for (const auto& judgement : judged[who]) {
        all.push_back(judgement);
        if (time > 0) all.back().participant += '\n' + std::to_string(time);  // another person, who says the same
      }
    }
  }
  std::vector<std::string> ids;
  for (const auto& term : default_output_.terms) ids.push_back(term.id);
  TACTUS_TRY(const auto counts, countVotes(all, settings_.series, ids));
  const auto enrolled = std::accumulate(resample.judgements.begin(), resample.judgements.end(), std::size_t{0});
  const auto votes = vote(counts, static_cast<int>(enrolled));
  TACTUS_TRY(auto terms, forceTermsFrom(settings_.force_terms, default_output_, all, settings_.series, votes,
                                        settings_.force_end_n));
  return std::move(terms.output);
}

Result<fuzzy::ForceModel> ResampledStudy::model(const Resample& resample) const {
  fuzzy::ForceModel out = built_;
  out.experts.clear();
  const auto& ramps = resample.ramps.empty() ? ramps_ : resample.ramps;
  if (has_speeds_) {
    std::vector<std::vector<Ramp>> drawn;
    std::vector<double> weights;
    for (std::size_t who = 0; who < people(); ++who) {
      for (std::size_t time = 0; time < resample.speeds[who] && !ramps[who].empty(); ++time) {
        drawn.push_back(ramps[who]);
        weights.push_back(speed_weights_[who]);
      }
    }
    if (drawn.empty() || std::all_of(weights.begin(), weights.end(), [](double one) { return !(one > 0); })) {
      return fail(ErrorCode::kData, "speeds", "none in this counts", "speeds of at least one participant");
    }
    fuzzy::Variable& speed = out.inputs[fuzzy::rateOf(out.inputs).value()];
    speed.terms = speedTerms(speed, averageRamps(drawn, weights, settings_.averaging));
  }
  if (has_judgements_) {
    TACTUS_TRY(auto output, outputOf(resample));
    out.output = std::move(output);
  }
  for (std::size_t who = 0; who < people(); ++who) {
    if (resample.rules[who] == 0 || expert_of_[who] == built_.experts.size()) continue;
    auto& expert = out.experts.emplace_back(built_.experts[expert_of_[who]]);
    expert.weight *= static_cast<double>(resample.rules[who]);
    if (resample.ramps.empty() || ramps[who].empty()) continue;
    const fuzzy::Variable& speed = out.inputs[fuzzy::rateOf(out.inputs).value()];
    for (auto& own : expert.overrides) {
      if (own.variable == speed.id) own.terms = speedTerms(speed, ramps[who]);
    }
  }
  if (out.experts.empty())
    return fail(ErrorCode::kData, "rules", "none in this counts", "rules of at least one participant");
  return out;
}

std::vector<std::optional<double>> ResampledStudy::forces(const Resample& resample,
                                                          std::span<const std::vector<double>> points) const {
  std::vector<std::optional<double>> out(points.size());
  const auto changed = model(resample);
  if (!changed) return out;
  const auto compiled = fuzzy::compile(*changed);
  if (!compiled) return out;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const auto force = compiled->evaluate(points[p]);
    if (force.fired) out[p] = force.force_n;
  }
  return out;
}

}  // namespace tactus::elicitation
