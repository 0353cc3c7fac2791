// A simulated nurse goes through a whole session on the screens, in time that passes faster than that of the clock.
#pragma once

#include <QByteArray>
#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTimer>
#include <optional>
#include <utility>

#include "app/workbench/device/virtual_time.h"
#include "app/workbench/rehearsal/screen_nurse.h"
#include "core/base/error.h"
#include "core/store/study_file.h"

namespace tactus::workbench {

// Whether a rehearsed session is in the study file: what the nurse remembers against the records.

/// Refuses, with one sentence: a person or a session that is missing or not marked as simulated, a block that is not
/// closed, and every word, insertion, comparison and mark that the nurse gave and the file lacks, or the other way
/// round. Thread: that of `file`.
base::Result<void> checkRehearsal(const store::StudyFile& file, const NurseMemory& memory);

class ParticipantController;

/// Thread: gui.
class Rehearsal : public QObject {
  Q_OBJECT

 public:
  /// What is rehearsed on; all outlive this. `device` runs in `time`.
  struct Parts {
    ParticipantController& course;
    ParticipantWindow& window;
    const nurse::Look& look;
    DeviceSession& device;
    VirtualTime& time;
  };

  /// `speed` > 0: how many seconds of the nurse pass in one of the clock, as far as the computer can follow.
  Rehearsal(const Parts& on, session::NurseTraits traits, std::uint64_t seed, double speed);

  void begin();
  const NurseMemory& memory() const { return nurse_.memory(); }

 signals:
  /// Something else is asked, or the disk began or ceased to refuse: `progressLine`.
  void came(const QByteArray& line);
  /// She is done with the last screen.
  void done();
  /// One sentence: why she cannot continue.
  void stuck(const QString& sentence);

 private:
  void wake();
  void tell();
  bool standsStill();
  double nowS() const { return static_cast<double>(on_.time.nowNs()) * 1e-9; }

  Parts on_;
  ScreenHands hands_;
  ScreenNurse nurse_;
  double speed_;
  QTimer timer_;
  QElapsedTimer clock_;                                 ///< since the last wake
  double owed_ms_ = 0;                                  ///< of virtual time
  std::optional<std::pair<std::uint64_t, bool>> told_;  ///< serial and failure of the last line
  // The last time at which something else was asked.
  std::uint64_t serial_ = 0;
  double serial_since_s_ = 0;
  QElapsedTimer serial_since_;
};

}  // namespace tactus::workbench
