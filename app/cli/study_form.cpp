// `tactus study form`: the questionnaire of a study for survey systems, and on paper; the way back:
// study_responses.cpp.
#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/cli/study_commands.h"
#include "app/cli/study_text.h"
#include "app/report/printed_form.h"
#include "app/session/study_protocol.h"
#include "core/base/files/file.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"
#include "questionnaires/survey.h"

namespace tactus::cli {
namespace {

using questionnaires::Survey;

struct AskedForm {
  std::string form;
  std::vector<std::string> languages;
  std::vector<std::string> notices;
};

/// The form and the languages of the study's protocol; the defaults for a file without one and for tables.
base::Result<AskedForm> askedForm(const std::string& path) {
  session::StudyProtocol protocol;
  std::vector<std::string> notices;
  if (!std::filesystem::is_directory(path)) {
    const auto file = store::StudyFile::open(path, {store::Access::kReadOnly});
    if (!file) return tl::unexpected(file.error());
    auto current = session::currentProtocol(*file);
    if (!current) return base::inFile(current.error(), path);
    if (*current) protocol = std::move(**current);
    notices = noticesOf(*file);
  }
  return AskedForm{protocol.settings.form, protocol.languages, std::move(notices)};
}

/// The form in the languages of the study in which it has these words. Says which it has not.
base::Result<std::vector<Survey>> surveysOf(AskedForm& asked, const std::string& wording) {
  const auto known = questionnaires::languagesOf(asked.form, wording);
  std::vector<Survey> out;
  std::vector<std::string> without;
  for (const std::string& language : asked.languages) {
    if (!wording.empty() && std::find(known.begin(), known.end(), language) == known.end()) {
      without.push_back(language);
      continue;
    }
    auto one = questionnaires::survey(asked.form, language, wording);
    if (!one) return tl::unexpected(one.error());
    out.push_back(std::move(*one));
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
  for (const Survey& survey : out) asked.languages.push_back(survey.language);
  return out;
}

using NamedFiles = std::vector<std::pair<std::string, std::string>>;

NamedFiles filesFor(const std::string& to, const std::vector<Survey>& surveys) {
  NamedFiles out;
  const std::string& name = surveys.front().name;
  if (to == "limesurvey") {
    out.emplace_back(name + ".txt", questionnaires::limeSurveyStructure(surveys));
  } else {
    for (const Survey& survey : surveys) {
      const std::string file = name + "." + survey.language;
      if (to == "redcap") out.emplace_back(file + ".csv", questionnaires::redcapDictionary(survey));
      if (to == "print") out.emplace_back(file + ".html", report::printedForm(survey));
    }
  }
  if (to != "print") {
    out.emplace_back("fields.csv", questionnaires::fieldTable(surveys.front()));
    out.emplace_back("codes.csv", questionnaires::codeTable(surveys.front()));
  }
  return out;
}

}  // namespace

base::Result<Output> studyForm(const StudyFormOptions& options) {
  auto asked = askedForm(options.study);
  if (!asked) return tl::unexpected(asked.error());
  if (!options.responses.empty()) return studyResponses(options, asked->form, std::move(asked->notices));
  const auto surveys = surveysOf(*asked, options.wording);
  if (!surveys) return base::inFile(surveys.error(), options.study);
  const NamedFiles files = filesFor(options.to, *surveys);
  if (const auto made = base::makeFolder(options.out); !made) return tl::unexpected(made.error());
  std::vector<std::string> paths;
  for (const auto& [name, text] : files) {
    paths.push_back(options.out + "/" + name);
    if (const auto written = base::writeFileAtomically(paths.back(), text); !written)
      return tl::unexpected(written.error());
  }
  std::vector<std::string> warnings = std::move(asked->notices);
  if (options.to == "limesurvey") {
    warnings.push_back("this structure was never imported into a LimeSurvey server; look at it before it is used");
  }
  if (!options.json) {
    std::string text;
    for (const std::string& path : paths) text += base::oneLine(path) + '\n';
    return Output{std::move(text), std::move(warnings)};
  }
  base::JsonWriter json;
  json.beginObject().key("study").value(options.study).key("form").value(asked->form);
  json.key("wording").value(surveys->front().wording);
  json.key("languages").values(asked->languages).key("files").values(paths).key("warnings").values(warnings);
  return Output{json.endObject().text(), std::move(warnings)};
}

}  // namespace tactus::cli
