#include "app/workbench/feel/felt_state.h"

#include <utility>

#include "app/workbench/feel/feel_controller.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/patient.h"
#include "app/workbench/model/scene_controller.h"

namespace tactus::workbench {

FeltState::FeltState(const FeelController& feel, const SceneController& scene, EditController& edits, QObject* parent)
    : QObject(parent), feel_(feel), scene_(scene), edits_(edits) {
  connect(&edits_, &EditController::modelReset, this, &FeltState::forget);
  connect(&edits_, &EditController::historyChanged, this, &FeltState::follow);
  connect(&feel_, &FeelController::sampled, this, &FeltState::add);
}

void FeltState::forget() {
  kept_.clear();
  state_ = edits_.history().current();
  tell();
}

void FeltState::follow() {
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
      const auto depth = inputNamed(edits_.model(), kDepthId);
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

}  // namespace tactus::workbench
