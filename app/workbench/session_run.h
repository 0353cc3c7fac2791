// A session from the research mode: the nurse's window over the study that is open, on another screen if there is one,
// and the researcher's monitor on this one. The window of the research mode is hidden meanwhile, so that nothing of it
// shows or interferes.
#pragma once

#include <QObject>
#include <QString>
#include <memory>

#include "app/workbench/device/device_search.h"

class QScreen;

namespace tactus::workbench {

class DeviceSession;
class MainWindow;
class MonitorController;
class MonitorWindow;
class StudyConnection;
class TakePart;
struct ParticipantPlan;

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
  bool preparing_ = false;
  bool quits_with_last_window_ = true;  ///< as it was before
  std::unique_ptr<TakePart> take_part_;
  std::unique_ptr<MonitorController> monitor_;  ///< ends before the session that it watches
  std::unique_ptr<MonitorWindow> monitor_window_;
};

}  // namespace tactus::workbench
