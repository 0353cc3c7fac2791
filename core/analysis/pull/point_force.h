// The force at one point while memberships, output terms or one rule are replaced, without compiling a model again.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/analysis/pull/pull_edit.h"
#include "core/fuzzy/force_model.h"
#include "core/fuzzy/membership.h"

namespace tactus::analysis {

/// A rule that takes part, with indices instead of names.
struct PointRule {
  struct Condition {
    std::size_t input;
    std::size_t term;  ///< in the expert's list
  };
  std::size_t index = 0;  ///< in Expert::rules
  std::vector<Condition> conditions;
  std::size_t then = 0;  ///< in the expert's output terms
  double weight = 1;
  double membership = 0;  ///< the smallest of the conditions at the point
};

/// One expert at the point.
struct PointExpert {
  double weight = 1;
  std::vector<std::vector<double>> memberships;  ///< per input, per term of the expert's list
  std::vector<PointRule> rules;
  std::vector<fuzzy::MembershipFunction> words;  ///< output terms
  std::vector<double> strengths;                 ///< per output term
  std::optional<double> force_n;                 ///< nothing: the expert abstains
};

/// Agrees with CompiledModel::evaluate to a few ulp. Nothing stands for a point at which no rule fires.
class PointForce {
 public:
  /// `model`: valid; it stays where it is as long as this object. `point`: inside the universes.
  PointForce(const fuzzy::ForceModel& model, std::span<const double> point);

  const fuzzy::ForceModel& model() const noexcept { return model_; }
  double at(std::size_t input) const noexcept { return point_[input]; }
  const std::vector<PointExpert>& experts() const noexcept { return experts_; }
  std::optional<double> now() const { return mean({}, {}); }

  /// The force of one expert with these strengths and words.
  std::optional<double> centroid(std::span<const double> strengths,
                                 std::span<const fuzzy::MembershipFunction> words) const;

  /// The mean if the experts `changed` (ascending) had the forces `forces`.
  std::optional<double> mean(std::span<const std::size_t> changed, std::span<const std::optional<double>> forces) const;

  /// The force with other words for the readers of the output list `list`.
  std::optional<double> withWords(std::span<const std::size_t> readers,
                                  std::span<const fuzzy::MembershipFunction> words) const;

  /// The force with rule number `rule` (in PointExpert::rules) of `expert` changed.
  std::optional<double> withRule(std::size_t expert, std::size_t rule, std::size_t then, double weight) const;

 private:
  const fuzzy::ForceModel& model_;
  std::vector<double> point_;
  std::vector<PointExpert> experts_;
};

/// The same with other memberships of the terms of one list of an input.
class MembershipProbe {
 public:
  MembershipProbe(const PointForce& point, const PulledList& list);

  /// `memberships`: one for each term of the list.
  std::optional<double> force(std::span<const double> memberships) const;

  /// The values of a membership, ascending, at which the force may bend: where it equals another membership or
  /// strength.
  std::vector<double> bends() const;

 private:
  struct Reader {
    struct Rule {
      std::size_t term;
      std::size_t then;
      double weight;
      double rest;  ///< the smallest membership of the other conditions; above 0
    };
    std::vector<Rule> rules;
    std::vector<double> strengths;  ///< of the rules without a condition on the input
  };

  const PointForce& point_;
  std::vector<std::size_t> reader_indices_;
  std::vector<Reader> readers_;
};

}  // namespace tactus::analysis
