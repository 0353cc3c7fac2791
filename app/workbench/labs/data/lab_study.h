// What the labs know of the open study: read once in the thread of the study, then shared unchanged.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/session/judged_forces.h"
#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/records.h"
#include "core/study/session_records.h"
#include "elicitation/depth/depth_measurement.h"

namespace tactus::workbench {

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

}  // namespace tactus::workbench
