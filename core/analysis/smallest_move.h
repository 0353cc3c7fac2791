// The nearest place along one input at which something about the mean of the experts has changed. Internal to the
// counterfactuals.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/fuzzy/centroid.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"
#include "core/fuzzy/membership.h"

namespace tactus::analysis {

// The force and the word shares of one expert along one input, the other inputs kept. Internal to the counterfactuals.

// Polynomials of degree 6 through the values at the Chebyshev-Lobatto nodes of a stretch. Internal to the
// counterfactuals.

inline constexpr std::size_t kNodes = 7;

/// cos(pi (6 - j) / 6).
inline constexpr std::array<double, kNodes> kNodePlaces = {-1,  -0.86602540378443865, -0.5, 0,
                                                           0.5, 0.86602540378443865,  1};

/// Where a cubic is known: the nodes 0, 2, 4, 6.
inline constexpr std::array<double, 4> kCubicPlaces = {-1, -0.5, 0.5, 1};

/// The place of node `node` in [from, to]; the outer ones just within, as a limit is taken there.
inline double nodeAt(double from, double to, std::size_t node) {
  constexpr double kInside = 1e-9;
  const double share = std::clamp((1 + kNodePlaces[node]) / 2, kInside, 1 - kInside);
  return from + (to - from) * share;
}

/// Replaces the values at kNodePlaces by the coefficients of the polynomial through them, in
/// ascending powers of the place.
inline void toCoefficients(double* v) {
  // The even part is a cubic in the square of the place, the odd part a square times the place: divided differences.
  const double e0 = v[3], e1 = (v[4] + v[2]) / 2, e2 = (v[5] + v[1]) / 2, e3 = (v[6] + v[0]) / 2;
  const double e01 = (e1 - e0) * 4, e12 = (e2 - e1) * 2, e23 = (e3 - e2) * 4;
  const double e012 = (e12 - e01) / 0.75, e123 = (e23 - e12) / 0.75;
  const double e0123 = e123 - e012;
  const double o0 = v[4] - v[2], o1 = (v[5] - v[1]) / (2 * kNodePlaces[5]), o2 = (v[6] - v[0]) / 2;
  const double o01 = (o1 - o0) * 2, o12 = (o2 - o1) * 4;
  const double o012 = (o12 - o01) / 0.75;
  v[0] = e0;
  v[1] = o0 - o01 / 4 + o012 * 0.1875;
  v[2] = e01 - e012 / 4 + e0123 * 0.1875;
  v[3] = o01 - o012;
  v[4] = e012 - e0123;
  v[5] = o012;
  v[6] = e0123;
}

/// Weights of the values at kCubicPlaces in the cubic through them at `place` (Lagrange).
inline std::array<double, 4> cubicWeights(double place) {
  std::array<double, 4> out;
  for (std::size_t i = 0; i < 4; ++i) {
    out[i] = 1;
    for (std::size_t j = 0; j < 4; ++j) {
      if (j != i) out[i] *= (place - kCubicPlaces[j]) / (kCubicPlaces[i] - kCubicPlaces[j]);
    }
  }
  return out;
}

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

/// The experts that count along one input, and their mean: first the force, measured from the lower end of its
/// universe, then the share of each word.
class MeanLine {
 public:
  MeanLine(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled, std::size_t input,
           std::span<const double> point, std::span<const std::size_t> experts);

  /// The places at which a polynomial of some expert ends, and those at which a term has a vertical edge. Ascending.
  const std::vector<double>& places() const { return places_; }
  const std::vector<double>& edges() const { return edges_; }
  const std::vector<std::string>& words() const { return words_; }
  double width() const { return places_.back() - places_.front(); }

  /// The exact values at `x`; empty where all abstain.
  std::vector<double> at(double x) const;

  /// Takes the polynomials around `x`, which is no place. Returns false where all abstain.
  bool enter(double x);
  /// Bounds of the slopes of all polynomials taken.
  std::span<const double> slopes() const { return slopes_; }
  /// Their values: the force alone, or all.
  void polynomialsAt(double x, bool force_only, std::span<double> sums) const;

 private:
  struct Seat {
    ExpertLine line;
    double weight;
    std::vector<std::size_t> place;  ///< of each of its values among those of the mean
    std::size_t piece;               ///< where the search is
  };
  struct Moving {
    const ExpertLine::Piece* piece;
    const Seat* seat;
  };

  std::vector<Seat> seats_;
  std::vector<std::string> words_;
  std::vector<double> places_, edges_;
  double weights_ = 0;  ///< of those who fire around the place that was entered
  std::vector<double> slopes_;
  std::vector<double> constants_;  ///< the sums over those who do not vary there
  std::vector<Moving> moving_;     ///< the others
};

/// What a search looks for: that one of the excesses is 0 or more. They are sums of values of the mean, as shares of
/// the range of the force or of the area.
class Change {
 public:
  virtual ~Change() = default;
  virtual bool forceOnly() const = 0;
  virtual std::size_t excessCount() const = 0;
  virtual void excesses(std::span<const double> values, std::span<double> out) const = 0;
  /// Bounds of their slopes from those of the values.
  virtual void excessSlopes(std::span<const double> slopes, std::span<double> out) const = 0;
  /// Exactly at `x`. Not in a hole.
  virtual bool happened(double x) const = 0;
};

/// Branch and bound on the polynomials; what comes near is looked at exactly.
class MoveSearch {
 public:
  MoveSearch(MeanLine& line, const Change& change) : line_(line), change_(change) {}

  /// The nearest place from `now` on, in both directions, at which the change has happened.
  std::optional<double> nearest(double now);

 private:
  std::optional<double> along(double now, bool upward, double most);
  std::optional<double> firstWithin(double near, double far);
  std::optional<double> onlyCrossing(double near, double far);
  bool isWithinReach(double near, double far);
  void prepare();
  bool comesNear(double near, double far);
  double halvedFrom(double near, double after);
  double halved(double after) const;

  MeanLine& line_;
  const Change& change_;
  double before_ = 0;           ///< nearest place so far at which nothing has happened
  double varies_ = 0;           ///< how much the excesses that may reach 0 do in the stretch looked at
  double nearest_ = 0;          ///< the largest excess at its near end
  std::size_t candidates_ = 0;  ///< the number of excesses that may reach 0 there, and the last of them
  std::size_t candidate_ = 0;
  std::vector<double> values_, excesses_, highest_, lowest_;
  std::vector<double> at_nodes_;  ///< the excesses node by node
};

}  // namespace tactus::analysis
