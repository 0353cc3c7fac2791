// The check of the set-up before a session: what the program can look at by itself, the guided self-test of the device,
// and what only a person can say; and its dialog.
#pragma once

#include <QDialog>
#include <QObject>
#include <QSize>
#include <QString>
#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "app/devices/guided_runs.h"
#include "app/session/setup_certificate.h"
#include "app/workbench/device/device_search.h"
#include "app/workbench/device/device_session.h"
#include "app/workbench/study/connection/study_connection.h"

class QLabel;
class QPushButton;

namespace tactus::workbench {

class NumberBox;

/// Thread: gui.
class SetupCheck : public QObject {
  Q_OBJECT

 public:
  enum class State {
    kOpen,     ///< nothing is known yet
    kRunning,  ///< the device is looked at, or a person is asked for something
    kGood,
    kBad,
  };
  struct Row {
    State state = State::kOpen;
    QString found;  ///< one line; empty: nothing yet
  };
  /// The screens of this computer: the participant's first.
  using Screens = std::function<std::vector<QSize>()>;

  /// `study` is open and outlives this, as `device` does. `utc_ms`: the clock.
  SetupCheck(StudyConnection& study, DeviceSession& device, Screens screens, std::function<std::int64_t()> utc_ms,
             QObject* parent = nullptr);
  /// Ends the run of the device.
  ~SetupCheck() override;

  /// Everything anew, with the device `id` of the list of devices; what a person has said is forgotten.
  void begin(const QString& id);

  const Row& row(session::SetupItem item) const { return rows_[static_cast<std::size_t>(item)]; }
  /// What the person at the device is asked to do now; empty: nothing.
  QString instruction() const;
  /// The self-test asks in which direction the device pulled.
  bool asksDirection() const { return test_ && test_->phase() == devices::SelfTest::Phase::kAsk; }
  void feltDirection(devices::Felt felt);
  /// The self-test once more.
  void repeatForce();

  static constexpr double kScaleN = 0.5;      ///< far above friction, and no device gets warm from it
  static constexpr double kScaleShare = 0.1;  ///< a kitchen scale and a hand that holds still
  /// The device pushes with kScaleN as long as the button is pressed, at most 5 s.
  void pushOnScale();
  bool mayPush() const;
  /// What the scale showed meanwhile, g. Takes the place of the self-test.
  void scaleShowed(double grams);
  /// Whether the tone of a call was heard.
  void heard(bool tone);

  /// Each item is good or bad.
  bool isDone() const;
  session::SetupCertificate certificate() const;

 signals:
  void changed();
  /// The last open item was decided, or one was decided anew.
  void done(const tactus::session::SetupCertificate& certificate);

 private:
  void set(session::SetupItem item, State state, const QString& found = {});
  void set(session::SetupItem item, bool good, const QString& found) {
    set(item, good ? State::kGood : State::kBad, found);
  }
  void readStudy();
  void lookAtScreens();
  void onDevice();
  void onSamples(std::span<const haptics::Sample> samples);
  void sendOrders();
  void followTest();
  void measureLatency();
  void tell();

  StudyConnection& study_;
  DeviceSession& device_;
  Screens screens_;
  std::function<std::int64_t()> utc_ms_;
  QString device_id_;
  std::array<Row, session::kSetupItems.size()> rows_;
  bool needs_device_ = true;  ///< a part of the session is felt
  std::optional<devices::SelfTest> test_;
  bool told_ = false;  ///< `done` was emitted for these rows
};

/// "Check the set-up": one line for each thing that a session needs, with what a person has to do for it.
class SetupDialog : public QDialog {
  Q_OBJECT

 public:
  /// The study is open. Looks for the device at once. `study` and `device` outlive this.
  SetupDialog(StudyConnection& study, DeviceSession& device, QWidget* parent);

  SetupCheck& check() { return check_; }

 signals:
  void certified(const tactus::session::SetupCertificate& certificate);

 private:
  struct Line {
    QLabel* mark;
    QLabel* found;
  };

  void build();
  QWidget* makeForceActs();
  QWidget* makeSoundActs();
  void look();
  void showState();

  DeviceSearch search_;
  SetupCheck check_;
  std::array<Line, session::kSetupItems.size()> lines_{};
  QLabel* instruction_;
  QWidget* directions_;
  QWidget* scale_acts_;
  QPushButton* repeat_;
  QPushButton* push_;
  NumberBox* scale_;
  QLabel* verdict_;
  QPushButton* again_;
  QPushButton* close_;
};

}  // namespace tactus::workbench
