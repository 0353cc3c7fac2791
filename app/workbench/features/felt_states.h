// What the hand feels, in the words of the live link.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "app/link/link_lines.h"
#include "core/haptics/servo/sample.h"

namespace tactus::workbench {

class FeelController;
class SceneController;
struct OpenModel;

/// Thread: gui. It reads the samples that the servo has left for the screen; the servo knows nothing of it.
class FeltStates {
 public:
  FeltStates(const FeelController& feel, const SceneController& scene) : feel_(feel), scene_(scene) {}

  /// `samples` of the current run as states, in the setting of the scene.
  link::LinkStates of(std::span<const haptics::Sample> samples);
  /// The state after a run: the hand holds nothing and feels no force. No states if there was no run.
  link::LinkStates afterRun();

 private:
  std::shared_ptr<const link::LinkSetting> setting();

  const FeelController& feel_;
  const SceneController& scene_;
  std::uint64_t run_ = 0;
  std::int64_t run_began_ns_ = 0;
  // The setting and what it is of: made anew where one of these differs.
  std::shared_ptr<const OpenModel> model_;
  std::shared_ptr<const link::LinkSetting> setting_;
};

}  // namespace tactus::workbench
