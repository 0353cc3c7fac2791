#include "core/fuzzy/section_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/fuzzy/flat_map.h"

namespace tactus::fuzzy {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Vertices nearer to 0 than this, but not 0, and ramps narrower than this are left to the general path.
constexpr double kTiny = 1e-280;
// With ramps no wider and weights no smaller than these the smallest strength of an ordinary input is still positive.
constexpr double kWidestRamp = 1e10;
constexpr double kSmallestWeight = 1e-10;

/// 1 / width, rounded so that width * the result is at least 1.
double steepness(double width) {
  double slope = 1 / width;
  while (width * slope < 1) slope = std::nextafter(slope, kInfinity);
  return slope;
}

/// One ramp from `foot` (membership 0) to `shoulder` (1); `outward` is the direction from shoulder to foot. False where
/// the general path must take it.
bool setRamp(double foot, double shoulder, double outward, double& position, double& slope) {
  const double width = std::abs(shoulder - foot);
  const auto is_tiny = [](double x) { return x != 0 && std::abs(x) < kTiny; };
  if (width == 0) {
    // A vertical edge: a ramp one ulp wide that ends at the edge.
    if (std::abs(foot) < kTiny) return false;
    position = std::nextafter(foot, outward);
    slope = std::numeric_limits<double>::max();
    return true;
  }
  if (width < kTiny || is_tiny(foot) || is_tiny(shoulder)) return false;
  position = foot;
  slope = steepness(width);
  return true;
}

std::optional<Ramps> rampsOf(const MembershipFunction& f, double lo, double hi) {
  Ramps ramps;
  if (f.gaussian) return std::nullopt;
  ramps.has_rise = f.b > lo;
  ramps.has_fall = f.c < hi;
  if (ramps.has_rise && !setRamp(f.a, f.b, -kInfinity, ramps.a, ramps.rise)) return std::nullopt;
  if (ramps.has_fall && !setRamp(f.d, f.c, kInfinity, ramps.d, ramps.fall)) return std::nullopt;
  return ramps;
}

class Planner {
 public:
  Planner(const ModelTables& tables, std::span<const std::uint32_t> experts)
      : tables_(tables), experts_(experts), banks_(tables.experts[experts.front()].input_bank) {
    for (const std::uint32_t e : experts) rule_count_ += tables.experts[e].rules.size();
  }

  std::optional<SectionPlan> plan(std::span<const ClosedForm> forms, std::span<const std::uint32_t> form_of) {
    if (!placeSlots()) return std::nullopt;
    choosePivot();
    plan_.experts.reserve(experts_.size());
    plan_.rules.reserve(rule_count_);
    for (const std::uint32_t e : experts_) {
      const std::uint32_t form = form_of[tables_.experts[e].output_bank];
      if (!addExpert(e, form, forms[form].lane_of)) return std::nullopt;
    }
    if (!addTerms()) return std::nullopt;
    return std::move(plan_);
  }

 private:
  /// Blocks of eight after the constants, so that a block of terms is a block of slots.
  bool placeSlots() {
    std::size_t next = kLanes;
    for (std::size_t i = 0; i < banks_.size(); ++i) {
      plan_.first_slot[i] = static_cast<std::uint16_t>(next);
      next += (tables_.banks[banks_[i]].size() + kLanes - 1) / kLanes * kLanes;
    }
    plan_.slot_count = next;
    used_.assign(next, false);
    return next <= kMostSlots;
  }

  /// The input that most rules mention.
  void choosePivot() {
    std::array<std::size_t, kMostInputs> mentions{};
    for (const std::uint32_t e : experts_) {
      for (const auto& condition : tables_.experts[e].conditions) ++mentions[condition.input];
    }
    plan_.pivot_input =
        static_cast<std::uint16_t>(std::max_element(mentions.begin(), mentions.end()) - mentions.begin());
    const std::size_t terms = tables_.banks[banks_[plan_.pivot_input]].size();
    plan_.pivots.reserve(terms + 2);
    plan_.pivots.push_back(kOneSlot);
    for (std::size_t t = 0; t < terms; ++t) {
      plan_.pivots.push_back(static_cast<std::uint16_t>(plan_.first_slot[plan_.pivot_input] + t));
    }
    plan_.pivots.push_back(kZeroSlot);
  }

