// The general path: any model within the limits, one expert after the other, exact to rounding.
#include "core/fuzzy/general_path.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/fuzzy/centroid.h"
#include "core/fuzzy/model_tables.h"

namespace tactus::fuzzy {
namespace {

constexpr std::uint32_t kNoBank = std::numeric_limits<std::uint32_t>::max();
constexpr double kSmallest = std::numeric_limits<double>::denorm_min();

/// Memberships of one point times kStrengthScale, kept while consecutive experts share their terms.
struct Fuzzified {
  std::array<std::array<double, kMostTerms>, kMostInputs> membership;
  std::array<std::uint32_t, kMostInputs> bank;

  Fuzzified() noexcept { bank.fill(kNoBank); }
};

bool strengthsOf(const ModelTables& tables, const ExpertTable& expert, std::span<const double> clamped,
                 Fuzzified& fuzzified, std::span<double> strengths) noexcept {
  for (std::size_t i = 0; i < clamped.size(); ++i) {
    if (fuzzified.bank[i] == expert.input_bank[i]) continue;
    const auto bank = tables.bank(expert.input_bank[i]);
    for (std::size_t t = 0; t < bank.size(); ++t) {
      fuzzified.membership[i][t] = bank[t].scaled(clamped[i], kStrengthScale);
    }
    fuzzified.bank[i] = expert.input_bank[i];
  }

  std::fill(strengths.begin(), strengths.end(), 0.0);
  bool fired = false;
  for (const IndexedRule& rule : in(tables.rules, expert.rules)) {
    double membership = kStrengthScale;
    for (const IndexedCondition& condition : in(tables.conditions, tables.premises[rule.premise])) {
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

bool offsetOf(const ModelTables& tables, const ExpertTable& expert, std::span<const double> clamped,
              Fuzzified& fuzzified, double& offset) noexcept {
  const auto bank = tables.bank(expert.output_bank);
  std::array<double, kMostTerms> strengths;
  const std::span<double> used(strengths.data(), bank.size());
  if (!strengthsOf(tables, expert, clamped, fuzzified, used)) return false;

  const double largest = *std::max_element(used.begin(), used.end());
  std::array<ActiveTerm, kMostTerms> active;
  std::size_t count = 0;
  for (std::size_t t = 0; t < bank.size(); ++t) {
    if (strengths[t] == 0) continue;
    active[count++] = {&bank[t], std::max(strengths[t] / kStrengthScale, kSmallest),
                       std::max(strengths[t] / largest, kSmallest)};
  }
  offset = centroidOffset({active.data(), count}, tables.implication, tables.output_min, tables.output_max);
  return true;
}

}  // namespace

Evaluation evaluateGenerally(const ModelTables& tables, std::span<const double> clamped) noexcept {
  Fuzzified fuzzified;
  Mean mean;
  for (const auto& expert : tables.experts) {
    double offset = 0;
    if (expert.weight > 0 && offsetOf(tables, expert, clamped, fuzzified, offset)) mean.add(offset, expert.weight);
  }
  return mean.result(tables);
}

bool expertOffsetGenerally(const ModelTables& tables, std::size_t expert, std::span<const double> clamped,
                           double& offset) noexcept {
  Fuzzified fuzzified;
  return offsetOf(tables, tables.experts[expert], clamped, fuzzified, offset);
}

bool expertStrengths(const ModelTables& tables, std::size_t expert, std::span<const double> clamped,
                     std::span<double> strengths) noexcept {
  Fuzzified fuzzified;
  const bool fired = strengthsOf(tables, tables.experts[expert], clamped, fuzzified, strengths);
  for (double& strength : strengths) {
    if (strength > 0) strength = std::max(strength / kStrengthScale, kSmallest);
  }
  return fired;
}

}  // namespace tactus::fuzzy
