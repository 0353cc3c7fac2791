// The model of the open study: every edit of it becomes a version in the study, the averaged model is built from the
// answers when it is asked for, and another model is put into the study.
#pragma once

#include <QObject>
#include <QString>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/editing/edit_history.h"
#include "app/workbench/base/messages.h"
#include "app/workbench/base/worker.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/study/connection/study_connection.h"
#include "app/workbench/study/connection/study_contents.h"
#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "core/procedure/procedure.h"
#include "core/store/study_file.h"
#include "core/study/data_finding.h"
#include "core/study/records.h"
#include "core/study/session_records.h"
#include "elicitation/model/model_builder.h"

namespace tactus::workbench {

// The sentences about a study's data and about a build from them, with what each is about.

/// A study as elicitation takes it (session::StudyView), with what was left out of it.
struct ReadStudy {
  study::Study study;
  std::vector<std::string> notes;
};

/// One note for each finding; what is refused says so.
std::vector<BuildNote> dataNotes(const std::vector<study::DataFinding>& findings, const procedure::Procedure& about);

/// The notes of the reading and of the build, in this order.
std::vector<BuildNote> notesOf(const std::vector<std::string>& reading, const elicitation::BuiltModel& built);

/// Everything about `read`, and about the build of `model` from it, where there is one: its text as it was first. A
/// build with the settings of the workbench is made for that. Thread: any.
BuildNotes reviewed(const ReadStudy& read, const std::optional<std::string>& model);

/// The model that a study holds, with its history; and the averaged model, built from the answers as by `tactus build`.
/// Opening a study builds nothing: a model is a record of the study, and the researcher asks for it.
struct ModelInStudy {
  std::vector<study::ModelVersion> versions;    ///< without their texts
  std::optional<editing::EditHistory> history;  ///< of the model; nothing: there is none
  bool has_answers = false;                     ///< a model can be built of them, or the data say why not
};

/// Reads the model of the study. Thread: the one of `file`.
base::Result<ModelInStudy> readModel(const store::StudyFile& file);

/// A model built from the answers of a study.
struct BuiltFromStudy {
  editing::EditHistory history;  ///< of its own
  QString sentence;              ///< of what it was built
  BuildNotes notes;
};
/// Builds the averaged model of the study anew with `settings`, whose time and generator are set here; refused where
/// its data cannot be meant (study::refuseData). Thread: that of `file`.
base::Result<BuiltFromStudy> buildFromStudy(const store::StudyFile& file, const editing::Stamp& stamp,
                                            elicitation::BuildSettings settings = {});

// The texts of the study model's old versions. The study's thread reads the newest in advance, the others on request.

/// Thread: gui.
class VersionTexts : public QObject {
  Q_OBJECT

 public:
  /// 64 MiB: enough text for a long run of undo.
  static constexpr std::size_t kMostAheadBytes = std::size_t{64} << 20U;

  explicit VersionTexts(StudyConnection& study, QObject* parent = nullptr);

  /// Drops all texts. Then reads in advance the newest of `versions` (of the open study, oldest first), about
  /// `most_ahead_bytes` of text, so that undo does not have to wait.
  void begin(const std::vector<study::ModelVersion>& versions, std::size_t most_ahead_bytes = kMostAheadBytes);
  /// Returns a version that has been read, or the error of reading it. A version that is not read yet is an error, too;
  /// it is read then.
  EditController::VersionReader reader();

 signals:
  /// A version that a reader requested too early has been read.
  void arrived();

 private:
  using Read = base::Result<study::ModelVersion>;
  struct Shelf {
    std::map<study::RecordId, Read> read;
    std::set<study::RecordId> asked;     ///< requested too early
    std::vector<study::RecordId> ahead;  ///< to be read, in this order
    std::size_t most_bytes = 0;
    std::size_t bytes = 0;
  };
  void ask(const study::RecordId& id);
  void readAhead(std::size_t next);
  /// Reads `wanted` and puts the texts on the shelf; then calls `then`, unless `begin` has made another shelf.
  void read(std::vector<study::RecordId> wanted, std::function<void()> then);

