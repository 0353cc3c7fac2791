#include "app/demo/demo_folder.h"

#include <chrono>
#include <filesystem>
#include <utility>

#include "app/report/study_report.h"
#include "app/session/export_folder.h"
#include "app/session/simulated_study.h"
#include "app/session/study_source.h"
#include "app/session/study_view.h"
#include "app/simulation/scenario.h"
#include "app/version.h"
#include "core/base/clock.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/tables/csv.h"
#include "core/model_io/model_file.h"
#include "core/procedure/procedure.h"
#include "core/store/copies.h"
#include "core/store/study_file.h"
#include "core/study/csv_tables.h"
#include "questionnaires/published_rules.h"

namespace tactus::demo {
namespace {

using base::Result;
using elicitation::BuiltModel;

elicitation::BuildSettings settingsNow(std::uint64_t seed) {
  elicitation::BuildSettings settings;
  settings.created_utc = base::formatUtc(std::chrono::system_clock::now());
  settings.generator = kGenerator;
  settings.extra = {{"simulation_seed", std::to_string(seed)}};
  return settings;
}

/// S4 alone in one reading of Table A2, with the terms that the whole study gave.
Result<report::S4Reading> s4In(const questionnaires::TableReading& reading, study::Study study, std::uint64_t seed) {
  TACTUS_TRY(auto rules, questionnaires::s4Rules(reading.id));
  study.rules = std::move(rules);
  TACTUS_TRY(const auto built,
             elicitation::buildModel(study, session::knownForms(procedure::of(study)), settingsNow(seed)));
  TACTUS_TRY(auto model, elicitation::expertModel(built.model, "S4"));
  return report::S4Reading{reading.title, reading.assumes, std::move(model)};
}

Result<std::string> demoReport(const study::Study& study, const BuiltModel& built, const std::string& reading,
                               std::uint64_t seed) {
  std::vector<report::S4Reading> readings;
  for (const auto& one : questionnaires::s4Readings()) {
    TACTUS_TRY(auto s4, s4In(one, study, seed));
    readings.push_back(std::move(s4));
  }
  const report::DemoReportInputs inputs{.study = study,
                                        .built = built,
                                        .build_settings = settingsNow(seed),
                                        .readings = std::move(readings),
                                        .forms = session::knownForms(procedure::of(study)),
                                        .settings = {{"Program", std::string(kGenerator)},
                                                     {"Created (UTC)", built.model.created_utc},
                                                     {"Seed of the simulated data", std::to_string(seed)},
                                                     {"Reading of Table A2", reading}}};
  return report::demoReport(inputs);
}

std::string checksAsCsv(const fuzzy::ForceModel& model) {
  std::vector<std::string> columns;
  for (const auto& input : model.inputs) columns.push_back(input.id);
  columns.insert(columns.end(), {"expected_force", "expected_fired"});
  base::CsvWriter csv(columns);
  for (const auto& check : model.checks) {
    for (const double value : check.in) csv.cell(value);
    csv.cell(check.force).cell(check.fired ? 1 : 0).endRow();
  }
  return csv.text();
}

// Says that a folder is a demo's, so that a demo never writes over other files.
constexpr std::string_view kMarkerFile = "written-by-tactus-demo.txt";
constexpr std::string_view kMarker =
    "tactus demo wrote this folder, and running it again on this folder replaces its files.\n"
    "Its data are simulated, except for S4's published rules.\n";

/// Makes the folder and marks it. Refused: a folder that holds something and no mark.
Result<void> takeFolder(const std::string& folder) {
  std::error_code ignored;
  const std::string marker = folder + '/' + std::string(kMarkerFile);
  const bool empty = !std::filesystem::exists(folder, ignored) || std::filesystem::is_empty(folder, ignored);
  if (!empty && std::filesystem::is_directory(folder, ignored) && !std::filesystem::exists(marker, ignored)) {
    return tl::unexpected(base::Error{base::ErrorCode::kIo,
                                      folder,
                                      {},
                                      "a folder that holds other files",
                                      "a new or empty folder, or one that tactus demo wrote"});
  }
  if (auto made = base::makeFolder(folder); !made) return made;
  return base::writeFileAtomically(marker, kMarker);
}

/// Lets the simulated nurses go through their sessions into the demo's study file, in the place of an older one, and
/// reads from it what elicitation needs.
Result<study::Study> runStudy(const std::string& folder, std::uint64_t seed, const std::string& reading) {
  if (auto made = base::makeFolder(folder + "/study"); !made) return tl::unexpected(made.error());
  const std::string path = folder + '/' + std::string(kStudyFile);
  std::error_code problem;
  // Held until the new one stands in its place, so that none is replaced while a program works on it.
  std::optional<store::StudyFile> older;
  if (std::filesystem::exists(path, problem)) {
    TACTUS_TRY(auto opened, store::StudyFile::open(path, {store::Access::kReadOnly, {}}));
    older = std::move(opened);
  }
  session::removeOurs(session::leftoversOfStudy(path));
  TACTUS_TRY(const auto work, store::WorkFolder::beside(path));
  const std::string unfinished = work.file(std::filesystem::path(path).filename().string());
  TACTUS_TRY(auto file, session::makeSimulatedNgtStudy(unfinished, seed, reading, std::string(kGenerator)));
  TACTUS_TRY(auto view, session::studyForElicitation(file));
  if (auto closed = file.close(); !closed) return tl::unexpected(closed.error());
  for (const char* tail : {"-wal", "-journal", "-shm"}) std::filesystem::remove(path + tail, problem);
  // The study before keeps its mode.
  const auto before = std::filesystem::status(path, problem);
  problem.clear();
  if (std::filesystem::exists(before)) std::filesystem::permissions(unfinished, before.permissions(), problem);
  if (!problem) std::filesystem::rename(unfinished, path, problem);
  if (problem) {
    return tl::unexpected(
        base::Error{base::ErrorCode::kIo, path, {}, problem.message(), "a writable place for the study file"});
  }
  return std::move(view.study);
}

constexpr std::string_view kExportReadme =
    "Export of the averaged force model of the simulated nasogastric tube study.\n"
    "\n"
    "model.tactus.json   the model; its checks are evaluated again by every Tactus program that opens it\n"
    "checks.csv          the same checks as a table, for a program of your own\n"
    "\n"
    "  tactus check model.tactus.json\n"
    "  tactus eval model.tactus.json --in checks.csv     force beside expected_force\n"
    "\n"
    "S4's rules are published; everything else in this model was simulated.\n";

/// Writes models and export; each file whole or not at all.
Result<std::vector<DemoFile>> writeModels(const BuiltModel& built, const std::string& folder) {
  std::vector<DemoFile> files;
  for (const char* below : {"/models", "/export"}) {
    if (auto made = base::makeFolder(folder + below); !made) return tl::unexpected(made.error());
  }
  const auto write = [&](const fuzzy::ForceModel& model, const std::string& path, std::string holds) -> Result<void> {
    files.push_back({path, std::move(holds)});
    return model_io::writeModel(model, folder + '/' + path);
  };
  for (const auto& expert : built.model.experts) {
    TACTUS_TRY(const auto alone, elicitation::expertModel(built.model, expert.id));
    if (auto ok = write(alone, "models/" + expert.id + ".tactus.json", "the model of " + expert.id + " alone"); !ok) {
      return tl::unexpected(ok.error());
    }
  }
  if (auto ok = write(built.model, "models/averaged.tactus.json", "the averaged model"); !ok)
    return tl::unexpected(ok.error());
  if (auto ok = write(built.model, "export/model.tactus.json", "the averaged model for the simulator"); !ok) {
    return tl::unexpected(ok.error());
  }
  files.push_back({"export/checks.csv", "points with the forces that the simulator must get"});
  if (auto ok = base::writeFileAtomically(folder + "/export/checks.csv", checksAsCsv(built.model)); !ok) {
    return tl::unexpected(ok.error());
  }
  files.push_back({"export/README.txt", "how to check the export"});
  if (auto ok = base::writeFileAtomically(folder + "/export/README.txt", kExportReadme); !ok)
    return tl::unexpected(ok.error());
  return files;
}

/// The scenarios of the report's figures, to be run again and changed.
Result<std::vector<DemoFile>> writeScenarios(const std::string& folder) {
  if (auto made = base::makeFolder(folder + "/scenarios"); !made) return tl::unexpected(made.error());
  const std::pair<DemoFile, std::string_view> all[] = {
      {{"scenarios/one_stroke.json", "one stroke for tactus simulate (Fig. 13)"}, simulation::oneStrokeScenarioJson()},
      {{"scenarios/placement.json", "a whole placement for tactus simulate (Fig. 18)"},
       simulation::placementScenarioJson()}};
  std::vector<DemoFile> files;
  for (const auto& [file, text] : all) {
    if (auto ok = base::writeFileAtomically(folder + '/' + file.path, text); !ok) return tl::unexpected(ok.error());
    files.push_back(file);
  }
  return files;
}

}  // namespace

Result<DemoFolder> writeDemo(const DemoSettings& settings, const std::function<void(DemoPart)>& begins) {
  const std::string& folder = settings.folder;
  const std::string reading =
      settings.reading.empty() ? std::string(questionnaires::kDefaultReading) : settings.reading;
  const std::uint64_t seed = settings.seed.value_or(session::kDefaultSeed);
  const auto begin = [&begins](DemoPart part) {
    if (begins) begins(part);
  };
  if (auto known = questionnaires::s4Rules(reading); !known) return tl::unexpected(known.error());

  begin(DemoPart::kSessions);
  if (auto ok = takeFolder(folder); !ok) return tl::unexpected(ok.error());
  const auto study = runStudy(folder, seed, reading);
  if (!study) return tl::unexpected(study.error());
  begin(DemoPart::kModel);
  TACTUS_TRY(const auto built,
             elicitation::buildModel(*study, session::knownForms(procedure::of(*study)), settingsNow(seed)));
  begin(DemoPart::kReport);
  TACTUS_TRY(const auto page, demoReport(*study, built, reading, seed));

  begin(DemoPart::kFiles);
  if (auto ok = session::writeTables(*study, folder + "/study"); !ok) return tl::unexpected(ok.error());
  TACTUS_TRY(auto models, writeModels(built, folder));
  TACTUS_TRY(const auto scenarios, writeScenarios(folder));
  if (auto ok = base::writeFileAtomically(folder + "/report.html", page); !ok) return tl::unexpected(ok.error());

  DemoFolder demo{{{"report.html", "tables, figures and claims of the paper, recomputed"},
                   {std::string(kStudyFile), "the study: sessions of simulated nurses, record by record"},
                   {"study/", "the data of the model, as tables (CSV)"}},
                  built.notes};
  demo.files.insert(demo.files.end(), models.begin(), models.end());
  demo.files.insert(demo.files.end(), scenarios.begin(), scenarios.end());
  return demo;
}

}  // namespace tactus::demo
