// The general path: every model, every number.
#include <algorithm>

#include "core/analysis/gradient/gradient_centroid.h"
#include "core/analysis/gradient/gradient_paths.h"

namespace tactus::analysis {
namespace {

using fuzzy::kMostTerms;

constexpr double kSmallest = std::numeric_limits<double>::denorm_min();
// Memberships and strengths are kept times this power of two, so that small ones keep their digits.
constexpr double kStrengthScale = 0x1p512;

/// For each output term of one expert the strength times kStrengthScale, and the first rule that gives it.
struct Winners {
  std::array<double, kMostTerms> strength;
  std::array<std::uint32_t, kMostTerms> rule;
};

std::span<const GradientCondition> conditionsOf(const GradientExpert& expert, const GradientRule& rule) noexcept {
  return std::span(expert.conditions).subspan(rule.first_condition, rule.condition_count);
}

void fuzzify(const GradientTables& tables, const GradientExpert& expert, std::span<const double> clamped,
             GeneralPoint& point) noexcept {
  for (std::size_t i = 0; i < clamped.size(); ++i) {
    if (point.bank[i] == expert.bank[i]) continue;
    point.bank[i] = expert.bank[i];
    const auto& functions = tables.banks[expert.bank[i]].functions;
    for (std::size_t t = 0; t < functions.size(); ++t)
      point.membership[i][t] = functions[t].scaled(clamped[i], kStrengthScale);
  }
}

bool fire(const GradientExpert& expert, const GeneralPoint& point, std::size_t terms, Winners& winners) noexcept {
  std::fill_n(winners.strength.begin(), terms, 0.0);
  bool fired = false;
  for (std::size_t r = 0; r < expert.rules.size(); ++r) {
    const GradientRule& rule = expert.rules[r];
    double membership = kStrengthScale;
    for (const auto& condition : conditionsOf(expert, rule))
      membership = std::min(membership, point.membership[condition.input][condition.term]);
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

/// Adds to the input and the points of a term what `log_derivative`, that of the force with respect to the logarithm of
/// the membership, makes of them: no small membership is ever divided by.
void addCondition(const GradientTables& tables, const GradientBank& bank, const GradientCondition& condition, double x,
                  double log_derivative, GradientSink& sink) noexcept {
  const auto& f = bank.functions[condition.term];
  const TermSlots& slots = bank.slots[condition.term];
  sink.touch(bank.first_slot[condition.term]);
  if (f.gaussian) {
    const double u = (x - f.mean) / f.sigma;
    const double steepness = log_derivative * u / f.sigma;
    sink.addInput(condition.input, -steepness);
    sink.add(slots[0], steepness);
    sink.add(slots[1], steepness * u);
    return;
  }
  // On a ramp the membership is (x - foot) / (shoulder - foot), whether it rises or falls.
  const auto add_ramp = [&](double foot, double shoulder, std::uint32_t foot_slot, std::uint32_t shoulder_slot) {
    const double steepness = log_derivative / (x - foot);
    sink.addInput(condition.input, steepness);
    sink.add(foot_slot, -steepness * ((shoulder - x) / (shoulder - foot)));
    sink.add(shoulder_slot, -log_derivative / (shoulder - foot));
  };
  const bool upper_end = x == tables.input_max[condition.input];
  if (x < f.b || (upper_end && x == f.b && f.a < f.b)) {
    add_ramp(f.a, f.b, slots[0], slots[1]);
  } else if (x > f.c || (!upper_end && x == f.c && f.c < f.d)) {
    add_ramp(f.d, f.c, slots[3], slots[2]);
  }
}

}  // namespace

Firing addGenerally(const GradientTables& tables, const GradientExpert& expert, std::span<const double> clamped,
                    GeneralPoint& point, GradientSink& sink, double& offset) noexcept {
  const GradientBank& bank = tables.banks[expert.bank.back()];
  const std::size_t count = bank.functions.size();
  fuzzify(tables, expert, clamped, point);
  Winners winners;
  if (!fire(expert, point, count, winners)) return Firing::kAbstains;

  const double largest = *std::max_element(winners.strength.data(), winners.strength.data() + count);
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
  offset =
      centroidGradient({firing.data(), firing_count}, tables.implication, tables.output_min, tables.output_max, sets);
  for (std::size_t i = 0; i < firing_count; ++i) {
    const std::uint32_t t = index[i];
    const std::size_t points = bank.functions[t].gaussian ? 2 : 4;
    sink.touch(bank.first_slot[t]);
    for (std::size_t p = 0; p < points; ++p) sink.add(bank.slots[t][p], expert.weight * sets[i].points[p]);

    const double log_derivative = expert.weight * sets[i].log_strength;
    const GradientRule& rule = expert.rules[winners.rule[t]];
    sink.touch(rule.slot);
    sink.add(rule.slot, log_derivative / rule.weight);
    const auto conditions = conditionsOf(expert, rule);
    const auto smallest = std::min_element(conditions.begin(), conditions.end(), [&](const auto& one, const auto& two) {
      return point.membership[one.input][one.term] < point.membership[two.input][two.term];
    });
    addCondition(tables, tables.banks[expert.bank[smallest->input]], *smallest, clamped[smallest->input],
                 log_derivative, sink);
  }
  return Firing::kFires;
}

}  // namespace tactus::analysis
