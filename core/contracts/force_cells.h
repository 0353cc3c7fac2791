// Certain bounds of the averaged force and of its slopes over boxes of inputs.
//
// Words of this folder:
// - Flank: what one membership is between two neighboring vertices, times the weight of its rule: a line, a part of a
//   Gaussian or a constant. Example: `depth is nasopharynx` between 60 and 80 mm is (x - 60) / 20.
// - Stretch of a variable: an open range between two vertices, or one vertex alone.
// - Cell: one stretch for each variable. In it each firing strength is a maximum of minimums of flanks, and the same
//   experts fire everywhere.
// - Part: a box within a cell, and what was decided there about the order of flanks. Example: "here the membership in
//   `well` is at most that in `nasopharynx`". With the order known a strength is one flank, and the centroid is a
//   closed form of the flanks.
// - Copy: one model at some of the variables. Two copies with opposite signs make a difference of forces.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/fuzzy/force_model.h"
#include "core/fuzzy/membership.h"

namespace tactus::contracts {

// Intervals of real numbers whose ends are rounded outward: what is computed with them is certain.
//
// Every operation widens its ends by one and a half of the last digit, which is more than the rounding to nearest can
// take away. No rounding mode is set, so no optimization can undo it.

/// At most `x` of real arithmetic, where `x` was computed with one rounding.
inline double down(double x) noexcept { return x - (std::abs(x) * 0x1.8p-52 + 0x1p-1074); }
inline double up(double x) noexcept { return x + (std::abs(x) * 0x1.8p-52 + 0x1p-1074); }

/// All numbers from `low` to `high`, both finite.
struct Interval {
  double low = 0;
  double high = 0;

  Interval() = default;
  Interval(double x) noexcept : low(x), high(x) {}
  Interval(double from, double to) noexcept : low(from), high(to) {}

  double middle() const noexcept { return std::clamp(low + (high - low) / 2, low, high); }
  double width() const noexcept { return high - low; }
  bool contains(double x) const noexcept { return low <= x && x <= high; }
  bool isZero() const noexcept { return low == 0 && high == 0; }
};

inline Interval operator-(const Interval& x) noexcept { return {-x.high, -x.low}; }
inline Interval operator+(const Interval& x, const Interval& y) noexcept {
  return {down(x.low + y.low), up(x.high + y.high)};
}
inline Interval operator-(const Interval& x, const Interval& y) noexcept { return x + -y; }
inline Interval operator*(const Interval& x, const Interval& y) noexcept {
  const double a = x.low * y.low, b = x.low * y.high, c = x.high * y.low, d = x.high * y.high;
  return {down(std::min(std::min(a, b), std::min(c, d))), up(std::max(std::max(a, b), std::max(c, d)))};
}
/// `y` above 0.
inline Interval operator/(const Interval& x, const Interval& y) noexcept {
  return {down(x.low / (x.low < 0 ? y.low : y.high)), up(x.high / (x.high < 0 ? y.high : y.low))};
}

/// The smallest interval around both.
inline Interval hull(const Interval& x, const Interval& y) noexcept {
  return {std::min(x.low, y.low), std::max(x.high, y.high)};
}
/// What both contain; `x` where rounding leaves nothing.
inline Interval common(const Interval& x, const Interval& y) noexcept {
  const Interval both{std::max(x.low, y.low), std::min(x.high, y.high)};
  return both.low <= both.high ? both : x;
}

/// The inputs of a model, and one of them a second time.
inline constexpr std::size_t kMostVariables = fuzzy::kMostInputs + 1;
inline constexpr std::size_t kMostFlanks = 64;  ///< of a cell; with more, nothing is bounded

// The closed form of the centroid of one expert's output terms, with intervals. Internal to the cells.

/// The firing strength of an output term in a part.
struct TermStrength {
  Interval value;
  std::array<Interval, kMostVariables> slope{};
};

/// Which of two neighboring output terms has the smaller strength.
enum class Smaller { kLeft, kRight, kUnknown };

class OutputSets {
 public:
  /// Nothing where the terms have no closed form: Gaussians, terms without an order, ramps cut off by the universe,
  /// overlaps beyond neighbors, and scaled sets that overlap beyond their ramps.
  static std::optional<OutputSets> of(std::span<const fuzzy::Term> terms, double low, double high,
                                      fuzzy::Implication implication);

  std::size_t size() const noexcept { return own_.size(); }
  /// The place of a term of the list in the order on the universe, which is that of all strengths below.
  std::size_t placeOf(std::size_t term) const noexcept { return place_[term]; }

  /// A range in which the part of the output set lies that term `k` adds, layer by layer: no force is below or above
  /// all ranges of the terms that fire.
  const Interval& reachOf(std::size_t k) const noexcept { return reach_[k]; }

  /// Area and first moment about `about`, both measured from the lower end of the universe. `smaller`: of each term
  /// and the next.
  struct Sums {
    Interval area, moment;
  };
  Sums sumsAt(std::span<const double> strengths, std::span<const Smaller> smaller, double about) const;
  /// What the moment about `about` + `beside` grows by with strength number `k`, as a rate.
  Interval rate(std::size_t k, std::span<const TermStrength> strengths, std::span<const Smaller> smaller, double about,
                const Interval& beside) const;

