// What all labs share: the open study as elicitation sees it, and the settings of the model that is built from it.
// Nothing is read while no lab is on the screen.
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/session/judged_forces.h"
#include "app/workbench/base/computed.h"
#include "app/workbench/study/connection/study_connection.h"
#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "core/store/study_file.h"
#include "core/study/records.h"
#include "core/study/session_records.h"
#include "elicitation/depth/depth_measurement.h"
#include "elicitation/model/method_study.h"
#include "elicitation/model/model_builder.h"

namespace tactus::workbench {

// Where curves are drawn before anybody chooses a place.

/// The value at which the procedure shows `input`; the middle of an input that it lacks.
double usualValue(const procedure::Procedure& procedure, const fuzzy::Variable& input);
/// The input of the depth, which is the x axis of curves; 0 without one.
std::size_t depthInput(const fuzzy::ForceModel& model);

// What a lab's buttons and Ctrl+Z take back: corrections of records, or edits of a measurement.

/// Thread: gui.
class UndoSource : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  virtual bool canUndo() const = 0;
  virtual bool canRedo() const = 0;
  /// What the next undo or redo is about; empty if there is none.
  virtual QString undoText() const = 0;
  virtual QString redoText() const = 0;

 public slots:
  virtual void undo() = 0;
  virtual void redo() = 0;

 signals:
  /// One of the above changed.
  void changed();
};

/// What the labs know of the open study: read once in the thread of the study, then shared unchanged.
struct LabStudy {
  study::Study study;                        ///< as elicitation takes it (session::studyForElicitation)
  std::vector<study::RecordId> answer_ids;   ///< of the records behind `study.answers`, in their order
  std::vector<study::RecordId> rule_ids;     ///< of those behind `study.rules`
  std::vector<session::JudgedForce> judged;  ///< every judgement of the counted sessions
  std::vector<std::string> notes;            ///< what is left out of it, and why
  std::vector<study::Form> forms;            ///< the known forms
  std::optional<elicitation::DepthMeasurement> measured_depths;  ///< the latest; nothing: none was made
  std::vector<study::Person> persons;
  std::vector<study::SessionRecord> sessions;
  // All records that are not corrected, also of sessions that do not count: what a number came from.
  std::vector<study::StrokeRecord> strokes;  ///< without recordings
  std::vector<study::JudgementRecord> judgements;
  std::vector<study::AnswerRecord> answers;
  std::vector<study::RuleRecord> rules;

  /// The code of the participant of `session`; empty for an unknown one.
  std::string codeOf(const study::RecordId& session) const;
};

/// Thread: the one of `file`.
base::Result<LabStudy> readLabStudy(const store::StudyFile& file);

/// What most computations of the labs begin with.
struct LabInputs {
  std::shared_ptr<const LabStudy> study;  ///< never null
  elicitation::BuildSettings settings;
};

/// Is held while a lab wants the study: it is read then. Thread: gui.
class LabData : public Held {
  Q_OBJECT

 public:
  /// `connection` outlives this.
  explicit LabData(StudyConnection& connection, QObject* parent = nullptr);

  /// The study, shared unchanged; null while none is read.
  const std::shared_ptr<const LabStudy>& study() const { return study_; }
  /// One sentence: why the study cannot be read; empty if it can.
  const QString& failure() const { return failure_; }
  /// The study is being read.
  bool isReading() const { return reading_; }
  StudyConnection& connection() { return connection_; }
  const StudyConnection& connection() const { return connection_; }

  /// The settings of every lab's model. They begin with the defaults when a study is opened.
  const elicitation::BuildSettings& settings() const { return settings_; }
  void setSettings(elicitation::BuildSettings settings);
  /// Another measurement of depths for the settings. Without effect on a model with the template's depths; its undo is
  /// that of the lab that measures.
  void setMeasuredDepths(const elicitation::DepthMeasurement& measured);

  /// Nothing while no study is read.
  std::optional<LabInputs> inputs() const;
  /// While a session runs, the thread of the study belongs to it: reading waits until the end.
  void setSessionRunning(bool runs);

 public slots:
  /// Reads the study again: something in it has changed.
  void refresh();

 signals:
  /// `study` is another; comes before `studyChanged`.
  void studyReplaced();
  /// `study`, `failure` or `isReading` changed.
  void studyChanged();
  void settingsChanged();
  /// The user has changed the settings; comes before `settingsChanged`. Not when a study is opened or closed.
  void settingsEdited(const tactus::elicitation::BuildSettings& before,
                      const tactus::elicitation::BuildSettings& after);
  /// The depths of the model were measured anew; comes before `settingsChanged`.
  void depthsEdited(const tactus::elicitation::BuildSettings& before);

 private:
  void followHolders() override { read(); }
  void setStudy(std::shared_ptr<const LabStudy> study);
  void read();
  void forget();

  StudyConnection& connection_;
  std::shared_ptr<const LabStudy> study_;
  QString failure_;
  elicitation::BuildSettings settings_;
  bool stale_ = false;
  bool reading_ = false;
  bool runs_ = false;
};

/// What differs between two settings of the labs: `α 0.95 → 0.8, m 2 → 1.5`; empty: nothing.
QString settingsChange(const elicitation::BuildSettings& before, const elicitation::BuildSettings& after);

// The averaged model of the open study with the labs' settings, and everything that led to it.

/// `settings`, with which a clustering ends early if `stop` asks for it.
elicitation::BuildSettings stoppable(elicitation::BuildSettings settings, const std::stop_token& stop);

/// Keeps `cell` at the study and the settings of `data`.
void followLabData(Computation& cell, LabData& data);

/// What computations that compare forces begin with.
struct BuiltStudy {
  std::shared_ptr<const elicitation::BuiltModel> model;
  std::shared_ptr<const LabStudy> study;  ///< that the model was made from
  elicitation::BuildSettings settings;    ///< that made it
};

/// The newest build stays while another one runs. Thread: gui.
class LabModel : public Computed<LabInputs, BuiltStudy> {
 public:
  /// `data` outlives this.
  explicit LabModel(LabData& data, QObject* parent = nullptr);

  /// Null if there is no model, or it cannot be built.
  std::shared_ptr<const elicitation::BuiltModel> built() const { return value() ? value()->model : nullptr; }
  /// The model with what made it; nothing: none.
  std::optional<BuiltStudy> inputs() const { return value() ? std::optional(*value()) : std::nullopt; }
};

/// The choices of the method, compared for a model.
struct StudiedMethod {
  BuiltStudy built;
  std::shared_ptr<const elicitation::MethodStudy> choices;  ///< never null
};

}  // namespace tactus::workbench
