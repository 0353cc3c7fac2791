// Derivatives of the force in exact rational arithmetic, by difference quotients with a vanishing step. Only for tests.
#pragma once

#include <cstddef>
#include <gmpxx.h>
#include <optional>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::reference {

/// A number of a model, or of the point where it is evaluated, that can move.
struct Parameter {
  enum class Kind { kInput, kPoint, kWeight };
  Kind kind = Kind::kInput;
  std::optional<std::size_t> expert;  ///< of a weight or of a point in an expert's own list
  std::size_t variable = 0;           ///< input, or the number of inputs for the output
  std::size_t index = 0;              ///< term or rule
  std::size_t point = 0;              ///< in Term::points
};

/// A one-sided derivative.
struct ExactDerivative {
  mpq_class value;
  /// The size of what cancels in `value`: range of the output times the sum over the experts of share in the mean *
  /// |d ln(area of the output set)|. F is moment / area, so dF = (dmoment - F darea) / area, and both terms are at most
  /// about this large.
  mpq_class scale;
  bool jump = false;  ///< the force is not continuous in this direction
};

/// The slow, obvious forward differences at one point. Trapezoids and triangles only. The step is so much smaller than
/// all distances in the model that the quotient differs from the limit by less than 1e-15 of it.
class ExactGradient {
 public:
  ExactGradient(const fuzzy::ForceModel& model, const std::vector<double>& inputs);

  /// The force, nothing where all experts abstain.
  const std::optional<mpq_class>& force() const { return force_; }
  /// Whether two candidates for one choice are equal or closer than `relative`: the smallest memberships of a rule, the
  /// strongest rules of an output term, the strengths of two output terms of an expert.
  bool tied(double relative) const;
  /// Every parameter of the model, and the inputs.
  std::vector<Parameter> parameters() const;
  /// The derivative to the right (direction 1) or to the left (-1), after `parameter` has been moved by `offset`.
  /// Nothing where the parameter cannot move that way because its points would lose their order. Weights may leave
  /// [0, 1]: the semantics go on, with a rule of negative strength never the largest.
  std::optional<ExactDerivative> derivative(const Parameter& parameter, int direction, double offset = 0) const;

 private:
  struct Trapezoid {
    mpq_class a, b, c, d;
    bool triangle = false;
    mpq_class at(const mpq_class& x) const;
    bool ordered() const { return a <= b && b <= c && c <= d; }
  };
  struct Rule {
    std::vector<std::pair<std::size_t, std::size_t>> conditions;  ///< input, term
    std::size_t then = 0;
    mpq_class weight;
    bool enabled = true;
  };
  struct Expert {
    mpq_class weight;
    std::vector<std::size_t> bank;
    std::vector<Rule> rules;
  };
  struct State {
    std::vector<mpq_class> inputs;
    std::vector<std::vector<Trapezoid>> banks;
    std::vector<Expert> experts;
  };
  struct Centroid {
    bool fired = false;
    std::vector<mpq_class> strengths;
    mpq_class area, force;
  };

  bool move(State& state, const Parameter& parameter, const mpq_class& by) const;
  std::size_t bankOf(const Parameter& parameter) const;
  /// Smallest distance that matters to a parameter of `variable`: between vertices, ends of the universe and the input.
  mpq_class smallestDistance(const State& state, std::size_t variable) const;
  mpq_class stepFor(const Parameter& parameter, const State& state, const std::vector<Centroid>& centroids) const;
  /// Whether `parameter` is one of the numbers that expert `e` is computed from.
  bool concerns(const Parameter& parameter, std::size_t e) const;
  /// Centroids of all experts. Where `state` differs from that of `known` in `changed` only, those of the experts that
  /// it does not concern, or whose strengths and output terms stay, are taken over.
  std::vector<Centroid> centroids(const State& state, const Parameter* changed,
                                  const std::vector<Centroid>* known) const;
  std::optional<mpq_class> mean(const std::vector<Centroid>& centroids) const;

  std::vector<mpq_class> min_, max_;  ///< of the inputs and the output
  bool clip_ = true;
  std::vector<std::vector<std::size_t>> own_bank_;  ///< of each expert and variable, 0 where there is none
  State state_;
  std::vector<Centroid> centroids_;
  std::vector<mpq_class> smallest_;  ///< smallestDistance of state_, by variable
  std::optional<mpq_class> force_;
};

}  // namespace tactus::reference
