#include "app/bundle/bundle.h"

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "app/bundle/file_errors.h"
#include "app/bundle/zip.h"
#include "app/cli/commands.h"
#include "app/cli/contracts_text.h"
#include "app/cli/output_file.h"
#include "app/cli/pull_text.h"
#include "app/session/study_procedure.h"
#include "app/version.h"
#include "core/base/clock.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"
#include "core/fuzzy/compiled_model.h"
#include "core/model_io/model_file.h"

namespace tactus::cli {
namespace {

namespace fs = std::filesystem;

/// The folder or zip file of a bundle, from what was named.
base::Result<std::string> bundleNamed(const std::string& name) {
  std::error_code ignored;
  if (name.empty()) {
    const fs::path manifest(model_io::kManifestName);
    if (fs::exists(fs::symlink_status(manifest, ignored))) return std::string(".");
    return base::fail(base::ErrorCode::kIo, "the present folder", "no bundle",
                      "the folder of a bundle, or its name behind tactus verify");
  }
  const fs::path path(name);
  if (path.filename() != model_io::kManifestName || fs::is_directory(path, ignored)) return name;
  return path.has_parent_path() ? path.parent_path().string() : std::string(".");
}

/// What was found of the whole bundle, beside its files.
struct Sender {
  std::string signed_by;  ///< the key whose signature was asked for and found
  std::string failure;    ///< one sentence where the bundle is not the one that was meant
};

/// A fingerprint as it is compared: in lower case, without spaces.
std::string plainFingerprint(const std::string& text) {
  std::string out = base::lowered(text);
  std::erase_if(out, [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; });
  return out;
}

base::Result<Sender> senderOf(const VerifyOptions& options, const std::string& name,
                              const model_io::BundleCheck& bundle) {
  Sender out;
  if (!options.key.empty()) {
    if (bundle.signature) {
      const auto signer = bundle::signerOf(bundle.manifest, *bundle.signature, options.key);
      if (signer) {
        out.signed_by = *signer;
      } else if (signer.error().code == base::ErrorCode::kMismatch) {
        out.failure = base::oneLine(name) + "/" + signer.error().message();
      } else {
        return tl::unexpected(signer.error());
      }
    } else {
      out.failure = base::oneLine(name) + ": found no signature, wanted one of the manifest by the key in " +
                    base::oneLine(options.key) + ", in the file " + std::string(model_io::kSignatureName);
    }
  }
  if (!options.expect.empty() && plainFingerprint(options.expect) != bundle.fingerprint) {
    out.failure = base::oneLine(name) + ": found the fingerprint " + model_io::fingerprintText(bundle.fingerprint) +
                  ", wanted " + base::oneLine(options.expect) + ": this is another bundle";
  }
  return out;
}

std::string asText(const std::string& name, const model_io::BundleCheck& bundle, const Sender& sender,
                   const std::vector<CheckedContract>& contracts) {
  const bool ok = bundle.ok() && sender.failure.empty() && brokenContract(contracts).empty();
  std::string text = base::oneLine(name) + ": " + (ok ? "verified" : "not verified") + "\n  fingerprint " +
                     model_io::fingerprintText(bundle.fingerprint) + '\n';
  if (!sender.signed_by.empty()) {
    text += "  signed by " + sender.signed_by + '\n';
  } else if (bundle.signature && sender.failure.empty()) {
    text += "  signed; --key PUBLIC checks by whom\n";
  }
  for (const model_io::Approval& one : bundle.approvals) {
    text += "  approved by " + base::oneLine(one.author) + ", " + base::oneLine(one.utc) + ": " +
            base::oneLine(one.text) + '\n';
  }
  for (const model_io::FileCheck& check : bundle.files) {
    text += std::string(check.ok ? "  ok     " : "  wrong  ") + base::oneLine(check.file.path);
    if (check.file.promise) {
      text += "  largest error " + base::formatNumber(check.largest_error_n) + " N of " +
              base::formatNumber(check.file.promise->tolerance_n) + " N" +
              (check.evaluated ? "" : ", as measured when it was written");
    }
    text += '\n';
  }
  return text + contractsAsText(bundle.model, contracts);
}

std::string asJson(const std::string& name, const model_io::BundleCheck& bundle, const Sender& sender,
                   const std::vector<CheckedContract>& contracts) {
  const bool ok = bundle.ok() && sender.failure.empty() && brokenContract(contracts).empty();
  base::JsonWriter json;
  json.beginObject().key("bundle").value(name).key("ok").value(ok);
  json.key("fingerprint").value(bundle.fingerprint).key("model_sha256").value(bundle.model_sha256);
  json.key("signature").value(bundle.signature.has_value()).key("signed_by");
  sender.signed_by.empty() ? json.null() : json.value(sender.signed_by);
  writeSignOffs(json, bundle.approvals);
  json.key("files").beginArray();
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
  json.endArray();
  writeContracts(contracts, json);
  return json.endObject().text();
}

}  // namespace

base::Result<Output> verify(const VerifyOptions& options) {
  TACTUS_TRY(const auto name, bundleNamed(options.folder));
  TACTUS_TRY(const auto bundle, bundle::verifyBundle(name, kGenerator));
  TACTUS_TRY(const auto sender, senderOf(options, name, bundle));
  TACTUS_TRY(const auto compiled, fuzzy::compile(bundle.model));
  TACTUS_TRY(const auto contracts, checkedContracts(bundle.model, compiled, {}));
  Output output{options.json ? asJson(name, bundle, sender, contracts) : asText(name, bundle, sender, contracts), {}};
  output.failure = sender.failure;
  for (const model_io::FileCheck& check : bundle.files) {
    if (!check.ok && output.failure.empty()) output.failure = check.wrong;
  }
  const std::string broken = brokenContract(contracts);
  if (output.failure.empty() && !broken.empty()) output.failure = base::oneLine(name) + ": " + broken;
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
  return text + "  fingerprint " + model_io::fingerprintText(made.fingerprint) + '\n';
}

std::string asJson(const std::string& folder, const bundle::Bundle& made) {
  base::JsonWriter json;
  json.beginObject().key("bundle").value(folder).key("warnings").values(made.warnings);
  json.key("fingerprint").value(made.fingerprint);
  json.key("manifest").raw(model_io::formatManifest(made.manifest)).endObject();
  return json.text();
}

}  // namespace

