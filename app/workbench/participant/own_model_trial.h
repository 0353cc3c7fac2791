// Her own model in the hand, region by region: built from her answers, kept in the study, and what she says of it.
#pragma once

#include <QObject>
#include <QPointF>
#include <QString>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/session/session_notes.h"
#include "app/workbench/device/device_session.h"
#include "app/workbench/participant/kit/participant_state.h"
#include "app/workbench/study/connection/study_connection.h"
#include "core/base/error.h"
#include "core/haptics/sources/servo_scene.h"
#include "core/store/study_file.h"
#include "core/study/session_records.h"

namespace tactus::workbench {

// The force model of one participant's own answers, to be felt region by region.

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

/// Thread: gui.
class OwnModelTrial : public QObject {
  Q_OBJECT

 public:
  /// Both outlive this.
  OwnModelTrial(StudyConnection& study, DeviceSession& device) : study_(study), device_(device) {}

  /// Builds the model of the participant `code` and stores it as a version of its own; does nothing if that was asked
  /// before. Ends with `changed`.
  void prepare(const std::string& code);
  bool isThere() const { return model_ != nullptr; }
  /// Puts the region into the device. The model is there, and the device runs.
  void feel();
  /// All samples: the place of a mark is where the hand was last.
  void look(std::span<const haptics::Sample> samples);

  std::size_t region() const { return region_; }
  /// A mark at the last place in the hand.
  session::Note mark();
  /// What she says of the region: `lighter`, `right`, `heavier`. Goes to the next region.
  session::Note say(const QString& comparison);
  /// All regions were felt.
  bool isDone() const { return done_; }

  /// Without what is chosen on the screen. `runs`: the device does.
  OwnModelState state(bool runs) const;
  /// Depth in mm, share of the largest force; empty: no model.
  const std::vector<QPointF>& curve() const;

 signals:
  void changed();

 private:
  session::OwnModelPlace place() const;

  StudyConnection& study_;
  DeviceSession& device_;
  bool asked_ = false;
  std::shared_ptr<const OwnModel> model_;
  QString refused_;
  std::size_t region_ = 0;
  bool done_ = false;
  int marks_ = 0;
  std::optional<haptics::Sample> felt_;  ///< the last one with the handle in the hand, in this region
};

}  // namespace tactus::workbench
