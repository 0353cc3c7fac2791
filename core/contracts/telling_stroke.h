// The stroke that tells two models apart: the insertion in which a hand feels the largest difference between them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::contracts {

/// An insertion: minimum jerk from one depth to a larger one (Flash and Hogan 1985), the other inputs kept.
struct Stroke {
  double from_mm = 0;
  double to_mm = 0;
  double peak_mm_s = 0;        ///< speed in the middle; the mean is 8/15 of it
  std::vector<double> inputs;  ///< one value for each input of the models; those of depth and speed are not used

  bool operator==(const Stroke&) const = default;
};

/// A moment of a stroke.
struct StrokeMoment {
  double time_s = 0;
  double depth_mm = 0;
  double speed_mm_s = 0;
};
/// After the share `done` of its time, [0, 1].
StrokeMoment momentOf(const Stroke& stroke, double done);

/// The inputs that a stroke moves.
struct StrokeInputs {
  std::size_t depth = 0;
  std::optional<std::size_t> speed;
};
/// The inputs with the ids `depth` and `speed`. Refused: a model without the former.
base::Result<StrokeInputs> strokeInputs(const fuzzy::ForceModel& model);

/// What hands and devices do: the strokes that are looked at.
struct StrokeLimits {
  double slowest_mm_s = 5;
  double fastest_mm_s = 250;
  double shortest_mm = 30;  ///< or the whole depth of the models where that is less
  double device_n = 3.3;    ///< largest force that the device gives; strokes with more of it are left out
};

/// How two models differ along a stroke, over its time.
struct StrokeFeel {
  double rms_jnd = 0;  ///< root mean square of the difference, in just-noticeable ones around the first force
  double largest_jnd = 0;
  double largest_n = 0;    ///< second minus first force there
  double at_mm = 0;        ///< the depth there
  double peak_n = 0;       ///< largest force of either model
  std::size_t silent = 0;  ///< of the places, those at which a model has no force; left out
};
StrokeFeel feelOf(const fuzzy::CompiledModel& first, const fuzzy::CompiledModel& second, const StrokeInputs& inputs,
                  const Stroke& stroke);

struct TellingStroke {
  Stroke stroke;
  StrokeFeel feel;
  /// At no place with a speed up to the fastest the models differ by more, certainly, and so no stroke either; nothing
  /// if that was not asked for, or cannot be said.
  std::optional<double> bound_jnd;
  std::size_t parts = 0;  ///< of the input space that were bounded
};

struct TellEffort {
  bool bound = true;
  std::size_t parts = 60'000;
  std::function<void(double share)> progress = {};  ///< called now and then by the searching thread; [0, 1], rising
};

/// Searches the telling stroke: places where the models differ most, strokes through them, climbs. Deterministic.
/// Refused: models with other inputs, or without a depth. Thread: any.
base::Result<TellingStroke> tell(const fuzzy::ForceModel& first, const fuzzy::CompiledModel& compiled_first,
                                 const fuzzy::ForceModel& second, const fuzzy::CompiledModel& compiled_second,
                                 const StrokeLimits& limits = {}, const TellEffort& effort = {},
                                 const std::stop_token& stop = {});

}  // namespace tactus::contracts
