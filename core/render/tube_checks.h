// Scripted insertions, and what the hand feels in them: with these a tube that was written anew is compared.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::render {

/// The inputs of a model that is felt with the way and the rate of the tip free.
struct TubeInputs {
  std::size_t depth = 0;                ///< the way
  std::optional<std::size_t> speed;     ///< the rate; nothing: the force does not depend on it
  std::vector<std::size_t> conditions;  ///< all others, in the order of the model
};

/// Refused, with the reason: a model without a way, or with other units than mm, mm/s and N.
base::Result<TubeInputs> tubeInputs(const fuzzy::ForceModel& model);

/// What the hand does in one step.
struct TubeStep {
  double position_mm = 0;
  bool held = false;
  double dt_s = 0.001;
  std::vector<double> conditions;  ///< values of TubeInputs::conditions
};

/// What it feels after it.
struct TubeFeel {
  double force_n = 0;
  double depth_mm = 0;
  int phase = 0;  ///< 0 released, 1 stuck, 2 sliding
  unsigned stroke = 0;

  bool operator==(const TubeFeel&) const = default;
};

struct TubeTrace {
  std::string name;  ///< of letters, digits and `_`
  std::vector<TubeStep> steps;
};

/// A change of conditions within a trace fades in this time.
inline constexpr double kTraceFadeS = 0.05;
/// A tube slips at this force at the latest.
inline constexpr double kTubeCapN = 2;

/// Insertions in which each rule of the renderer shows: strokes with stops, fast and slow, withdrawal, the entry and
/// the end of the depth, a trembling hand, changes of the conditions in the hand, steps of other and of impossible
/// lengths, and a random hand. Then, for each event of the model, one that passes it, draws back, goes on, draws back
/// and passes it in the next stroke. Deterministic. `inputs`: of `model`, which is valid.
std::vector<TubeTrace> tubeTraces(const fuzzy::ForceModel& model, const TubeInputs& inputs);

/// One insertion by the renderer of this program, step by step; it begins at depth 0, out of the hand.
class TubeRun {
 public:
  /// `inputs`: of `model`. `compiled`: made from it.
  TubeRun(const fuzzy::ForceModel& model, TubeInputs inputs, fuzzy::CompiledModel compiled);
  ~TubeRun();
  TubeRun(TubeRun&&) noexcept;
  TubeRun& operator=(TubeRun&&) noexcept;

  /// Refused: conditions that are not finite.
  base::Result<TubeFeel> step(const TubeStep& step);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tactus::render
