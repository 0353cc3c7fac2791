// "Take part": the nurse's screens over an open study, until the researcher leaves them with the study's passphrase.
#pragma once

#include <QObject>
#include <functional>

#include "app/workbench/participant/kit/look.h"
#include "app/workbench/participant/participant_controller.h"
#include "app/workbench/participant/participant_views.h"
#include "app/workbench/participant/participant_window.h"

class QScreen;

namespace tactus::workbench {

class LeavePanel;

class TakePart : public QObject {
  Q_OBJECT

 public:
  /// `study` is open. `study` and `device` outlive this. `now`: the clocks.
  TakePart(StudyConnection& study, DeviceSession& device, const ParticipantPlan& plan,
           std::function<study::Moment()> now = session::systemTools().now);

  /// Shows the first screen on `screen`.
  void begin(QScreen& screen);

  ParticipantController& course() { return course_; }
  ParticipantWindow& window() { return window_; }
  const nurse::Look& look() const { return look_; }

 signals:
  /// The window is closed: the researcher typed the passphrase, or the study has none.
  void left();
  /// A participant is done.
  void finished();

 private:
  void askForPassphrase();
  void check(LeavePanel& asked, const QString& passphrase);
  void giveHand();

  StudyConnection& study_;
  nurse::Look look_;
  ParticipantController course_;
  ParticipantWindow window_;
  ParticipantViews views_;
  VirtualHand hand_;
};

}  // namespace tactus::workbench
