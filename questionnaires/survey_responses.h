// The answers in a table of responses, as a survey system exports it.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/tables/csv.h"
#include "core/study/records.h"
#include "questionnaires/survey.h"

namespace tactus::questionnaires {

struct ResponseSettings {
  /// Participant of each record id. Empty: the record ids are the participants' codes.
  std::map<std::string, std::string> participants;
  std::vector<std::string> missing;  ///< further cells that mean no answer, such as `-999`
};

struct SurveyResponses {
  std::vector<std::string> participants;  ///< in the order of the rows
  std::vector<study::Answer> answers;     ///< of each participant all items of the form
  /// What participants said of themselves: stored value by field (SurveyOpening::profile), of those who did.
  std::map<std::string, std::map<std::string, std::string>> profiles;
  std::vector<std::string> notes;  ///< one sentence each: columns and rows that are left out
};

/// Reads one row for each participant. `languages`: the same form in each language whose labels may be in the table.
/// Columns: the record id is `record_id`, `code` or the first column; the items are `q01` (REDCap), `m01[q01]`
/// (LimeSurvey) or, if no item is called so, the items' texts where each is there once. Cells: codes or labels; an
/// empty one is `skipped`. Columns of the profile are read if the languages have an opening. A row without any answer
/// is left out. Refused, with line and column: an item without a column, a cell that is no code and no label, a second
/// row of a participant, a record id that `participants` lacks.
base::Result<SurveyResponses> surveyResponses(const base::CsvTable& table, std::span<const Survey> languages,
                                              const ResponseSettings& settings = {});

}  // namespace tactus::questionnaires
