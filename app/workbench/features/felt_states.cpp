#include "app/workbench/features/felt_states.h"

#include <string>
#include <utility>
#include <vector>

#include "app/workbench/feel/feel_controller.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/model/patient.h"
#include "app/workbench/model/scene_controller.h"

namespace tactus::workbench {
namespace {

/// The values of the inputs that the hand does not move.
std::vector<std::pair<std::string, double>> conditionsOf(const SceneController& scene) {
  std::vector<std::pair<std::string, double>> conditions;
  const auto& inputs = scene.model()->model.inputs;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (!isMovedByHand(inputs[i])) conditions.emplace_back(inputs[i].id, scene.value(i));
  }
  return conditions;
}

std::vector<link::LinkSetting::Region> regionsOf(const fuzzy::ForceModel& model) {
  std::vector<link::LinkSetting::Region> regions;
  if (const auto depth = fuzzy::wayOf(model.inputs)) {
    for (const DepthRegion& region : depthRegions(model.inputs[*depth]))
      regions.push_back({region.from_mm, region.to_mm, region.id});
  }
  return regions;
}

}  // namespace

std::shared_ptr<const link::LinkSetting> FeltStates::setting() {
  const bool same_model = setting_ && model_ == scene_.shared();
  auto made = std::make_shared<link::LinkSetting>();
  made->conditions = conditionsOf(scene_);
  const auto device = feel_.device();
  made->simulated = device ? device->simulated || feel_.isReplay() : setting_ && setting_->simulated;
  if (same_model && made->conditions == setting_->conditions && made->simulated == setting_->simulated) return setting_;
  made->regions = same_model ? setting_->regions : regionsOf(scene_.model()->model);
  model_ = scene_.shared();
  setting_ = std::move(made);
  return setting_;
}

link::LinkStates FeltStates::of(std::span<const haptics::Sample> samples) {
  if (samples.empty() || !scene_.model()) return {};
  if (feel_.runs() != run_) {
    run_ = feel_.runs();
    run_began_ns_ = samples.front().time_ns;
  }
  link::LinkStates states{setting(), {}};
  states.states.reserve(samples.size());
  for (const haptics::Sample& sample : samples) {
    link::LinkState state;
    state.time_s = static_cast<double>(sample.time_ns - run_began_ns_) * 1e-9;
    state.depth_mm = sample.depth_mm + feel_.depthOffsetMm();
    state.speed_mm_s = sample.speed_mm_s;
    state.slip_speed_mm_s = sample.slip_speed_mm_s;
    state.force_n = sample.force_n;
    state.model_force_n = sample.model_force_n;
    state.held = sample.enabled;
    state.held_last = sample.held;
    state.stroke = sample.stroke;
    states.states.push_back(state);
  }
  return states;
}

link::LinkStates FeltStates::afterRun() {
  if (run_ == 0 || feel_.runs() != run_) return {};
  haptics::Sample last = feel_.latest();
  last.force_n = last.model_force_n = last.speed_mm_s = last.slip_speed_mm_s = 0;
  last.enabled = last.held = false;
  return of({&last, 1});
}

}  // namespace tactus::workbench
