#include "app/bundle/verify_bundle.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "app/bundle/file_errors.h"
#include "app/bundle/zip.h"
#include "core/analysis/check_points.h"
#include "core/base/files/file.h"
#include "core/base/files/unfinished.h"
#include "core/base/text.h"
#include "core/exchange/c_source.h"

namespace tactus::bundle {
namespace {

namespace fs = std::filesystem;
using model_io::FileCheck;

constexpr std::size_t kMostFileBytes = std::size_t{256} << 20U;

class Verifier {
 public:
  Verifier(const fuzzy::ForceModel& model, fuzzy::CompiledModel compiled, std::string folder, bool same_program)
      : model_(model),
        compiled_(std::move(compiled)),
        folder_(std::move(folder)),
        same_program_(same_program),
        points_(analysis::checkPoints(model)) {}

  void look(FileCheck& check) {
    const std::string path = folder_ + "/" + check.file.path;
    auto bytes = base::readFile(path, kMostFileBytes);
    if (!bytes) return fail(check, bytes.error().message());
    if (check.file.kind == "table") {
      const auto table = parseTable(model_, std::move(*bytes), path);
      if (!table) return fail(check, table.error().message());
      return take(check, errorOf(*table, compiled_, points_));
    }
    if (check.file.kind == "c") return lookAtSource(check, *bytes);
    for (const exchange::Dialect dialect : exchange::kDialects) {
      if (check.file.kind == name(dialect)) return lookAtExpert(check, *bytes, dialect);
    }
  }

 private:
  void lookAtExpert(FileCheck& check, const std::string& bytes, exchange::Dialect dialect) {
    const auto expert = std::find_if(model_.experts.begin(), model_.experts.end(),
                                     [&](const fuzzy::Expert& one) { return one.id == check.file.expert; });
    if (expert == model_.experts.end())
      return fail(check, check.file.path + ": found the expert " + base::quoted(check.file.expert) +
                             ", wanted one of the model");
    const auto index = static_cast<std::size_t>(expert - model_.experts.begin());
    const auto text = exchange::format(model_, index, dialect);
    compare(check, bytes, text ? std::optional(*text) : std::nullopt);
    if (check.ok) take(check, promiseOf(dialect, compiled_, index, points_));
  }

  /// The text of another version is not run, because it is not known what it does.
  void lookAtSource(FileCheck& check, const std::string& bytes) {
    const auto source = exchange::cSource(model_);
    const bool header = check.file.path.ends_with(".h");
    compare(check, bytes, source ? std::optional(header ? source->header : source->source) : std::nullopt);
    if (!check.ok || !same_program_ || header) return;
    const model_io::Promise now = promiseOf(*source, compiled_, points_);
    if (now.measured) take(check, now);
  }

  void compare(FileCheck& check, const std::string& bytes, const std::optional<std::string>& wanted) const {
    if (!same_program_ || (wanted && *wanted == bytes)) return;
    fail(check, check.file.path + ": found another text than this program writes for the model, wanted the same");
  }

  /// The error of now takes the place of the promised one.
  static void take(FileCheck& check, const model_io::Promise& now) {
    check.evaluated = true;
    check.largest_error_n = now.largest_error_n;
    if (!check.file.promise || now.largest_error_n <= check.file.promise->tolerance_n) return;
    fail(check, check.file.path + ": found an error of " + base::formatNumber(now.largest_error_n) +
                    " N, wanted at most " + base::formatNumber(check.file.promise->tolerance_n) + " N");
  }

  static void fail(FileCheck& check, std::string sentence) {
    check.ok = false;
    check.wrong = std::move(sentence);
  }

  const fuzzy::ForceModel& model_;
  fuzzy::CompiledModel compiled_;
  std::string folder_;
  bool same_program_;
  std::vector<std::vector<double>> points_;
};

}  // namespace

namespace {

base::Result<model_io::BundleCheck> verifyFolder(const std::string& folder, std::string_view generator) {
  auto bundle = model_io::checkBundle(folder);
  if (!bundle) return bundle;
  auto compiled = fuzzy::compile(bundle->model);
  if (!compiled) return tl::unexpected(compiled.error());
  Verifier verifier(bundle->model, std::move(*compiled), folder, bundle->generator == generator);
  for (FileCheck& check : bundle->files) {
    if (check.ok && !check.evaluated) verifier.look(check);
  }
  return bundle;
}

base::Result<model_io::BundleCheck> verifyZip(const std::string& path, std::string_view generator) {
  const auto files = unzipped(path);
  if (!files) return tl::unexpected(files.error());
  std::error_code ignored;
  const fs::path place = fs::temp_directory_path(ignored) / "tactus-verify";
  const base::Unfinished folder = base::makeUnfinishedFolder(place.string(), base::kUnfinishedEnding);
  if (!folder.descriptor.isOpen())
    return base::fail(base::ErrorCode::kIo, place.string(), "no place to unpack", "a folder for temporary files");
  base::Result<void> written;
  for (const auto& [name, bytes] : *files) {
    const std::string file = folder.path + "/" + name;
    if (written) written = base::makeFolder(fs::path(file).parent_path().string());
    if (written) written = base::writeFileAtomically(file, bytes);
  }
  auto bundle = written ? verifyFolder(folder.path, generator) : tl::unexpected(written.error());
  fs::remove_all(folder.path, ignored);
  // Its user knows the zip file alone.
  const auto rename = [&](std::string& text) {
    for (std::size_t at = 0; (at = text.find(folder.path, at)) != std::string::npos; at += path.size())
      text.replace(at, folder.path.size(), path);
  };
  if (!bundle) {
    base::Error error = bundle.error();
    rename(error.file);
    return tl::unexpected(std::move(error));
  }
  for (FileCheck& check : bundle->files) rename(check.wrong);
  return bundle;
}

}  // namespace

base::Result<model_io::BundleCheck> verifyBundle(const std::string& path, std::string_view generator) {
  std::error_code ignored;
  return isZipName(path) && fs::is_regular_file(path, ignored) ? verifyZip(path, generator)
                                                               : verifyFolder(path, generator);
}

}  // namespace tactus::bundle
