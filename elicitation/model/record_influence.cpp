#include "elicitation/model/record_influence.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/analysis/force_probe.h"
#include "core/base/error.h"
#include "core/fuzzy/compiled_model.h"
#include "core/procedure/procedure.h"
#include "elicitation/force/force_terms_from.h"
#include "elicitation/force/noticeable_force.h"

namespace tactus::elicitation {
namespace {

using fuzzy::Evaluation;

/// A point with the averaged force of all experts and the weight of those who fire there.
struct SharedPoint {
  std::vector<double> at;
  Evaluation mean;
  double weight = 0;
  bool even = false;  ///< counts for the root mean square
};

/// The points of analysis::forceDifference for two models like `model`.
std::vector<SharedPoint> sharedPoints(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                                      const std::stop_token& stop) {
  std::size_t cost = 0;
  {
    const analysis::ForceProbe probe(model, compiled, 0);
    cost = probe.costOfMean();
  }
  const std::size_t most = analysis::affordablePoints(1 + 2 * cost);
  std::vector<SharedPoint> out;
  std::vector<Evaluation> experts(compiled.expertCount());
  const auto add = [&](std::vector<double> at, bool even) {
    SharedPoint& point = out.emplace_back();
    point.mean = compiled.evaluate(at);
    fuzzy::evaluateEveryExpert(compiled, at, experts);
    for (std::size_t e = 0; e < experts.size(); ++e) point.weight += experts[e].fired ? compiled.weight(e) : 0;
    point.at = std::move(at);
    point.even = even;
  };
  const auto kinks = analysis::kinkPoints(model, most);
  const auto spread = analysis::evenPoints(model, most);
  for (std::size_t p = 0; p < kinks.size() && !stop.stop_requested(); ++p) add(kinks[p], false);
  for (std::size_t p = 0; p < spread.size() && !stop.stop_requested(); ++p) add(spread[p], true);
  return out;
}

/// `model` with one expert alone.
fuzzy::ForceModel alone(const fuzzy::ForceModel& model, std::size_t expert) {
  fuzzy::ForceModel out;
  out.inputs = model.inputs;
  out.output = model.output;
  out.implication = model.implication;
  out.experts = {model.experts[expert]};
  out.experts.front().weight = 1;
  return out;
}

// Two plans of the same rules may differ by rounding; docs/semantics.md: 1e-12 of the output's range.
constexpr double kSameShare = 1e-12;

/// The averaged force where `expert` with `weight` gives `after` in the place of `before`.
Evaluation meanWith(const SharedPoint& point, double weight, double same_n, const Evaluation& before,
                    const Evaluation& after) {
  if (before.fired == after.fired && (!before.fired || std::abs(before.force_n - after.force_n) <= same_n)) {
    return point.mean;
  }
  const double rest = point.weight - (before.fired ? weight : 0);
  const double sum = (point.weight > 0 ? point.weight * point.mean.force_n : 0) -
                     (before.fired ? weight * before.force_n : 0) + (after.fired ? weight * after.force_n : 0);
  const double all = rest + (after.fired ? weight : 0);
  return all > 0 ? Evaluation{sum / all, true} : Evaluation{};
}

std::optional<RecordInfluence> withoutOne(const fuzzy::ForceModel& model, std::span<const SharedPoint> points,
                                          std::size_t expert, std::size_t rule) {
  fuzzy::ForceModel one = alone(model, expert);
  const auto before = fuzzy::compile(one);
  auto& rules = one.experts.front().rules;
  rules.erase(rules.begin() + static_cast<std::ptrdiff_t>(rule));
  const auto after = fuzzy::compile(one);
  if (!before || !after) return std::nullopt;
  const double same_n = kSameShare * (model.output.max - model.output.min);
  const double weight = model.experts[expert].weight;
  RecordInfluence out;
  analysis::ForceDifference& found = out.difference;
  double squares = 0;
  std::size_t even_points = 0;
  for (const SharedPoint& point : points) {
    const Evaluation without = meanWith(point, weight, same_n, before->evaluate(point.at), after->evaluate(point.at));
    if (point.mean.fired != without.fired) ++found.only_one_fires;
    if (!point.mean.fired || !without.fired) continue;
    ++found.points;
    const double newtons = std::abs(point.mean.force_n - without.force_n);
    if (point.even) {
      squares += newtons * newtons;
      ++even_points;
    }
    if (newtons <= found.largest_n) continue;
    found.largest_n = newtons;
    found.at = point.at;
    found.first_n = point.mean.force_n;
    found.second_n = without.force_n;
  }
  if (even_points > 0) found.rms_n = std::sqrt(squares / static_cast<double>(even_points));
  if (found.largest_n > 0) out.noticeable = found.largest_n / justNoticeableDifference(found.first_n);
  return out;
}

}  // namespace

std::vector<std::optional<RecordInfluence>> withoutRules(const BuiltModel& built,
                                                         std::span<const std::optional<std::size_t>> rules,
                                                         const std::stop_token& stop) {
  std::vector<std::optional<RecordInfluence>> out(rules.size());
  const auto compiled = fuzzy::compile(built.model);
  if (!compiled) return out;
  const auto points = sharedPoints(built.model, *compiled, stop);
  for (std::size_t e = 0; e < rules.size() && !stop.stop_requested(); ++e) {
    if (rules[e]) out[e] = withoutOne(built.model, points, e, *rules[e]);
  }
  return out;
}

namespace {

using base::Result;

Result<RecordInfluence> compared(const fuzzy::ForceModel& with, const fuzzy::ForceModel& without) {
  TACTUS_TRY(const auto first, fuzzy::compile(with));
  TACTUS_TRY(const auto second, fuzzy::compile(without));
  RecordInfluence out;
  out.difference = analysis::forceDifference(with, first, without, second);
  if (out.difference.largest_n > 0) {
    out.noticeable = out.difference.largest_n / justNoticeableDifference(out.difference.first_n);
  }
  return out;
}

}  // namespace

Result<RecordInfluence> withoutJudgement(const BuiltModel& built, const study::Study& study,
                                         const BuildSettings& settings, std::size_t index) {
  if (study.judgements[index].series != settings.series) return RecordInfluence();
  std::vector<study::ForceJudgement> rest = study.judgements;
  rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(index));
  const fuzzy::Variable& words = procedure::of(study).output;
  std::vector<std::string> ids;
  for (const fuzzy::Term& term : words.terms) ids.push_back(term.id);
  TACTUS_TRY(const auto counts, countVotes(rest, settings.series, ids));
  const auto votes = vote(counts, static_cast<int>(study.participants.size()));
  TACTUS_TRY(const auto terms,
             forceTermsFrom(settings.force_terms, words, rest, settings.series, votes, settings.force_end_n));
  fuzzy::ForceModel without = built.model;
  without.output = terms.output;
  return compared(built.model, without);
}

