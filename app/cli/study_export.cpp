#include "app/session/study_export.h"

#include <random>
#include <utility>

#include "app/cli/study_commands.h"
#include "app/cli/study_text.h"
#include "app/dataset/dataset.h"
#include "app/session/study_source.h"
#include "app/version.h"
#include "core/base/json/json_writer.h"
#include "elicitation/variables/ngt_variables.h"

namespace tactus::cli {
namespace {

/// A random seed that is not kept, so that the order of the participants stays secret.
std::uint64_t secretSeed() {
  std::random_device device;
  return (static_cast<std::uint64_t>(device()) << 32U) | device();
}

base::Result<Output> dataSet(const StudyExportOptions& options) {
  auto tables = session::readStudy(options.file, elicitation::ngtInputIds());
  if (!tables) return tl::unexpected(tables.error());
  const auto layout = options.layout == "bids" ? dataset::Layout::kBids : dataset::Layout::kPsychDs;
  const auto done = dataset::writeDataSet(tables->study, layout, options.folder, secretSeed(), kGenerator);
  if (!done) return tl::unexpected(done.error());
  std::vector<std::string> notes = std::move(tables->notes);
  notes.insert(notes.end(), done->notes.begin(), done->notes.end());
  if (options.json) {
    base::JsonWriter json;
    json.beginObject().key("file").value(options.file).key("folder").value(options.folder);
    json.key("layout").value(options.layout).key("profile").value("shareable");
    json.key("participants").value(done->participants).key("files").value(done->files);
    json.key("notes").values(notes).key("notices").values(tables->notices).endObject();
    return Output{json.text(), std::move(tables->notices)};
  }
  notes.insert(notes.begin(), tables->notices.begin(), tables->notices.end());
  return Output{"Wrote " + std::to_string(done->participants) + " participants in the layout " + options.layout +
                    " to " + base::oneLine(options.folder) +
                    "; read README and enter authors and license before it is published\n",
                std::move(notes)};
}

}  // namespace

base::Result<Output> studyExport(const StudyExportOptions& options) {
  if (!options.layout.empty()) return dataSet(options);
  const auto file = store::StudyFile::open(options.file, {store::Access::kReadOnly});
  if (!file) return tl::unexpected(file.error());
  session::ExportOptions settings;
  settings.shareable = options.shareable;
  settings.seed = secretSeed();
  settings.mark = options.mark ? store::ByteOrderMark::kWrite : store::ByteOrderMark::kNone;
  auto done = session::exportStudy(*file, options.folder, settings);
  if (!done) return tl::unexpected(done.error());
  auto notices = noticesOf(*file);
  const std::string profile = options.shareable ? "shareable" : "full";
  if (options.json) {
    base::JsonWriter json;
    json.beginObject().key("file").value(options.file).key("folder").value(options.folder);
    json.key("profile").value(profile).key("participants").value(done->participants);
    json.key("notes").values(done->notes).key("notices").values(notices).endObject();
    return Output{json.text(), std::move(notices)};
  }
  done->notes.insert(done->notes.begin(), notices.begin(), notices.end());
  return Output{"Wrote the " + profile + " export of " + std::to_string(done->participants) + " participants to " +
                    base::oneLine(options.folder) + "; codebook.md describes the tables\n",
                std::move(done->notes)};
}

}  // namespace tactus::cli
