// The model of the open study: every edit of it becomes a version in the study, the averaged model is built from the
// answers when it is asked for, and another model is put into the study.
#pragma once

#include <QObject>
#include <QString>
#include <cstddef>
#include <functional>
#include <optional>

#include "app/workbench/base/messages.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/study/connection/study_connection.h"
#include "app/workbench/study/connection/study_keeper.h"
#include "app/workbench/study/model_in_study.h"
#include "app/workbench/study/study_review.h"
#include "app/workbench/study/version_texts.h"
#include "elicitation/model/model_builder.h"

namespace tactus::workbench {

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
  void backOffered(const QString& sentence, const tactus::workbench::MessageAct& act);
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
