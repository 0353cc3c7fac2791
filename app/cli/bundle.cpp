#include "app/bundle/bundle.h"

#include <chrono>
#include <filesystem>

#include "app/bundle/file_errors.h"
#include "app/bundle/zip.h"
#include "app/cli/commands.h"
#include "app/cli/output_file.h"
#include "app/version.h"
#include "core/base/clock.h"
#include "core/base/error.h"
#include "core/base/files/checksums.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"
#include "core/model_io/model_file.h"

namespace tactus::cli {
namespace {

std::string asText(const std::string& folder, const model_io::BundleCheck& bundle) {
  std::string text = base::oneLine(folder) + ": " + (bundle.ok() ? "verified" : "not verified") + "\n  fingerprint " +
                     bundle.fingerprint + '\n';
  for (const model_io::FileCheck& check : bundle.files) {
    text += std::string(check.ok ? "  ok     " : "  wrong  ") + base::oneLine(check.file.path);
    if (check.file.promise) {
      text += "  largest error " + base::formatNumber(check.largest_error_n) + " N of " +
              base::formatNumber(check.file.promise->tolerance_n) + " N" +
              (check.evaluated ? "" : ", as measured when it was written");
    }
    text += '\n';
  }
  return text;
}

std::string asJson(const std::string& folder, const model_io::BundleCheck& bundle) {
  base::JsonWriter json;
  json.beginObject().key("bundle").value(folder).key("ok").value(bundle.ok());
  json.key("fingerprint").value(bundle.fingerprint).key("files").beginArray();
  for (const model_io::FileCheck& check : bundle.files) {
    json.beginObject().key("path").value(check.file.path).key("kind").value(check.file.kind);
    json.key("largest_error_n");
    check.file.promise ? json.value(check.largest_error_n) : json.null();
    json.key("tolerance_n");
    check.file.promise ? json.value(check.file.promise->tolerance_n) : json.null();
    json.key("ok").value(check.ok).key("evaluated").value(check.evaluated);
    if (!check.ok) json.key("wrong").value(check.wrong);
    json.endObject();
  }
  return json.endArray().endObject().text();
}

}  // namespace

base::Result<Output> verify(const VerifyOptions& options) {
  TACTUS_TRY(const auto bundle, bundle::verifyBundle(options.folder, kGenerator));
  Output output{options.json ? asJson(options.folder, bundle) : asText(options.folder, bundle), {}};
  if (!options.expect.empty() && base::lowered(options.expect) != bundle.fingerprint) {
    output.failure = base::oneLine(options.folder) + ": found the fingerprint " + bundle.fingerprint + ", wanted " +
                     base::oneLine(options.expect);
    return output;
  }
  for (const model_io::FileCheck& check : bundle.files) {
    if (!check.ok && output.failure.empty()) output.failure = check.wrong;
  }
  return output;
}

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
  TACTUS_TRY(auto read, model_io::readModel(options.model));
  const bundle::BundleSettings settings{options.accept_holes, base::formatUtc(std::chrono::system_clock::now()),
                                        std::string(kGenerator), options.table_error_n};
  const auto made = bundle::makeBundle(std::move(read.model), settings);
  if (!made) return base::inFile(made.error(), options.model);
  const bool zip = bundle::isZipName(options.out) && !std::filesystem::is_directory(options.out);
  if (zip) {
    if (const auto ok = requireOutput(options.out, {options.model}); !ok) return tl::unexpected(ok.error());
  }
  if (const auto written = zip ? bundle::writeBundleZip(*made, options.out) : bundle::writeBundle(*made, options.out);
      !written)
    return tl::unexpected(written.error());
  std::vector<std::string> warnings = read.warnings;
  warnings.insert(warnings.end(), made->warnings.begin(), made->warnings.end());
  return Output{options.json ? asJson(options.out, *made) : asText(options.out, *made), std::move(warnings)};
}

}  // namespace tactus::cli
