// The fast form of a model: flat tables for the kernels (kernels.h). `compile` and `specialized` make it; nothing edits
// it.
//
// Words of this folder, with the rule IF depth is deep AND speed is fast THEN force is high:
// - Slot: the place of one membership in an array; slots 0 and 1 hold the constants 0 and 1.
//   Example: slot 9 holds the membership of the current depth in `deep`.
// - Pivot: the condition of a rule on the pivot input, the one input by which the rules of a section are sorted.
//   Example: with depth as pivot input, `depth is deep` is the pivot.
// - Rest: the other conditions of the rule. Strength = weight * min(pivot, rest). Example: `speed is fast`.
// - Row: the rests of all rules with the same pivot.
// - Segment: an interval between two breakpoints of the pivot input, where the same rows can be active.
//   Example: for depths between 20 and 30 mm only the rows of `middle` and `deep` are read.
// - Section: the experts that share their input terms. The next section reuses the slots.
// - Team: up to kTeam experts of a section with the same output terms, evaluated at once, one lane each.
// - Seat: the place of an expert in the order of the teams. Example: if team 0 has four experts, team 1 begins at 4.
// - Form: the closed form of a bank of output terms (closed_form.h), which also defines lane.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <optional>
#include <span>
#include <vector>

#include "core/fuzzy/closed_form.h"
#include "core/fuzzy/force_model.h"

namespace tactus::fuzzy {

struct Kernels;
struct ModelTables;

inline constexpr std::size_t kBatch = 32;       ///< points per call of the batch kernel
inline constexpr std::size_t kTeam = 4;         ///< experts that the point kernel evaluates at once: an AVX register
inline constexpr std::size_t kGridCells = 256;  ///< cells of the table that finds the segment of a point
/// Limit of memberships and antecedents of one section. The general path evaluates a model with a larger section.
inline constexpr std::size_t kMostSlots = 1024;

// Slots with constants.
inline constexpr std::uint16_t kZeroSlot = 0;
inline constexpr std::uint16_t kOneSlot = 1;

/// A range of elements of a flat table.
struct Stretch {
  std::uint32_t first = 0;
  std::uint32_t count = 0;

