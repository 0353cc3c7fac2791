// Evaluation of one compiled model at many points: curves, surfaces, exports.
#pragma once

#include <cstdint>
#include <span>

#include "core/fuzzy/compiled_model.h"

namespace tactus::fuzzy {

/// The output arrays of a batch. Both are as long as the input arrays.
struct BatchResult {
  std::span<double> force_n;      ///< as Evaluation::force_n
  std::span<std::uint8_t> fired;  ///< 1 or 0, as Evaluation::fired
};

/// The averaged force at every point.
/// `inputs`: one array per model input, in the order and units of the model. All arrays have the length of the results.
/// The forces agree with CompiledModel::evaluate to 4 ulp, `fired` exactly; out-of-range and non-finite inputs are
/// treated as there.
/// Thread: any. Real-time safe: yes.
void evaluateBatch(const CompiledModel& model, std::span<const std::span<const double>> inputs,
                   BatchResult out) noexcept;

}  // namespace tactus::fuzzy
