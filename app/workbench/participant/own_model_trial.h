// Her own model in the hand, region by region: built from her answers, kept in the study, and what she says of it.
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "app/session/session_notes.h"
#include "app/workbench/device/device_session.h"
#include "app/workbench/participant/own_model.h"
#include "app/workbench/participant/participant_state.h"
#include "app/workbench/study/connection/study_connection.h"

namespace tactus::workbench {

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
