// From the model that people edit to indices and slots.
#include <algorithm>

#include "core/analysis/gradient.h"
#include "core/base/check.h"
#include "core/fuzzy/validate.h"

namespace tactus::analysis {
namespace {

std::size_t indexOf(const std::vector<fuzzy::Term>& terms, const std::string& id) {
  const fuzzy::Term* const term = fuzzy::findTerm(terms, id);
  TACTUS_CHECK(term != nullptr);
  return static_cast<std::size_t>(term - terms.data());
}

std::size_t indexOf(const std::vector<fuzzy::Variable>& variables, const std::string& id) {
  const auto it =
      std::find_if(variables.begin(), variables.end(), [&id](const fuzzy::Variable& v) { return v.id == id; });
  TACTUS_CHECK(it != variables.end());
  return static_cast<std::size_t>(it - variables.begin());
}

}  // namespace

GradientModel::Bank GradientModel::makeBank(const std::vector<fuzzy::Term>& terms) {
  Bank bank;
  for (const auto& term : terms) {
    const auto first = static_cast<std::uint32_t>(slot_count_);
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
    slot_count_ += fuzzy::pointCount(term.shape);
  }
  bank.first_slot.push_back(static_cast<std::uint32_t>(slot_count_));
  return bank;
}

GradientModel::Expert GradientModel::makeExpert(const fuzzy::ForceModel& model, const fuzzy::Expert& expert) {
  Expert made;
  const auto add_bank = [&](const fuzzy::Variable& variable, std::size_t index) {
    const auto& terms = fuzzy::termsFor(expert, variable);
    const bool shared = &terms == &variable.terms;
    if (!shared) banks_.push_back(makeBank(terms));
    made.bank.push_back(static_cast<std::uint32_t>(shared ? index : banks_.size() - 1));
  };
  for (std::size_t i = 0; i < model.inputs.size(); ++i) add_bank(model.inputs[i], i);
  add_bank(model.output, model.inputs.size());

  made.first_rule_slot = static_cast<std::uint32_t>(slot_count_);
  slot_count_ += expert.rules.size();
  const auto& output_terms = fuzzy::termsFor(expert, model.output);
  for (std::size_t r = 0; r < expert.rules.size(); ++r) {
    const auto& rule = expert.rules[r];
    if (!rule.enabled || rule.weight == 0) continue;
    made.rules.push_back({static_cast<std::uint32_t>(made.conditions.size()),
                          static_cast<std::uint16_t>(rule.conditions.size()),
                          static_cast<std::uint16_t>(indexOf(output_terms, rule.then)),
                          made.first_rule_slot + static_cast<std::uint32_t>(r), rule.weight});
    for (const auto& condition : rule.conditions) {
      const std::size_t input = indexOf(model.inputs, condition.input);
      const auto& terms = fuzzy::termsFor(expert, model.inputs[input]);
      made.conditions.push_back(
          {static_cast<std::uint8_t>(input), static_cast<std::uint8_t>(indexOf(terms, condition.term))});
    }
  }
  return made;
}

base::Result<GradientModel> GradientModel::of(const fuzzy::ForceModel& model) {
  if (auto ok = fuzzy::validate(model); !ok) return tl::unexpected(ok.error());

  GradientModel out;
  out.output_min_ = model.output.min;
  out.output_max_ = model.output.max;
  out.default_force_n_ = model.default_force_n;
  out.implication_ = model.implication;
  out.slot_count_ = model.inputs.size();
  for (const auto& input : model.inputs) {
    out.input_min_.push_back(input.min);
    out.input_max_.push_back(input.max);
    out.banks_.push_back(out.makeBank(input.terms));
  }
  out.banks_.push_back(out.makeBank(model.output.terms));

  double largest_weight = 0;
  for (const auto& expert : model.experts) largest_weight = std::max(largest_weight, expert.weight);
  for (const auto& expert : model.experts) {
    out.experts_.push_back(out.makeExpert(model, expert));
    out.experts_.back().weight = expert.weight / largest_weight;
  }
  return out;
}

std::size_t GradientModel::inputSlot(std::size_t input) const noexcept {
  TACTUS_CHECK(input < inputCount());
  return input;
}

std::size_t GradientModel::pointSlot(std::size_t variable, std::size_t term, std::size_t point) const noexcept {
  TACTUS_CHECK(variable <= inputCount());
  const Bank& bank = banks_[variable];
  TACTUS_CHECK(term < bank.functions.size() && point < bank.first_slot[term + 1] - bank.first_slot[term]);
  return bank.first_slot[term] + point;
}

std::size_t GradientModel::pointSlot(std::size_t expert, std::size_t variable, std::size_t term,
                                     std::size_t point) const noexcept {
  TACTUS_CHECK(expert < experts_.size() && variable <= inputCount());
  const Bank& bank = banks_[experts_[expert].bank[variable]];
  TACTUS_CHECK(term < bank.functions.size() && point < bank.first_slot[term + 1] - bank.first_slot[term]);
  return bank.first_slot[term] + point;
}

bool GradientModel::hasOwnTerms(std::size_t expert, std::size_t variable) const noexcept {
  TACTUS_CHECK(expert < experts_.size() && variable <= inputCount());
  return experts_[expert].bank[variable] != variable;
}

std::size_t GradientModel::weightSlot(std::size_t expert, std::size_t rule) const noexcept {
  TACTUS_CHECK(expert < experts_.size());
  const std::size_t slot = experts_[expert].first_rule_slot + rule;
  TACTUS_CHECK(slot < slot_count_);
  return slot;
}

}  // namespace tactus::analysis
