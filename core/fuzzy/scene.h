// A compiled model specialized for inputs that stay constant for a while.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/batch.h"
#include "core/fuzzy/compiled_model.h"

namespace tactus::fuzzy {

struct BatchProgram;

/// What a scene is made for. One point of a scene costs no less than a point of the model: its cost is the centroids,
/// not the rules that a scene could leave out (docs/numerics.md). Only a batch gains from tables of its own.
enum class SceneUse {
  kPoints,   ///< `evaluate` alone: nothing is specialized
  kBatches,  ///< `evaluateBatch` too: rules and memberships of the fixed inputs are folded
};

/// The force as a function of the inputs that still vary. Immutable; it keeps what it needs of the model, so the model
/// may go away.
class Scene {
 public:
  /// `fixed`: one entry per input of the model, a value where it is fixed, nothing where it varies. Any subset may be
  /// fixed, all or none included. Refused: a fixed value that is not finite.
  static base::Result<Scene> specialize(const CompiledModel& model, std::span<const std::optional<double>> fixed,
                                        SceneUse use = SceneUse::kBatches);

  std::size_t freeInputCount() const noexcept { return free_.size(); }

  /// The averaged force; `free_inputs` holds the varying inputs in the order of the model. The same bits as
  /// CompiledModel::evaluate.
  /// Thread: any. Real-time safe: yes.
  Evaluation evaluate(std::span<const double> free_inputs) const noexcept;

  /// The same at many points, as exactly as evaluateBatch, for a scene made for batches: one array per varying input,
  /// all as long as the results.
  /// Thread: any. Real-time safe: yes.
  void evaluateBatch(std::span<const std::span<const double>> free_inputs, BatchResult out) const noexcept;

 private:
  CompiledModel model_;
  std::shared_ptr<const BatchProgram> program_;  ///< null in a scene for points
  std::array<double, kMostInputs> point_{};      ///< all inputs, clamped; the fixed ones at their values
  std::vector<std::size_t> free_;                ///< indices of the varying inputs
};

}  // namespace tactus::fuzzy
