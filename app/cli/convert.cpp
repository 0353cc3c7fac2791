#include <chrono>
#include <system_error>
#include <utility>

#include "app/bundle/bundle.h"
#include "app/cli/commands.h"
#include "app/cli/model_arguments.h"
#include "app/cli/output_file.h"
#include "app/version.h"
#include "core/base/clock.h"
#include "core/base/error.h"
#include "core/base/files/checksums.h"
#include "core/base/files/file.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"
#include "core/exchange/c_source.h"
#include "core/exchange/dialect.h"
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
  TACTUS_TRY(const auto file, exchange::ReadFile::open(options.file, formatNamed(options.from)));
  auto model = file.model(options.output);
  if (!model) return tl::unexpected(advised(model.error(), file, options.output));
  model->created_utc = base::formatUtc(std::chrono::system_clock::now());
  model->generator = kGenerator;
  if (const auto checked = elicitation::setChecks(*model); !checked) return base::inFile(checked.error(), options.file);
  TACTUS_TRY(const auto text, model_io::modelText(*model, options.out));
  return written(options.out, text,
                 {options.json ? importAsJson(options, file, *model) : importAsText(options, *model), file.warnings()},
                 options.json);
}

namespace {

using Files = std::vector<std::pair<std::string, std::string>>;  // name, text

base::Result<Files> expertFiles(const fuzzy::ForceModel& model, exchange::Dialect dialect,
                                const exchange::Origin& origin) {
  Files files;
  const std::vector<std::string> names = bundle::expertFileNames(model);
  for (std::size_t e = 0; e < model.experts.size(); ++e) {
    TACTUS_TRY(auto text, exchange::format(model, e, dialect, origin));
    files.emplace_back(names[e] + std::string(suffix(dialect)), std::move(text));
  }
  return files;
}

base::Result<Files> filesOf(const fuzzy::ForceModel& model, const ConvertOptions& options,
                            const exchange::Origin& origin) {
  if (options.to != "c" && !options.fixed.empty())
    return base::fail(base::ErrorCode::kValue, "--fix", "--to " + options.to, "--to c, which alone can fix inputs");
  for (const exchange::Dialect dialect : exchange::kDialects) {
    if (options.to == name(dialect)) return expertFiles(model, dialect, origin);
  }
  std::vector<exchange::FixedInput> fixed;
  for (const std::string& text : options.fixed) {
    TACTUS_TRY(const auto one, inputOption(model, "--fix", text));
    fixed.push_back({one.first, one.second});
  }
  TACTUS_TRY(auto source, exchange::cSource(model, fixed, origin));
  return Files{{"force_model.h", std::move(source.header)}, {"force_model.c", std::move(source.source)}};
}

}  // namespace

base::Result<Output> convert(const ConvertOptions& options) {
  TACTUS_TRY(const auto bytes, base::readFile(options.model, model_io::kMostModelFileBytes));
  TACTUS_TRY(const auto read, model_io::parseModel(bytes, options.model));
  const auto files =
      filesOf(read.model, options, {base::sha256(bytes), read.model.created_utc, std::string(kGenerator)});
  if (!files) return base::inFile(files.error(), options.model);
  if (const auto made = base::makeFolder(options.out); !made) return tl::unexpected(made.error());
  Output output{{}, read.warnings};
  for (const std::string& event : fuzzy::eventTexts(read.model)) {
    output.warnings.push_back(
        base::oneLine(options.model + ": not in these files: puncture, " + event + "; the tube of a bundle has it"));
  }
  std::vector<std::string> paths;
  for (const auto& [name, text] : *files) {
    const std::string path = options.out + "/" + name;
    if (const auto written = base::writeFileAtomically(path, text); !written) return tl::unexpected(written.error());
    paths.push_back(path);
    output.text += base::oneLine(path) + '\n';
  }
  if (!options.json) return output;
  base::JsonWriter json;
  json.beginObject().key("model").value(options.model).key("to").value(options.to);
  json.key("files").values(paths).key("warnings").values(output.warnings);
  output.text = json.endObject().text();
  return output;
}

}  // namespace tactus::cli
