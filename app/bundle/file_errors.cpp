#include "app/bundle/file_errors.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "app/bundle/program_run.h"
#include "app/bundle/zip.h"
#include "core/analysis/check_points.h"
#include "core/analysis/sampled_centroid.h"
#include "core/base/error.h"
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
  /// `generator`: this program.
  Verifier(const model_io::BundleCheck& bundle, fuzzy::CompiledModel compiled, std::string folder,
           std::string_view generator)
      : model_(bundle.model),
        origin_{bundle.model_sha256, bundle.model.created_utc, bundle.generator},
        compiled_(std::move(compiled)),
        folder_(std::move(folder)),
        same_program_(bundle.generator == generator),
        points_(analysis::checkPoints(model_)) {}

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
    const auto text = exchange::format(model_, index, dialect, origin_);
    compare(check, bytes, text ? std::optional(*text) : std::nullopt);
    if (check.ok) take(check, promiseOf(dialect, compiled_, index, points_));
  }

  /// The text of another version is not run, because it is not known what it does.
  void lookAtSource(FileCheck& check, const std::string& bytes) {
    const auto source = exchange::cSource(model_, {}, origin_);
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
  exchange::Origin origin_;
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
  TACTUS_TRY(auto compiled, fuzzy::compile(bundle->model));
  Verifier verifier(*bundle, std::move(compiled), folder, generator);
  for (FileCheck& check : bundle->files) {
    if (check.ok && !check.evaluated) verifier.look(check);
  }
  return bundle;
}

