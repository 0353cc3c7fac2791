// The model that a study holds, with its history; and the averaged model, built from the answers as by `tactus build`.
// Opening a study builds nothing: a model is a record of the study, and the researcher asks for it.
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "app/editing/edit_history.h"
#include "app/workbench/base/messages.h"
#include "core/store/study_file.h"
#include "core/study/session_records.h"
#include "elicitation/model/model_builder.h"

namespace tactus::workbench {

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

}  // namespace tactus::workbench
