// The fast form of a model: flat tables that the kernels read (kernels.h). Made by compile and specialise, never
// edited.
//
// Experts that share their input terms stand in one section. A section is evaluated by itself: its memberships go to
// slots, which the next section uses again.
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

inline constexpr std::size_t kBatch = 32;       ///< points that the batch kernel takes at once
inline constexpr std::size_t kTeam = 4;         ///< experts that the point kernel takes at once
inline constexpr std::size_t kGridCells = 256;  ///< of the table that finds a point's segment
/// Memberships and antecedents of one section; a model with a larger one is evaluated by the general path alone.
inline constexpr std::size_t kMostSlots = 1024;

// The first slots hold constants.
inline constexpr std::uint16_t kZeroSlot = 0;
inline constexpr std::uint16_t kOneSlot = 1;

/// A stretch of one of the flat tables.
struct Stretch {
  std::uint32_t first = 0;
  std::uint32_t count = 0;

  std::uint32_t end() const noexcept { return first + count; }
};

/// The tables of a model stand in memory that they share and that is given back as a whole.
template <class T>
using Table = std::pmr::vector<T>;

/// Makes room for `more` elements, and for many more where it has to move those that are there.
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

/// A trapezoid of an input: the lesser of two ramps, cut to [0, 1].
struct Ramps {
  double a = 0, rise = 0;  ///< (x - a) * rise; `rise` is rounded so that it reaches 1 where the core begins
  double d = 0, fall = 0;  ///< (d - x) * fall
  bool has_rise = true;    ///< false where the term is 1 from the lower end of the universe on
  bool has_fall = true;
};

/// The least of some memberships: what a rule asks besides its pivot term.
struct Antecedent {
  std::uint16_t slot = 0;
  Stretch of;      ///< slots
  double cap = 1;  ///< the least of those that are fixed
};

// ---- one point

/// Up to eight terms of one input side by side: their memberships go to eight slots in a row.
struct TermBlock {
  std::uint16_t input = 0;
  std::uint16_t slot = 0;   ///< of the first
  std::uint16_t count = 0;  ///< terms
  Lanes a, rise, d, fall;   ///< as in Ramps; an absent ramp has its foot at infinity
  Lanes height;             ///< 1; 0 for an absent term
};

/// What remains of a rule's conditions without its pivot term: strength = weight * min(pivot, rest).
struct Rest {
  std::uint16_t slot = 0;
  std::uint16_t lane = 0;  ///< in Layout::kSparse the output term that it strengthens
};

struct alignas(32) Weights {
  double value[kTeam] = {};
};

/// Experts with the same terms, at most kTeam. A weight is 0 where there is no such rule. The first expert takes the
/// places that are left too, with a share of 0.
struct Team {
  /// What stands for each rest.
  enum class Layout : std::uint8_t {
    kAlone,   ///< one expert: a weight for each of eight output terms
    kDense,   ///< at most eight output terms: for each of them a weight for each expert
    kSparse,  ///< the lane of one output term, and a weight for each expert
  };
  Layout layout = Layout::kSparse;
  std::uint16_t experts = 1;
  std::uint16_t lanes = 1;  ///< output terms
  std::uint32_t form = 0;
  std::uint32_t first_row = 0;  ///< rows[first_row + r] are the rests of pivot term r
  std::uint32_t first_rest = 0;
  std::uint32_t first_weight = 0;  ///< of its first rest
  Weights shares;                  ///< of each expert: weight relative to the sum of all weights
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

/// Where the segment of a point in this cell is: this one or a later one.
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
  Table<double> breakpoints{memory};  ///< of the pivot input, ascending, infinity at the end
  Table<GridCell> cells{memory};
  Table<std::uint16_t> segment_rows{
      memory};                          ///< rows that can be active between two breakpoints, rows_per_segment each
  Table<std::uint16_t> pivots{memory};  ///< slots
  Table<Team> teams{memory};            ///< all experts of the model, in an order of their own
  Table<Stretch> rows{memory};          ///< of rests
  Table<Rest> rests{memory};
  Table<Weights> weights{memory};
  Table<std::uint32_t> expert_at{memory};  ///< expert of the model for each seat: teams in order, experts in the team
};

// ---- many points

struct BatchTerm {
  Ramps ramps;
  std::uint16_t input = 0;
  std::uint16_t slot = 0;
  bool cap = true;  ///< cut at 1; a rest needs not be, because its pivot is
};

/// A slot with the same value at all points.
struct FixedSlot {
  std::uint16_t slot = 0;
  double value = 0;
};

struct BatchRule {
  std::uint16_t rest;  ///< slot
  double weight;
};

/// Rules of one pivot term and one output term.
struct RuleGroup {
  std::uint16_t pivot = 0;   ///< slot
  bool unit_weights = true;  ///< strength = min(pivot, largest rest)
  Stretch rules;
  double cap = 0;  ///< the largest rest of those that are fixed, with unit weights
};

/// An output term that some rule can reach.
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

/// Experts whose tables fit into a cache together. All points of a tile go through one chunk before the next, or the
/// tables of a thousand experts would be fetched from memory again for every few points.
struct BatchChunk {
  Stretch sections;  ///< that have experts of the chunk
  Stretch experts;   ///< of the whole program; the first chunk begins with the first expert
};

struct BatchProgram {
  std::pmr::memory_resource* memory;
  Table<BatchSection> sections{memory};
  Table<FixedSlot> fixed{memory};
  Table<BatchTerm> terms{memory};
  Table<Antecedent> antecedents{memory};
  Table<std::uint16_t> antecedent_slots{memory};
  Table<BatchExpert> experts{memory};  ///< those with a weight > 0
  Table<BatchLane> lanes{memory};
  Table<RuleGroup> groups{memory};
  Table<BatchRule> rules{memory};
  Table<BatchChunk> chunks{memory};  ///< all experts in order, at least one chunk; set by setChunks
};

/// Divides the experts of a program, which is complete otherwise, into chunks.
void setChunks(BatchProgram& program);

struct Kernels;

/// What all programs of a model share.
struct Program {
  std::pmr::memory_resource* memory;
  const Kernels* kernels = nullptr;  ///< what runs it on this processor; never null once made
  bool usable = false;               ///< false: the general path evaluates everything
  bool clip = true;
  /// No product of a membership and a weight underflows for ordinary inputs, so an area of 0 means that nothing fires.
  bool zero_is_certain = true;
  std::size_t inputs = 0;
  std::array<double, kMostInputs> input_min{}, input_max{};
  double output_min = 0;
  double negligible = 0;  ///< an area up to this, but not 0, is left to the general path
  Table<ClosedForm> forms{memory};
  PointProgram point{memory};
  BatchProgram batch{memory};  ///< with nothing fixed
};

struct ModelTables;

/// Makes the fast form of the tables of a model. Not usable where a limit is exceeded or a shape needs the general
/// path.
void makeProgram(const ModelTables& tables, Program& program);

/// A program for many points with some inputs fixed: one entry per input, a value in its universe or nothing. Whatever
/// depends on fixed inputs alone is computed here, and what cannot fire any more drops out.
BatchProgram specialised(const BatchProgram& program, std::span<const std::optional<double>> fixed,
                         std::pmr::memory_resource* memory);

}  // namespace tactus::fuzzy
