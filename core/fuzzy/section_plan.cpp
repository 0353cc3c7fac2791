#include "core/fuzzy/section_plan.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <numeric>

#include "core/fuzzy/flat_map.h"

namespace tactus::fuzzy {
namespace {

// With ramps no wider and weights no smaller than these the smallest strength of an ordinary input is still positive.
constexpr double kWidestRamp = 1e10;
constexpr double kSmallestWeight = 1e-10;

class Planner {
 public:
  Planner(const ModelTables& tables, std::span<const std::uint32_t> experts, std::span<std::uint32_t> scratch,
          std::pmr::memory_resource* memory)
      : tables_(tables),
        experts_(experts),
        banks_(tables.experts[experts.front()].input_bank),
        planned_as_(scratch),
        plan_{memory} {}

  std::optional<SectionPlan> plan(std::span<const ClosedForm> forms, std::span<const std::uint32_t> form_of) {
    if (!placeSlots()) return std::nullopt;
    collectPremises();
    choosePivot();
    const bool fits = addPremises();
    if (fits) addRules(forms, form_of);
    for (const std::uint32_t premise : premises_) planned_as_[premise] = kUnplanned;
    if (!fits || !addTerms()) return std::nullopt;
    return std::move(plan_);
  }

 private:
  std::size_t inputs() const { return tables_.input_min.size(); }

  std::span<const IndexedCondition> conditionsOf(std::uint32_t premise) const {
    return in(tables_.conditions, tables_.premises[premise]);
  }

  /// Blocks of eight after the constants, so that a block of terms is a block of slots.
  bool placeSlots() {
    std::size_t next = kLanes;
    for (std::size_t i = 0; i < inputs(); ++i) {
      plan_.first_slot[i] = static_cast<std::uint16_t>(next);
      next += (tables_.bank(banks_[i]).size() + kLanes - 1) / kLanes * kLanes;
    }
    plan_.block_count = next / kLanes - 1;
    plan_.slot_count = next;
    return next <= kMostSlots;
  }

  void collectPremises() {
    for (const std::uint32_t e : experts_) rule_count_ += tables_.experts[e].rules.count;
    premises_.reserve(std::min<std::size_t>(rule_count_, tables_.premises.size()));
    for (const std::uint32_t e : experts_) {
      for (const IndexedRule& rule : in(tables_.rules, tables_.experts[e].rules)) {
        if (planned_as_[rule.premise] != kUnplanned) continue;
        planned_as_[rule.premise] = 0;
        premises_.push_back(rule.premise);
      }
    }
  }

  /// The input that most premises mention.
  void choosePivot() {
    std::array<std::size_t, kMostInputs> mentions{};
    for (const std::uint32_t premise : premises_) {
      for (const IndexedCondition& condition : conditionsOf(premise)) ++mentions[condition.input];
    }
    plan_.pivot_input =
        static_cast<std::uint16_t>(std::max_element(mentions.begin(), mentions.end()) - mentions.begin());
    const std::size_t terms = tables_.bank(banks_[plan_.pivot_input]).size();
    plan_.pivots.reserve(terms + 2);
    plan_.pivots.push_back(kOneSlot);
    for (std::size_t t = 0; t < terms; ++t) {
      plan_.pivots.push_back(static_cast<std::uint16_t>(plan_.first_slot[plan_.pivot_input] + t));
    }
    plan_.pivots.push_back(kZeroSlot);
  }

  bool addPremises() {
    Table<std::uint16_t> row_of(premises_.size(), plan_.memory);
    plan_.row_end.assign(plan_.pivots.size(), 0);
    for (std::size_t p = 0; p < premises_.size(); ++p) {
      for (const auto [input, term] : conditionsOf(premises_[p])) {
        if (input == plan_.pivot_input) row_of[p] = static_cast<std::uint16_t>(1 + term);
      }
      ++plan_.row_end[row_of[p]];
    }
    std::exclusive_scan(plan_.row_end.begin(), plan_.row_end.end(), plan_.row_end.begin(), 0U);
    plan_.premises.resize(premises_.size());
    for (std::size_t p = 0; p < premises_.size(); ++p) {
      const std::uint32_t place = plan_.row_end[row_of[p]]++;
      planned_as_[premises_[p]] = place;
      plan_.premises[place].row = row_of[p];
      if (!setRest(premises_[p], plan_.premises[place].rest)) return false;
    }
    return true;
  }