base::Result<model_io::BundleCheck> verifyZip(const std::string& path, std::string_view generator) {
  TACTUS_TRY(const auto files, unzipped(path));
  std::error_code ignored;
  const fs::path place = fs::temp_directory_path(ignored) / "tactus-verify";
  const base::Unfinished folder = base::makeUnfinishedFolder(place.string(), base::kUnfinishedEnding);
  if (!folder.descriptor.isOpen())
    return base::fail(base::ErrorCode::kIo, place.string(), "no place to unpack", "a folder for temporary files");
  base::Result<void> written;
  for (const auto& [name, bytes] : files) {
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

// The C source of a bundle, compiled and run: what its forces really are.

/// The forces of `force_model` at `points`, computed by a program made of `source` with the C compiler `cc` of this
/// computer, in a folder that is removed. Nothing if there is no compiler, or it cannot be run here.
std::optional<std::vector<double>> forcesOf(const exchange::CSource& source,
                                            const std::vector<std::vector<double>>& points,
                                            const std::stop_token& stop = {});

namespace {

constexpr std::size_t kMostBytes = std::size_t{64} << 20U;

/// Reads points and writes their forces, all digits of them.
constexpr std::string_view kMain = R"(#include <stdio.h>
#include "force_model.h"
int main(void) {
  double inputs[FORCE_MODEL_INPUTS];
  for (;;) {
    int i, fired;
    for (i = 0; i < FORCE_MODEL_INPUTS; ++i) {
      if (scanf("%lf", &inputs[i]) != 1) return 0;
    }
    printf("%.17g\n", force_model(inputs, &fired));
  }
}
)";

}  // namespace

std::optional<std::vector<double>> forcesOf(const exchange::CSource& source,
                                            const std::vector<std::vector<double>>& points,
                                            const std::stop_token& stop) {
  std::error_code ignored;
  const base::Unfinished work =
      base::makeUnfinishedFolder((fs::temp_directory_path(ignored) / "tactus-c").string(), base::kUnfinishedEnding);
  if (!work.descriptor.isOpen()) return std::nullopt;
  struct Removed {
    const std::string& folder;
    ~Removed() {
      std::error_code unimportant;
      fs::remove_all(folder, unimportant);
    }
  } const removed{work.path};

  std::string input;
  for (const auto& point : points) {
    for (const double value : point) input += base::formatNumber(value) + ' ';
    input += '\n';
  }
  const auto write = [&](const std::string& name, std::string_view text) {
    return base::writeFileAtomically(work.path + "/" + name, text).has_value();
  };
  if (!write("force_model.h", source.header) || !write("force_model.c", source.source) || !write("main.c", kMain) ||
      !write("in", input))
    return std::nullopt;
  const std::string program = work.path + "/forces";
  const std::vector<std::string> compile = {
      "cc", "-std=c99", "-O1", work.path + "/force_model.c", work.path + "/main.c", "-o", program, "-lm"};
  if (runProgram(compile, work.path, stop) != Ran::kWell || runProgram({program}, work.path, stop) != Ran::kWell)
    return std::nullopt;
  const auto output = base::readFile(work.path + "/out", kMostBytes);
  if (!output) return std::nullopt;
  std::vector<double> forces;
  std::string_view rest = *output;
  for (std::size_t end = rest.find('\n'); end != std::string_view::npos; end = rest.find('\n')) {
    const auto force = base::parseNumber(rest.substr(0, end));
    if (!force) return std::nullopt;
    forces.push_back(*force);
    rest.remove_prefix(end + 1);
  }
  if (forces.size() != points.size()) return std::nullopt;
  return forces;
}

namespace {

constexpr double kRounding = 1e-12;

/// The next number with two digits above `value`.
double rounded(double value) {
  if (value <= 0) return 0;
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return std::ceil(value / unit) * unit;
}

/// `difference(point)`: of the force there; nothing where there is none to compare.
model_io::Promise measured(std::string rule, double tolerance_n, const std::vector<std::vector<double>>& points,
                           const std::function<double(std::span<const double>)>& difference) {
  model_io::Promise promise{std::move(rule), tolerance_n, 0, {}};
  for (const auto& point : points) {
    const double error_n = std::abs(difference(point));
    if (!(error_n > promise.largest_error_n)) continue;
    promise.largest_error_n = error_n;
    promise.at = point;
  }
  promise.tolerance_n = std::max(promise.tolerance_n, rounded(promise.largest_error_n));
  return promise;
}

}  // namespace

model_io::Promise promiseOf(exchange::Dialect dialect, const fuzzy::CompiledModel& model, std::size_t expert,
                            const std::vector<std::vector<double>>& points) {
  using Rule = analysis::Sampling::Rule;
  const exchange::ReaderRule reader = exchange::readerRule(dialect);
  const analysis::Sampling sampling{reader.midpoint ? Rule::kMidpoint : Rule::kLinspace, reader.count};
  const double range_n = model.outputMax() - model.outputMin();
  const std::string rule = (reader.midpoint ? "midpoint:" : "linspace:") + std::to_string(reader.count);
  return measured(rule, reader.tolerance * range_n, points, [&](std::span<const double> point) {
    const auto exact = model.evaluateExpert(expert, point);
    if (!exact.fired) return 0.0;
    const double sampled_n = analysis::evaluateSampled(model, point, sampling, expert).force_n;
    // The set lies between the samples: such a reader may give anything.
    return std::isnan(sampled_n) ? range_n : sampled_n - exact.force_n;
  });
}

model_io::Promise promiseOf(const BoundedTable& table, const fuzzy::CompiledModel& model,
                            const std::vector<std::vector<double>>& points) {
  model_io::Promise promise = errorOf(table.table, model, points);
  promise.tolerance_n = std::max(promise.tolerance_n, rounded(table.bound.bound_n));
  return promise;
}

model_io::Promise errorOf(const ForceTable& table, const fuzzy::CompiledModel& model,
                          const std::vector<std::vector<double>>& points) {
  return measured("table", 0, points,
                  [&](std::span<const double> point) { return table.force(point) - model.evaluate(point).force_n; });
}

model_io::Promise exactPromise(const fuzzy::ForceModel& model) {
  return {"exact", kRounding * (model.output.max - model.output.min), 0, {}};
}

model_io::Promise promiseOf(const exchange::CSource& source, const fuzzy::CompiledModel& model,
                            const std::vector<std::vector<double>>& points, const std::stop_token& stop) {
  const double bound_n = kRounding * (model.outputMax() - model.outputMin());
  const auto forces = forcesOf(source, points, stop);
  if (!forces) {
    model_io::Promise promise{"exact", bound_n, bound_n, {}};
    promise.measured = false;
    return promise;
  }
  std::size_t next = 0;
  return measured("exact", bound_n, points, [&](std::span<const double> point) {
    const double difference = (*forces)[next++] - model.evaluate(point).force_n;
    // A force that is none at all.
    return std::isnan(difference) ? model.outputMax() - model.outputMin() : difference;
  });
}

}  // namespace tactus::bundle
