// "Take part": the nurse's screens over an open study, until the researcher leaves them with the study's passphrase.
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <memory>

#include "app/workbench/device/device_search.h"
#include "app/workbench/device/device_session.h"
#include "app/workbench/participant/kit/look.h"
#include "app/workbench/participant/participant_controller.h"
#include "app/workbench/participant/participant_views.h"
#include "app/workbench/participant/participant_window.h"
#include "app/workbench/study/connection/study_connection.h"

class QScreen;

namespace tactus::workbench {

class DeviceSession;
class LeavePanel;
class MainWindow;
class MonitorController;
class MonitorWindow;
class StudyConnection;
struct ParticipantPlan;

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

// `tactus-workbench --take-part STUDY`: opens the study and shows the nurse's screens, without the research mode.

/// The device of a session: the first usable one that is not simulated; without one, a running double such as that of
/// `tactus emulate haply`; without that, the virtual device.
QString deviceToFeel(const devices::DeviceList& list);

class TakePartStart : public QObject {
  Q_OBJECT

 public:
  explicit TakePartStart(DeviceAccess devices = realDevices());

  /// Ends with `left`, as soon as the researcher leaves, or with `failed`.
  void open(const QString& study);

 signals:
  /// The study is closed; the research mode may open it.
  void left(const QString& study);
  /// One sentence: why the study cannot be opened or followed.
  void failed(const QString& sentence);

 private:
  void plan();
  void begin(ParticipantPlan plan);

  StudyConnection study_;
  DeviceSearch search_;
  DeviceSession device_;
  QString path_;
  std::unique_ptr<TakePart> take_part_;
};

// A session from the research mode: the nurse's window over the study that is open, on another screen if there is one,
// and the researcher's monitor on this one. The window of the research mode is hidden meanwhile, so that nothing of it
// shows or interferes.

/// The screen for the participant: the first one that is not `researcher`, else that one.
QScreen& screenForParticipant(QScreen& researcher);

class SessionRun : public QObject {
  Q_OBJECT

 public:
  SessionRun(MainWindow& window, StudyConnection& study, DeviceSession& device, QObject* parent = nullptr);
  ~SessionRun() override;

  /// From the start until the researcher has left the participant's screens.
  bool isRunning() const { return preparing_ || take_part_ != nullptr; }
  /// The screens of the participant; null while none are shown.
  TakePart* takePart() { return take_part_.get(); }
  /// What the researcher sees of it; null while none are shown. With one screen alone its window stays hidden.
  MonitorController* monitor() { return monitor_.get(); }
  MonitorWindow* monitorWindow() { return monitor_window_.get(); }

  /// The set-up was checked just now: sessions on its device are marked with it, as long as it holds.
  void setSetup(std::optional<session::SetupCertificate> setup) { setup_ = std::move(setup); }

 public slots:
  /// `code`: of the participant who sits down; empty: the screens ask. Ends with `changed` or `failed`.
  void start(const QString& code);
  /// The usability form for a clinical teacher with a new code. Ends as `start`.
  void startUsability();
  /// The last one that failed to begin, once more.
  void startAgain();

 signals:
  void changed();
  /// One sentence: why no session can be held.
  void failed(const QString& sentence);
  /// One sentence: what the protocol lacks before a person can take part.
  void refused(const QString& sentence);

 private:
  void prepare(const QString& code, bool usability);
  void plan();
  void begin(ParticipantPlan plan);
  void watch(QScreen& nurse, QScreen& researcher);
  void report();
  void hideMonitor();
  void end();
  void fail(const QString& sentence);

  MainWindow& window_;
  StudyConnection& study_;
  DeviceSession& device_;
  DeviceSearch search_;
  QString study_path_;  ///< that the session was asked for
  QString code_;
  bool usability_ = false;
  std::optional<session::SetupCertificate> setup_;
  bool setup_unchecked_ = false;  ///< of the session that runs
  bool preparing_ = false;
  bool plans_again_ = false;            ///< once the study is no longer being opened or left
  bool quits_with_last_window_ = true;  ///< as it was before
  std::unique_ptr<TakePart> take_part_;
  std::unique_ptr<MonitorController> monitor_;  ///< ends before the session that it watches
  std::unique_ptr<MonitorWindow> monitor_window_;
};

}  // namespace tactus::workbench