  bool addExpert(std::uint32_t e, std::uint32_t form, const std::vector<std::uint16_t>& lane_of) {
    const RuleTable& table = tables_.experts[e];
    plan_.experts.push_back(
        {e, form, {static_cast<std::uint32_t>(plan_.rules.size()), static_cast<std::uint32_t>(table.rules.size())}});
    for (const auto& rule : table.rules) {
      PlannedRule planned{0, kOneSlot, lane_of[rule.then], rule.weight};
      std::array<std::uint16_t, kMostInputs> others;
      std::size_t count = 0;
      std::uint64_t key = 0;  // of the other conditions: seven bits per input
      for (std::uint32_t c = rule.first_condition; c < rule.first_condition + rule.condition_count; ++c) {
        const auto [input, term] = table.conditions[c];
        const auto slot = static_cast<std::uint16_t>(plan_.first_slot[input] + term);
        used_[slot] = true;
        if (input == plan_.pivot_input) {
          planned.row = static_cast<std::uint16_t>(1 + term);
        } else {
          others[count++] = slot;
          key |= (term + std::uint64_t{1}) << 7U * input;
        }
      }
      if (count == 1) planned.rest = others[0];
      if (count > 1 && !setAntecedent(key, {others.data(), count}, planned.rest)) return false;
      if (rule.weight < kSmallestWeight) plan_.zero_is_certain = false;
      plan_.rules.push_back(planned);
    }
    return true;
  }

  bool setAntecedent(std::uint64_t key, std::span<const std::uint16_t> slots, std::uint16_t& rest) {
    if (!antecedents_) antecedents_.emplace(rule_count_);
    const auto next = static_cast<std::uint32_t>(plan_.slot_count);
    rest = static_cast<std::uint16_t>(antecedents_->findOrAdd(key, next));
    if (rest != next) return true;
    if (next == kMostSlots) return false;
    ++plan_.slot_count;
    plan_.antecedents.push_back(
        {rest, {static_cast<std::uint32_t>(plan_.antecedent_slots.size()), static_cast<std::uint32_t>(slots.size())}});
    plan_.antecedent_slots.insert(plan_.antecedent_slots.end(), slots.begin(), slots.end());
    return true;
  }

  bool addTerms() {
    plan_.terms.reserve(used_.size());
    for (std::uint16_t i = 0; i < banks_.size(); ++i) {
      const auto& bank = tables_.banks[banks_[i]];
      for (std::size_t t = 0; t < bank.size(); ++t) {
        const auto slot = static_cast<std::uint16_t>(plan_.first_slot[i] + t);
        if (!used_[slot]) continue;
        const auto ramps = rampsOf(bank[t], tables_.input_min[i], tables_.input_max[i]);
        if (!ramps) return false;
        const auto is_wide = [](bool present, double slope) { return present && slope < 1 / kWidestRamp; };
        if (is_wide(ramps->has_rise, ramps->rise) || is_wide(ramps->has_fall, ramps->fall)) {
          plan_.zero_is_certain = false;
        }
        plan_.terms.push_back({*ramps, i, slot});
      }
    }
    return true;
  }

  const ModelTables& tables_;
  std::span<const std::uint32_t> experts_;
  const std::vector<std::uint32_t>& banks_;  ///< of the inputs
  std::size_t rule_count_ = 0;
  std::vector<bool> used_;  ///< slots of terms that rules mention
  std::optional<FlatMap> antecedents_;
  SectionPlan plan_;
};

}  // namespace

std::optional<SectionPlan> planSection(const ModelTables& tables, std::span<const std::uint32_t> experts,
                                       std::span<const ClosedForm> forms, std::span<const std::uint32_t> form_of) {
  return Planner(tables, experts).plan(forms, form_of);
}

Stretch addAntecedents(const SectionPlan& plan, std::vector<Antecedent>& antecedents,
                       std::vector<std::uint16_t>& antecedent_slots) {
  const Stretch added{sizeOf(antecedents), sizeOf(plan.antecedents)};
  const std::uint32_t first_slot = sizeOf(antecedent_slots);
  for (Antecedent antecedent : plan.antecedents) {
    antecedent.of.first += first_slot;
    antecedents.push_back(antecedent);
  }
  antecedent_slots.insert(antecedent_slots.end(), plan.antecedent_slots.begin(), plan.antecedent_slots.end());
  return added;
}

}  // namespace tactus::fuzzy
