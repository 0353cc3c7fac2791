// The model that a study holds, with its history. If the study has answers but no model, the averaged model is built as
// by `tactus build`.
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "app/editing/edit_history.h"
#include "app/workbench/base/build_note.h"
#include "core/store/study_file.h"
#include "core/study/session_records.h"
#include "elicitation/model/model_builder.h"

namespace tactus::workbench {

struct ModelInStudy {
  std::vector<study::ModelVersion> versions;    ///< without their texts
  std::optional<editing::EditHistory> history;  ///< of the model; nothing: there is none
  bool built = false;                           ///< the model was built just now and is no version yet
  QString note;                                 ///< one or two sentences for the person; may be empty
  BuildNotes notes;                             ///< where a model was built
};

/// Reads the model of the study. `stamp`: author and time of a model that is built. Thread: the one of `file`.
base::Result<ModelInStudy> readModel(const store::StudyFile& file, const editing::Stamp& stamp);

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

}  // namespace tactus::workbench