  std::uint32_t end() const noexcept { return first + count; }
};

/// The tables of a model share one memory resource, which is released as a whole.
template <class T>
using Table = std::pmr::vector<T>;

/// Reserves space for `more` elements. If the elements have to move, at least doubles the capacity.
template <class T>
void makeRoom(Table<T>& table, std::size_t more) {
  if (table.capacity() - table.size() < more) table.reserve(std::max(table.size() + more, 2 * table.capacity()));
}

template <class T, class Allocator>
std::uint32_t sizeOf(const std::vector<T, Allocator>& table) noexcept {
  return static_cast<std::uint32_t>(table.size());
}

template <class T, class Allocator>
std::span<const T> in(const std::vector<T, Allocator>& table, Stretch stretch) noexcept {
  return {table.data() + stretch.first, stretch.count};
}

/// The minimum of some memberships: a rest of more than one condition.
struct Antecedent {
  std::uint16_t slot = 0;
  Stretch of;      ///< slots of the conditions
  double cap = 1;  ///< minimum of the memberships of fixed inputs
};

// ---- one point

/// Up to eight terms of one input side by side. Their memberships go to eight consecutive slots.
struct TermBlock {
  std::uint16_t input = 0;
  std::uint16_t slot = 0;   ///< of the first term
  std::uint16_t count = 0;  ///< number of terms
  Lanes a, rise, d, fall;   ///< as in Ramps; an absent ramp starts at infinity
  Lanes height;             ///< 1; 0 for an absent term
};

/// The rest of a rule.
struct Rest {
  std::uint16_t slot = 0;
  std::uint16_t lane = 0;  ///< Layout::kSparse only: the output term of the rule
};

struct alignas(32) Weights {
  double value[kTeam] = {};
};

/// Up to kTeam experts with the same terms. A weight is 0 if the expert has no such rule. If the team is not full, the
/// first expert also fills the free places, with a share of 0.
struct Team {
  /// The data of each rest.
  enum class Layout : std::uint8_t {
    kAlone,   ///< one expert: a weight for each of eight output terms
    kDense,   ///< at most eight output terms: for each of them, a weight for each expert
    kSparse,  ///< the lane of one output term, and a weight for each expert
  };
  Layout layout = Layout::kSparse;
  std::uint16_t experts = 1;
  std::uint16_t lanes = 1;  ///< number of output terms
  std::uint32_t form = 0;
  std::uint32_t first_row = 0;  ///< rows[first_row + r] are the rests of pivot term r
  std::uint32_t first_rest = 0;
  std::uint32_t first_weight = 0;  ///< weight of the first rest
  Weights shares;                  ///< per expert: weight relative to the sum of all weights
};

struct PointSection {
  Stretch blocks, antecedents, teams;
  std::uint16_t pivot_input = 0;
  double grid_start = 0;  ///< lower end of the pivot input's universe
  double cells_per_unit = 0;
  std::uint32_t first_cell = 0;
  std::uint32_t first_breakpoint = 0;  ///< in breakpoints
  std::uint32_t first_segment_row = 0;
  std::uint32_t rows_per_segment = 1;
  std::uint32_t first_pivot = 0;  ///< pivots[first_pivot + r] is the slot of pivot term r
};

/// A cell of the grid. A point in it lies in this segment or in a later one.
struct GridCell {
  std::uint16_t segment = 0;
  std::uint16_t row = 0;  ///< rows_per_segment * segment
};

struct PointProgram {
  std::pmr::memory_resource* memory;
  Table<PointSection> sections{memory};
  Table<TermBlock> blocks{memory};
  Table<Antecedent> antecedents{memory};
  Table<std::uint16_t> antecedent_slots{memory};
  Table<double> breakpoints{memory};  ///< of the pivot input, ascending; the last is infinity
  Table<GridCell> cells{memory};
  Table<std::uint16_t> segment_rows{
      memory};                          ///< rows that can be active between two breakpoints, rows_per_segment each
  Table<std::uint16_t> pivots{memory};  ///< slots
  Table<Team> teams{memory};            ///< all experts of the model, sorted into teams
  Table<Stretch> rows{memory};          ///< ranges of `rests`
  Table<Rest> rests{memory};
  Table<Weights> weights{memory};
  Table<std::uint32_t> expert_at{memory};  ///< the model's index of the expert at each seat
};

// ---- many points

struct BatchTerm {
  Ramps ramps;
  std::uint16_t input = 0;
  std::uint16_t slot = 0;
  bool cap = true;  ///< cut at 1; not needed for a rest, because min with the pivot cuts it
};

/// A slot with the same value at all points, because its inputs are fixed.
struct FixedSlot {
  std::uint16_t slot = 0;
  double value = 0;
};

struct BatchRule {
  std::uint16_t rest;  ///< slot
  double weight;
};

/// The rules with the same pivot and the same output term.
struct RuleGroup {
  std::uint16_t pivot = 0;   ///< slot
  bool unit_weights = true;  ///< all weights are 1: strength = min(pivot, largest rest)
  Stretch rules;
  double cap = 0;  ///< largest of the fixed rests; only for unit weights
};

/// An output term of at least one rule.
struct BatchLane {
  std::uint16_t lane = 0;
  Stretch groups;
};

struct BatchExpert {
  double share = 1;  ///< weight relative to the sum of all weights
  std::uint32_t form = 0;
  Stretch lanes;
};

struct BatchSection {
  Stretch fixed, terms, antecedents, experts;
};

/// Experts whose tables fit into the cache together. All points of a tile pass through one chunk before the next chunk
/// starts. Otherwise a model of a thousand experts would be fetched from memory again for every few points.
struct BatchChunk {
  Stretch sections;  ///< sections with experts of this chunk
  Stretch experts;   ///< indices into the experts of the program; the first chunk starts at 0
};

struct BatchProgram {
  std::pmr::memory_resource* memory;
  Table<BatchSection> sections{memory};
  Table<FixedSlot> fixed{memory};
  Table<BatchTerm> terms{memory};
  Table<Antecedent> antecedents{memory};
  Table<std::uint16_t> antecedent_slots{memory};
  Table<BatchExpert> experts{memory};  ///< experts with a weight > 0
  Table<BatchLane> lanes{memory};
  Table<RuleGroup> groups{memory};
  Table<BatchRule> rules{memory};
  Table<BatchChunk> chunks{memory};  ///< all experts in order; at least one chunk; set by setChunks
};

/// Divides the experts of a program into chunks. All other tables of the program must be complete.
void setChunks(BatchProgram& program);

/// The programs of a model and their common data.
struct Program {
  std::pmr::memory_resource* memory;
  const Kernels* kernels = nullptr;  ///< kernels for this processor; not null after makeProgram
  bool usable = false;               ///< false: the general path evaluates everything
  bool clip = true;
  /// For ordinary inputs (areOrdinary) no product of a membership and a weight underflows. So an area of 0 means that
  /// no rule fires.
  bool zero_is_certain = true;
  std::size_t inputs = 0;
  std::array<double, kMostInputs> input_min{}, input_max{};
  double output_min = 0;
  double negligible = 0;  ///< the general path evaluates points with an area in (0, negligible]
  Table<ClosedForm> forms{memory};
  PointProgram point{memory};
  BatchProgram batch{memory};  ///< without fixed inputs
};

/// Makes the fast form from the tables of a model. Sets `usable` to false if the model exceeds a limit or a shape needs
/// the general path.
void makeProgram(const ModelTables& tables, Program& program);

/// A program for many points with some inputs fixed. `fixed`: one entry per input, a value inside its universe, or
/// empty if the input varies. Computes everything that depends on fixed inputs only, and drops the rules that cannot
/// fire.
BatchProgram specialized(const BatchProgram& program, std::span<const std::optional<double>> fixed,
                         std::pmr::memory_resource* memory);

}  // namespace tactus::fuzzy
