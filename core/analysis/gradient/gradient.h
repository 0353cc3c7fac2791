// The force and its derivatives with respect to all editable numbers: inputs, vertices of terms, rule weights.
//
// Slot: the index of one parameter in a gradient.
// Example: slot 0 holds dF/d(depth), slot 7 the derivative with respect to point b of the term `slow`.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

/// The force at one point and its partial derivatives. GradientModel::makeGradient makes it, `evaluate` fills it. Reuse
/// it for the next point: an evaluation clears only the values of the previous one.
class Gradient {
 public:
  double force_n = 0;  ///< as from CompiledModel::evaluate, up to rounding
  bool fired = false;

  /// N per unit of the parameter, by slot.
  std::span<const double> values() const noexcept { return {values_.data(), slot_count_}; }
  double operator[](std::size_t slot) const noexcept { return values_[slot]; }

 private:
  friend class GradientModel;
  friend class GradientSink;

  std::size_t slot_count_ = 0;
  std::vector<double> values_;          ///< one per slot, and a few spare ones
  std::vector<std::uint32_t> touched_;  ///< groups of slots that may be non-zero: the first `touched_count_` entries
  std::size_t touched_count_ = 0;
  bool all_touched_ = false;
};

/// The method for gradients.
enum class GradientMethod {
  kFastest,  ///< the closed form if the model has one
  kGeneral,  ///< always the general sweep, for comparison
};

struct GradientTables;

/// A force model prepared for gradients: immutable, cheap to copy, shared freely between threads.
/// One reverse pass gives all derivatives: from the centroid to the sets, from each strength to its winning rule, from
/// there to the smallest membership of that rule. It reads only the terms with a membership above 0 at the point, and
/// the rules of which all terms are such.
///
/// The derivatives are those of docs/semantics.md in real arithmetic, up to rounding. At a kink of the force the
/// derivative is one-sided:
/// - Equal memberships of a rule, equally strong rules of an output term, coinciding highest output sets: the first in
///   the model's order counts; the others have derivative 0.
/// - Input on a vertex of a term: the piece to the right; at the upper end of the universe the piece to the left.
/// - Input outside its universe: derivative 0 with respect to the input; the terms use the clamped value.
/// - Input on a vertical edge, where a membership jumps: the piece to the right; 0 if that is a plateau.
/// - Rule of strength 0, weight 0, or disabled: counts as absent, derivative 0.
/// - Vertical edge of an output term: each vertex moves in its possible direction, the outer one (a, d) outwards and
///   the inner one (b, c) inwards, which makes the edge a ramp. An outer vertex at the end of the universe has
///   derivative 0.
/// If several kinks coincide, each of these rules applies separately. If the choice depends on rounding (two strengths
/// or two sets within a few ulps), the result may be either side. If all experts abstain, the force is constant and all
/// derivatives are 0.
class GradientModel {
 public:
  /// Validates `model` and prepares it. Returns the error of fuzzy::validate if it is invalid.
  static base::Result<GradientModel> of(const fuzzy::ForceModel& model,
                                        GradientMethod method = GradientMethod::kFastest);

  std::size_t inputCount() const noexcept;
  std::size_t slotCount() const noexcept;
  /// A gradient of the right size for `evaluate`.
  Gradient makeGradient() const;

  /// Slot of an input: dF/d(input).
  std::size_t inputSlot(std::size_t input) const noexcept;
  /// The slot of point number `point` (index in Term::points) of a term in a variable's own list. All experts without
  /// their own list share it. `variable`: index of an input, or inputCount() for the output.
  std::size_t pointSlot(std::size_t variable, std::size_t term, std::size_t point) const noexcept;
  /// The slot in the list that `expert` uses: its own or the shared one.
  std::size_t pointSlot(std::size_t expert, std::size_t variable, std::size_t term, std::size_t point) const noexcept;
  /// Whether `expert` has its own list for `variable`.
  bool hasOwnTerms(std::size_t expert, std::size_t variable) const noexcept;
  /// The slot of a rule's weight. `rule`: index in Expert::rules.
  std::size_t weightSlot(std::size_t expert, std::size_t rule) const noexcept;
  /// Whether the closed form applies to `expert`, at points without extreme numbers. It requires: no Gaussians; ordered
  /// output terms that reach at most the second next one; no ramp cut by the universe or narrower than a thousandth of
  /// it. Other experts cost several times as much.
  bool hasClosedForm(std::size_t expert) const noexcept;

  /// Force and gradient at a point.
  /// `inputs`: inputCount() values in the order and units of the model's inputs. If one is not finite, the force and
  /// all derivatives are NaN and `fired` is false.
  /// `out`: from makeGradient() of this model or of one of the same shape. Reuse it for the next point, because only
  /// the slots of this and the previous point are written.
  /// Trapezoids and triangles in closed form; Gaussian output terms by quadrature, error 1e-12. A derivative beyond the
  /// range of double is infinite.
  /// Thread: any. Real-time safe: yes (no allocation, no lock, bounded time).
  void evaluate(std::span<const double> inputs, Gradient& out) const noexcept;
  /// The same with a new gradient, for a single point. Real-time safe: no.
  Gradient evaluate(std::span<const double> inputs) const;

 private:
  std::shared_ptr<const GradientTables> tables_;
};

}  // namespace tactus::analysis