 private:
  /// The part of a trapezoid above each height `h`: `width - h taper` wide around `middle + h skew`, up to `top`.
  struct Layers {
    Interval width, taper, middle, skew;
    double top = 1;
    double fall = 0, rise = 0;  ///< of an overlap: of the ramps that make it
    double wide = 0;            ///< of an overlap; 0: there is none
  };
  struct Sum {
    Interval constant, linear, square, width, taper;
  };
  static Layers layersOf(double a, double b, double c, double d, double low);
  static void add(Sums& sums, const Layers& layers, double strength, double about, double sign);
  void addScaledOverlap(Sums& sums, std::size_t k, double left, double right, double about) const;
  Interval clippedRate(std::size_t k, const Interval& s, bool with_left, bool with_right, double about,
                       const Interval& beside) const;
  Interval scaledRate(std::size_t k, std::span<const TermStrength> strengths, double about,
                      const Interval& beside) const;

  bool clip_ = true;
  std::vector<Layers> own_;
  std::vector<Layers> overlap_;  ///< of each term with the next one
  std::vector<Interval> reach_;
  std::vector<std::size_t> place_;
};

/// One model in a sum of forces.
struct Copy {
  const fuzzy::ForceModel* model = nullptr;  ///< valid; outlives everything made of it
  double sign = 1;
  std::vector<std::size_t> variables;  ///< for each input the variable that it takes its value from
};

/// A range of a variable between neighboring vertices (open), or a vertex (low == high).
struct Stretch {
  double low = 0;
  double high = 0;
};

/// A box, one range for each variable.
using Box = std::array<Interval, kMostVariables>;

/// A set of flanks, by number.
using Mask = std::uint64_t;

/// A flank that is at most another one.
using Order = std::pair<std::uint8_t, std::uint8_t>;

struct Part {
  Box box{};
  std::vector<Order> orders;
};

/// What is known of the sum of forces in a part.
struct PartBounds {
  Interval value;                              ///< of the sum, in newtons
  Interval first;                              ///< of the first copy alone, where nothing of it cancels out
  std::array<Interval, kMostVariables> slope;  ///< along each variable, almost everywhere
  bool bounded = true;                         ///< false: some end of `slope` is only a sign, because areas may vanish
  std::optional<Order> undecided;              ///< the order of two flanks that would say more
  std::size_t widest = 0;                      ///< the variable along which memberships vary most
  double widest_by = 0;                        ///< by how much
};

/// A sum of averaged forces of models, each at some of the variables.
class ForceSum {
 public:
  /// `ranges`: of the variables, within the universes of the inputs that take them.
  ForceSum(std::vector<Copy> copies, std::vector<Interval> ranges);
  ~ForceSum();
  ForceSum(const ForceSum&) = delete;
  ForceSum& operator=(const ForceSum&) = delete;

  std::size_t variableCount() const noexcept { return ranges_.size(); }
  /// Whether a membership along this variable jumps at `vertex`.
  bool jumpsAt(std::size_t variable, double vertex) const noexcept;
  /// Vertices and open stretches in turn, with both ends of the range.
  std::vector<Stretch> stretches(std::size_t variable) const;

  /// Whether every expert of every copy fires at every point of the ranges.
  bool allFireEverywhere() const;
  /// A cell in which no expert of the first copy fires; nothing where some rule fires everywhere.
  std::optional<std::vector<Stretch>> silentCell() const;

  /// Takes the cell of these stretches, one for each variable; the other members speak of it. False where it has too
  /// many flanks.
  bool enter(std::span<const Stretch> cell);
  /// The whole cell.
  Part whole() const;
  /// For each copy the experts that fire, in the order of the copies and experts.
  const std::vector<bool>& firing() const noexcept { return firing_; }
  /// Whether each copy has an expert that fires.
  bool isForceEverywhere() const noexcept { return force_everywhere_; }

  /// Bounds for a part of the cell. Its box may shrink to where the orders hold. Nothing where they hold nowhere.
  std::optional<PartBounds> bounds(Part& part);

 private:
  struct Tables;
  struct Scratch;

  std::optional<std::array<double, kMostVariables>> pointIn(const Part& part) const;
  void cancelEqual();
  bool takePart(Part& part);
  void noteUndecided(std::size_t a, std::size_t b, PartBounds& out);
  void chooseFlanks(const std::vector<Mask>& rules);
  void findStrength(std::size_t term, const Part& part, std::span<const double> middle, PartBounds& out);
  void findSmaller(std::size_t terms, PartBounds& out);
  void addForce(std::size_t firing, bool middle_is_inner, PartBounds& out, Interval& centered);
  std::optional<std::vector<Stretch>> silentCellOf(std::size_t first, std::size_t last) const;

  std::vector<Copy> copies_;
  std::vector<Interval> ranges_;
  std::vector<std::vector<double>> vertices_;
  std::vector<std::vector<double>> jumps_;
  std::vector<bool> firing_;
  bool force_everywhere_ = true;
  std::vector<Stretch> cell_;
  std::unique_ptr<Tables> tables_;
  std::unique_ptr<Scratch> scratch_;
};

}  // namespace tactus::contracts
