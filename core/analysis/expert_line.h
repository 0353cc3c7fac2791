// The force and the word shares of one expert along one input, the other inputs kept. Internal to the counterfactuals.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/analysis/piece_polynomial.h"
#include "core/fuzzy/centroid.h"
#include "core/fuzzy/force_model.h"
#include "core/fuzzy/membership.h"

namespace tactus::analysis {

/// Its values: the force, measured from the lower end of its universe, then the share of each output term of the
/// expert, in their order. Exact at any place (`at`), and as polynomials between the places where they bend or jump
/// (`pieces`). The strengths of the output terms bend at vertices and where two weighted memberships are equal; there a
/// share may jump.
class ExpertLine {
 public:
  /// The polynomials through the values at the Chebyshev-Lobatto nodes of [from, to]. They miss the values by about
  /// 1e-8 (of the universe of the force, of the area). The ends are limits from within.
  struct Piece {
    double from = 0;
    double to = 0;
    bool fires = false;
    bool constant = false;  ///< one coefficient for each value
    /// Value by value, kNodes of each, in ascending powers of `place`; none where the expert abstains.
    std::vector<double> coefficients;
    std::vector<double> steepest;  ///< value by value, no slope is larger; none if constant

    /// -1 at `from`, 1 at `to`.
    double place(double x) const noexcept { return ((x - from) - (to - x)) / (to - from); }
    /// Value number `v` at a place, of a piece that is not constant.
    double at(std::size_t v, double place) const noexcept {
      const double* const c = coefficients.data() + v * kNodes;
      double sum = c[kNodes - 1];
      for (std::size_t power = kNodes - 1; power-- > 0;) sum = sum * place + c[power];
      return sum;
    }
  };

  /// `point`: inside the universes.
  ExpertLine(const fuzzy::ForceModel& model, std::size_t expert, std::size_t input, std::span<const double> point);

  std::size_t valueCount() const noexcept { return 1 + functions_.size(); }
  /// The values with the input at `x`, exact to rounding; false where the expert abstains.
  bool at(double x, std::span<double> values) const;
  /// From one end of the universe to the other, ascending, each at least 1e-10 of it wide.
  const std::vector<Piece>& pieces() const noexcept { return pieces_; }

 private:
  /// A rule along the line: its strength is weight * min(ceiling, membership of `term`), times 2^512.
  struct LineRule {
    std::size_t term;  ///< of the input; kNoTerm: the rule does not look at it
    std::size_t then;
    double weight;
    double ceiling;  ///< smallest membership of the other conditions
  };

  void addRules(const fuzzy::ForceModel& model, const fuzzy::Expert& expert, std::size_t input,
                std::span<const double> point);
  void strengthsAt(double x, std::span<double> strengths) const;
  bool valuesOf(std::span<const double> strengths, std::span<double> values) const;
  void addHeights(std::vector<double>& levels) const;
  std::vector<double> bends() const;
  double slicesOf(std::span<const double> strengths, std::span<fuzzy::AreaAndMoment> slices) const;
  bool fit(Piece& piece) const;
  bool fitCubics(Piece& piece) const;
  bool agrees(const Piece& piece, double place, std::span<const double> values) const;
  bool isConstant(double from, double to) const;
  void addPieces(double from, double to, int halvings);

  fuzzy::Implication implication_;
  bool cubic_slices_ = false;
  double lo_, hi_;                                    ///< universe of the force
  double min_, max_;                                  ///< universe of the input
  std::vector<fuzzy::MembershipFunction> terms_;      ///< of the input
  std::vector<fuzzy::MembershipFunction> functions_;  ///< of the force
  std::vector<LineRule> rules_;
  std::vector<Piece> pieces_;
};

/// Ascending, each number once.
void sortOnce(std::vector<double>& numbers);

}  // namespace tactus::analysis
