// Stores what is felt in the open study: a summary of each placement, and recordings. Replays recordings through the
// current model.
#pragma once

#include <QObject>
#include <QString>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/workbench/base/messages.h"
#include "app/workbench/feel/placement.h"
#include "core/haptics/device/device.h"
#include "core/haptics/servo/sample.h"
#include "core/store/study_file.h"
#include "core/study/record_id.h"
#include "core/study/session_records.h"

namespace tactus::workbench {

/// The study sessions in which a person feels a model: one for each person and each run. A session is created with its
/// first record. Used only by the thread of the study file.
class FeelSessions {
 public:
  /// A person and the device.
  struct Visit {
    std::uint64_t run = 0;               ///< number of the run
    std::optional<study::RecordId> who;  ///< nothing: the researcher
    study::Moment started;
    std::string device;
    std::string device_id;
    bool simulated = false;
    std::optional<double> device_friction_n;
  };

  /// The session of `visit` in `file`; creates it if there is none. At the first session of the researcher it adds a
  /// person with a code and a profile that says so.
  base::Result<study::RecordId> sessionOf(const Visit& visit, store::StudyFile& file, study::RecordIds& ids);

  /// The number of the recording `serial` within `session`, counted from 1 in the order of their beginning.
  int numberOf(std::uint64_t serial, const study::RecordId& session);

 private:
  base::Result<study::RecordId> researcher(store::StudyFile& file, study::RecordIds& ids);

  using Key = std::pair<std::uint64_t, std::optional<study::RecordId>>;
  std::map<Key, study::RecordId> sessions_;
  std::map<std::uint64_t, int> numbers_;
  std::map<study::RecordId, int> counts_;
};

/// Name and serial number, as records keep them.
std::string deviceText(const haptics::DeviceInfo& info);

/// Turns the samples of the servo into the channels of a recording (docs/study-file.md, "Feeling a model").
class FeelRecorder {
 public:
  /// An input of the model that is a condition of the tube or the patient.
  struct Condition {
    std::string id;
    std::string unit;
    double value = 0;
  };

  /// The first added sample is time 0. `rate_hz`: rate of the servo.
  FeelRecorder(double rate_hz, const std::vector<Condition>& conditions);

  /// Whether `conditions` are the recorder's conditions, with any values.
  bool has(const std::vector<Condition>& conditions) const;
  /// Sets the values from the next sample on; as many values as conditions.
  void setConditions(const std::vector<double>& values) { conditions_ = values; }
  /// Whether servo samples between the last added sample and `next` are missing.
  bool isGapBefore(const haptics::Sample& next) const { return last_tick_ && next.tick != *last_tick_ + 1; }
  /// Adds a sample. `depth_mm` in the coordinates of the model; `placement` counts from 1.
  void add(const haptics::Sample& sample, double depth_mm, int placement);

  /// Seconds since the first sample.
  double lengthS() const { return length_s_; }
  /// Seconds since the end of the last piece.
  double pieceS() const;
  /// The samples added since the last call, or nothing. Times continue from piece to piece.
  std::optional<study::Recording> takePiece();

 private:
  study::Recording empty_;  ///< the channels without samples
  study::Recording piece_;
  std::vector<double> conditions_;
  std::optional<std::int64_t> start_ns_;
  std::optional<std::uint64_t> last_tick_;
  double length_s_ = 0;
};

/// The values of the channel `name`; null if there is none.
const std::vector<double>* channelOf(const study::Recording& recording, const std::string& name);

class FeelController;
class SceneController;
class StudyConnection;

/// Thread: gui.
class FeelStore : public QObject {
  Q_OBJECT

 public:
  static constexpr double kPieceS = 2;  ///< of a recording; a crash loses at most this

  /// The version of the shown model in the study; nothing if the study does not keep the model.
  using ModelVersion = std::function<std::optional<study::RecordId>()>;
  FeelStore(FeelController& feel, SceneController& scene, StudyConnection& study, ModelVersion model_version,
            QObject* parent = nullptr);
  /// Orders the rest of the current recording to be written.
  ~FeelStore() override;

