// One recorded stroke through two models: the hand as recorded, the force of either model in the same renderer, and the
// difference in newtons and in just-noticeable differences. Open loop: the hand does not answer to the other force.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "app/editing/edit.h"
#include "app/replay/recorded_strokes.h"
#include "core/base/error.h"
#include "core/render/renderer_state.h"

namespace tactus::replay {

/// The ticks of a stroke with both forces. All of one length, at least 2.
struct StrokeTrace {
  std::span<const double> time_s;      ///< rising
  std::span<const double> path_mm;     ///< of the hand, inward positive
  std::span<const double> depth_mm;    ///< of the tube in the model before: names places
  std::span<const double> force_n[2];  ///< before, after
};

/// All integrals by the trapezoid rule over the samples, ends included; a share counts half of the interval beside a
/// sample.
struct StrokeNumbers {
  double peak_n[2] = {};  ///< before, after
  double largest_n = 0;   ///< largest |difference|
  double largest_at_mm = 0;
  std::size_t largest_tick = 0;
  double rms_n = 0;        ///< over time
  double mean_n = 0;       ///< after minus before, over time
  double work_mj[2] = {};  ///< ∫F dx over forward motion of the hand
  double time_share = 0;   ///< with |difference| above one just-noticeable difference around the force before
  double path_share = 0;   ///< the same of the path of the hand, both ways
  double noticeable = 0;   ///< largest |difference| in just-noticeable differences
  double noticeable_at_mm = 0;
  double noticeable_by_n = 0;  ///< after minus before there

  bool operator==(const StrokeNumbers&) const = default;
};
StrokeNumbers numbersOf(const StrokeTrace& trace);

/// A stroke through one model.
struct StrokeRun {
  /// The renderer's question to the model at a tick, and the answer.
  struct Answer {
    std::size_t tick = 0;
    render::ForcePoint point;
    render::ModelForce force;
  };
  std::vector<double> force_n;   ///< per tick
  std::vector<double> depth_mm;  ///< of the tube, with the offset of the model
  std::vector<Answer> answers;
  std::optional<double> hole_mm;  ///< no rule fires there, and the renderer would hold the last force
};

/// Values of the conditions that a stroke has no recorded value for, by id of the input.
using Conditions = std::map<std::string, double>;

/// Runs `stroke` through `model`. Refused: what the servo refuses (haptics::ServoScene::make), a condition that neither
/// the stroke nor `otherwise` has. Thread: any.
base::Result<StrokeRun> runStroke(const RecordedStroke& stroke, const editing::ReadyModel& model,
                                  const Conditions& otherwise);

/// A stroke through a model before and after a change.
struct ComparedStroke {
  std::size_t stroke = 0;            ///< index
  std::vector<double> after_n;       ///< per tick
  std::optional<double> hole_mm[2];  ///< before, after: no numbers then, the last force would only be held
  std::optional<StrokeNumbers> numbers;
  std::size_t asked = 0;  ///< forces of the model after that were computed
};

struct StrokeSummary {
  std::size_t compared = 0;          ///< strokes with numbers
  std::size_t felt = 0;              ///< of these, with a difference of at least one just-noticeable difference
  std::size_t holes = 0;             ///< strokes that meet a hole after the change and did not before
  std::size_t left_out = 0;          ///< strokes that are not compared (isCompared, a condition that is missing)
  double median_noticeable = 0;      ///< of the largest difference per stroke, in just-noticeable differences
  std::optional<std::size_t> worst;  ///< place in StrokeComparison::strokes

  bool operator==(const StrokeSummary&) const = default;
};

/// The strokes through the model before.
struct StrokeBaseline {
  std::shared_ptr<const std::vector<RecordedStroke>> strokes;
  editing::SharedModel model;
  Conditions otherwise;
  std::vector<std::optional<StrokeRun>> runs;  ///< one per stroke; nothing: left out
  std::optional<base::Error> refusal;          ///< why the first stroke that could be compared is left out
};

/// Stops early, with what is done, when `stop` is requested.
StrokeBaseline baselineOf(std::shared_ptr<const std::vector<RecordedStroke>> strokes, editing::SharedModel before,
                          Conditions otherwise, const std::stop_token& stop = {});

struct StrokeComparison {
  std::vector<ComparedStroke> strokes;  ///< worst first: strokes into a hole, then by `noticeable`
  StrokeSummary summary;
};

enum class Skip {
  kUnchanged,  ///< computes nothing where the models cannot differ (editing::changedRegion): the same numbers
  kNothing,    ///< computes every tick: the proof of the former
};
StrokeComparison compareStrokes(const StrokeBaseline& before, const editing::ReadyModel& after,
                                Skip skip = Skip::kUnchanged, const std::stop_token& stop = {});

}  // namespace tactus::replay
