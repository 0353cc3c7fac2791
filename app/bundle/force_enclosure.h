// The force and its derivatives over a box of the inputs, enclosed by interval arithmetic.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "core/fuzzy/force_model.h"
#include "core/fuzzy/membership.h"

namespace tactus::bundle {

inline constexpr std::size_t kParts = 64;  // of the universe of the output

/// From `lo` to `hi`, both included.
struct Range {
  double lo = 0;
  double hi = 0;

  Range& operator+=(const Range& other) {
    lo += other.lo;
    hi += other.hi;
    return *this;
  }
};

/// Lets `range` reach `value`.
inline void include(Range& range, double value) {
  range.lo = std::min(range.lo, value);
  range.hi = std::max(range.hi, value);
}

/// A membership and its derivative over an open interval.
struct Membership {
  Range value;
  Range slope;
  bool jumps = false;
};

/// A list of terms of one input, shared by the experts who have it.
struct Bank {
  std::size_t input = 0;
  const std::vector<fuzzy::Term>* list = nullptr;
  std::vector<fuzzy::MembershipFunction> terms;
};

/// The terms of the force, over equal parts of its universe.
struct OutputBank {
  const std::vector<fuzzy::Term>* list = nullptr;
  std::vector<std::array<double, kParts>> lowest, highest;  ///< membership within each part
  std::vector<std::size_t> first, last;                     ///< the parts in which it is above 0 at all; last excluded
};

struct RuleLook {
  double weight = 1;
  std::size_t then = 0;
  std::vector<std::pair<std::size_t, std::size_t>> conditions;  ///< bank, term
};

struct ExpertLook {
  double weight = 1;
  std::size_t output = 0;
  std::vector<RuleLook> rules;
};

/// The force over a box: where it lies, and its derivatives if they are bounded.
struct ForceRange {
  Range force_n;
  std::array<Range, fuzzy::kMostInputs> slopes{};
  bool smooth = true;  ///< every expert who counts fires everywhere in the box, and nothing jumps
  bool fires = false;  ///< some expert may
};

/// The limits of a membership at `x` from above and from below: a vertical edge has two.
double fromTheRight(const fuzzy::MembershipFunction& f, double x);
double fromTheLeft(const fuzzy::MembershipFunction& f, double x);

/// A membership over the open interval from `lo` to `hi`.
Membership over(const fuzzy::MembershipFunction& f, double lo, double hi);

/// What is known of a box is enclosed: the truth lies within, however the box is divided.
class ForceEnclosure {
 public:
  explicit ForceEnclosure(const fuzzy::ForceModel& model);

  const std::vector<Bank>& banks() const { return banks_; }
  std::size_t experts() const { return experts_.size(); }

  /// Whether the rules that may fire in the cell are few is decided once per cell.
  struct Cell {
    std::vector<std::vector<const RuleLook*>> rules;  ///< of each expert
  };

  void lookAt(std::span<const double> lo, std::span<const double> hi, std::vector<std::vector<Membership>>& out) const;

  void cellOf(const std::vector<std::vector<Membership>>& memberships, Cell& cell) const;

  ForceRange enclose(const Cell& cell, const std::vector<std::vector<Membership>>& memberships) const;

 private:
  /// One expert over a box.
  struct One {
    Range force_n;
    std::array<Range, fuzzy::kMostInputs> slopes{};
    bool may_fire = false;
    bool certain = false;
    bool smooth = true;
  };

  void addExpert(const fuzzy::Expert& expert, double weight);

  std::size_t bankOf(std::size_t input, const std::vector<fuzzy::Term>& list);

  double partEnd(std::size_t part) const;

  std::size_t outputBankOf(const std::vector<fuzzy::Term>& list);

  /// The strength of one output term over a box.
  struct Strength {
    std::size_t term = 0;
    Range value;
    std::array<Range, fuzzy::kMostInputs> slopes{};
    bool smooth = true;
  };

  /// The terms that may fire, in `strengths`; how many.
  std::size_t strengthsOf(const std::vector<const RuleLook*>& rules,
                          const std::vector<std::vector<Membership>>& memberships, std::span<Strength> strengths) const;

  void encloseExpert(const ExpertLook& expert, const std::vector<const RuleLook*>& rules,
                     const std::vector<std::vector<Membership>>& memberships, One& out) const;

  /// The parts of the output that are looked at, and the heights of the set there: the two largest of the terms'.
  struct Heights {
    std::size_t first = kParts;
    std::size_t last = 0;
    std::array<double, kParts> lowest, highest, second_lowest, second_highest;
  };

  template <bool clip>
  void encloseCentroid(const OutputBank& bank, std::span<const Strength> strengths, One& out) const;

  /// Where the centroid of a set between the two can lie, from the lower end of the universe: it is largest for the
  /// upper set beyond some point and the lower one before it. `area`: of the set, in parts.
  Range centroidOf(const Heights& set, Range& area) const;

  const fuzzy::ForceModel& model_;
  std::vector<Bank> banks_;
  std::vector<OutputBank> outputs_;
  std::vector<ExpertLook> experts_;
  static inline thread_local std::vector<Strength> scratch_;
};

}  // namespace tactus::bundle
