// Evaluation of a compiled model at one point.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/check.h"
#include "core/fuzzy/centroid.h"
#include "core/fuzzy/compiled_model.h"

namespace tactus::fuzzy {
namespace {

constexpr std::uint32_t kNoBank = std::numeric_limits<std::uint32_t>::max();
constexpr double kSmallest = std::numeric_limits<double>::denorm_min();

}  // namespace

/// Memberships of the current point times kStrengthScale, kept while consecutive experts share their terms.
struct CompiledModel::Fuzzified {
  std::array<std::array<double, kMostTerms>, kMostInputs> membership;
  std::array<std::uint32_t, kMostInputs> bank;

  Fuzzified() noexcept { bank.fill(kNoBank); }
};

double CompiledModel::clampInput(std::size_t input, double value) const noexcept {
  return std::clamp(value, input_min_[input], input_max_[input]);
}

bool CompiledModel::clampInputs(std::span<const double> inputs, std::span<double> clamped) const noexcept {
  TACTUS_CHECK(inputs.size() == inputCount());
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (!std::isfinite(inputs[i])) return false;
    clamped[i] = clampInput(i, inputs[i]);
  }
  return true;
}

bool CompiledModel::expertStrengths(const CompiledExpert& expert, std::span<const double> clamped, Fuzzified& fuzzified,
                                    std::span<double> strengths) const noexcept {
  for (std::size_t i = 0; i < clamped.size(); ++i) {
    if (fuzzified.bank[i] == expert.input_bank[i]) continue;
    const Bank& bank = banks_[expert.input_bank[i]];
    for (std::size_t t = 0; t < bank.size(); ++t)
      fuzzified.membership[i][t] = bank[t].scaled(clamped[i], kStrengthScale);
    fuzzified.bank[i] = expert.input_bank[i];
  }

  std::fill(strengths.begin(), strengths.end(), 0.0);
  bool fired = false;
  for (const auto& rule : expert.rules) {
    double membership = kStrengthScale;
    for (std::uint32_t c = rule.first_condition; c < rule.first_condition + rule.condition_count; ++c) {
      const auto& condition = expert.conditions[c];
      membership = std::min(membership, fuzzified.membership[condition.input][condition.term]);
    }
    if (membership == 0) continue;
    // The product may underflow, the rule fires all the same.
    const double strength = std::max(rule.weight * membership, kSmallest);
    strengths[rule.then] = std::max(strengths[rule.then], strength);
    fired = true;
  }
  return fired;
}

bool CompiledModel::expertOffset(const CompiledExpert& expert, std::span<const double> clamped, Fuzzified& fuzzified,
                                 double& offset) const noexcept {
  const Bank& bank = banks_[expert.output_bank];
  std::array<double, kMostTerms> strengths;
  if (!expertStrengths(expert, clamped, fuzzified, {strengths.data(), bank.size()})) return false;

  const double largest =
      *std::max_element(strengths.begin(), strengths.begin() + static_cast<std::ptrdiff_t>(bank.size()));
  std::array<ActiveTerm, kMostTerms> active;
  std::size_t count = 0;
  for (std::size_t t = 0; t < bank.size(); ++t) {
    if (strengths[t] == 0) continue;
    active[count++] = {&bank[t], std::max(strengths[t] / kStrengthScale, kSmallest),
                       std::max(strengths[t] / largest, kSmallest)};
  }
  offset = centroidOffset({active.data(), count}, implication_, output_min_, output_max_);
  return true;
}

Evaluation CompiledModel::evaluate(std::span<const double> inputs) const noexcept {
  std::array<double, kMostInputs> clamped;
  if (!clampInputs(inputs, clamped)) return {std::numeric_limits<double>::quiet_NaN(), false};

  Fuzzified fuzzified;
  const std::span<const double> point(clamped.data(), inputs.size());
  double weights = 0;
  double mean_offset = 0;
  for (const auto& expert : experts_) {
    double offset = 0;
    if (expert.weight == 0 || !expertOffset(expert, point, fuzzified, offset)) continue;
    // Running mean: stays between the smallest and the largest force, and one expert's force comes out unchanged.
    weights += expert.weight;
    mean_offset += (offset - mean_offset) * (expert.weight / weights);
  }
  if (weights == 0) return {default_force_n_, false};
  return {output_min_ + mean_offset, true};
}

Evaluation CompiledModel::evaluateExpert(std::size_t expert, std::span<const double> inputs) const noexcept {
  std::array<double, kMostInputs> clamped;
  if (!clampInputs(inputs, clamped)) return {std::numeric_limits<double>::quiet_NaN(), false};
  Fuzzified fuzzified;
  double offset = 0;
  if (!expertOffset(experts_[expert], {clamped.data(), inputs.size()}, fuzzified, offset))
    return {default_force_n_, false};
  return {output_min_ + offset, true};
}

bool CompiledModel::strengths(std::size_t expert, std::span<const double> inputs,
                              std::span<double> strengths) const noexcept {
  std::array<double, kMostInputs> clamped;
  const auto terms = outputTerms(expert).size();
  if (!clampInputs(inputs, clamped)) return false;
  Fuzzified fuzzified;
  const std::span<double> scaled = strengths.first(terms);
  const bool fired = expertStrengths(experts_[expert], {clamped.data(), inputs.size()}, fuzzified, scaled);
  for (double& strength : scaled) {
    if (strength > 0) strength = std::max(strength / kStrengthScale, kSmallest);
  }
  return fired;
}

std::span<const MembershipFunction> CompiledModel::outputTerms(std::size_t expert) const noexcept {
  return banks_[experts_[expert].output_bank];
}

}  // namespace tactus::fuzzy
