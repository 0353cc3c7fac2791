// `tactus study import` of answer files: those that the form as a web page saves.
#include <filesystem>
#include <utility>

#include "app/cli/study_commands.h"
#include "app/cli/study_text.h"
#include "app/webform/answers.h"
#include "core/base/json/json_writer.h"

namespace tactus::cli {

using base::Result;

Result<Output> studyAnswers(const StudyImportOptions& options) {
  for (const std::string& path : options.sources) {
    std::error_code ignored;
    if (!std::filesystem::is_directory(path, ignored)) continue;
    return tl::unexpected(base::Error{
        base::ErrorCode::kIo, path, {}, "a folder among answer files", "answer files, or one folder alone"});
  }
  std::vector<std::string> warnings;
  TACTUS_TRY(auto file, openToWrite(options.file, warnings));
  TACTUS_TRY(auto imported, webform::importAnswers(file, options.sources, utcNowMs()));
  for (auto& notice : noticesOf(file)) warnings.push_back(std::move(notice));
  const auto notices = warnings;
  for (auto& warning : closeSaved(file)) warnings.push_back(std::move(warning));
  warnings.insert(warnings.end(), imported.notes.begin(), imported.notes.end());
  if (!options.json) {
    std::string text;
    for (const auto& one : imported.files) {
      text += base::oneLine(one.path + ": " + one.participant) +
              (one.added ? ", answered " + std::to_string(one.answered) : ", in the study already") + '\n';
    }
    return Output{text + "Added persons " + std::to_string(imported.persons) + ", sessions " +
                      std::to_string(imported.sessions) + ", records " + std::to_string(imported.records) + " to " +
                      base::oneLine(options.file) + '\n',
                  std::move(warnings)};
  }
  base::JsonWriter json;
  json.beginObject().key("file").value(options.file).key("answers").beginArray();
  for (const auto& one : imported.files) {
    json.beginObject().key("file").value(one.path).key("participant").value(one.participant);
    json.key("added").value(one.added).key("answered").value(one.answered).endObject();
  }
  json.endArray().key("persons").value(imported.persons).key("sessions").value(imported.sessions);
  json.key("records").value(imported.records).key("notes").values(imported.notes).key("notices").values(notices);
  return Output{json.endObject().text(), std::move(warnings)};
}

}  // namespace tactus::cli
