#include <cstdlib>
#include <filesystem>

#include "app/cli/study_commands.h"
#include "app/cli/study_text.h"
#include "core/base/clock.h"
#include "core/base/error.h"
#include "core/base/json/json_writer.h"
#include "core/store/copies.h"
#include "core/store/person_codes.h"
#include "core/store/withdrawal.h"

namespace tactus::cli {
namespace {

using base::ErrorCode;
using base::Result;

/// Where the workbench keeps what a crash must not lose (app/workbench/tune/history/history_file.h).
std::vector<std::string> autosaveFolders() {
  namespace fs = std::filesystem;
  const char* const data = std::getenv("XDG_DATA_HOME");  // NOLINT(concurrency-mt-unsafe)
  const char* const home = std::getenv("HOME");           // NOLINT(concurrency-mt-unsafe)
  fs::path root = data != nullptr && *data != '\0' ? fs::path(data) : fs::path();
  if (root.empty() && home != nullptr) root = fs::path(home) / ".local" / "share";
  if (root.empty()) return {};
  return {(root / "Tactus" / "tactus-workbench" / "autosave").string()};
}

void addCopies(const std::string& file, const study::RecordId& person, const std::vector<std::string>& codes,
               Output& output) {
  for (const auto& copy : store::findCopies(file, person, codes, autosaveFolders())) {
    output.warnings.push_back(copy.path + ": " + copy.what + "; withdraw there too, or delete it");
  }
}

/// The members that every JSON of a withdrawal begins with.
void beginJson(base::JsonWriter& json, const StudyWithdrawOptions& options, const std::string& code,
               const study::RecordId& person, bool removed) {
  json.beginObject().key("file").value(options.file).key("participant").value(code);
  json.key("id").value(toText(person)).key("removed").value(removed);
}

std::string endJson(base::JsonWriter& json, const std::vector<std::string>& warnings) {
  return json.key("warnings").values(warnings).endObject().text();
}

/// What is left to do for a participant who withdrew already.
Result<Output> finishWithdrawal(store::StudyFile& file, const StudyWithdrawOptions& options,
                                const store::Tombstone& tombstone) {
  TACTUS_TRY(const auto unfinished, store::unfinishedErasures(file));
  Output output;
  output.text = base::oneLine(options.person + " withdrew from " + options.file) + " on " + utcText(tombstone.utc_ms);
  if (unfinished.empty()) {
    output.text += "; there is nothing left to remove\n";
  } else {
    if (auto erased = store::erase(file); !erased) return tl::unexpected(erased.error());
    output.text += "; the erasure, which was interrupted, is finished now\n";
  }
  output.warnings = noticesButErasure(file);
  if (auto closed = file.close(); !closed) return tl::unexpected(closed.error());
  addCopies(options.file, tombstone.person, {options.person}, output);
  if (options.json) {
    base::JsonWriter json;
    beginJson(json, options, options.person, tombstone.person, true);
    json.key("records").value(0).key("models_cleaned").value(0);
    output.text = endJson(json, output.warnings);
  }
  return output;
}

/// What would go and what would stay; changes nothing.
Result<Output> previewOf(const StudyWithdrawOptions& options) {
  TACTUS_TRY(const auto file, store::StudyFile::open(options.file, {store::Access::kReadOnly}));
  TACTUS_TRY(const auto person, store::personNamed(file, options.person));
  TACTUS_TRY(const auto preview, store::previewWithdrawal(file, person.id));
  const auto line = [](const char* what, long long count) {
    return std::string("  ") + what + ' ' + std::to_string(count) + '\n';
  };
  Output output;
  output.text = "A withdrawal of " + base::oneLine(person.code) + " from " + base::oneLine(options.file) +
                " would remove " + std::to_string(preview.records) + " records for good:\n" +
                line("sessions", preview.sessions) + line("strokes", preview.strokes) +
                line("judgements", preview.judgements) + line("answers", preview.answers) +
                line("rules given directly", preview.rules) + line("profiles", preview.profiles) +
                line("ratings", preview.ratings) + line("placements felt", preview.placements) +
                line("recordings of feeling", preview.feel_recordings) +
                line("versions of models cleaned of the participant's rules", preview.models_cleaned) +
                "What would stay:\n" + line("versions of models as they are", preview.models_kept);
  output.warnings = noticesOf(file);
  addCopies(options.file, person.id, {person.code}, output);
  if (options.json) {
    base::JsonWriter json;
    beginJson(json, options, person.code, person.id, false);
    json.key("records").value(preview.records).key("sessions").value(preview.sessions);
    json.key("strokes").value(preview.strokes).key("judgements").value(preview.judgements);
    json.key("answers").value(preview.answers).key("rules").value(preview.rules);
    json.key("profiles").value(preview.profiles).key("ratings").value(preview.ratings);
    json.key("placements").value(preview.placements).key("feel_recordings").value(preview.feel_recordings);
    json.key("models_cleaned").value(preview.models_cleaned).key("models_kept").value(preview.models_kept);
    output.text = endJson(json, output.warnings);
  }
  return output;
}

}  // namespace

Result<Output> studyRecode(const StudyRecodeOptions& options) {
  std::vector<std::string> notices;
  TACTUS_TRY(auto file, openToWrite(options.file, notices));
  TACTUS_TRY(const auto person, store::personNamed(file, options.person));
  if (const auto recoded = store::recode(file, person.id, options.code, study::RecordIds().next(), utcNowMs());
      !recoded)
    return tl::unexpected(recoded.error());
  for (auto& notice : noticesOf(file)) notices.push_back(std::move(notice));
  if (auto closed = file.close(); !closed) return tl::unexpected(closed.error());
  return Output{"The participant " + base::oneLine(person.code) + " (" + toText(person.id) + ") has the code " +
                    base::oneLine(options.code + " in " + options.file) + " now\n",
                std::move(notices)};
}

Result<Output> studyWithdraw(const StudyWithdrawOptions& options) {
  if (options.dry_run) return previewOf(options);
  TACTUS_TRY(auto file, store::StudyFile::open(options.file));
  const auto person = store::personNamed(file, options.person);
  if (!person) {
    const auto withdrawn = store::withdrawnWithCode(file, options.person);
    if (withdrawn && *withdrawn) return finishWithdrawal(file, options, **withdrawn);
    return tl::unexpected(person.error());
  }
  TACTUS_TRY(const auto withdrawal, store::withdraw(file, person->id, utcNowMs()));
  Output output;
  output.warnings = noticesButErasure(file);  // what was interrupted before is finished with it
  if (auto closed = file.close(); !closed) return tl::unexpected(closed.error());
  output.text = "Removed " + std::to_string(withdrawal.records) + " records of " + base::oneLine(person->code) +
                " from " + base::oneLine(options.file) + " and cleaned " + std::to_string(withdrawal.models) +
                " versions of models. Backups and exports made before still hold them.\n";
  for (const auto& code : withdrawal.shared_codes) {
    output.warnings.push_back(base::quoted(code) +
                              " is the code of another participant too: models and texts with it "
                              "were left as they are");
  }
  addCopies(options.file, person->id, {person->code}, output);
  if (options.json) {
    base::JsonWriter json;
    beginJson(json, options, person->code, person->id, true);
    json.key("records").value(withdrawal.records).key("models_cleaned").value(withdrawal.models);
    output.text = endJson(json, output.warnings);
  }
  return output;
}

Result<Output> studyErase(const StudyEraseOptions& options) {
  TACTUS_TRY(auto file, store::StudyFile::open(options.file));
  TACTUS_TRY(const auto erasure, store::erase(file));
  TACTUS_TRY(const auto withdrawn, store::tombstones(file));
  Output output;
  output.warnings = noticesButErasure(file);
  if (auto closed = file.close(); !closed) return tl::unexpected(closed.error());
  output.text = base::oneLine(options.file) + ": " +
                (erasure.unfinished.empty() ? std::string("no erasure was interrupted")
                                            : "finished the erasure of " + std::to_string(erasure.unfinished.size()) +
                                                  (erasure.unfinished.size() == 1 ? " participant" : " participants")) +
                "; the file holds no data of withdrawn participants any more\n";
  for (const auto& tombstone : withdrawn) addCopies(options.file, tombstone.person, {}, output);
  if (options.json) {
    base::JsonWriter json;
    json.beginObject().key("file").value(options.file).key("finished").beginArray();
    for (const auto& person : erasure.unfinished) json.value(toText(person));
    json.endArray().key("models_cleaned").value(erasure.models).key("withdrawn").value(withdrawn.size());
    output.text = json.key("warnings").values(output.warnings).endObject().text();
  }
  return output;
}

}  // namespace tactus::cli
