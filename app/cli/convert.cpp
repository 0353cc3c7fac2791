#include <utility>

#include "app/bundle/bundle.h"
#include "app/cli/commands.h"
#include "app/cli/model_arguments.h"
#include "core/base/files/file.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"
#include "core/exchange/c_source.h"
#include "core/exchange/dialect.h"
#include "core/model_io/model_file.h"

namespace tactus::cli {
namespace {

using Files = std::vector<std::pair<std::string, std::string>>;  // name, text

base::Result<Files> expertFiles(const fuzzy::ForceModel& model, exchange::Dialect dialect) {
  Files files;
  const std::vector<std::string> names = bundle::expertFileNames(model);
  for (std::size_t e = 0; e < model.experts.size(); ++e) {
    auto text = exchange::format(model, e, dialect);
    if (!text) return tl::unexpected(text.error());
    files.emplace_back(names[e] + std::string(suffix(dialect)), std::move(*text));
  }
  return files;
}

base::Result<Files> filesOf(const fuzzy::ForceModel& model, const ConvertOptions& options) {
  if (options.to != "c" && !options.fixed.empty())
    return base::fail(base::ErrorCode::kValue, "--fix", "--to " + options.to, "--to c, which alone can fix inputs");
  for (const exchange::Dialect dialect : exchange::kDialects) {
    if (options.to == name(dialect)) return expertFiles(model, dialect);
  }
  std::vector<exchange::FixedInput> fixed;
  for (const std::string& text : options.fixed) {
    const auto one = inputOption(model, "--fix", text);
    if (!one) return tl::unexpected(one.error());
    fixed.push_back({one->first, one->second});
  }
  auto source = exchange::cSource(model, fixed);
  if (!source) return tl::unexpected(source.error());
  return Files{{"force_model.h", std::move(source->header)}, {"force_model.c", std::move(source->source)}};
}

}  // namespace

base::Result<Output> convert(const ConvertOptions& options) {
  const auto read = model_io::readModel(options.model);
  if (!read) return tl::unexpected(read.error());
  const auto files = filesOf(read->model, options);
  if (!files) return base::inFile(files.error(), options.model);
  if (const auto made = base::makeFolder(options.out); !made) return tl::unexpected(made.error());
  Output output{{}, read->warnings};
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