  /// The person who feels, for all records from now on; nothing: the researcher.
  std::optional<study::RecordId> who() const { return who_; }
  /// Whether a study is open to record into.
  bool canRecord() const;
  /// Whether a recording is in progress or waits for the start of a device.
  bool isRecording() const { return recording_; }
  /// Length of the current recording, s.
  double recordedS() const { return recorder_ ? recorder_->lengthS() : 0; }
  /// The recording being replayed; nothing if there is none.
  std::optional<study::RecordId> replayed() const;

  // For other records of the current run. Need a run.

  /// Used by the thread of the study alone.
  const std::shared_ptr<FeelSessions>& sessions() const { return sessions_; }
  FeelSessions::Visit visit() const;
  study::FeltSetting setting() const;

 public slots:
  void setWho(std::optional<tactus::study::RecordId> who);
  /// Starts a recording with a new placement: at once, or with the next start of a device. It ends with the run.
  void setRecording(bool recording);
  /// Ends the current recording and starts another one.
  void recordAgain();
  /// Replays the movement of a recording through the current model.
  void replay(const tactus::study::RecordId& recording);
  /// The same for a recording that is there; `id`: in the study; nothing: it was made by calculation.
  void play(const std::optional<tactus::study::RecordId>& id, const tactus::study::Recording& recording);

 signals:
  /// The recording, its length in seconds, the replay or the person changed.
  void changed();
  void said(const QString& sentence);
  /// One sentence: what was not recorded, stored or replayed, and why; `act` helps.
  void failed(const QString& sentence, const tactus::workbench::MessageAct& act);
  /// One sentence: this recording cannot be replayed, another one may.
  void notReplayable(const QString& sentence);

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
  void playNext();
  void showSample(std::size_t sample);
  void endPlacement();
  std::vector<FeelRecorder::Condition> conditions() const;
  study::Entry entry();
  study::EnteredBy enteredBy() const;
  MessageAct recordingAgain();
  void storePlacement(study::PlacementRecord record, FeelSessions::Visit visit);
  /// Orders `record` to be appended when its session exists; then calls `done`. `what` names the record for the user;
  /// `act` helps where the study refuses it.
  template <class Record>
  void store(Record record, const QString& what, const FeelSessions::Visit& visit, std::uint64_t serial,
             const MessageAct& act, std::function<void()> done);

  FeelController& feel_;
  SceneController& scene_;
  StudyConnection& study_;
  ModelVersion model_version_;
  std::shared_ptr<FeelSessions> sessions_;  ///< used only by the thread of the study
  study::RecordIds ids_;
  std::optional<study::RecordId> who_;
  std::uint64_t seen_run_ = 0;
  study::Moment run_started_;
  bool recording_ = false;
  std::optional<FeelRecorder> recorder_;
  FeelSessions::Visit recorded_visit_;
  std::uint64_t recordings_ = 0;  ///< number of recordings begun
  std::uint64_t refused_ = 0;     ///< the recording of which the study refused a part; said once
  std::uint64_t first_orders_ = 0;
  std::uint64_t placement_orders_ = 0;
  int placement_ = 0;
  int pieces_ = 0;
  int shown_s_ = -1;
  std::optional<study::FeltSetting> felt_;  ///< at the first grip of this placement

  struct Replay {
    std::optional<study::RecordId> id;
    study::Recording recording;
    std::vector<double> time_s;  ///< of each sample, since the start of the run
    std::size_t sample = 0;      ///< the last sample that was followed
  };
  std::optional<Replay> replay_;
  struct Next {
    std::unique_ptr<haptics::HapticDevice> device;
    RecordedForce beside;
    Replay replay;
  };
  std::optional<Next> next_;  ///< begins when the previous device has stopped
};

}  // namespace tactus::workbench
