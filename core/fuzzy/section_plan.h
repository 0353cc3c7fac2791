// A section before its program is made: rules over slots. Words: program.h. Nothing outside core/fuzzy includes this.
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

/// The conditions of a rule without the pivot: strength = weight * min(pivot of the row, rest).
struct PlannedPremise {
  std::uint16_t row = 0;
  std::uint16_t rest = 0;  ///< slot
};

struct PlannedRule {
  double weight;
  std::uint32_t premise;  ///< index into the premises of the section
  std::uint16_t lane;
};

struct PlannedExpert {
  std::uint32_t expert = 0;  ///< index in the model
  std::uint32_t form = 0;
  Stretch rules;
};

/// Experts that share their input terms.
struct SectionPlan {
  std::pmr::memory_resource* memory;  ///< for the plan and for temporary data of its readers
  /// Premises with the same pivot make a row: row 1 + t for term t of the pivot input, row 0 for premises without a
  /// pivot.
  std::uint16_t pivot_input = 0;
  Table<std::uint16_t> pivots{memory};                  ///< slot of each row's pivot; the last row has no premises
  std::array<std::uint16_t, kMostInputs> first_slot{};  ///< of each input's terms
  std::size_t block_count = 0;                          ///< blocks of eight terms
  std::size_t slot_count = 0;
  Table<PlannedTerm> terms{memory};  ///< terms that occur in rules
  Table<Antecedent> antecedents{memory};
  Table<std::uint16_t> antecedent_slots{memory};
  Table<PlannedPremise> premises{memory};  ///< premises of the rules, row by row
  Table<std::uint32_t> row_end{memory};    ///< index into premises
  Table<PlannedExpert> experts{memory};
  Table<PlannedRule> rules{memory};
  bool unit_weights = true;     ///< every rule has the weight 1
  bool bare_pivots = false;     ///< some premise consists of its pivot alone
  bool zero_is_certain = true;  ///< see Program
};

inline constexpr std::uint32_t kUnplanned = std::numeric_limits<std::uint32_t>::max();

/// Plans the section of `experts`, which share their input terms. Empty if the section exceeds a limit or the shape of
/// a term needs the general path.
/// `form_of`: the form of each output bank. `scratch`: kUnplanned for each premise of the model, restored on return.
std::optional<SectionPlan> planSection(const ModelTables& tables, std::span<const std::uint32_t> experts,
                                       std::span<const ClosedForm> forms, std::span<const std::uint32_t> form_of,
                                       std::span<std::uint32_t> scratch, std::pmr::memory_resource* memory);

/// Appends the antecedents of the section to the tables of a program. Returns their range.
Stretch addAntecedents(const SectionPlan& plan, Table<Antecedent>& antecedents, Table<std::uint16_t>& antecedent_slots);

/// Appends the section to a program for one point.
void addSection(const SectionPlan& plan, const ModelTables& tables, std::span<const ClosedForm> forms,
                PointProgram& program);

/// Appends the section to a program for many points, without experts of weight 0.
void addSection(const SectionPlan& plan, const ModelTables& tables, std::span<const ClosedForm> forms,
                BatchProgram& program);

}  // namespace tactus::fuzzy
