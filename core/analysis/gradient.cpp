// The reverse pass: from the centroid of each expert back to vertices, weights and inputs.
#include "core/analysis/gradient.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/analysis/gradient_centroid.h"
#include "core/base/check.h"

namespace tactus::analysis {
namespace {

using fuzzy::kMostInputs;
using fuzzy::kMostTerms;

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
constexpr double kSmallest = std::numeric_limits<double>::denorm_min();
// Memberships and strengths are kept times this power of two, so that small ones keep their digits.
constexpr double kStrengthScale = 0x1p512;

}  // namespace

/// Memberships of the current point times kStrengthScale, kept while consecutive experts share their terms.
struct GradientModel::Fuzzified {
  std::array<std::array<double, kMostTerms>, kMostInputs> membership;
  std::array<std::uint32_t, kMostInputs> bank;

  Fuzzified() noexcept { bank.fill(kNone); }
};

/// For each output term of one expert the strength times kStrengthScale, and the rule that gives it.
struct GradientModel::Winners {
  std::array<double, kMostTerms> strength;
  std::array<std::uint32_t, kMostTerms> rule;
};

bool GradientModel::fire(const Expert& expert, std::span<const double> clamped, Fuzzified& fuzzified,
                         Winners& winners) const noexcept {
  for (std::size_t i = 0; i < clamped.size(); ++i) {
    if (fuzzified.bank[i] == expert.bank[i]) continue;
    const auto& functions = banks_[expert.bank[i]].functions;
    for (std::size_t t = 0; t < functions.size(); ++t)
      fuzzified.membership[i][t] = functions[t].scaled(clamped[i], kStrengthScale);
    fuzzified.bank[i] = expert.bank[i];
  }

  std::fill_n(winners.strength.begin(), banks_[expert.bank.back()].functions.size(), 0.0);
  bool fired = false;
  for (std::size_t r = 0; r < expert.rules.size(); ++r) {
    const Rule& rule = expert.rules[r];
    double membership = kStrengthScale;
    for (std::uint32_t c = rule.first_condition; c < rule.first_condition + rule.condition_count; ++c) {
      const auto& condition = expert.conditions[c];
      membership = std::min(membership, fuzzified.membership[condition.input][condition.term]);
    }
    // The product may underflow, the rule fires all the same.
    double& strongest = winners.strength[rule.then];
    const double strength = rule.weight * membership;
    if (strength <= strongest && (strongest > 0 || membership == 0)) continue;
    strongest = std::max(strength, kSmallest);
    winners.rule[rule.then] = static_cast<std::uint32_t>(r);
    fired = true;
  }
  return fired;
}

const GradientModel::Condition& GradientModel::smallestOf(const Rule& rule, const Expert& expert,
                                                          const Fuzzified& fuzzified) noexcept {
  const auto first = expert.conditions.begin() + rule.first_condition;
  return *std::min_element(first, first + rule.condition_count, [&](const Condition& a, const Condition& b) {
    return fuzzified.membership[a.input][a.term] < fuzzified.membership[b.input][b.term];
  });
}

void GradientModel::addCondition(const Expert& expert, const Condition& condition, std::span<const double> clamped,
                                 double log_derivative, std::span<double> values) const noexcept {
  const Bank& bank = banks_[expert.bank[condition.input]];
  const auto& f = bank.functions[condition.term];
  const auto& slots = bank.slots[condition.term];
  const double x = clamped[condition.input];
  double& input = values[condition.input];
  // Derivatives of the logarithm of the membership times that of the force: no small membership is ever divided by.
  if (f.gaussian) {
    const double u = (x - f.mean) / f.sigma;
    const double steepness = log_derivative * u / f.sigma;
    input -= steepness;
    values[slots[0]] += steepness;
    values[slots[1]] += steepness * u;
    return;
  }
  const bool upper_end = x == input_max_[condition.input];
  if (x < f.b || (upper_end && x == f.b && f.a < f.b)) {
    const double steepness = log_derivative / (x - f.a);
    input += steepness;
    if (x < f.b) values[slots[0]] -= steepness * ((f.b - x) / (f.b - f.a));
    values[slots[1]] -= log_derivative / (f.b - f.a);
  } else if (x > f.c || (!upper_end && x == f.c && f.c < f.d)) {
    const double steepness = log_derivative / (f.d - x);
    input -= steepness;
    values[slots[2]] += log_derivative / (f.d - f.c);
    if (x > f.c) values[slots[3]] += steepness * ((x - f.c) / (f.d - f.c));
  }
}

double GradientModel::addExpert(const Expert& expert, std::span<const double> clamped, const Fuzzified& fuzzified,
                                const Winners& winners, std::span<double> values) const noexcept {
  const Bank& bank = banks_[expert.bank.back()];
  const std::size_t count = bank.functions.size();
  const double largest =
      *std::max_element(winners.strength.begin(), winners.strength.begin() + static_cast<std::ptrdiff_t>(count));
  std::array<fuzzy::ActiveTerm, kMostTerms> firing;
  std::array<std::uint32_t, kMostTerms> index;
  std::size_t firing_count = 0;
  for (std::size_t t = 0; t < count; ++t) {
    const double strength = winners.strength[t];
    if (strength == 0) continue;
    index[firing_count] = static_cast<std::uint32_t>(t);
    firing[firing_count++] = {&bank.functions[t], std::max(strength / kStrengthScale, kSmallest),
                              std::max(strength / largest, kSmallest)};
  }

  std::array<SetGradient, kMostTerms> sets;
  const double offset = centroidGradient({firing.data(), firing_count}, implication_, output_min_, output_max_, sets);
  for (std::size_t i = 0; i < firing_count; ++i) {
    const std::uint32_t t = index[i];
    const std::size_t points = bank.functions[t].gaussian ? 2 : 4;
    for (std::size_t p = 0; p < points; ++p) values[bank.slots[t][p]] += expert.weight * sets[i].points[p];

    const double log_derivative = expert.weight * sets[i].log_strength;
    const Rule& rule = expert.rules[winners.rule[t]];
    values[rule.slot] += log_derivative / rule.weight;
    addCondition(expert, smallestOf(rule, expert, fuzzified), clamped, log_derivative, values);
  }
  return offset;
}

void GradientModel::evaluate(std::span<const double> inputs, Gradient& out) const noexcept {
  TACTUS_CHECK(inputs.size() == inputCount() && out.values.size() == slot_count_);
  out.fired = false;
  std::array<double, kMostInputs> clamped;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (!std::isfinite(inputs[i])) {
      out.force_n = std::numeric_limits<double>::quiet_NaN();
      std::fill(out.values.begin(), out.values.end(), out.force_n);
      return;
    }
    clamped[i] = std::clamp(inputs[i], input_min_[i], input_max_[i]);
  }

  std::fill(out.values.begin(), out.values.end(), 0.0);
  const std::span<const double> point(clamped.data(), inputs.size());
  Fuzzified fuzzified;
  Winners winners;
  double weights = 0;
  double mean_offset = 0;
  for (const auto& expert : experts_) {
    if (expert.weight == 0 || !fire(expert, point, fuzzified, winners)) continue;
    const double offset = addExpert(expert, point, fuzzified, winners, out.values);
    weights += expert.weight;
    mean_offset += (offset - mean_offset) * (expert.weight / weights);
  }
  out.fired = weights > 0;
  out.force_n = out.fired ? output_min_ + mean_offset : default_force_n_;
  if (!out.fired) return;
  if (weights != 1) {
    for (double& value : out.values) value /= weights;
  }
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (inputs[i] != clamped[i]) out.values[i] = 0;
  }
}

}  // namespace tactus::analysis
