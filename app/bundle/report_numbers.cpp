#include <algorithm>
#include <charconv>
#include <cmath>

#include "app/bundle/report_parts.h"
#include "core/analysis/force_steps.h"
#include "core/analysis/sample_points.h"
#include "core/base/text.h"
#include "core/fuzzy/membership.h"
#include "elicitation/force/noticeable_force.h"

namespace tactus::bundle {
namespace {

constexpr std::size_t kMostPoints = 20'000;

std::size_t rulesOf(const fuzzy::ForceModel& model) {
  std::size_t rules = 0;
  for (const fuzzy::Expert& expert : model.experts) rules += expert.rules.size();
  return std::max<std::size_t>(rules, 1);
}

/// The values of each input to try; of `input` those in `range`.
std::vector<std::vector<double>> valuesOf(const fuzzy::ForceModel& model, std::size_t input, double from, double to) {
  const auto vertices = analysis::sortedVertices(model);
  std::vector<std::vector<double>> out;
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    const fuzzy::Variable& one = model.inputs[i];
    out.push_back(analysis::valuesWorthALook(vertices[i], i == input ? from : one.min, i == input ? to : one.max));
  }
  return out;
}

}  // namespace

const std::string& labelOf(const fuzzy::Variable& variable) {
  return variable.label.empty() ? variable.id : variable.label;
}

const std::string& labelOf(const fuzzy::Term& term) { return term.label.empty() ? term.id : term.label; }

std::string shortly(double value) {
  if (std::abs(value) >= 10) return std::abs(value) < 1e6 ? base::formatFixed(value, 0) : base::formatNumber(value);
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, 2);
  return {text, end.ptr};
}

double coreMiddle(const fuzzy::Variable& variable, const fuzzy::Term& term) {
  const auto within = [&](double x) { return std::clamp(x, variable.min, variable.max); };
  switch (term.shape) {
    case fuzzy::Shape::kTrapezoid: return (within(term.points[1]) + within(term.points[2])) / 2;
    case fuzzy::Shape::kTriangle: return within(term.points[1]);
    case fuzzy::Shape::kGaussian: return within(term.points[0]);
  }
  return variable.min;
}

std::vector<double> middleWords(const fuzzy::ForceModel& model) {
  std::vector<double> out;
  for (const fuzzy::Variable& input : model.inputs)
    out.push_back(coreMiddle(input, input.terms[input.terms.size() / 2]));
  return out;
}

std::vector<RegionNumbers> regionNumbers(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled) {
  constexpr int kPositions = 6000;
  const auto input = fuzzy::wayOf(model.inputs);
  if (!input) return {};
  const fuzzy::Variable& depth = model.inputs[*input];
  std::vector<fuzzy::MembershipFunction> words;
  for (const fuzzy::Term& term : depth.terms) words.push_back(fuzzy::MembershipFunction::of(term));
  std::vector<RegionNumbers> out;
  const fuzzy::Term* before = nullptr;
  for (int i = 0; i <= kPositions; ++i) {
    const double x = depth.min + (depth.max - depth.min) * i / kPositions;
    const fuzzy::Term* truest = nullptr;
    double most = 0;
    for (std::size_t t = 0; t < words.size(); ++t) {
      if (words[t](x) <= most) continue;
      most = words[t](x);
      truest = &depth.terms[t];
    }
    if (truest != nullptr && truest != before) out.push_back({labelOf(*truest), x, x, {}, {}, 0});
    if (truest != nullptr) out.back().to_mm = x;
    before = truest;
  }
  const std::size_t most = std::max<std::size_t>(analysis::affordablePoints(rulesOf(model)) / (out.size() + 1), 50);
  std::vector<double> own(model.experts.size());
  for (RegionNumbers& region : out) {
    const analysis::SamplePoints points(valuesOf(model, *input, region.from_mm, region.to_mm), most);
    for (std::size_t p = 0; p < points.size(); ++p) {
      const std::vector<double> point = points[p];
      const auto mean = compiled.evaluate(point);
      if (!mean.fired) continue;
      region.lowest_n = std::min(region.lowest_n.value_or(mean.force_n), mean.force_n);
      region.highest_n = std::max(region.highest_n.value_or(mean.force_n), mean.force_n);
      double low = mean.force_n;
      double high = mean.force_n;
      for (std::size_t e = 0; e < model.experts.size(); ++e) {
        const auto force = compiled.evaluateExpert(e, point);
        if (!force.fired || model.experts[e].weight <= 0) continue;
        low = std::min(low, force.force_n);
        high = std::max(high, force.force_n);
      }
      region.apart_n = std::max(region.apart_n, high - low);
    }
  }
  return out;
}

std::optional<Slope> largestSlope(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                                  std::size_t input) {
  constexpr std::size_t kMostSteps = 1000;
  const fuzzy::Variable& x = model.inputs[input];
  const double width = analysis::stepWidth(x);
  const auto steps =
      static_cast<std::size_t>(std::clamp((x.max - x.min) / width, 1.0, static_cast<double>(kMostSteps)));
  auto values = valuesOf(model, input, x.min, x.max);
  values[input] = {x.min};
  const std::size_t most = 4 * analysis::affordablePoints(rulesOf(model)) / steps;
  const analysis::SamplePoints settings(values, std::clamp<std::size_t>(most, 1, kMostPoints));
  std::optional<Slope> out;
  for (std::size_t s = 0; s < settings.size(); ++s) {
    std::vector<double> point = settings[s];
    std::optional<double> before;
    for (std::size_t k = 0; k <= steps; ++k) {
      const double at = x.min + (x.max - x.min) * static_cast<double>(k) / static_cast<double>(steps);
      const std::vector<double> from = point;
      point[input] = at;
      const auto force = compiled.evaluate(point);
      if (force.fired && before) {
        const double slope = std::abs(force.force_n - *before) / (at - from[input]);
        if (!out || slope > out->slope) out = Slope{slope, from};
      }
      before = force.fired ? std::optional(force.force_n) : std::nullopt;
    }
  }
  return out;
}

std::optional<Agreement> agreementOf(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                                     std::size_t expert) {
  const auto points =
      analysis::evenPoints(model, std::max<std::size_t>(analysis::affordablePoints(rulesOf(model)), 100));
  Agreement out;
  std::size_t count = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const std::vector<double> point = points[p];
    const auto own = compiled.evaluateExpert(expert, point);
    const auto mean = compiled.evaluate(point);
    if (!own.fired || !mean.fired) continue;
    ++count;
    const double distance_n = std::abs(own.force_n - mean.force_n);
    out.mean_n += distance_n;
    if (distance_n <= elicitation::justNoticeableDifference(std::abs(mean.force_n))) out.within_jnd += 1;
  }
  if (count == 0) return std::nullopt;
  out.mean_n /= static_cast<double>(count);
  out.within_jnd /= static_cast<double>(count);
  return out;
}

}  // namespace tactus::bundle
