// From the model that people edit to indices and slots.
#include <algorithm>

#include "core/analysis/gradient/gradient.h"
#include "core/analysis/gradient/gradient_sink.h"
#include "core/analysis/gradient/gradient_tables.h"
#include "core/analysis/rule_table.h"
#include "core/base/check.h"
#include "core/fuzzy/validate.h"

namespace tactus::analysis {
namespace {

// Words of all tables of bits together. A model with more takes the general path for the experts that come last.
constexpr std::size_t kMostBitWords = 1 << 20;

class Compiler {
 public:
  Compiler(const fuzzy::ForceModel& model, GradientMethod method) : model_(model), method_(method) {}

  GradientTables run() {
    out_.output_min = model_.output.min;
    out_.output_max = model_.output.max;
    out_.default_force_n = model_.default_force_n;
    out_.implication = model_.implication;
    out_.slot_count = model_.inputs.size();
    for (const auto& input : model_.inputs) {
      out_.input_min.push_back(input.min);
      out_.input_max.push_back(input.max);
    }
    for (std::size_t v = 0; v <= model_.inputs.size(); ++v) out_.banks.push_back(makeBank(variable(v).terms, v));

    // Relative to the largest one first: their sum may be beyond the range of double.
    double largest = 0;
    for (const auto& expert : model_.experts) largest = std::max(largest, expert.weight);
    double sum = 0;
    for (const auto& expert : model_.experts) sum += expert.weight / largest;
    for (const auto& expert : model_.experts) {
      out_.experts.push_back(makeExpert(expert));
      out_.experts.back().weight = expert.weight / largest / sum;
    }
    return std::move(out_);
  }

 private:
  /// The inputs, then the output.
  const fuzzy::Variable& variable(std::size_t index) const {
    return index < model_.inputs.size() ? model_.inputs[index] : model_.output;
  }

  GradientBank makeBank(const std::vector<fuzzy::Term>& terms, std::size_t of_variable) {
    GradientBank bank;
    for (const auto& term : terms) {
      const auto first = static_cast<std::uint32_t>(out_.slot_count);
      bank.functions.push_back(fuzzy::MembershipFunction::of(term));
      bank.first_slot.push_back(first);
      switch (term.shape) {
        case fuzzy::Shape::kTrapezoid:
          bank.slots.push_back({first, first + 1, first + 2, first + 3});
          break;
        case fuzzy::Shape::kTriangle:
          bank.slots.push_back({first, first + 1, first + 1, first + 2});
          break;
        case fuzzy::Shape::kGaussian:
          bank.slots.push_back({first, first + 1, first, first});
          break;
      }
      out_.slot_count += fuzzy::pointCount(term.shape);
    }
    bank.first_slot.push_back(static_cast<std::uint32_t>(out_.slot_count));

    const auto& v = variable(of_variable);
    if (method_ == GradientMethod::kGeneral) return bank;
    if (of_variable < model_.inputs.size()) {
      bank.pieces = InputPieces::of(bank.functions, bank.slots, v.min, v.max);
    } else {
      bank.ordered = OrderedSets::of(bank.functions, bank.slots, v.min, v.max, model_.implication);
    }
    return bank;
  }

  GradientExpert makeExpert(const fuzzy::Expert& expert) {
    GradientExpert made;
    for (std::size_t v = 0; v <= model_.inputs.size(); ++v) {
      const auto& terms = fuzzy::termsFor(expert, variable(v));
      const bool shared = &terms == &variable(v).terms;
      if (!shared) out_.banks.push_back(makeBank(terms, v));
      made.bank.push_back(static_cast<std::uint32_t>(shared ? v : out_.banks.size() - 1));
    }
    made.first_rule_slot = static_cast<std::uint32_t>(out_.slot_count);
    out_.slot_count += expert.rules.size();
    for (const ResolvedRule& resolved : resolveRules(model_, expert)) {
      const auto& conditions = expert.rules[resolved.index].conditions;
      made.rules.push_back({static_cast<std::uint32_t>(made.conditions.size()),
                            static_cast<std::uint16_t>(conditions.size()), static_cast<std::uint16_t>(resolved.then),
                            made.first_rule_slot + static_cast<std::uint32_t>(resolved.index), resolved.weight});
      for (const auto& condition : conditions) {
        std::size_t input = 0;
        while (model_.inputs[input].id != condition.input) ++input;
        made.conditions.push_back(
            {static_cast<std::uint8_t>(input), static_cast<std::uint8_t>(resolved.termOf(input))});
      }
    }
    // An output term, a weight and an input term for each output term that fires.
    out_.most_groups += 3 * out_.banks[made.bank.back()].functions.size();
    if (hasFastForm(made)) made.fast = fastRules(made);
    return made;
  }

  bool hasFastForm(const GradientExpert& expert) const {
    const auto has_pieces = [&](std::uint32_t bank) { return out_.banks[bank].pieces.has_value(); };
    const auto is_ordinary = [](const GradientRule& rule) { return isOrdinary(rule.weight); };
    return out_.banks[expert.bank.back()].ordered &&
           std::all_of(expert.bank.begin(), expert.bank.end() - 1, has_pieces) &&
           std::all_of(expert.rules.begin(), expert.rules.end(), is_ordinary);
  }

