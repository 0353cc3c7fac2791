// The part of a study that the workbench loads on opening: participants, the model with its history, and recordings. If
// the study has no model yet, the averaged model is built as by `tactus build`.
#pragma once

#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

#include "app/editing/edit_history.h"
#include "app/workbench/base/build_note.h"
#include "app/workbench/base/study_notice.h"
#include "core/store/feel_records.h"
#include "core/store/study_file.h"
#include "core/store/study_info.h"
#include "core/study/session_records.h"

namespace tactus::workbench {

/// A person who can feel a model.
struct StudyPerson {
  study::RecordId id;
  QString code;
  bool simulated = false;
  bool researcher = false;  ///< says so in a profile
};

/// The profile category that marks the researcher of a study.
inline constexpr auto kResearcherCategory = "researcher";

struct StudyContents {
  QString path;
  store::StudyInfo info;
  std::vector<StudyPerson> people;  ///< sorted by code
  std::vector<store::FeelSummary> recordings;
  std::vector<study::ModelVersion> versions;    ///< without their texts
  std::optional<editing::EditHistory> history;  ///< of the model; nothing: there is none
  bool built = false;                           ///< the model was built just now and is no version yet
  QString note;                                 ///< one or two sentences for the person; may be empty
  BuildNotes notes;                             ///< where a model was built
  StudyNotices notices;
};

/// Reads the study. `stamp`: author and time of a model that is built. Thread: the one of `file`.
base::Result<StudyContents> readContents(const store::StudyFile& file, const editing::Stamp& stamp);

/// A model built from the answers of a study.
struct BuiltFromStudy {
  editing::EditHistory history;  ///< of its own
  QString sentence;              ///< of what it was built
  BuildNotes notes;
};
/// Builds the averaged model of the study anew; refused where its data cannot be meant (study::refuseData). Thread:
/// that of `file`.
base::Result<BuiltFromStudy> buildFromStudy(const store::StudyFile& file, const editing::Stamp& stamp);

/// What happened to the study. Thread: that of `file`.
base::Result<StudyNotices> readNotices(const store::StudyFile& file);

/// The participants of the study. Thread: that of `file`.
base::Result<std::vector<StudyPerson>> readPeople(const store::StudyFile& file);

/// The current time of the wall clock, ms since 1970 UTC.
std::int64_t utcNowMs();

}  // namespace tactus::workbench