base::Result<Output> bundle(const BundleOptions& options) {
  TACTUS_TRY(auto read, model_io::readModel(options.model));
  bundle::BundleSettings settings{options.accept_holes, base::formatUtc(std::chrono::system_clock::now()),
                                  std::string(kGenerator), options.table_error_n};
  if (!options.study.empty()) {
    TACTUS_TRY(auto sign_offs, signOffsOn(read.model, options.study));
    settings.approvals = std::move(sign_offs);
    TACTUS_TRY(settings.procedure, session::procedureAt(options.study));
  }
  const bool zip = bundle::isZipName(options.out) && !std::filesystem::is_directory(options.out);
  // What would stop it in the end is said before the work.
  if (zip) {
    if (const auto ok = requireOutput(options.out, {options.model, options.study, options.sign}); !ok)
      return tl::unexpected(ok.error());
  } else if (const auto ok = bundle::mayHoldBundle(options.out); !ok) {
    return tl::unexpected(ok.error());
  }
  if (!options.sign.empty()) {
    TACTUS_TRY(const auto key, base::readFile(options.sign, std::size_t{1} << 20U));
  }
  auto made = bundle::makeBundle(std::move(read.model), settings);
  if (!made) return base::inFile(made.error(), options.model);
  if (!options.sign.empty()) {
    TACTUS_TRY(auto signature, bundle::signatureOf(made->files.back().second, options.sign));
    made->files.emplace_back(model_io::kSignatureName, std::move(signature));
  }
  if (const auto written = zip ? bundle::writeBundleZip(*made, options.out) : bundle::writeBundle(*made, options.out);
      !written)
    return tl::unexpected(written.error());
  std::vector<std::string> warnings = read.warnings;
  warnings.insert(warnings.end(), made->warnings.begin(), made->warnings.end());
  if (!options.study.empty() && settings.approvals.empty())
    warnings.push_back(options.study + " has no sign-off on this state of the model");
  return Output{options.json ? asJson(options.out, *made) : asText(options.out, *made), std::move(warnings)};
}

}  // namespace tactus::cli
