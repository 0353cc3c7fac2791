// Keeps how the current state of the model was felt: its strokes, the device and the regions that the tip reached.
#pragma once

#include <QObject>
#include <cstdint>
#include <map>
#include <set>
#include <span>

#include "app/editing/edit_history.h"
#include "app/workbench/feel/depth_regions.h"
#include "core/haptics/servo/sample.h"

namespace tactus::workbench {

class EditController;
class FeelController;
class SceneController;

/// Thread: gui.
class FeltState : public QObject {
  Q_OBJECT

 public:
  /// Tells `edits` with `setFelt`. The others outlive this.
  FeltState(const FeelController& feel, const SceneController& scene, EditController& edits, QObject* parent = nullptr);

 private:
  struct Kept {
    editing::Felt felt;
    std::set<std::size_t> regions;  ///< indices
  };

  void forget();
  void follow();
  void add(std::span<const haptics::Sample> samples);
  void tell();

  const FeelController& feel_;
  const SceneController& scene_;
  EditController& edits_;
  std::map<editing::StateId, Kept> kept_;
  std::vector<DepthRegion> regions_;
  editing::StateId state_ = 0;
  std::uint32_t stroke_ = 0;  ///< the newest one; a stroke counts for the state on which it begins
};

}  // namespace tactus::workbench
