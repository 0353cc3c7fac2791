// The sentences about a study's data and about a build from them, with what each is about.
#pragma once

#include <string>
#include <vector>

#include "app/workbench/base/messages.h"
#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "core/study/data_finding.h"
#include "core/study/records.h"
#include "elicitation/model/model_builder.h"

namespace tactus::workbench {

/// A study as elicitation takes it (session::StudyView), with what was left out of it.
struct ReadStudy {
  study::Study study;
  std::vector<std::string> notes;
};

/// One note for each finding; what is refused says so.
std::vector<BuildNote> dataNotes(const std::vector<study::DataFinding>& findings);

/// The notes of the reading and of the build, in this order.
std::vector<BuildNote> notesOf(const std::vector<std::string>& reading, const elicitation::BuiltModel& built);

/// Everything about `read`, and about the build of `model` from it, where there is one: its text as it was first. A
/// build with the settings of the workbench is made for that. Thread: any.
BuildNotes reviewed(const ReadStudy& read, const std::optional<std::string>& model);

}  // namespace tactus::workbench
