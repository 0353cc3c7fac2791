// What a ForceSum keeps of its models, of a cell and of a part. Internal to it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/contracts/force_cells.h"

namespace tactus::contracts {

constexpr Mask bit(std::size_t place) { return Mask{1} << place; }

struct Flank {
  enum class Kind { kConstant, kLine, kGaussian } kind = Kind::kConstant;
  std::size_t variable = 0;
  double foot = 0, span = 1;  ///< a line is (x - foot) / span; of a Gaussian mean and sigma
  double weight = 1;
  Interval constant;

  bool operator==(const Flank& other) const {
    return kind == other.kind && weight == other.weight &&
           (kind == Kind::kConstant ? constant.low == other.constant.low && constant.high == other.constant.high
                                    : variable == other.variable && foot == other.foot && span == other.span);
  }

  /// A value at a point; six roundings at most are covered.
  Interval at(double x) const {
    if (kind == Kind::kConstant) return constant;
    if (kind == Kind::kLine) {
      const double v = std::clamp((x - foot) / span, 0.0, 1.0) * weight;
      return {std::max(0.0, down(down(down(v)))), std::min(weight, up(up(up(v))))};
    }
    const double u = (x - foot) / span;
    const double v = std::exp(-0.5 * u * u) * weight;
    const double error = v * (u * u + 8) * 0x1p-50 + 0x1p-1074;
    return {std::max(0.0, down(v - error)), std::min(weight, up(v + error))};
  }
  /// Over a range within one stretch, where it rises or falls.
  Interval over(const Interval& x) const { return hull(at(x.low), at(x.high)); }
  Interval slope(const Interval& x) const {
    if (kind == Kind::kConstant) return 0.0;
    const Interval w = weight;
    if (kind == Kind::kLine)
      return span > 0 ? w / (Interval(span) * Interval(down(1), up(1))) : -(w / Interval(down(-span), up(-span)));
    const Interval inverse = Interval(1) / span;
    return -((x - foot) * inverse * inverse * over(x));
  }
  /// The x of a line where its value lies in `value`, cut to `x`.
  Interval whereIn(const Interval& value, const Interval& x) const {
    if (kind != Kind::kLine) return x;
    const Interval share = value / Interval(weight);
    return common(x, Interval(foot) + share * Interval(span));
  }
};

/// What a condition is in a stretch: never, fully, or a flank.
struct Condition {
  enum class Kind { kNever, kFully, kFlank } kind = Kind::kNever;
  Flank flank;
};

struct ForceSum::Tables {
  struct Rule {
    double weight = 1;
    std::vector<std::pair<std::size_t, std::size_t>> conditions;  ///< variable, term among those of the variable
    std::size_t place = 0;                                        ///< of its output term
  };
  struct Expert {
    std::size_t copy = 0;
    double weight = 1;  ///< normalized
    std::vector<Rule> rules;
    std::optional<OutputSets> sets;
    std::vector<Interval> reach;  ///< of the output terms, from the lower end of the universe, by place
    const std::vector<fuzzy::Term>* output = nullptr;
    double low = 0, high = 0;  ///< that universe
  };
  std::vector<std::vector<fuzzy::MembershipFunction>>
      terms;  ///< of each variable, of all copies and experts, each once
  std::vector<Expert> experts;
};

struct ForceSum::Scratch {
  /// An expert that fires in the cell.
  struct Firing {
    const Tables::Expert* expert = nullptr;
    Interval share;
    bool cancels = false;                  ///< another copy's expert takes it off again
    std::vector<std::vector<Mask>> rules;  ///< by place of the output term: the flanks of each rule
  };
  std::vector<std::vector<Condition>> conditions;  ///< by variable and term, in the stretch taken
  std::vector<Flank> flanks;
  std::vector<Firing> firing;
  Interval constant;  ///< of the copies of which no expert fires

  // Of a part.
  std::vector<Interval> values;           ///< of the flanks
  std::array<Mask, kMostFlanks> at_most;  ///< for each flank those that are at least as large
  std::array<Mask, kMostFlanks> below;    ///< those that are at most as large, and lower in number if equal
  double undecided_by = 0;                ///< the common range of the two flanks of PartBounds::undecided
  std::vector<Mask> chosen;               ///< of an output term: for each rule that may be the largest its flanks

  // Of the output terms of one expert, by place.
  std::array<TermStrength, fuzzy::kMostTerms> strengths;
  std::array<Interval, fuzzy::kMostTerms> at_center;  ///< strengths at the middle of the part
  std::array<double, fuzzy::kMostTerms> middles;      ///< numbers within
  std::array<int, fuzzy::kMostTerms> single;          ///< the flank that a strength is; -1: one of several
  std::array<Smaller, fuzzy::kMostTerms> smaller;     ///< of a term and the next
  std::array<Interval, kMostVariables> slope;         ///< of the force, before the area divides it
};

}  // namespace tactus::contracts
