#include <chrono>
#include <system_error>

#include "app/cli/commands.h"
#include "app/cli/output_file.h"
#include "app/version.h"
#include "core/base/clock.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"
#include "core/exchange/import/import_model.h"
#include "core/model_io/model_file.h"
#include "elicitation/model/model_provenance.h"

namespace tactus::cli {
namespace {

std::optional<exchange::ImportFormat> formatNamed(const std::string& word) {
  using enum exchange::ImportFormat;
  for (const auto format : {kFll, kFcl, kFis}) {
    if (word == name(format)) return format;
  }
  return std::nullopt;
}

/// What a person may do about an error: one of several outputs is chosen by an option.
base::Error advised(base::Error error, const exchange::ReadFile& file, const std::string& output) {
  if (output.empty() && file.outputs().size() > 1) error.wanted += ": --output NAME";
  return error;
}

std::string importAsText(const ImportOptions& options, const fuzzy::ForceModel& model) {
  return base::oneLine(options.out + ": " + model.name) + "; inputs " + std::to_string(model.inputs.size()) +
         ", output " + base::oneLine(model.output.id) + ", rules " +
         std::to_string(model.experts.front().rules.size()) + '\n';
}

std::string importAsJson(const ImportOptions& options, const exchange::ReadFile& file, const fuzzy::ForceModel& model) {
  base::JsonWriter json;
  json.beginObject().key("model").value(options.out).key("format").value(name(file.format()));
  json.key("name").value(model.name).key("inputs").beginArray(base::JsonWriter::Layout::kInline);
  for (const auto& input : model.inputs) json.value(input.id);
  json.endArray().key("output").value(model.output.id);
  json.key("rules").value(model.experts.front().rules.size()).key("warnings").values(file.warnings());
  return json.endObject().text();
}

}  // namespace

base::Result<Output> import(const ImportOptions& options) {
  if (auto ok = requireOutput(options.out, {options.file}); !ok) return tl::unexpected(ok.error());
  const auto file = exchange::ReadFile::open(options.file, formatNamed(options.from));
  if (!file) return tl::unexpected(file.error());
  auto model = file->model(options.output);
  if (!model) return tl::unexpected(advised(model.error(), *file, options.output));
  model->created_utc = base::formatUtc(std::chrono::system_clock::now());
  model->generator = kGenerator;
  if (const auto checked = elicitation::setChecks(*model); !checked) return base::inFile(checked.error(), options.file);
  const auto text = model_io::modelText(*model, options.out);
  if (!text) return tl::unexpected(text.error());
  return written(
      options.out, *text,
      {options.json ? importAsJson(options, *file, *model) : importAsText(options, *model), file->warnings()},
      options.json);
}

}  // namespace tactus::cli
