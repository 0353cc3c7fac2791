// The fast form of a model: flat tables that the kernels read (kernels.h). Made by compile and specialise, never
// edited.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/fuzzy/force_model.h"
#include "core/fuzzy/membership.h"

namespace tactus::fuzzy {

struct ModelTables;

// Sizes up to which a model has a fast form; larger ones are evaluated by the general path alone.
inline constexpr std::size_t kBatch = 16;          ///< points that the batch kernel takes at once
inline constexpr std::size_t kMostConstants = 64;  ///< slots with a constant value
inline constexpr std::size_t kLanes = 8;           ///< output terms of one expert
inline constexpr std::size_t kGridCells = 256;     ///< of the table that finds a point's segment
inline constexpr std::size_t kMostSlots = 512;     ///< memberships and antecedents of one evaluation

/// Eight numbers side by side, one per output term.
struct alignas(64) Lanes {
  double value[kLanes] = {};
};

/// One input term that can be active: membership = min of two ramps, each cut to [0, 1].
struct FastTerm {
  std::uint16_t input = 0;
  std::uint16_t slot = 0;  ///< where its membership goes
  double a = 0, rise = 0;  ///< ramp (x - a) * rise; `rise` is rounded so that it reaches 1 where the core begins
  double d = 0, fall = 0;  ///< ramp (d - x) * fall
  bool has_rise = true;    ///< false where the term is 1 from the lower end of the universe on
  bool has_fall = true;
};

/// The centroid of up to eight ordered terms of which only neighbours overlap, as polynomials in their strengths.
/// Area of a trapezoid clipped at s: s (width - s half_taper); moment: area * middle + skew s^2 (half_width - s
/// third_taper), positions from the lower end of the universe. The same for the overlap of each term with the next,
/// clipped at the least of both strengths and its own peak. Scaled sets: area and moment are linear in s; an overlap is
/// a triangle between two ramps.
struct ClosedForm {
  Lanes width, half_taper, middle, skew, half_width, third_taper;
  Lanes overlap_width, overlap_half_taper, overlap_middle, overlap_skew, overlap_half_width, overlap_third_taper;
  Lanes overlap_peak;
  Lanes overlap_start, inverse_fall, inverse_rise;  ///< scale only: ramps of the overlap
  std::size_t count = 0;                            ///< output terms
};

/// Up to eight terms of one input side by side: their memberships go to eight slots in a row.
struct TermBlock {
  std::uint16_t input = 0;
  std::uint16_t slot = 0;   ///< of the first
  std::uint16_t count = 0;  ///< terms
  Lanes a, rise, d, fall;   ///< as in FastTerm; an absent ramp has its foot at infinity, an absent term is 0 everywhere
};

/// min of some memberships, for rules with more than two conditions: one slot that others can refer to.
struct Antecedent {
  std::uint16_t slot = 0;
  std::vector<std::uint16_t> of;  ///< slots
};

/// Rules that share one term of the pivot input: strength = weight * min(pivot, rest), for every rest.
struct Row {
  std::uint16_t pivot = 0;  ///< slot
  std::uint32_t first = 0;  ///< of the expert's rests and weights
  std::uint32_t count = 0;
};

/// One rule of the batch kernel: strength = weight * min(pivot, rest) for one output term.
struct FastRule {
  std::uint16_t rest = 0;  ///< slot
  double weight = 1;
};

/// Rules of one row and one output term.
struct RuleGroup {
  std::uint16_t pivot = 0;
  std::uint16_t lane = 0;
  std::uint32_t first = 0;  ///< of the expert's batch_rules
  std::uint32_t count = 0;
  bool unit_weights = true;  ///< then strength = min(pivot, largest rest)
};

struct FastExpert {
  double share = 1;  ///< weight relative to the sum of all weights
  std::uint16_t pivot_input = 0;
  std::vector<double> breakpoints;  ///< of the pivot input, ascending, infinity at the end
  double grid_start = 0;            ///< lower end of the pivot input's universe
  double cells_per_unit = 0;
  std::vector<std::uint16_t> first_segment;  ///< of each grid cell; the segment of a point is this one or a later one
  std::size_t rows_per_segment = 1;
  std::vector<std::uint32_t> segment_rows;  ///< rows that can be active between two breakpoints, rows_per_segment each
  std::vector<Row> rows;
  std::vector<std::uint16_t> rests;  ///< slots
  std::vector<Lanes> weights;        ///< one per rest; 0 where that output term has no such rule
  std::vector<RuleGroup> groups;
  std::vector<FastRule> batch_rules;
  std::size_t form = 0;  ///< index of the closed form
};

struct Kernels;

struct Program {
  const Kernels* kernels = nullptr;  ///< what runs it on this processor
  bool usable = false;               ///< false: the general path evaluates everything
  bool clip = true;
  /// No product of a membership and a weight underflows for ordinary inputs, so an area of 0 means that nothing fires.
  bool zero_is_certain = true;
  std::vector<std::uint16_t> varying;  ///< the inputs that terms read
  std::array<double, kMostInputs> input_min{}, input_max{};
  double output_min = 0;
  double negligible = 0;         ///< an area up to this, but not 0, is left to the general path
  std::vector<Lanes> constants;  ///< values of the first slots: 0, 1, then what else is constant
  std::size_t constant_count = 0;
  std::vector<FastTerm> terms;    ///< the same terms twice: for a batch,
  std::vector<TermBlock> blocks;  ///< and for one point
  std::vector<Antecedent> antecedents;
  std::vector<ClosedForm> forms;
  std::vector<FastExpert> experts;  ///< one per expert of the model
};

/// The fast form of the tables of a model. `fixed`: the values of inputs that do not vary, one entry per input; their
/// memberships become constants. Not usable where a limit is exceeded or a shape needs the general path.
Program makeProgram(const ModelTables& tables, std::span<const std::optional<double>> fixed);

/// The closed form of an expert's output terms, or nothing where the general sweep is needed: more than eight terms, a
/// Gaussian, terms without an order, overlaps beyond neighbours, ramps cut by the universe.
/// `lane_of` receives the lane of each term.
std::optional<ClosedForm> closedForm(std::span<const MembershipFunction> terms, double lo, double hi,
                                     Implication implication, std::vector<std::uint16_t>& lane_of);

}  // namespace tactus::fuzzy
