#include "app/cli/study_text.h"

#include <chrono>

#include "app/version.h"
#include "core/base/clock.h"
#include "core/store/copies.h"

namespace tactus::cli {

std::int64_t utcNowMs() {
  using namespace std::chrono;
  return duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count();
}

std::string utcText(std::int64_t utc_ms) {
  return base::formatUtc(std::chrono::system_clock::time_point(std::chrono::milliseconds(utc_ms)));
}

base::Result<store::StudyFile> newStudy(const std::string& path, const std::string& name) {
  return store::StudyFile::create(path, {study::RecordIds().next(), name, utcNowMs(), std::string(kGenerator)});
}

base::Result<store::StudyFile> openToWrite(const std::string& path, std::vector<std::string>& warnings) {
  auto file = store::StudyFile::open(path);
  if (!file) return file;
  if (const auto kept = store::keepCopy(*file); !kept)
    warnings.push_back("no copy of the study was kept: " + kept.error().message());
  return file;
}

std::vector<std::string> noticesOf(const store::StudyFile& file) {
  std::vector<std::string> warnings;
  for (const auto& notice : file.notices()) warnings.push_back(file.path() + ": " + notice.sentence);
  return warnings;
}

std::vector<std::string> noticesButErasure(const store::StudyFile& file) {
  std::vector<std::string> warnings;
  for (const auto& notice : file.notices()) {
    if (notice.kind != store::Notice::Kind::kErasure) warnings.push_back(file.path() + ": " + notice.sentence);
  }
  return warnings;
}

std::vector<std::string> closeSaved(store::StudyFile& file) {
  const std::string path = file.path();
  const auto closed = file.close();
  if (closed) return {};
  return {"everything is saved, but " + path + "-wal could not be worked into the study: " + closed.error().message() +
          "; leave it beside the study, the next opening does it"};
}

void writeCounts(const std::vector<store::TableCount>& counts, base::JsonWriter& json) {
  json.beginObject(base::JsonWriter::Layout::kInline);
  for (const auto& count : counts) json.key(count.table).value(count.rows);
  json.endObject();
}

std::string mergeAsText(const store::Merge& merge) {
  std::string text = merge.added.empty() ? "nothing new" : "added";
  for (const auto& count : merge.added) text += ' ' + count.table + ' ' + std::to_string(count.rows);
  text +=
      ", withdrawn " + std::to_string(merge.withdrawn) + ", conflicts " + std::to_string(merge.conflicts.size()) + '\n';
  for (const auto& conflict : merge.conflicts) text += "  " + base::oneLine(conflict) + '\n';
  return text;
}

void writeMerge(const store::Merge& merge, base::JsonWriter& json) {
  json.key("added");
  writeCounts(merge.added, json);
  json.key("withdrawn").value(merge.withdrawn).key("conflicts").values(merge.conflicts);
}

}  // namespace tactus::cli
