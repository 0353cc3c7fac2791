// What a GradientModel holds. Only the sources of the gradient include this.
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
  std::optional<InputPieces> pieces;   ///< of an input's terms, where they have the form that the fast path needs
  std::optional<OrderedSets> ordered;  ///< of output terms, likewise
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

/// Rules for the fast path, and which of them can fire while each input lies between two neighbouring vertices.
struct FastRules {
  struct Rule {
    double weight;
    std::uint32_t slot;  ///< of the weight
    std::uint16_t lane;  ///< of the output term
  };
  struct Input {
    std::size_t input;
    std::size_t first_word;  ///< of the first segment; each segment has `words`
  };
  std::vector<Rule> rules;
  std::size_t stride = 1;             ///< conditions of a rule; a rule with fewer has its first one several times
  std::vector<std::uint16_t> places;  ///< of the memberships, see FastPoint
  std::size_t words = 0;
  std::vector<Input> inputs;        ///< those that rules mention
  std::vector<std::uint64_t> bits;  ///< one per rule
};

struct GradientExpert {
  double weight = 1;                ///< relative to the sum of all weights
  std::vector<std::uint32_t> bank;  ///< one per input, then that of the output
  std::uint32_t first_rule_slot = 0;
  std::vector<GradientRule> rules;  ///< enabled rules with a weight > 0 only
  std::vector<GradientCondition> conditions;
  std::optional<FastRules> fast;  ///< for the fast path, which is taken where no number is extreme
};

struct GradientTables {
  std::vector<double> input_min, input_max;
  double output_min = 0, output_max = 1;
  double default_force_n = 0;
  fuzzy::Implication implication = fuzzy::Implication::kClip;
  std::size_t slot_count = 0;
  std::size_t most_groups = 0;      ///< groups of slots that one evaluation may touch
  std::vector<GradientBank> banks;  ///< first those of the inputs and of the output, then the experts' own
  std::vector<GradientExpert> experts;
};

}  // namespace tactus::analysis
