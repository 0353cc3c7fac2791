// The report of one's own study, as one page.
#include <filesystem>
#include <utility>

#include "app/cli/output_file.h"
#include "app/cli/study_build.h"
#include "app/cli/study_commands.h"
#include "app/cli/terminal.h"
#include "app/demo/demo_folder.h"
#include "app/report/study_report.h"
#include "app/session/study_procedure.h"
#include "app/session/study_source.h"
#include "app/version.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/json/json_writer.h"

namespace tactus::cli {
namespace {

std::string asText(const std::string& folder, const std::vector<demo::DemoFile>& files) {
  std::string text =
      "Wrote the demo study (simulated, except for S4's published rules) to " + base::oneLine(folder) + ":\n";
  for (const auto& file : files) {
    text += "  " + padded(file.path, 30, 2) + file.holds + '\n';
  }
  return text;
}

std::string asJson(const std::string& folder, const std::vector<demo::DemoFile>& files,
                   const std::vector<std::string>& notes) {
  base::JsonWriter json;
  json.beginObject().key("folder").value(folder).key("simulated").value(true).key("files").beginArray();
  for (const auto& file : files) {
    json.beginObject(base::JsonWriter::Layout::kInline)
        .key("path")
        .value(file.path)
        .key("holds")
        .value(file.holds)
        .endObject();
  }
  json.endArray().key("notes").values(notes).endObject();
  return json.text();
}

/// The same job for another procedure, whose experts are invented from its pack.
base::Result<Output> demoOfPack(const DemoOptions& options) {
  std::error_code ignored;
  if (std::filesystem::exists(options.folder, ignored) && !std::filesystem::is_empty(options.folder, ignored)) {
    return base::inFile({base::ErrorCode::kIo, {}, {}, "a folder that is not empty", "a new or an empty folder"},
                        options.folder);
  }
  TACTUS_TRY(const auto procedure, packNamed(options.pack));
  if (auto ok = base::makeFolder(options.folder); !ok) return tl::unexpected(std::move(ok).error());
  const auto in = [&](const std::string& name) { return options.folder + "/" + name; };
  const std::string study = in(procedure->id + "-demo.tactus");
  TACTUS_TRY(const auto made,
             studyNew({study, procedure->titleIn("en") + " (simulated experts, not measured)", options.pack}));
  StudySimulateOptions simulate{study, {}};
  simulate.group.seed = options.seed.value_or(session::kDefaultSeed);
  TACTUS_TRY(const auto simulated, studySimulate(simulate));
  // The copy of what was there before is of a study without anybody.
  std::filesystem::remove(study + ".copy-1", ignored);
  BuildOptions build;
  build.study = study;
  build.out = in("averaged.tactus.json");
  TACTUS_TRY(const auto built, cli::build(build));
  BundleOptions bundle;
  bundle.model = build.out;
  bundle.out = in("export");
  TACTUS_TRY(const auto bundled, cli::bundle(bundle));
  ReportOptions report;
  static_cast<BuildOptions&>(report) = build;
  report.out = in("report.html");
  TACTUS_TRY(const auto reported, writeReport(report));
  const std::vector<demo::DemoFile> files = {
      {"report.html", "what the study says, with the model to try"},
      {procedure->id + "-demo.tactus", "the study: whole sessions of four simulated experts, and the pack"},
      {"averaged.tactus.json", "their averaged model"},
      {"export/", "the bundle for a simulator"}};
  if (options.json) return Output{asJson(options.folder, files, built.warnings), {}};
  std::string text = "Wrote a demo study of " + base::oneLine(procedure->titleIn("en")) +
                     " (simulated experts, not measured) to " + base::oneLine(options.folder) + ":\n";
  for (const auto& file : files) text += "  " + padded(file.path, 30, 2) + file.holds + '\n';
  return Output{std::move(text), {}};
}

}  // namespace

base::Result<Output> demo(const DemoOptions& options) {
  if (!options.pack.empty()) return demoOfPack(options);
  TACTUS_TRY(const auto made, tactus::demo::writeDemo({options.folder, options.seed, options.reading}));
  return Output{options.json ? asJson(options.folder, made.files, made.notes) : asText(options.folder, made.files), {}};
}

base::Result<Output> writeReport(const ReportOptions& options) {
  TACTUS_TRY(auto made, buildStudy(options, RulesNeeded::kNo));
  for (auto& note : acceptedNotes(made.data, made.accepted)) made.built.notes.push_back(std::move(note));
  if (!made.in_order) return tl::unexpected(made.in_order.error());
  TACTUS_TRY(auto evidence, session::readEvidence(options.study));
  const report::StudyReportInputs inputs{.study = made.tables.study,
                                         .built = made.built,
                                         .build_settings = made.settings,
                                         .forms = session::knownForms(procedure::of(made.tables.study)),
                                         .data = made.data,
                                         .settings = {{"Study", options.study},
                                                      {"Program", std::string(kGenerator)},
                                                      {"Created (UTC)", made.settings.created_utc}},
                                         .replicates = options.replicates,
                                         .usability = made.usability,
                                         .usability_simulated = made.usability_simulated,
                                         .in_order = std::move(*made.in_order),
                                         .duels = std::move(evidence.duels),
                                         .sealed = std::move(evidence.sealed)};
  const auto page = report::studyReport(inputs);
  if (!page) return inFile(page.error(), options.study);
  const auto experts = made.built.model.experts.size();
  if (!options.json) {
    return written(
        options.out, *page,
        {base::oneLine(options.out) + ": report of " + std::to_string(made.tables.study.participants.size()) +
             " participants, " + std::to_string(experts) + " experts\n",
         made.warnings()},
        options.json);
  }
  base::JsonWriter json;
  json.beginObject().key("report").value(options.out);
  json.key("participants").value(made.tables.study.participants.size()).key("experts").value(experts);
  json.key("notes").values(made.built.notes).key("notices").values(made.notices).endObject();
  return written(options.out, *page, {json.text(), made.warnings()}, options.json);
}

}  // namespace tactus::cli
