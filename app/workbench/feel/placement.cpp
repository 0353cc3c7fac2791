#include "app/workbench/feel/placement.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/feel/feel_controller.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/patient.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/plot/plot_caption.h"

namespace tactus::workbench {
namespace {

struct TraceTable {
  Q_DECLARE_TR_FUNCTIONS(TraceTable)
};

}  // namespace

PlotTable traceTable(const SceneController& scene, const FeelHistory& history,
                     const std::optional<haptics::DeviceInfo>& device) {
  // Depth and speed change along the trace.
  std::vector<std::size_t> moving;
  const auto& inputs = scene.model()->model.inputs;
  for (const auto& input : {fuzzy::wayOf(inputs), fuzzy::rateOf(inputs)}) {
    if (input) moving.push_back(*input);
  }
  QString felt_on;
  if (device) {
    felt_on = device->simulated ? TraceTable::tr("Felt on: %1, a simulated device").arg(text(device->name))
                                : TraceTable::tr("Felt on: %1").arg(text(device->name));
  }
  PlotTable table =
      captionedTable(scene, TraceTable::tr("force felt in the last %1 s").arg(numberText(FeelHistory::kTraceS)), moving,
                     {felt_on}, QStringLiteral("-force-trace"));
  table.columns = {"time_s", "force_n", "model_force_n", "source_force_n"};
  if (history.hasRecorded()) table.columns.emplace_back("recorded_force_n");
  for (const TracePoint& point : history.trace()) {
    auto& row = table.rows.emplace_back();
    for (const double value : {point.time_s - history.nowS(), point.force_n, point.model_n, point.friction_n}) {
      row.emplace_back(value);
    }
    if (!history.hasRecorded()) continue;
    if (point.recorded_n) {
      row.emplace_back(*point.recorded_n);
    } else {
      row.emplace_back();
    }
  }
  return table;
}

FeltState::FeltState(const FeelController& feel, const SceneController& scene, EditController& edits, QObject* parent)
    : QObject(parent), feel_(feel), scene_(scene), edits_(edits) {
  connect(&edits_, &EditController::modelReset, this, &FeltState::forget);
  connect(&edits_, &EditController::historyChanged, this, &FeltState::refreshState);
  connect(&feel_, &FeelController::sampled, this, &FeltState::add);
}

void FeltState::forget() {
  kept_.clear();
  state_ = edits_.history().current();
  tell();
}

void FeltState::refreshState() {
  if (!edits_.isOpen() || edits_.history().current() == state_) return;
  state_ = edits_.history().current();
  tell();
}

void FeltState::add(std::span<const haptics::Sample> samples) {
  if (samples.empty() || !edits_.isOpen()) return;
  // A recording is no hand, and neither a drag nor another version is this state.
  const auto device = feel_.device();
  if (!device || feel_.isReplay() || edits_.inGesture() || scene_.showsAnother()) {
    stroke_ = samples.back().stroke;
    return;
  }
  Kept& kept = kept_[state_];
  const editing::Felt before = kept.felt;
  for (const haptics::Sample& sample : samples) {
    const bool begins = sample.stroke != stroke_ && sample.stroke > 0;
    stroke_ = sample.stroke;
    if (begins) {
      ++kept.felt.strokes;
      kept.felt.device = device->name;
      kept.felt.simulated = device->simulated;
      const auto depth = fuzzy::wayOf(edits_.model().inputs);
      regions_ = depth ? depthRegions(edits_.model().inputs[*depth]) : std::vector<DepthRegion>();
    }
    if (!sample.enabled || kept.felt.strokes == 0) continue;
    if (const auto region = regionAt(regions_, sample.depth_mm + feel_.depthOffsetMm())) kept.regions.insert(*region);
  }
  kept.felt.regions.clear();
  for (const std::size_t region : kept.regions) {
    if (region < regions_.size()) kept.felt.regions.push_back(regions_[region].label.toStdString());
  }
  if (kept.felt != before) tell();
}

void FeltState::tell() {
  const auto kept = kept_.find(state_);
  edits_.setFelt(kept == kept_.end() ? editing::Felt() : kept->second.felt);
}

void FeelHistory::clear() { *this = {}; }

void FeelHistory::add(const haptics::Sample& sample) {
  if (!any_) start_ns_ = sample.time_ns;
  now_s_ = static_cast<double>(sample.time_ns - start_ns_) * 1e-9;
  const TracePoint point{now_s_, sample.model_force_n, sample.source_force_n, sample.force_n, recordedAt(now_s_)};
  const auto step = static_cast<std::int64_t>(std::floor(now_s_ / kTraceStepS));
  if (!any_ || step != step_) {
    trace_.push_back(point);
  } else if (std::abs(point.friction_n) > std::abs(trace_.back().friction_n)) {
    trace_.back() = point;
  }
  any_ = true;
  step_ = step;
  while (trace_.front().time_s < now_s_ - kTraceS) trace_.pop_front();
}

// The nearest sample: the times of both are of whole ticks, but for rounding.
std::optional<double> FeelHistory::recordedAt(double time_s) const {
  const auto& times = recorded_.time_s;
  const auto after = std::lower_bound(times.begin(), times.end(), time_s);
  if (after == times.end() || (after == times.begin() && *after - time_s > kTraceStepS)) return std::nullopt;
  const bool before_is_nearer = after != times.begin() && time_s - *(after - 1) < *after - time_s;
  return recorded_.force_n[static_cast<std::size_t>(after - times.begin()) - (before_is_nearer ? 1 : 0)];
}

void PlacementMeter::begin(std::uint64_t number) {
  *this = {};
  number_ = number;
}

void PlacementMeter::add(const haptics::Sample& sample, double depth_mm) {
  if (sample.orders < number_) return;
  strokes_ = sample.stroke;
  if (sample.phase == render::Phase::kReleased) return;
  if (ticks_ == 0) first_ns_ = sample.time_ns;
  last_ns_ = sample.time_ns;
  ++ticks_;
  sum_n_ += sample.force_n;
  peak_n_ = std::max(peak_n_, sample.force_n);
  depth_mm_ = std::max(depth_mm_, depth_mm);
}

std::optional<PlacementSummary> PlacementMeter::summary() const {
  if (ticks_ == 0) return std::nullopt;
  PlacementSummary out;
  out.duration_s = static_cast<double>(last_ns_ - first_ns_) * 1e-9;
  out.strokes = strokes_;
  out.peak_force_n = peak_n_;
  out.mean_force_n = sum_n_ / static_cast<double>(ticks_);
  out.depth_mm = depth_mm_;
  return out;
}

}  // namespace tactus::workbench
