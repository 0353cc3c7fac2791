// Rules over slots: what the makers of the fast form start from. Nothing outside core/fuzzy includes this.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
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

/// The conditions of rules without that of the pivot input: strength = weight * min(pivot of the row, rest).
struct PlannedPremise {
  std::uint16_t row = 0;
  std::uint16_t rest = 0;  ///< slot
};

struct PlannedRule {
  double weight;
  std::uint32_t premise;  ///< of the section
  std::uint16_t lane;
};

struct PlannedExpert {
  std::uint32_t expert = 0;  ///< of the model
  std::uint32_t form = 0;
  Stretch rules;
};

/// Experts that share their input terms.
struct SectionPlan {
  std::pmr::memory_resource* memory;  ///< of the plan, and for whoever needs some while reading it
  /// Premises with the same term of the pivot input make a row: row 1 + t for its term t, row 0 for those without one.
  std::uint16_t pivot_input = 0;
  Table<std::uint16_t> pivots{memory};                  ///< slot of each row; the last row never has premises
  std::array<std::uint16_t, kMostInputs> first_slot{};  ///< of each input's terms
  std::size_t block_count = 0;                          ///< of eight terms
  std::size_t slot_count = 0;
  Table<PlannedTerm> terms{memory};  ///< those that rules use
  Table<Antecedent> antecedents{memory};
  Table<std::uint16_t> antecedent_slots{memory};
  Table<PlannedPremise> premises{memory};  ///< those of the rules, row by row
  Table<std::uint32_t> row_end{memory};    ///< in premises
  Table<PlannedExpert> experts{memory};
  Table<PlannedRule> rules{memory};
  bool unit_weights = true;     ///< of all rules
  bool bare_pivots = false;     ///< some premise asks for its pivot alone
  bool zero_is_certain = true;  ///< see Program
};

inline constexpr std::uint32_t kUnplanned = std::numeric_limits<std::uint32_t>::max();

/// The plan of `experts`, which share their input terms; `form_of` has the form of each output bank. Nothing where a
/// limit is exceeded or a term's shape needs the general path. `scratch` holds kUnplanned for each premise of the
/// model, afterwards again.
std::optional<SectionPlan> planSection(const ModelTables& tables, std::span<const std::uint32_t> experts,
                                       std::span<const ClosedForm> forms, std::span<const std::uint32_t> form_of,
                                       std::span<std::uint32_t> scratch, std::pmr::memory_resource* memory);

/// Appends the antecedents of the section to the tables of a program.
Stretch addAntecedents(const SectionPlan& plan, Table<Antecedent>& antecedents, Table<std::uint16_t>& antecedent_slots);

/// Adds the section to a program for one point.
void addSection(const SectionPlan& plan, const ModelTables& tables, std::span<const ClosedForm> forms,
                PointProgram& program);

/// Adds it to a program for many points; experts of weight 0 are left out.
void addSection(const SectionPlan& plan, const ModelTables& tables, std::span<const ClosedForm> forms,
                BatchProgram& program);

}  // namespace tactus::fuzzy