Result<RecordInfluence> withoutRule(const BuiltModel& built, std::size_t expert, std::size_t rule) {
  fuzzy::ForceModel without = built.model;
  auto& rules = without.experts[expert].rules;
  rules.erase(rules.begin() + static_cast<std::ptrdiff_t>(rule));
  return compared(built.model, without);
}

Result<RecordInfluence> withoutStroke(const BuiltModel& built, const study::Study& study, const BuildSettings& settings,
                                      std::string_view participant, std::string_view level, int stroke) {
  study::Study own;
  for (const auto& one : study.participants) {
    if (one.code == participant) own.participants.push_back(one);
  }
  bool found = false;
  for (const auto& sample : study.speeds) {
    if (sample.participant != participant) continue;
    const bool left_out = sample.level == level && sample.stroke == stroke;
    found = found || left_out;
    if (!left_out) own.speeds.push_back(sample);
  }
  const auto who = std::find_if(built.speeds.begin(), built.speeds.end(),
                                [&](const auto& one) { return one.participant == participant; });
  if (!found || who == built.speeds.end()) {
    return base::fail(base::ErrorCode::kReference, "stroke",
                      std::string(participant) + ", " + std::string(level) + " " + std::to_string(stroke),
                      "a stroke of the study");
  }
  const fuzzy::Variable* const speed = procedure::of(study).rateInput();
  TACTUS_TRY(auto again, clusterSpeeds(own, *speed, settings.speed));
  auto speeds = built.speeds;
  auto weights = built.speed_weights;
  const auto index = who - built.speeds.begin();
  if (again.empty()) {
    speeds.erase(speeds.begin() + index);
    if (!weights.empty()) weights.erase(weights.begin() + index);
  } else {
    speeds[static_cast<std::size_t>(index)] = again.front();
  }
  if (speeds.empty()) {
    return base::fail(base::ErrorCode::kData, "strokes", "none without this one",
                      "a stroke of at least one participant");
  }
  std::vector<std::vector<Ramp>> ramps;
  for (const auto& one : speeds) ramps.push_back(one.ramps);
  fuzzy::ForceModel without = built.model;
  auto& changed = without.inputs[fuzzy::rateOf(without.inputs).value()];
  changed = averagedSpeed(*speed, speeds, averageRamps(ramps, weights, settings.averaging));
  for (auto& expert : without.experts) {
    if (expert.id != participant) continue;
    std::erase_if(expert.overrides, [&](const auto& list) { return again.empty() && list.variable == changed.id; });
    for (auto& list : expert.overrides) {
      if (list.variable == changed.id) list.terms = speedTerms(changed, again.front().ramps);
    }
  }
  return compared(built.model, without);
}

}  // namespace tactus::elicitation