  StudyConnection& study_;
  std::shared_ptr<Shelf> shelf_;
};

// What there is to say about the data of the open study and about the build of its model. The thread of the study
// reads the data, a thread of its own looks at them, so neither the window nor what is to be stored waits for that.

/// Thread: gui.
class StudyReview : public QObject {
  Q_OBJECT

 public:
  explicit StudyReview(StudyConnection& study, QObject* parent = nullptr);

  /// Forgets everything and looks at the study that is open. `model`: a version of the model whose notes are wanted.
  /// They come from building it once more; where that gives another model than the first version of this one, a note
  /// says so. Without `model` there are no notes of a build.
  void begin(const std::optional<study::RecordId>& model);
  /// Takes what is known already.
  void set(BuildNotes notes);
  void clear() { set({}); }

  const BuildNotes& notes() const { return notes_; }
  /// Something is to come.
  bool isBusy() const { return busy_; }

 signals:
  void changed();

 private:
  void setNotes(BuildNotes notes);

  StudyConnection& study_;
  BuildNotes notes_;
  bool busy_ = false;
  std::uint64_t newest_ = 0;  ///< what was begun before does not count any more
  Background background_;
};

/// Thread: gui.
class StudyModels : public QObject, private StudyKeeper {
  Q_OBJECT

 public:
  /// While the open model belongs to the study, stores every edit of `edits`. `study` outlives this.
  StudyModels(StudyConnection& study, ModelController& models, EditController& edits, QObject* parent = nullptr);
  /// Orders the last edit; the end of `study` waits until it is written.
  ~StudyModels() override;

  /// The open model belongs to the study: its edits become versions.
  bool keepsModel() const;
  /// The study has a model, whether it is the open model or not.
  bool hasModel() const { return has_model_; }
  /// What is odd in the data of the study, and what the build says of its model. Comes some time after the opening.
  const BuildNotes& notes() const { return review_.notes(); }
  /// Still being computed.
  bool isReviewing() const { return review_.isBusy(); }
  /// `Stored in STUDY`, `Saving in STUDY…`, `Not stored in STUDY`; empty if the model does not belong to the study.
  QString savedText() const;
  /// The version of the model on the screen, also if it is not written yet; nothing if the study does not keep the
  /// model. For a model shown in place of the open one: its version, or the version from which it was made.
  std::optional<study::RecordId> modelVersion() const;

 public slots:
  /// Shows the study's model again, as stored last.
  void openModel();
  /// Builds the averaged model from the answers again and adds it to the study as another model.
  void buildModel() { buildModelWith({}); }
  /// The same with the settings of the labs.
  void buildModelWith(const tactus::elicitation::BuildSettings& settings);
  /// Puts the open model with its whole history into the study as versions.
  void putModel();

 signals:
  /// One sentence: what failed for which file, and why.
  void failed(const QString& path, const QString& sentence, const tactus::workbench::MessageAct& act);
  /// One or two sentences about a completed action.
  void said(const QString& sentence);
  /// The study has no model, but answers: one sentence, beside which `buildModel` is offered.
  void buildOffered(const QString& sentence);
  /// A model was built beside the one that was open, which stays in the history: one sentence, and the way back.
  void backOffered(const QString& sentence, const tactus::workbench::MessageAct& back);
  /// `savedText`, `keepsModel` or the state of the connection changed.
  void savedChanged();
  void notesChanged();

 private:
  ReadShare reader() override;
  void orderRest() override;
  QString refusal() const override { return refused_; }
  void orderAgain() override;
  void leave() override;

  void adopt(ModelInStudy& model);
  void show(editing::EditHistory history);
  bool putBeside(const fuzzy::ForceModel& built, const std::string& label, const QString& sentence);
  void storeNow();
  void storeEvents();
  void moveOut();

  StudyConnection& study_;
  ModelController& models_;
  EditController& edits_;
  bool adopting_ = false;  ///< a history is being handed over; its signals must not be stored
  bool has_model_ = false;
  std::size_t events_ordered_ = 0;  ///< events of the history that are stored or ordered to be
  QString refused_;                 ///< why a version was refused for another reason than the disk
  VersionTexts texts_{study_};
  StudyReview review_{study_};
};

}  // namespace tactus::workbench
