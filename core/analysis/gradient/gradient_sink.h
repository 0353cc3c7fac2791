// The output of the reverse pass.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <span>

#include "core/analysis/gradient/gradient.h"
#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

/// Largest number of slots of one term. Every list of slots has this many spare ones at its end.
inline constexpr std::size_t kSlotGroup = 4;

/// Writes one gradient: clears the values of the last evaluation, then adds.
class GradientSink {
 public:
  explicit GradientSink(Gradient& out) noexcept : out_(out), values_(out.values_.data()), end_(out.touched_.data()) {
    // Clears whole groups: the other slots in them are 0 or about to be cleared.
    for (std::size_t k = 0; k < out.touched_count_; ++k) std::fill_n(values_ + out.touched_[k], kSlotGroup, 0.0);
    if (out.all_touched_) std::fill(out.values_.begin(), out.values_.end(), 0.0);
    out.all_touched_ = false;
  }
  ~GradientSink() { out_.touched_count_ = static_cast<std::size_t>(end_ - out_.touched_.data()); }
  GradientSink(const GradientSink&) = delete;
  GradientSink& operator=(const GradientSink&) = delete;

  /// Announces additions to up to kSlotGroup slots from `first` on.
  void touch(std::size_t first) noexcept { *end_++ = static_cast<std::uint32_t>(first); }
  /// Adds to a slot of a touched group.
  void add(std::size_t slot, double value) noexcept { values_[slot] += value; }
  void addInput(std::size_t input, double value) noexcept { by_input_[input] += value; }

  /// Finishes with the derivatives with respect to the inputs that were not clamped.
  void finish(std::span<const double> inputs, std::span<const double> clamped) noexcept {
    for (std::size_t i = 0; i < inputs.size(); ++i) values_[i] = inputs[i] == clamped[i] ? by_input_[i] : 0;
  }
  /// Divides all derivatives. Call after `finish`.
  void divide(double divisor) noexcept {
    for (double& value : out_.values_) value /= divisor;
  }

  /// Sets all values of a gradient to NaN.
  static void fillWithNan(Gradient& out) noexcept {
    out.force_n = std::numeric_limits<double>::quiet_NaN();
    out.fired = false;
    std::fill(out.values_.begin(), out.values_.end(), out.force_n);
    out.all_touched_ = true;
  }

 private:
  Gradient& out_;
  double* values_;
  std::uint32_t* end_;  ///< of the touched groups
  std::array<double, fuzzy::kMostInputs> by_input_{};
};

}  // namespace tactus::analysis
