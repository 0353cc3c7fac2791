// `tactus study form --responses`: what people answered in a survey system, as the tables of a study.
#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "app/cli/study_commands.h"
#include "app/cli/study_text.h"
#include "app/session/study_protocol.h"
#include "app/session/study_source.h"
#include "core/base/files/file.h"
#include "core/base/json/json_writer.h"
#include "core/base/tables/csv.h"
#include "core/base/text.h"
#include "core/study/csv_tables.h"
#include "core/study/table_line.h"
#include "elicitation/variables/ngt_variables.h"
#include "questionnaires/survey_responses.h"

namespace tactus::cli {
namespace {

using base::Result;
using questionnaires::SurveyResponses;

/// `record,participant`, one row for each record id.
Result<std::map<std::string, std::string>> participantsOf(const std::string& path) {
  std::map<std::string, std::string> out;
  if (path.empty()) return out;
  const auto table = base::CsvTable::read(path);
  if (!table) return tl::unexpected(table.error());
  const auto record = table->require("record");
  if (!record) return tl::unexpected(record.error());
  const auto participant = table->require("participant");
  if (!participant) return tl::unexpected(participant.error());
  for (std::size_t row = 0; row < table->rowCount(); ++row) {
    const std::string code(base::trimmed(table->cell(row, *participant)));
    if (code.empty() || base::looksLikeFormula(code))
      return table->refuse(row, *participant, base::ErrorCode::kValue, base::kNoFormula);
    if (!out.try_emplace(std::string(base::trimmed(table->cell(row, *record))), code).second)
      return table->refuse(row, *record, base::ErrorCode::kSchema, "each record once");
  }
  return out;
}

Result<SurveyResponses> responsesOf(const StudyFormOptions& options, const std::string& form) {
  questionnaires::ResponseSettings settings;
  auto participants = participantsOf(options.participants);
  if (!participants) return tl::unexpected(participants.error());
  settings.participants = std::move(*participants);
  settings.missing = options.missing;
  std::vector<questionnaires::Survey> languages;
  for (const std::string& wording : questionnaires::wordingsOf(form)) {
    if (!options.wording.empty() && wording != options.wording) continue;
    for (const std::string& language : questionnaires::languagesOf(form, wording)) {
      auto one = questionnaires::survey(form, language, wording);
      if (!one) return tl::unexpected(one.error());
      languages.push_back(std::move(*one));
    }
  }
  if (languages.empty()) {
    return base::fail(base::ErrorCode::kReference, "--wording", base::quoted(options.wording),
                      "one of " + base::joined(questionnaires::wordingsOf(form), ", "));
  }
  const auto table = base::CsvTable::read(options.responses);
  if (!table) return tl::unexpected(table.error());
  auto out = questionnaires::surveyResponses(*table, languages, settings);
  if (!out) return out;
  for (study::Answer& answer : out->answers) answer.wording = options.wording;
  if (options.wording.empty() && questionnaires::wordingsOf(form).size() > 1)
    out->notes.push_back("in which words the items were asked is not known; --wording plain or published says it");
  if (table->note()) out->notes.insert(out->notes.begin(), *table->note());
  return out;
}

/// The tables of the responses alone. Who is in the study already keeps what is known of that person.
study::Study tablesOf(SurveyResponses responses, const std::vector<study::Participant>& known) {
  study::Study out;
  for (const std::string& code : responses.participants) {
    const auto it = std::find_if(known.begin(), known.end(), [&](const auto& one) { return one.code == code; });
    study::Participant fresh;
    fresh.code = code;
    out.participants.push_back(it == known.end() ? std::move(fresh) : *it);
  }
  out.answers = std::move(responses.answers);
  return out;
}

/// A folder in which a table would be replaced is refused.
Result<void> requireNoTables(const std::string& folder) {
  std::error_code ignored;
  for (const auto name : {study::kParticipantsTable, study::kSpeedsTable, study::kJudgementsTable, study::kAnswersTable,
                          study::kRulesTable}) {
    if (!std::filesystem::exists(std::filesystem::path(folder) / name, ignored)) continue;
    return tl::unexpected(base::Error{base::ErrorCode::kIo,
                                      folder,
                                      {},
                                      "a folder that holds " + std::string(name),
                                      "a folder without the tables of a study"});
  }
  return {};
}

}  // namespace

Result<Output> studyResponses(const StudyFormOptions& options, const std::string& form,
                              std::vector<std::string> notices) {
  if (auto ok = requireNoTables(options.out); !ok) return tl::unexpected(ok.error());
  std::vector<study::Participant> known;
  std::error_code ignored;
  const auto has_participants = std::filesystem::path(options.study) / study::kParticipantsTable;
  if (!std::filesystem::is_directory(options.study) || std::filesystem::exists(has_participants, ignored)) {
    auto study = session::readStudy(options.study, elicitation::ngtInputIds());
    if (!study) return tl::unexpected(study.error());
    known = std::move(study->study.participants);
  }
  auto responses = responsesOf(options, form);
  if (!responses) return tl::unexpected(responses.error());
  std::vector<std::string> warnings = std::move(notices);
  warnings.insert(warnings.end(), responses->notes.begin(), responses->notes.end());
  const study::Study tables = tablesOf(std::move(*responses), known);
  if (tables.participants.empty()) {
    return tl::unexpected(
        base::Error{base::ErrorCode::kData, options.responses, {}, "no row with an answer", "at least one"});
  }
  if (auto ok = study::writeStudyFolder(tables, elicitation::ngtInputIds(), options.out); !ok)
    return tl::unexpected(ok.error());
  const auto is_answered = [](const study::Answer& one) { return one.status == study::Answer::Status::kAnswered; };
  const auto answered = std::count_if(tables.answers.begin(), tables.answers.end(), is_answered);
  if (!options.json) {
    return Output{base::oneLine(options.out) + ": " + std::to_string(tables.participants.size()) + " participants, " +
                      std::to_string(answered) + " answers; `tactus study import STUDY " + base::oneLine(options.out) +
                      "` adds them\n",
                  std::move(warnings)};
  }
  base::JsonWriter json;
  json.beginObject().key("study").value(options.study).key("form").value(form);
  json.key("responses").value(options.responses).key("folder").value(options.out);
  json.key("participants").value(tables.participants.size());
  json.key("answered").value(static_cast<std::size_t>(answered)).key("warnings").values(warnings);
  return Output{json.endObject().text(), std::move(warnings)};
}

}  // namespace tactus::cli
