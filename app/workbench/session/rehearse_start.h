// `tactus-workbench --rehearse`: a simulated nurse does a whole session on the screens of a study, and the file is read
// back.
#pragma once

#include <QObject>
#include <QString>
#include <cstdint>
#include <memory>

#include "app/session/simulated_nurse.h"
#include "app/workbench/device/device_session.h"
#include "app/workbench/device/virtual_time.h"
#include "app/workbench/rehearsal/rehearsal.h"
#include "app/workbench/session/take_part.h"
#include "app/workbench/study/connection/study_connection.h"

namespace tactus::workbench {

struct RehearseSettings {
  QString study;     ///< a study file, made if there is none; empty: a new one in the folder for temporary files
  double speed = 1;  ///< 0.1 to 1000
};

class RehearseStart : public QObject {
  Q_OBJECT

 public:
  explicit RehearseStart(const RehearseSettings& settings);

  const QString& study() const { return path_; }
  /// Ends with `succeeded` or `failed`.
  void begin();

 signals:
  /// All that the nurse did is in the study file, which is closed.
  void succeeded();
  /// The screens are about to be shown.
  void raised(tactus::workbench::ParticipantController* course);
  /// Rehearsal::came.
  void came(const QByteArray& line);
  /// One sentence.
  void failed(const QString& sentence);

 private:
  void prepare();
  void raise(const ParticipantPlan& plan, const session::NurseTraits& nurse);
  void readBack();
  study::Moment now() const;
  void end(const QString& sentence);

  double speed_;
  QString path_;
  std::int64_t began_utc_ms_ = 0;
  VirtualTime time_;
  StudyConnection study_;
  DeviceSession device_;
  std::unique_ptr<TakePart> take_part_;
  std::unique_ptr<Rehearsal> rehearsal_;
  bool ended_ = false;
};

}  // namespace tactus::workbench
