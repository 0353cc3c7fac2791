#include "app/bundle/bundle.h"

#include <chrono>
#include <filesystem>

#include "app/bundle/zip.h"
#include "app/cli/commands.h"
#include "app/cli/output_file.h"
#include "app/version.h"
#include "core/base/clock.h"
#include "core/base/files/checksums.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"
#include "core/model_io/model_file.h"

namespace tactus::cli {
namespace {

std::string asText(const std::string& folder, const bundle::Bundle& made) {
  std::string text = base::oneLine(folder) + ": " + std::to_string(made.files.size()) + " files\n";
  for (const auto& file : made.manifest.files) {
    text += "  " + base::oneLine(file.path);
    if (file.promise) {
      text += "  " + file.promise->rule + ", largest error " + base::formatNumber(file.promise->largest_error_n) +
              " N, tolerance " + base::formatNumber(file.promise->tolerance_n) + " N";
    }
    text += '\n';
  }
  return text + "  fingerprint " + base::sha256(made.files.back().second) + '\n';
}

std::string asJson(const std::string& folder, const bundle::Bundle& made) {
  base::JsonWriter json;
  json.beginObject().key("bundle").value(folder).key("warnings").values(made.warnings);
  json.key("fingerprint").value(base::sha256(made.files.back().second));
  json.key("manifest").raw(model_io::formatManifest(made.manifest)).endObject();
  return json.text();
}

}  // namespace

base::Result<Output> bundle(const BundleOptions& options) {
  auto read = model_io::readModel(options.model);
  if (!read) return tl::unexpected(read.error());
  const bundle::BundleSettings settings{options.accept_holes, base::formatUtc(std::chrono::system_clock::now()),
                                        std::string(kGenerator), options.table_error_n};
  const auto made = bundle::makeBundle(std::move(read->model), settings);
  if (!made) return base::inFile(made.error(), options.model);
  const bool zip = bundle::isZipName(options.out) && !std::filesystem::is_directory(options.out);
  if (zip) {
    if (const auto ok = requireOutput(options.out, {options.model}); !ok) return tl::unexpected(ok.error());
  }
  const auto written = zip ? bundle::writeBundleZip(*made, options.out) : bundle::writeBundle(*made, options.out);
  if (!written) return tl::unexpected(written.error());
  std::vector<std::string> warnings = read->warnings;
  warnings.insert(warnings.end(), made->warnings.begin(), made->warnings.end());
  return Output{options.json ? asJson(options.out, *made) : asText(options.out, *made), std::move(warnings)};
}

}  // namespace tactus::cli
