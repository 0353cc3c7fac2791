#include <filesystem>

#include "app/cli/findings_text.h"
#include "app/cli/study_commands.h"
#include "app/cli/study_text.h"
#include "app/session/data_checks.h"
#include "app/session/export_folder.h"
#include "app/session/study_source.h"
#include "app/version.h"
#include "core/base/clock.h"
#include "core/base/error.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"
#include "core/procedure/procedure.h"
#include "core/store/merge.h"
#include "core/store/study_info.h"

namespace tactus::cli {
namespace {

using base::ErrorCode;
using base::Result;
using Layout = base::JsonWriter::Layout;

std::string infoAsText(const std::string& file, const store::StudyInfo& info, const procedure::Procedure& about) {
  std::string text = base::oneLine(file + ": " + info.name) + "\n  made " + utcText(info.created_utc_ms) + " with " +
                     base::oneLine(info.program) + "\n  version of the file " + std::to_string(info.version) +
                     "\n  id " + toText(info.id) + '\n';
  if (about.id != procedure::defaultProcedure()->id)
    text +=
        "  procedure " + about.id + ", version " + std::to_string(about.version) + ", SHA-256 " + about.sha256 + '\n';
  for (const auto& count : info.counts) text += "  " + count.table + ' ' + std::to_string(count.rows) + '\n';
  if (info.protocol_version > 0) {
    text += "  protocol: version " + std::to_string(info.protocol_version) +
            (info.protocol_locked ? ", which participants follow\n" : ", a draft\n");
  }
  if (info.placements > 0) text += "  placements felt: " + std::to_string(info.placements) + " of the events\n";
  if (info.feel_recordings > 0) text += "  recordings of feeling: " + std::to_string(info.feel_recordings) + '\n';
  if (info.simulated_persons > 0) {
    text += "  simulated: " + std::to_string(info.simulated_persons) + " of the persons\n";
  }
  return text;
}

std::string infoAsJson(const std::string& file, const store::StudyInfo& info, const procedure::Procedure& about,
                       const std::vector<std::string>& notices) {
  base::JsonWriter json;
  json.beginObject().key("file").value(file).key("id").value(toText(info.id)).key("name").value(info.name);
  json.key("created_utc").value(utcText(info.created_utc_ms)).key("program").value(info.program);
  json.key("version").value(info.version).key("simulated_persons").value(info.simulated_persons);
  json.key("protocol_version").value(info.protocol_version).key("protocol_locked").value(info.protocol_locked);
  json.key("procedure").beginObject(Layout::kInline).key("id").value(about.id);
  json.key("pack_version").value(about.version).key("sha256").value(about.sha256).endObject();
  json.key("placements").value(info.placements).key("feel_recordings").value(info.feel_recordings);
  json.key("rows");
  writeCounts(info.counts, json);
  json.key("notices").values(notices).endObject();
  return json.text();
}

struct NamedMerge {
  std::string file;
  store::Merge merge;
};

std::string mergesAsText(const std::vector<NamedMerge>& merges) {
  std::string text;
  for (const auto& [file, merge] : merges) text += base::oneLine(file) + ": " + mergeAsText(merge);
  return text;
}

std::string mergesAsJson(const std::string& file, const std::vector<NamedMerge>& merges,
                         const std::vector<std::string>& notices) {
  base::JsonWriter json;
  json.beginObject().key("file").value(file).key("merged").beginArray();
  for (const auto& [other, merge] : merges) {
    json.beginObject().key("file").value(other);
    writeMerge(merge, json);
    json.endObject();
  }
  json.endArray().key("notices").values(notices).endObject();
  return json.text();
}

}  // namespace

Result<Output> studyNew(const StudyNewOptions& options) {
  const std::string name = options.name.empty() ? std::filesystem::path(options.file).stem().string() : options.name;
  session::ProcedurePtr procedure;
  if (!options.pack.empty()) {
    TACTUS_TRY(procedure, packNamed(options.pack));
  }
  TACTUS_TRY(auto file, newStudy(options.file, name));
  if (procedure != nullptr && procedure != procedure::defaultProcedure()) {
    auto tools = session::systemTools();
    if (auto kept = session::keepProcedure(file, procedure, tools); !kept)
      return tl::unexpected(std::move(kept).error());
  }
  TACTUS_TRY(const auto info, store::studyInfo(file));
  if (auto closed = file.close(); !closed) return tl::unexpected(closed.error());
  if (options.json) {
    base::JsonWriter json;
    json.beginObject().key("file").value(options.file).key("id").value(toText(info.id)).key("name").value(name);
    return Output{json.endObject().text(), {}};
  }
  return Output{"Made the study " + base::oneLine(name) + " in " + base::oneLine(options.file) + '\n', {}};
}

Result<Output> studyInfo(const StudyInfoOptions& options) {
  TACTUS_TRY(const auto file, store::StudyFile::open(options.file, {store::Access::kReadOnly}));
  TACTUS_TRY(const auto info, store::studyInfo(file));
  TACTUS_TRY(const auto procedure, session::procedureIn(file));
  const procedure::Procedure& about = procedure::orDefault(procedure);
  auto notices = noticesOf(file);
  std::string text =
      options.json ? infoAsJson(options.file, info, about, notices) : infoAsText(options.file, info, about);
  return Output{std::move(text), std::move(notices)};
}

Result<Output> studyCheck(const StudyCheckOptions& options) {
  std::error_code ignored;
  const bool is_folder = std::filesystem::is_directory(options.file, ignored);
  std::vector<std::string> findings;
  if (!is_folder) {
    TACTUS_TRY(const auto file, store::StudyFile::open(options.file, {store::Access::kReadOnly}));
    TACTUS_TRY(auto found, store::checkStudy(file));
    findings = std::move(found);
    for (const auto& leftover : session::leftoversOfStudy(options.file)) findings.push_back(sentence(leftover));
  }
  const auto tables = session::readStudy(options.file);
  if (is_folder && !tables) return tl::unexpected(tables.error());
  // What keeps elicitation from reading the file is a finding too.
  if (!tables) findings.push_back("Elicitation cannot read it: " + tables.error().message());
  const auto data = tables ? session::dataFindings(tables->study) : std::vector<study::DataFinding>{};
  const auto notes = tables ? tables->notes : std::vector<std::string>{};
  if (options.json) {
    base::JsonWriter json;
    json.beginObject().key("file").value(options.file).key("findings").values(findings);
    writeData(data, json);
    json.key("notes").values(notes).endObject();
    return Output{json.text(), {}};
  }
  std::string text = base::oneLine(options.file) + ": findings " + std::to_string(findings.size()) + '\n';
  for (const auto& finding : findings) text += "  " + base::oneLine(finding) + '\n';
  return Output{text + dataAsText(data), notes};
}

Result<Output> studyMerge(const StudyMergeOptions& options) {
  std::vector<std::string> warnings;
  TACTUS_TRY(auto file, openToWrite(options.file, warnings));
  study::RecordIds ids;
  std::vector<NamedMerge> merges;
  for (const auto& other : options.others) {
    std::error_code ignored;
    if (std::filesystem::equivalent(other, options.file, ignored)) {
      return tl::unexpected(base::Error{ErrorCode::kIo, other, {}, "the study itself", "another study file"});
    }
    if (auto same = session::requireSameProcedure(file, other); !same) return tl::unexpected(std::move(same).error());
    TACTUS_TRY(auto merge, store::mergeStudy(file, other, ids.next(), utcNowMs()));
    merges.push_back({other, std::move(merge)});
  }
  for (auto& notice : noticesOf(file)) warnings.push_back(std::move(notice));
  std::string text = options.json ? mergesAsJson(options.file, merges, warnings) : mergesAsText(merges);
  for (auto& warning : closeSaved(file)) warnings.push_back(std::move(warning));
  return Output{std::move(text), std::move(warnings)};
}

Result<Output> studySimulate(const StudySimulateOptions& options) {
  std::vector<std::string> warnings;
  TACTUS_TRY(auto file, openToWrite(options.file, warnings));
  auto added = session::addSimulatedNurses(file, options.group, utcNowMs(), std::string(kGenerator));
  if (!added) return base::inFile(std::move(added).error(), options.file);
  for (auto& notice : noticesOf(file)) warnings.push_back(std::move(notice));
  for (auto& warning : closeSaved(file)) warnings.push_back(std::move(warning));
  if (options.json) {
    base::JsonWriter json;
    json.beginObject().key("file").value(options.file).key("simulated").values(*added).key("notices").values(warnings);
    return Output{json.endObject().text(), std::move(warnings)};
  }
  return Output{"Added " + std::to_string(added->size()) + " simulated experts to " + base::oneLine(options.file) +
                    ": " + base::joined(*added, ", ") + "\n",
                std::move(warnings)};
}

}  // namespace tactus::cli
