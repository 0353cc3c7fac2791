// Evaluation of one compiled model at many points: curves, surfaces, exports.
#pragma once

#include <cstdint>
#include <span>

#include "core/fuzzy/compiled_model.h"

namespace tactus::fuzzy {

/// Where the results of a batch go: as many forces and flags as points.
struct BatchResult {
  std::span<double> force_n;      ///< as Evaluation::force_n
  std::span<std::uint8_t> fired;  ///< 1 or 0, as Evaluation::fired
};

/// The averaged force at every point. `inputs`: one array per input of the model, in its order and units, all as long
/// as the results. Policies as in CompiledModel::evaluate; the forces agree with it to 4 ulp, `fired` exactly. Thread:
/// any. Real-time safe: yes.
void evaluateBatch(const CompiledModel& model, std::span<const std::span<const double>> inputs,
                   BatchResult out) noexcept;

}  // namespace tactus::fuzzy
