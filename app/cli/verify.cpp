#include "app/bundle/verify_bundle.h"
#include "app/cli/commands.h"
#include "app/version.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"

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
  const auto bundle = bundle::verifyBundle(options.folder, kGenerator);
  if (!bundle) return tl::unexpected(bundle.error());
  Output output{options.json ? asJson(options.folder, *bundle) : asText(options.folder, *bundle), {}};
  if (!options.expect.empty() && base::lowered(options.expect) != bundle->fingerprint) {
    output.failure = base::oneLine(options.folder) + ": found the fingerprint " + bundle->fingerprint + ", wanted " +
                     base::oneLine(options.expect);
    return output;
  }
  for (const model_io::FileCheck& check : bundle->files) {
    if (!check.ok && output.failure.empty()) output.failure = check.wrong;
  }
  return output;
}

}  // namespace tactus::cli
