// The centroid of ordered output terms as polynomials in their strengths.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <optional>
#include <span>
#include <vector>

#include "core/fuzzy/force_model.h"
#include "core/fuzzy/membership.h"

namespace tactus::fuzzy {

inline constexpr std::size_t kLanes = 8;

/// Eight numbers side by side, one per term.
struct alignas(64) Lanes {
  double value[kLanes] = {};
};

/// Area and moment of a trapezoid clipped at s, positions from the lower end of the universe: area = s (width - s
/// half_taper), moment = area middle + s^2 (linear - s cubic). `Number` is a double, or one double per term.
/// For a scaled set, area = s width and moment = s middle; the rest is unused.
template <class Number>
struct Polynomial {
  Number width{}, half_taper{}, middle{}, linear{}, cubic{};
};

/// What two terms have in common: a trapezoid that is clipped at the least of both strengths and its own peak. Scaled
/// sets: a triangle between two ramps.
template <class Number>
struct Overlap {
  Polynomial<Number> shape;
  Number peak{};
  Number start{}, inverse_fall{}, inverse_rise{};  ///< scale only: the ramps
};

/// The output terms of one bank in their order on the universe; lane k is the k-th of them.
///
/// At each height the sets that are at least as strong form a chain of intervals in this order. So the area is the sum
/// of all areas, less what each one shares with the next that reaches this height: for neighbours their whole overlap,
/// for others the part of it above the strengths of all terms between.
struct ClosedForm {
  struct Pair {
    Overlap<double> overlap;
    std::uint16_t left = 0;
  };

  std::pmr::memory_resource* memory;
  std::pmr::vector<Polynomial<double>> terms{memory};
  std::pmr::vector<Pair> pairs{memory};  ///< those that overlap, ascending by their right term, then by the left one
  std::pmr::vector<std::uint32_t> first_pair{memory};  ///< of each right term, and the end
  std::pmr::vector<std::uint16_t> lane_of{memory};     ///< of each term of the bank

  /// The same with one lane per term, where that is enough: up to eight terms of which only neighbours overlap.
  struct SideBySide {
    Polynomial<Lanes> terms;
    Overlap<Lanes> overlaps;  ///< of each term with the next
  };
  bool fits_side_by_side = false;
  SideBySide side_by_side{};
};

/// Makes the closed form of a bank of output terms. False where the general sweep is needed: a Gaussian, terms without
/// an order, ramps cut by the universe, scaled sets that overlap beyond their ramps or their neighbours.
bool makeClosedForm(std::span<const MembershipFunction> terms, double lo, double hi, Implication implication,
                    ClosedForm& form);

}  // namespace tactus::fuzzy
