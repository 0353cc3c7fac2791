// The data of a GradientModel. Only the sources of the gradient include this.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/analysis/input_pieces.h"
#include "core/analysis/ordered_sets.h"
#include "core/fuzzy/force_model.h"
#include "core/fuzzy/membership.h"

namespace tactus::analysis {

/// A list of terms of one variable. The slots of a term are those of a, b, c, d (b and c of a triangle share one), or
/// of mean and sigma.
struct GradientBank {
  std::vector<fuzzy::MembershipFunction> functions;
  std::vector<TermSlots> slots;
  std::vector<std::uint32_t> first_slot;
  std::optional<InputPieces> pieces;   ///< for the terms of an input, if they have the form for the fast path
  std::optional<OrderedSets> ordered;  ///< for output terms, if they have the form for the fast path
};

struct GradientCondition {
  std::uint8_t input;
  std::uint8_t term;
};

struct GradientRule {
  std::uint32_t first_condition;
  std::uint16_t condition_count;
  std::uint16_t then;
  std::uint32_t slot;  ///< of the weight
  double weight;
};

/// Rules for the fast path, and for each segment between neighboring vertices a bit set of the rules that can fire.
struct FastRules {
  struct Rule {
    double weight;
    std::uint32_t slot;  ///< of the weight
    std::uint16_t lane;  ///< of the output term
  };
  struct Input {
    std::size_t input;
    std::size_t first_word;  ///< of the first segment; each segment has `words` words
  };
  std::vector<Rule> rules;
  std::size_t stride = 1;             ///< conditions per rule; a rule with fewer repeats its first one
  std::vector<std::uint16_t> places;  ///< indices of the memberships, see FastPoint
  std::size_t words = 0;
  std::vector<Input> inputs;        ///< inputs that occur in rules
  std::vector<std::uint64_t> bits;  ///< one per rule
};

struct GradientExpert {
  double weight = 1;                ///< relative to the sum of all weights
  std::vector<std::uint32_t> bank;  ///< one per input, then that of the output
  std::uint32_t first_rule_slot = 0;
  std::vector<GradientRule> rules;  ///< enabled rules with a weight > 0
  std::vector<GradientCondition> conditions;
  std::optional<FastRules> fast;  ///< for the fast path, used if no number is extreme
};

struct GradientTables {
  std::vector<double> input_min, input_max;
  double output_min = 0, output_max = 1;
  double default_force_n = 0;
  fuzzy::Implication implication = fuzzy::Implication::kClip;
  std::size_t slot_count = 0;
  std::size_t most_groups = 0;      ///< largest number of slot groups that one evaluation touches
  std::vector<GradientBank> banks;  ///< first the inputs and the output, then the experts' own lists
  std::vector<GradientExpert> experts;
};

}  // namespace tactus::analysis
