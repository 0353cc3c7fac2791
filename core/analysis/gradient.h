// The force and its derivatives with respect to everything an editor can move: inputs, vertices of terms, rule weights.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "core/fuzzy/membership.h"

namespace tactus::analysis {

/// The force at one point and its partial derivatives there.
struct Gradient {
  double force_n = 0;  ///< as CompiledModel::evaluate gives it, up to rounding
  bool fired = false;
  std::vector<double> values;  ///< newtons per unit of the parameter, by slot
};

/// A force model prepared for gradients: immutable, shared freely between threads. One reverse pass gives all
/// derivatives: from the centroid to the sets, from each strength to its rule, from there to one membership.
///
/// The derivatives are those of docs/semantics.md in real arithmetic, up to rounding. The force has kinks; there the
/// derivative is one-sided:
/// - smallest membership of a rule, largest rule of an output term, highest of several output sets that coincide: the
///   first in the model's order counts, the others have derivative 0.
/// - input on a vertex of a term: the piece to the right, and at the upper end of the universe the piece to the left.
/// - input outside its universe: derivative 0 with respect to the input; the terms feel the clamped value.
/// - membership that jumps (an input on a vertical edge): the piece to the right, for a plateau 0.
/// - rule of strength 0, also of weight 0 or disabled: counts as absent, derivative 0.
/// - vertical edge of an output term: each vertex moves to where it can go: the outer one (a, d) outwards and the inner
///   one (b, c) inwards, which turns the edge into a ramp. An outer vertex on the border of the universe has
///   derivative 0.
/// Where the choice hangs on rounding (two strengths or two sets within a few ulps of each other) either side may come.
/// Where all experts abstain the force is constant and all derivatives are 0.
class GradientModel {
 public:
  /// Validates `model` and prepares it. The error is that of fuzzy::validate.
  static base::Result<GradientModel> of(const fuzzy::ForceModel& model);

  std::size_t inputCount() const noexcept { return input_min_.size(); }
  std::size_t slotCount() const noexcept { return slot_count_; }
  /// A gradient of the right size for `evaluate`.
  Gradient makeGradient() const { return {0, false, std::vector<double>(slot_count_)}; }

  /// Slot of an input: dF/d(input).
  std::size_t inputSlot(std::size_t input) const noexcept;
  /// Slot of point `point` (its index in Term::points) of a term in a variable's own list, which all experts without a
  /// list of their own share. `variable` is the index of an input, or inputCount() for the output.
  std::size_t pointSlot(std::size_t variable, std::size_t term, std::size_t point) const noexcept;
  /// The same in the list that `expert` uses: the expert's own, or the shared one.
  std::size_t pointSlot(std::size_t expert, std::size_t variable, std::size_t term, std::size_t point) const noexcept;
  /// Whether `expert` has a list of its own for `variable`.
  bool hasOwnTerms(std::size_t expert, std::size_t variable) const noexcept;
  /// Slot of the weight of a rule, by its index in Expert::rules.
  std::size_t weightSlot(std::size_t expert, std::size_t rule) const noexcept;

  /// Force and gradient at a point. `inputs`: inputCount() values in the order and units of the model's inputs. `out`
  /// comes from makeGradient(). If an input is not finite, the force and all derivatives are NaN and `fired` is false.
  /// Trapezoids and triangles in closed form; Gaussian output terms by quadrature to 1e-12. A derivative beyond the
  /// range of double is infinite. Thread: any. Real-time safe: yes (no allocation, no lock, bounded time).
  void evaluate(std::span<const double> inputs, Gradient& out) const noexcept;

 private:
  /// A list of terms of one variable. The slots of a term are those of a, b, c, d (b and c of a triangle share one), or
  /// of mean and sigma.
  struct Bank {
    std::vector<fuzzy::MembershipFunction> functions;
    std::vector<std::array<std::uint32_t, 4>> slots;
    std::vector<std::uint32_t> first_slot;
  };
  struct Condition {
    std::uint8_t input;
    std::uint8_t term;
  };
  struct Rule {
    std::uint32_t first_condition;
    std::uint16_t condition_count;
    std::uint16_t then;
    std::uint32_t slot;
    double weight;
  };
  struct Expert {
    double weight = 1;                ///< relative to the largest weight
    std::vector<std::uint32_t> bank;  ///< one per input, then that of the output
    std::uint32_t first_rule_slot = 0;
    std::vector<Rule> rules;  ///< enabled rules with a weight > 0 only
    std::vector<Condition> conditions;
  };
  struct Fuzzified;
  struct Winners;

  Bank makeBank(const std::vector<fuzzy::Term>& terms);
  Expert makeExpert(const fuzzy::ForceModel& model, const fuzzy::Expert& expert);
  bool fire(const Expert& expert, std::span<const double> clamped, Fuzzified& fuzzified,
            Winners& winners) const noexcept;
  /// Adds weight * dF/dparameter of one expert; returns the force measured from the lower end of the universe.
  double addExpert(const Expert& expert, std::span<const double> clamped, const Fuzzified& fuzzified,
                   const Winners& winners, std::span<double> values) const noexcept;
  /// The first condition with the smallest membership.
  static const Condition& smallestOf(const Rule& rule, const Expert& expert, const Fuzzified& fuzzified) noexcept;
  /// Adds to the input and the points of a term what `log_derivative`, that of the force with respect to the logarithm
  /// of the membership, makes of them.
  void addCondition(const Expert& expert, const Condition& condition, std::span<const double> clamped,
                    double log_derivative, std::span<double> values) const noexcept;

  std::vector<double> input_min_;
  std::vector<double> input_max_;
  double output_min_ = 0;
  double output_max_ = 1;
  double default_force_n_ = 0;
  fuzzy::Implication implication_ = fuzzy::Implication::kClip;
  std::size_t slot_count_ = 0;
  std::vector<Bank> banks_;  ///< first those of the inputs and of the output, then the experts' own
  std::vector<Expert> experts_;
};

}  // namespace tactus::analysis
