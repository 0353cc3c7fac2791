// What is felt goes into the open study: a summary of each placement, and recordings, which can be replayed on the
// present model.
#pragma once

#include <QObject>
#include <QString>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "app/workbench/feel/feel_history.h"
#include "app/workbench/feel/recordings/feel_recorder.h"
#include "app/workbench/feel/recordings/feel_sessions.h"
#include "core/haptics/device/device.h"
#include "core/haptics/servo/sample.h"
#include "core/study/feel_records.h"

namespace tactus::workbench {

class FeelController;
class SceneController;
class StudyController;

/// Thread: gui.
class FeelStore : public QObject {
  Q_OBJECT

 public:
  static constexpr double kPieceS = 2;  ///< of a recording; a crash loses no more

  FeelStore(FeelController& feel, SceneController& scene, StudyController& study, QObject* parent = nullptr);
  /// What was recorded until then is ordered to be written.
  ~FeelStore() override;

  /// Who feels, for what is stored from now on; nothing: the researcher.
  std::optional<study::RecordId> who() const { return who_; }
  /// There is a study to record into.
  bool canRecord() const;
  /// A recording goes on, or waits for the start of a device.
  bool isRecording() const { return recording_; }
  /// Of the recording that goes on, s.
  double recordedS() const { return recorder_ ? recorder_->lengthS() : 0; }
  /// The recording that is replayed.
  std::optional<study::RecordId> replayed() const;

 public slots:
  void setWho(std::optional<tactus::study::RecordId> who);
  /// A recording begins with a new placement, at once or with the next start of a device; it ends with the run.
  void setRecording(bool recording);
  /// Moves as the recording did, through the present model.
  void replay(const tactus::study::RecordId& recording);

 signals:
  /// Recording, its length in seconds, replay or who changed.
  void changed();
  void said(const QString& sentence);
  void failed(const QString& sentence);

 private:
  void onState();
  void onSampled(std::span<const haptics::Sample> samples);
  void onAdvanced();
  void onPlacementEnded();
  void onStudy();
  void onModel();
  void beginRecording();
  void endRecording();
  void storePiece(bool gap_follows = false);
  void play(const study::RecordId& id, const study::Recording& recording);
  void playNext();
  void follow(std::size_t sample);
  void endPlacement();
  FeelSessions::Visit visit() const;
  study::FeltSetting setting() const;
  std::vector<FeelRecorder::Condition> conditions() const;
  study::Entry entry();
  /// Orders `record`, `what` for the person, to be appended once its session is there; then `done`.
  template <class Record>
  void store(Record record, const QString& what, const FeelSessions::Visit& visit, std::uint64_t serial,
             std::function<void()> done);

  FeelController& feel_;
  SceneController& scene_;
  StudyController& study_;
  std::shared_ptr<FeelSessions> sessions_;  ///< touched by the thread of the study alone
  study::RecordIds ids_;
  std::optional<study::RecordId> who_;
  std::uint64_t seen_run_ = 0;
  study::Moment run_started_;
  bool recording_ = false;
  std::optional<FeelRecorder> recorder_;
  FeelSessions::Visit recorded_visit_;
  std::uint64_t recordings_ = 0;  ///< begun so far
  std::uint64_t first_orders_ = 0;
  std::uint64_t placement_orders_ = 0;
  int placement_ = 0;
  int pieces_ = 0;
  int shown_s_ = -1;
  std::optional<study::FeltSetting> felt_;  ///< when the hand took the tube for the first time in this placement

  struct Replay {
    study::RecordId id;
    study::Recording recording;
    std::vector<double> time_s;  ///< of each sample, since the start of the run
    std::size_t sample = 0;      ///< that was followed last
  };
  std::optional<Replay> replay_;
  struct Next {
    std::unique_ptr<haptics::HapticDevice> device;
    RecordedForce beside;
    Replay replay;
  };
  std::optional<Next> next_;  ///< begins as soon as the device before has stopped
};

}  // namespace tactus::workbench
