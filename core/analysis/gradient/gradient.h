// The force and its derivatives with respect to everything an editor can move: inputs, vertices of terms, rule weights.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

/// The force at one point and its partial derivatives there. Made by GradientModel::makeGradient, filled by evaluate,
/// and meant to be used again and again: an evaluation clears only what the one before it wrote.
class Gradient {
 public:
  double force_n = 0;  ///< as CompiledModel::evaluate gives it, up to rounding
  bool fired = false;

  /// Newtons per unit of the parameter, by slot.
  std::span<const double> values() const noexcept { return {values_.data(), slot_count_}; }
  double operator[](std::size_t slot) const noexcept { return values_[slot]; }

 private:
  friend class GradientModel;
  friend class GradientSink;

  std::size_t slot_count_ = 0;
  std::vector<double> values_;          ///< and some to spare
  std::vector<std::uint32_t> touched_;  ///< groups of slots that may hold something, the first `touched_count_` of them
  std::size_t touched_count_ = 0;
  bool all_touched_ = false;
};

/// How gradients are computed.
enum class GradientMethod {
  kFastest,  ///< the closed form where the model has one
  kGeneral,  ///< the general sweep everywhere: to compare with
};

struct GradientTables;

/// A force model prepared for gradients: immutable, cheap to copy, shared freely between threads. One reverse pass
/// gives all derivatives: from the centroid to the sets, from each strength to its winning rule, from there to the
/// smallest membership of that rule. Only terms whose membership is not 0 at the point, and rules all of whose terms
/// are such, are looked at.
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
/// Where kinks meet (rules that tie, for an output term that ties with another) each of these choices is made by
/// itself. Where the choice hangs on rounding (two strengths or two sets within a few ulps of each other) either side
/// may come. Where all experts abstain the force is constant and all derivatives are 0.
class GradientModel {
 public:
  /// Validates `model` and prepares it. The error is that of fuzzy::validate.
  static base::Result<GradientModel> of(const fuzzy::ForceModel& model,
                                        GradientMethod method = GradientMethod::kFastest);

  std::size_t inputCount() const noexcept;
  std::size_t slotCount() const noexcept;
  /// A gradient of the right size for `evaluate`.
  Gradient makeGradient() const;

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
  /// Whether `expert` has the closed form, at points where no number is extreme: no Gaussians; output terms that are
  /// ordered, none of which reaches beyond the second next one, and no ramp of which is cut by the universe or narrower
  /// than a thousandth of it. Others cost several times as much.
  bool hasClosedForm(std::size_t expert) const noexcept;

  /// Force and gradient at a point. `inputs`: inputCount() values in the order and units of the model's inputs. `out`
  /// comes from makeGradient() of this model, or of another one of the same shape, and is best used again for the next
  /// point: only the slots that this point and the one before it touch are written. If an input is not finite, the
  /// force and all derivatives are NaN and `fired` is false. Trapezoids and triangles in closed form; Gaussian output
  /// terms by quadrature to 1e-12. A derivative beyond the range of double is infinite.
  /// Thread: any. Real-time safe: yes (no allocation, no lock, bounded time).
  void evaluate(std::span<const double> inputs, Gradient& out) const noexcept;
  /// The same into a gradient made for it: for a single point. Real-time safe: no.
  Gradient evaluate(std::span<const double> inputs) const;

 private:
  std::shared_ptr<const GradientTables> tables_;
};

}  // namespace tactus::analysis
