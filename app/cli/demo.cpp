// The main job, end to end (app/demo): simulated and published data in; study, tables, models, export and report out.
#include <utility>

#include "app/cli/commands.h"
#include "app/cli/wrapped_text.h"
#include "app/demo/demo_folder.h"
#include "core/base/error.h"
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

}  // namespace

base::Result<Output> demo(const DemoOptions& options) {
  const auto made = tactus::demo::writeDemo({options.folder, options.seed, options.reading});
  if (!made) return tl::unexpected(made.error());
  return Output{options.json ? asJson(options.folder, made->files, made->notes) : asText(options.folder, made->files),
                {}};
}

}  // namespace tactus::cli