  /// What a premise asks besides its pivot term; false where there are too many slots.
  bool setRest(std::uint32_t premise, std::uint16_t& rest) {
    std::array<std::uint16_t, kMostInputs> others;
    std::size_t count = 0;
    std::uint64_t key = 0;  // seven bits per input
    for (const auto [input, term] : conditionsOf(premise)) {
      const auto slot = static_cast<std::uint16_t>(plan_.first_slot[input] + term);
      used_[slot] = true;
      if (input == plan_.pivot_input) continue;
      others[count++] = slot;
      key |= (term + std::uint64_t{1}) << 7U * input;
    }
    rest = count == 0 ? kOneSlot : others[0];
    plan_.bare_pivots = plan_.bare_pivots || count == 0;
    if (count < 2) return true;
    if (!antecedents_) antecedents_.emplace(premises_.size());
    const auto next = static_cast<std::uint32_t>(plan_.slot_count);
    rest = static_cast<std::uint16_t>(antecedents_->findOrAdd(key, next));
    if (rest != next) return true;
    if (next == kMostSlots) return false;
    ++plan_.slot_count;
    plan_.antecedents.push_back({rest, {sizeOf(plan_.antecedent_slots), static_cast<std::uint32_t>(count)}});
    plan_.antecedent_slots.insert(plan_.antecedent_slots.end(), others.data(), others.data() + count);
    return true;
  }

  void addRules(std::span<const ClosedForm> forms, std::span<const std::uint32_t> form_of) {
    plan_.experts.reserve(experts_.size());
    plan_.rules.resize(rule_count_);
    PlannedRule* next = plan_.rules.data();
    double smallest_weight = 1;
    for (const std::uint32_t e : experts_) {
      const ExpertTable& table = tables_.experts[e];
      const std::uint32_t form = form_of[table.output_bank];
      const std::uint16_t* const lane_of = forms[form].lane_of.data();
      plan_.experts.push_back({e, form, {static_cast<std::uint32_t>(next - plan_.rules.data()), table.rules.count}});
      for (const IndexedRule& rule : in(tables_.rules, table.rules)) {
        *next++ = {rule.weight, planned_as_[rule.premise], lane_of[rule.then]};
        smallest_weight = std::min(rule.weight, smallest_weight);
      }
    }
    plan_.unit_weights = smallest_weight == 1;
    plan_.zero_is_certain = smallest_weight >= kSmallestWeight;
  }

  bool addTerms() {
    std::size_t terms = 0;
    for (std::size_t i = 0; i < inputs(); ++i) terms += tables_.bank(banks_[i]).size();
    plan_.terms.reserve(terms);
    for (std::uint16_t i = 0; i < inputs(); ++i) {
      const auto bank = tables_.bank(banks_[i]);
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
  std::span<const std::uint32_t> banks_;  ///< of the inputs
  std::size_t rule_count_ = 0;
  std::span<std::uint32_t> planned_as_;  ///< place in the plan of each premise of the model
  std::bitset<kMostSlots> used_;         ///< slots of terms that rules mention
  std::optional<FlatMap> antecedents_;
  SectionPlan plan_;
  Table<std::uint32_t> premises_{plan_.memory};  ///< of the model: those of the rules
};

}  // namespace

std::optional<SectionPlan> planSection(const ModelTables& tables, std::span<const std::uint32_t> experts,
                                       std::span<const ClosedForm> forms, std::span<const std::uint32_t> form_of,
                                       std::span<std::uint32_t> scratch, std::pmr::memory_resource* memory) {
  return Planner(tables, experts, scratch, memory).plan(forms, form_of);
}

Stretch addAntecedents(const SectionPlan& plan, Table<Antecedent>& antecedents,
                       Table<std::uint16_t>& antecedent_slots) {
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
