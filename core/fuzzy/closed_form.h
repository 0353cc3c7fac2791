// The centroid of ordered output terms as polynomials in their strengths.
//
// Lane: the place of one number in a row of numbers that the processor works on at once.
// Here lane k belongs to the k-th output term of a bank, in the order of the terms on the universe.
// Example: terms low, medium, high have the lanes 0, 1, 2; lanes 3 to 7 hold 0.
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

/// Eight numbers side by side, one per lane.
struct alignas(64) Lanes {
  double value[kLanes] = {};
};

/// Area and moment of a trapezoid clipped at strength s, with positions measured from the lower end of the universe:
/// area = s (width - s half_taper), moment = area middle + s^2 (linear - s cubic).
/// A scaled set uses two coefficients only: area = s width, moment = s middle.
/// `Number` is a double, or one double per lane.
template <class Number>
struct Polynomial {
  Number width{}, half_taper{}, middle{}, linear{}, cubic{};
};

/// The common part of two terms. Clipped sets: a trapezoid, clipped at the least of both strengths and its own peak.
/// Scaled sets: a triangle between two ramps.
template <class Number>
struct Overlap {
  Polynomial<Number> shape;
  Number peak{};
  Number start{}, inverse_fall{}, inverse_rise{};  ///< scaled sets only: the two ramps
};

/// The output terms of one bank, in their order on the universe.
///
/// The sets that reach a given height form a chain of intervals in this order. So the total area is the sum of all
/// areas, minus the overlap of each set with the next set that reaches the same height. Neighbors share their whole
/// overlap. Other pairs share only the part of it above the strengths of all terms between them.
struct ClosedForm {
  struct Pair {
    Overlap<double> overlap;
    std::uint16_t left = 0;
  };

  std::pmr::memory_resource* memory;
  std::pmr::vector<Polynomial<double>> terms{memory};
  std::pmr::vector<Pair> pairs{memory};  ///< overlapping terms, ascending by right term, then by left term
  std::pmr::vector<std::uint32_t> first_pair{memory};  ///< first pair of each right term; then the count
  std::pmr::vector<std::uint16_t> lane_of{memory};     ///< lane of each term of the bank

  /// The same numbers with one lane per term. Possible for up to eight terms of which only neighbors overlap.
  struct SideBySide {
    Polynomial<Lanes> terms;
    Overlap<Lanes> overlaps;  ///< of each term with the next one
  };
  bool fits_side_by_side = false;
  SideBySide side_by_side{};
};

/// Makes the closed form of a bank of output terms on the universe [lo, hi]. Returns false if the bank needs the
/// general path: it has a Gaussian, terms without an order, ramps cut off by the universe, or scaled sets that overlap
/// beyond their ramps or their neighbors.
bool makeClosedForm(std::span<const MembershipFunction> terms, double lo, double hi, Implication implication,
                    ClosedForm& form);

}  // namespace tactus::fuzzy
