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
/// `fired` is that of CompiledModel::evaluate, and the forces agree to 4 ulp with at most 16 experts. With more experts
/// they agree to 5/4 ulp for each of them: a batch adds up their forces one by one, a point four by four, and every
/// addition rounds. Out-of-range and non-finite inputs are treated as there.
/// Thread: any. Real-time safe: yes.
void evaluateBatch(const CompiledModel& model, std::span<const std::span<const double>> inputs,
                   BatchResult out) noexcept;

}  // namespace tactus::fuzzy