  /// Nothing where the table of bits would be too large.
  std::optional<FastRules> fastRules(const GradientExpert& expert) {
    FastRules fast;
    const OrderedSets& sets = *out_.banks[expert.bank.back()].ordered;
    for (const GradientRule& rule : expert.rules) {
      fast.rules.push_back({rule.weight, rule.slot, static_cast<std::uint16_t>(sets.laneOf(rule.then))});
      fast.stride = std::max<std::size_t>(fast.stride, rule.condition_count);
    }
    for (const GradientRule& rule : expert.rules) {
      for (std::size_t c = 0; c < fast.stride; ++c) {
        const auto& condition = expert.conditions[rule.first_condition + (c < rule.condition_count ? c : 0)];
        fast.places.push_back(static_cast<std::uint16_t>(condition.input * fuzzy::kMostTerms + condition.term));
      }
    }
    fast.words = (expert.rules.size() + 63) / 64;
    for (std::size_t i = 0; i < model_.inputs.size(); ++i) {
      const bool mentioned = std::any_of(expert.conditions.begin(), expert.conditions.end(),
                                         [i](const GradientCondition& c) { return c.input == i; });
      if (mentioned && !addBits(expert, i, fast)) return std::nullopt;
    }
    return fast;
  }

  bool addBits(const GradientExpert& expert, std::size_t input, FastRules& fast) {
    const InputPieces& pieces = *out_.banks[expert.bank[input]].pieces;
    const std::size_t first = fast.bits.size();
    const std::size_t words = pieces.segmentCount() * fast.words;
    bit_words_ += words;
    if (bit_words_ > kMostBitWords) return false;
    fast.inputs.push_back({input, first});
    fast.bits.resize(first + words);
    for (std::size_t segment = 0; segment < pieces.segmentCount(); ++segment) {
      std::uint64_t* const bits = fast.bits.data() + first + segment * fast.words;
      for (std::size_t r = 0; r < expert.rules.size(); ++r) {
        if (canFire(expert, expert.rules[r], input, pieces.piecesOf(segment)))
          bits[r / 64] |= std::uint64_t{1} << r % 64;
      }
    }
    return true;
  }

  /// Whether the conditions of the rule on an input allow it to fire where `pieces` are active.
  static bool canFire(const GradientExpert& expert, const GradientRule& rule, std::size_t input,
                      std::span<const MembershipPiece> pieces) {
    const auto conditions = std::span(expert.conditions).subspan(rule.first_condition, rule.condition_count);
    return std::all_of(conditions.begin(), conditions.end(), [&](const GradientCondition& condition) {
      const auto is_meant = [&](const MembershipPiece& piece) {
        return piece.isActive() && piece.term == condition.term;
      };
      return condition.input != input || std::any_of(pieces.begin(), pieces.end(), is_meant);
    });
  }

  const fuzzy::ForceModel& model_;
  GradientMethod method_;
  GradientTables out_;
  std::size_t bit_words_ = 0;
};

}  // namespace

base::Result<GradientModel> GradientModel::of(const fuzzy::ForceModel& model, GradientMethod method) {
  if (auto ok = fuzzy::validate(model); !ok) return tl::unexpected(ok.error());
  GradientModel out;
  out.tables_ = std::make_shared<const GradientTables>(Compiler(model, method).run());
  return out;
}

std::size_t GradientModel::inputCount() const noexcept { return tables_->input_min.size(); }
std::size_t GradientModel::slotCount() const noexcept { return tables_->slot_count; }

Gradient GradientModel::makeGradient() const {
  Gradient out;
  out.slot_count_ = tables_->slot_count;
  out.values_.resize(tables_->slot_count + kSlotGroup);
  out.touched_.resize(tables_->most_groups);
  return out;
}

std::size_t GradientModel::inputSlot(std::size_t input) const noexcept {
  TACTUS_CHECK(input < inputCount());
  return input;
}

std::size_t GradientModel::pointSlot(std::size_t variable, std::size_t term, std::size_t point) const noexcept {
  TACTUS_CHECK(variable <= inputCount());
  const GradientBank& bank = tables_->banks[variable];
  TACTUS_CHECK(term < bank.functions.size() && point < bank.first_slot[term + 1] - bank.first_slot[term]);
  return bank.first_slot[term] + point;
}

std::size_t GradientModel::pointSlot(std::size_t expert, std::size_t variable, std::size_t term,
                                     std::size_t point) const noexcept {
  TACTUS_CHECK(expert < tables_->experts.size() && variable <= inputCount());
  const GradientBank& bank = tables_->banks[tables_->experts[expert].bank[variable]];
  TACTUS_CHECK(term < bank.functions.size() && point < bank.first_slot[term + 1] - bank.first_slot[term]);
  return bank.first_slot[term] + point;
}

bool GradientModel::hasOwnTerms(std::size_t expert, std::size_t variable) const noexcept {
  TACTUS_CHECK(expert < tables_->experts.size() && variable <= inputCount());
  return tables_->experts[expert].bank[variable] != variable;
}

std::size_t GradientModel::weightSlot(std::size_t expert, std::size_t rule) const noexcept {
  TACTUS_CHECK(expert < tables_->experts.size());
  const std::size_t slot = tables_->experts[expert].first_rule_slot + rule;
  TACTUS_CHECK(slot < tables_->slot_count);
  return slot;
}

bool GradientModel::hasClosedForm(std::size_t expert) const noexcept {
  TACTUS_CHECK(expert < tables_->experts.size());
  return tables_->experts[expert].fast.has_value();
}

}  // namespace tactus::analysis
