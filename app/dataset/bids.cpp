#include "app/dataset/bids.h"

#include <filesystem>

#include "app/dataset/tsv.h"
#include "core/base/json/json_writer.h"

namespace tactus::dataset {
namespace {

constexpr std::string_view kDescription = "dataset_description.json";
constexpr std::string_view kGeneratedBy = R"("Name": "tactus")";
constexpr std::string_view kLayout =
    "The layout is BIDS 1.10. Each folder sub-... holds a participant: strokes below motion (acq is the speed that was "
    "asked for, run the number of the stroke), judged forces, given rules and the events of each session (run) below "
    "beh; a table of judgements without "
    "rows belongs to a participant who judged nothing. Answers to forms are below phenotype, one column for each item. "
    "The JSON file beside a table says what each column holds.";

bool isOurs(const std::filesystem::path& below) {
  const std::string path = below.generic_string();
  if (path == kDescription || path == "README" || path == "participants.tsv" || path == "participants.json")
    return true;
  const bool is_table = below.extension() == ".tsv" || below.extension() == ".json";
  if (!is_table) return false;
  if (below.parent_path() == "phenotype") return true;
  const std::string folder = below.parent_path().filename().string();
  const std::string participant = below.begin()->string();
  return (folder == "motion" || folder == "beh") && participant.starts_with("sub-") &&
         below.filename().string().starts_with(participant + "_task-");
}

std::string description(const PublishedStudy& published) {
  base::JsonWriter json;
  json.beginObject().key("Name").value(published.name()).key("BIDSVersion").value("1.10.0");
  json.key("DatasetType").value("raw");
  const std::size_t blank = published.version.find(' ');
  json.key("GeneratedBy").beginArray().beginObject(base::JsonWriter::Layout::kInline).key("Name").value("tactus");
  if (blank != std::string::npos) json.key("Version").value(published.version.substr(blank + 1));
  return json.endObject().endArray().endObject().text();
}

/// BIDS has its own word for both hands.
std::string handOf(const study::Participant& participant) {
  return participant.handedness == "both" ? "ambidextrous" : participant.handedness;
}

void writeParticipants(const PublishedStudy& published, FileSet& files) {
  // Told only where there is something to tell.
  const bool tells_device = !published.without_force.empty();
  std::vector<std::string> columns = {"participant_id", "handedness", "category", "years_experience_band", "simulated"};
  if (tells_device) columns.emplace_back("virtual_device");
  TsvWriter table(columns);
  for (std::size_t i = 0; i < published.study().participants.size(); ++i) {
    const auto& participant = published.study().participants[i];
    std::vector<std::string> cells = {subject(participant.code), handOf(participant), participant.category,
                                      published.shared.bands[i], participant.simulated ? "1" : "0"};
    if (tells_device) cells.emplace_back(participant.virtual_device ? "1" : "0");
    table.row(cells);
  }
  files.add("participants.tsv", table.text());
  Sidecar sidecar;
  sidecar.column("participant_id", "Participant, a code that was drawn for this data set");
  sidecar.column("handedness", "The hand with which the tube is inserted",
                 {{"left", "left"}, {"right", "right"}, {"ambidextrous", "either hand"}});
  sidecar.column("category", "The participant's own statement",
                 {{"beginner", "beginner"}, {"intermediate", "intermediate"}, {"expert", "expert"}});
  sidecar.column(
      "years_experience_band", "Experience in years",
      {{"<5", "below 5"}, {"5-9", "from 5, below 10"}, {"10-14", "from 10, below 15"}, {"15+", "15 and more"}});
  sidecar.column("simulated", "Whether a program made all data of this participant",
                 {{"0", "measured"}, {"1", "simulated by a program, not measured"}});
  if (tells_device) {
    sidecar.column("virtual_device", "Whether the participant moved a device that gives no force",
                   {{"0", "no"}, {"1", "VIRTUAL: nothing judged there is among the data"}});
  }
  files.add("participants.json", sidecar.text());
}

}  // namespace

session::ExportKind bidsExport() { return {kDescription, kGeneratedBy, isOurs}; }

std::string subject(const std::string& code) { return "sub-" + code; }

std::vector<std::string> writeBids(const PublishedStudy& published, FileSet& files) {
  files.add(kDescription, description(published));
  files.add("README", published.readme(kLayout));
  writeParticipants(published, files);
  auto notes = writeMotion(published, files);
  writeBehavior(published, files);
  writeEvents(published, files);
  writePhenotype(published, files);
  return notes;
}

}  // namespace tactus::dataset
