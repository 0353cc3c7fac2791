// Rules over slots: what the makers of the fast form start from. Nothing outside core/fuzzy includes this.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/fuzzy/model_tables.h"
#include "core/fuzzy/program.h"

namespace tactus::fuzzy {

struct PlannedTerm {
  Ramps ramps;
  std::uint16_t input = 0;
  std::uint16_t slot = 0;
};

/// Strength = weight * min(pivot of the row, rest).
struct PlannedRule {
  std::uint16_t row = 0;
  std::uint16_t rest = 0;  ///< slot
  std::uint16_t lane = 0;
  double weight = 1;
};

struct PlannedExpert {
  std::uint32_t expert = 0;  ///< of the model
  std::uint32_t form = 0;
  Stretch rules;
};

/// Experts that share their input terms.
struct SectionPlan {
  /// Rules with the same term of the pivot input make a row: row 1 + t for its term t, row 0 for rules without one.
  std::uint16_t pivot_input = 0;
  std::vector<std::uint16_t> pivots;                    ///< slot of each row; the last row never has rules
  std::array<std::uint16_t, kMostInputs> first_slot{};  ///< of each input's terms
  std::size_t slot_count = 0;
  std::vector<PlannedTerm> terms;  ///< those that rules use
  std::vector<Antecedent> antecedents;
  std::vector<std::uint16_t> antecedent_slots;
  std::vector<PlannedExpert> experts;
  std::vector<PlannedRule> rules;
  bool zero_is_certain = true;  ///< see Program
};

/// The plan of `experts`, which share their input terms; `form_of` has the form of each output bank. Nothing where a
/// limit is exceeded or a term's shape needs the general path.
std::optional<SectionPlan> planSection(const ModelTables& tables, std::span<const std::uint32_t> experts,
                                       std::span<const ClosedForm> forms, std::span<const std::uint32_t> form_of);

/// Appends the antecedents of the section to the tables of a program.
Stretch addAntecedents(const SectionPlan& plan, std::vector<Antecedent>& antecedents,
                       std::vector<std::uint16_t>& antecedent_slots);

/// Adds the section to a program for one point.
void addSection(const SectionPlan& plan, const ModelTables& tables, std::span<const ClosedForm> forms,
                PointProgram& program);

/// Adds it to a program for many points; experts of weight 0 are left out. The program still has to be specialised.
void addSection(const SectionPlan& plan, const ModelTables& tables, std::span<const ClosedForm> forms,
                BatchProgram& program);

}  // namespace tactus::fuzzy
