// The force model of one participant's own answers, to be felt region by region.
#pragma once

#include <QPointF>
#include <memory>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/haptics/sources/servo_scene.h"
#include "core/store/study_file.h"
#include "core/study/session_records.h"

namespace tactus::workbench {

/// A region of the way: the depth from which it is felt, to its end.
struct OwnRegion {
  std::string id;  ///< term id of the depth
  double from_mm = 0;
  double to_mm = 0;
};

/// Immutable.
struct OwnModel {
  std::shared_ptr<const haptics::ServoScene> scene;
  haptics::Conditions conditions;  ///< at which it is felt
  std::vector<OwnRegion> regions;  ///< along the way
  /// What a sample's depth lacks to the depth of the model, mm.
  double depthOffsetMm() const { return scene->renderer().depth_offset_mm; }
  /// As the study keeps it, without its id. Its label (session::kOwnModelLabel) tells it from the versions of the
  /// researcher's model.
  study::ModelVersion version;
  std::vector<QPointF> curve;  ///< depth in mm, share of the largest force; at the scene's conditions
};

/// Builds the model of the participant `code` from the study, at the middle of each condition (medium lubrication, …)
/// and with the head up, as the picture on her screen shows it. Refused: no rules follow from her answers, or the servo
/// refuses the model. Thread: that of `file`.
base::Result<OwnModel> ownModel(const store::StudyFile& file, const std::string& code);

}  // namespace tactus::workbench
