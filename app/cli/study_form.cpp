// `tactus study form`: the questionnaire of a study as a web page, for survey systems and on paper; the way back from
// survey systems.
#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "app/cli/study_commands.h"
#include "app/cli/study_text.h"
#include "app/report/printed_form.h"
#include "app/session/session_notes.h"
#include "app/session/study_protocol.h"
#include "app/session/study_source.h"
#include "app/webform/pictures.h"
#include "app/webform/web_form.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/json/json_writer.h"
#include "core/base/tables/csv.h"
#include "core/base/text.h"
#include "core/procedure/procedure.h"
#include "core/study/csv_tables.h"
#include "core/study/table_line.h"
#include "questionnaires/survey.h"
#include "questionnaires/survey_responses.h"

namespace tactus::cli {
namespace {

using base::Result;
using questionnaires::SurveyResponses;

struct AskedForm {
  session::StudyProtocol protocol;
  std::string form;
  std::vector<std::string> languages;
  std::vector<std::string> notices;
};

/// `record,participant`, one row for each record id.
Result<std::map<std::string, std::string>> participantsOf(const std::string& path) {
  std::map<std::string, std::string> out;
  if (path.empty()) return out;
  TACTUS_TRY(const auto table, base::CsvTable::read(path));
  TACTUS_TRY(const auto record, table.require("record"));
  TACTUS_TRY(const auto participant, table.require("participant"));
  for (std::size_t row = 0; row < table.rowCount(); ++row) {
    const std::string code(base::trimmed(table.cell(row, participant)));
    if (code.empty() || base::looksLikeFormula(code))
      return table.refuse(row, participant, base::ErrorCode::kValue, base::kNoFormula);
    if (!out.try_emplace(std::string(base::trimmed(table.cell(row, record))), code).second)
      return table.refuse(row, record, base::ErrorCode::kSchema, "each record once");
  }
  return out;
}

Result<SurveyResponses> responsesOf(const StudyFormOptions& options, const AskedForm& asked) {
  const std::string& form = asked.form;
  const procedure::Procedure& about = asked.protocol.settings.about();
  questionnaires::ResponseSettings settings;
  TACTUS_TRY(auto participants, participantsOf(options.participants));
  settings.participants = std::move(participants);
  settings.missing = options.missing;
  session::StudyProtocol every = asked.protocol;
  every.languages = about.languages;
  std::vector<questionnaires::Survey> languages;
  for (const std::string& wording : questionnaires::wordingsOf(about, form)) {
    if (!options.wording.empty() && wording != options.wording) continue;
    for (const std::string& language : questionnaires::languagesOf(about, form, wording)) {
      TACTUS_TRY(auto one, questionnaires::survey(about, form, language, wording));
      const auto content = webform::formContent({}, {}, every, wording);
      const auto* const words = content ? content->language(language) : nullptr;
      if (words != nullptr) one.opening = webform::openingOf(*content, *words);
      languages.push_back(std::move(one));
    }
  }
  if (languages.empty()) {
    return base::fail(base::ErrorCode::kReference, "--wording", base::quoted(options.wording),
                      "one of " + base::joined(questionnaires::wordingsOf(about, form), ", "));
  }
  TACTUS_TRY(const auto table, base::CsvTable::read(options.responses));
  auto out = questionnaires::surveyResponses(table, languages, settings);
  if (!out) return out;
  for (study::Answer& answer : out->answers) answer.wording = options.wording;
  if (options.wording.empty() && questionnaires::wordingsOf(about, form).size() > 1)
    out->notes.push_back("in which words the items were asked is not known; --wording plain or published says it");
  if (table.note()) out->notes.insert(out->notes.begin(), *table.note());
  return out;
}

/// The tables of the responses alone. Who is in the study already keeps what is known of that person.
study::Study tablesOf(SurveyResponses responses, const std::vector<study::Participant>& known) {
  study::Study out;
  for (const std::string& code : responses.participants) {
    const auto it = std::find_if(known.begin(), known.end(), [&](const auto& one) { return one.code == code; });
    study::Participant fresh;
    fresh.code = code;
    const auto& said = responses.profiles[code];
    if (const auto years = said.find("years"); years != said.end()) {
      if (const auto band = session::experienceBandCalled(years->second)) fresh.years_experience = band->middle_years;
    }
    if (const auto hand = said.find("handedness"); hand != said.end()) fresh.handedness = hand->second;
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

/// The responses as the tables of a study, in the folder `out`.
Result<Output> studyResponses(const StudyFormOptions& options, const AskedForm& asked) {
  const std::string& form = asked.form;
  if (auto ok = requireNoTables(options.out); !ok) return tl::unexpected(ok.error());
  std::vector<study::Participant> known;
  std::error_code ignored;
  const auto has_participants = std::filesystem::path(options.study) / study::kParticipantsTable;
  if (!std::filesystem::is_directory(options.study) || std::filesystem::exists(has_participants, ignored)) {
    TACTUS_TRY(auto study, session::readStudy(options.study));
    known = std::move(study.study.participants);
  }
  TACTUS_TRY(auto responses, responsesOf(options, asked));
  std::vector<std::string> warnings = asked.notices;
  warnings.insert(warnings.end(), responses.notes.begin(), responses.notes.end());
  study::Study tables = tablesOf(std::move(responses), known);
  tables.procedure = asked.protocol.settings.procedure;
  if (tables.participants.empty()) {
    return tl::unexpected(
        base::Error{base::ErrorCode::kData, options.responses, {}, "no row with an answer", "at least one"});
  }
  if (auto ok = session::writeTables(tables, options.out); !ok) return tl::unexpected(ok.error());
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

using questionnaires::Survey;

/// The form and the languages of the study's protocol; the defaults for a file without one and for tables.
base::Result<AskedForm> askedForm(const std::string& path) {
  session::StudyProtocol protocol;
  std::vector<std::string> notices;
  if (!std::filesystem::is_directory(path)) {
    TACTUS_TRY(const auto file, store::StudyFile::open(path, {store::Access::kReadOnly}));
    auto current = session::currentProtocol(file);
    if (!current) return base::inFile(current.error(), path);
    if (*current) protocol = std::move(**current);
    notices = noticesOf(file);
  }
  return AskedForm{protocol, protocol.settings.form, protocol.languages, std::move(notices)};
}

/// The form in the languages of the study in which it has these words. Says which it has not.
base::Result<std::vector<Survey>> surveysOf(AskedForm& asked, const std::string& wording) {
  const auto known = questionnaires::languagesOf(asked.protocol.settings.about(), asked.form, wording);
  std::vector<Survey> out;
  std::vector<std::string> without;
  for (const std::string& language : asked.languages) {
    if (!wording.empty() && std::find(known.begin(), known.end(), language) == known.end()) {
      without.push_back(language);
      continue;
    }
    TACTUS_TRY(auto one, questionnaires::survey(asked.protocol.settings.about(), asked.form, language, wording));
    out.push_back(std::move(one));
  }
  if (out.empty()) {
    return base::fail(
        base::ErrorCode::kReference, "--wording", base::quoted(wording) + " in " + base::joined(without, ", "),
        known.empty() ? "a wording of " + base::quoted(asked.form) : "a study in " + base::joined(known, " or "));
  }
  if (!without.empty())
    asked.notices.push_back("not written in " + base::joined(without, ", ") + ": the wording " + base::quoted(wording) +
                            " is there in " + base::joined(known, ", ") + " only");
  asked.languages.clear();
  // Consent, profile and words, as on the screens and on the web page.
  TACTUS_TRY(const auto content, webform::formContent({}, {}, asked.protocol, wording));
  for (Survey& survey : out) {
    asked.languages.push_back(survey.language);
    if (const auto* const language = content.language(survey.language))
      survey.opening = webform::openingOf(content, *language);
  }
  return out;
}

using NamedFiles = std::vector<std::pair<std::string, std::string>>;

/// The usual picture with the regions that the form asks about; with those of the first form for one without
/// conditions.
std::string regionsPicture(const AskedForm& asked) {
  const procedure::Procedure& about = asked.protocol.settings.about();
  const study::Form* const form = about.form(asked.form);
  return webform::regionsPicture(about, form == nullptr ? about.forms.front() : *form);
}

NamedFiles filesFor(const std::string& to, const AskedForm& asked, const std::vector<Survey>& surveys) {
  NamedFiles out;
  const std::string& name = surveys.front().name;
  if (to == "limesurvey") {
    out.emplace_back(name + ".txt", questionnaires::limeSurveyStructure(surveys));
  } else {
    for (const Survey& survey : surveys) {
      const std::string file = name + "." + survey.language;
      if (to == "redcap") out.emplace_back(file + ".csv", questionnaires::redcapDictionary(survey));
      if (to == "print") out.emplace_back(file + ".html", report::printedForm(survey, regionsPicture(asked)));
    }
  }
  if (to != "print") {
    out.emplace_back("fields.csv", questionnaires::fieldTable(surveys.front()));
    out.emplace_back("codes.csv", questionnaires::codeTable(surveys.front()));
  }
  return out;
}

/// Writes the files into the folder `--out`; their paths.
Result<std::vector<std::string>> written(const StudyFormOptions& options, const NamedFiles& files) {
  if (const auto made = base::makeFolder(options.out); !made) return tl::unexpected(made.error());
  std::vector<std::string> paths;
  for (const auto& [name, text] : files) {
    paths.push_back(options.out + "/" + name);
    if (const auto done = base::writeFileAtomically(paths.back(), text); !done) return tl::unexpected(done.error());
  }
  return paths;
}

std::string linesOf(const std::vector<std::string>& paths) {
  std::string text;
  for (const std::string& path : paths) text += base::oneLine(path) + '\n';
  return text;
}

/// The form as a web page. Its answers come back into a study file, so a folder of tables has none.
Result<Output> webForm(const StudyFormOptions& options) {
  if (std::filesystem::is_directory(options.study)) {
    return tl::unexpected(base::Error{base::ErrorCode::kReference,
                                      options.study,
                                      {},
                                      "a folder of tables",
                                      "a study file, whose id the answers name"});
  }
  TACTUS_TRY(const auto file, store::StudyFile::open(options.study, {store::Access::kReadOnly}));
  const auto content = webform::currentForm(file, options.wording);
  if (!content) return base::inFile(content.error(), options.study);
  std::vector<std::string> warnings = noticesOf(file);
  if (content->consent_version.empty()) {
    warnings.emplace_back(
        "the study has no protocol, so the form has no consent text and names no contact: for trying only; "
        "tactus study protocol sets both");
  }
  TACTUS_TRY(const auto paths, written(options, {{"form.html", webform::webPage(*content)},
                                                 {"README.txt", webform::webReadme(*content)}}));
  if (!options.json) return Output{linesOf(paths), std::move(warnings)};
  std::vector<std::string> languages;
  for (const auto& language : content->languages) languages.push_back(language.id);
  base::JsonWriter json;
  json.beginObject().key("study").value(options.study).key("form").value(content->form);
  json.key("wording").value(content->wording).key("form_sha256").value(content->sha256);
  json.key("languages").values(languages).key("files").values(paths).key("warnings").values(warnings);
  return Output{json.endObject().text(), std::move(warnings)};
}

}  // namespace

base::Result<Output> studyForm(const StudyFormOptions& options) {
  if (options.to == "web") return webForm(options);
  TACTUS_TRY(auto asked, askedForm(options.study));
  if (!options.responses.empty()) return studyResponses(options, asked);
  const auto surveys = surveysOf(asked, options.wording);
  if (!surveys) return base::inFile(surveys.error(), options.study);
  const NamedFiles files = filesFor(options.to, asked, *surveys);
  TACTUS_TRY(const auto paths, written(options, files));
  std::vector<std::string> pictures;
  if (options.to != "print") {
    TACTUS_TRY(pictures, written(options, {{surveys->front().name + ".picture.svg", regionsPicture(asked)}}));
  }
  std::vector<std::string> warnings = std::move(asked.notices);
  if (options.to == "limesurvey") {
    warnings.push_back("this structure was never imported into a LimeSurvey server; look at it before it is used");
  }
  if (!options.json) return Output{linesOf(paths) + linesOf(pictures), std::move(warnings)};
  base::JsonWriter json;
  json.beginObject().key("study").value(options.study).key("form").value(asked.form);
  json.key("wording").value(surveys->front().wording);
  json.key("languages").values(asked.languages).key("files").values(paths).key("pictures").values(pictures);
  json.key("warnings").values(warnings);
  return Output{json.endObject().text(), std::move(warnings)};
}

}  // namespace tactus::cli
