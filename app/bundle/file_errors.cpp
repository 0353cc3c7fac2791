#include "app/bundle/file_errors.h"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <functional>
#include <optional>
#include <poll.h>
#include <span>
#include <spawn.h>
#include <stop_token>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>
#include <vector>

#include "app/bundle/zip.h"
#include "core/analysis/centroid_bound.h"
#include "core/analysis/check_points.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/text.h"

extern char** environ;

namespace tactus::bundle {

Ran runProgram(std::vector<std::string> words, const std::string& folder, const std::stop_token& stop) {
  constexpr int kLongestMs = 60'000;  // a program that takes longer is not waited for
  constexpr int kStepMs = 5;
  constexpr int kNewFile = O_WRONLY | O_CREAT | O_TRUNC;
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, (folder + "/in").c_str(), O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, (folder + "/out").c_str(), kNewFile, 0600);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, (folder + "/err").c_str(), kNewFile, 0600);
  pid_t child = 0;
  const bool started = posix_spawnp(&child, arguments.front(), &files, nullptr, arguments.data(), environ) == 0;
  posix_spawn_file_actions_destroy(&files);
  if (!started) return Ran::kNotThere;
  int status = 0;
  for (int waited = 0; waitpid(child, &status, WNOHANG) == 0; waited += kStepMs) {
    if (waited >= kLongestMs || stop.stop_requested()) {
      kill(child, SIGKILL);
      waitpid(child, &status, 0);
      return Ran::kEnded;
    }
    poll(nullptr, 0, kStepMs);
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? Ran::kWell : Ran::kFailed;
}

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
        points_(analysis::checkPoints(model_)),
        sources_(sourcesOf(model_, origin_)),
        felt_(feltTraces(model_)) {}

  void look(FileCheck& check) {
    const std::string path = folder_ + "/" + check.file.path;
    auto bytes = base::readFile(path, kMostFileBytes);
    if (!bytes) return fail(check, bytes.error().message());
    if (check.file.kind == "table") {
      const auto table = parseTable(model_, std::move(*bytes), path);
      if (!table) return fail(check, table.error().message());
      return take(check, errorOf(*table, compiled_, points_));
    }
    for (const SourceFile& own : sources_.files) {
      if (check.file.path == own.path) return lookAtSource(check, *bytes, own);
    }
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
  void lookAtSource(FileCheck& check, const std::string& bytes, const SourceFile& own) {
    compare(check, bytes, own.bytes);
    if (!check.ok || !same_program_ || own.gives == SourceFile::Gives::kNothing) return;
    const model_io::Promise now = promiseOf(runs_, own, compiled_);
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
  Sources sources_;
  std::optional<FeltTraces> felt_;
  SourceRuns runs_{sources_, points_, felt_};
};

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
  TACTUS_TRY(const auto folder, UnzippedFolder::of(path));
  auto bundle = verifyFolder(folder.path(), generator);
  if (!bundle) return tl::unexpected(folder.named(bundle.error()));
  for (FileCheck& check : bundle->files) check.wrong = folder.named(std::move(check.wrong));
  return bundle;
}

}  // namespace

base::Result<model_io::BundleCheck> verifyBundle(const std::string& path, std::string_view generator) {
  std::error_code ignored;
  return isZipName(path) && fs::is_regular_file(path, ignored) ? verifyZip(path, generator)
                                                               : verifyFolder(path, generator);
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

model_io::Promise promiseOf(SourceRuns& runs, const SourceFile& file, const fuzzy::CompiledModel& model) {
  const double range_n = model.outputMax() - model.outputMin();
  model_io::Promise promise{"exact", kRounding * range_n, 0, {}};
  const auto forces = runs.of(file);
  if (!forces) {
    promise.largest_error_n = promise.tolerance_n;
    promise.measured = false;
    return promise;
  }
  std::size_t next = 0;
  const auto take = [&](double wanted_n, const auto& at) {
    // A force that is none at all.
    const double error_n = std::isnan((*forces)[next]) ? range_n : std::abs((*forces)[next] - wanted_n);
    ++next;
    if (!(error_n > promise.largest_error_n)) return;
    promise.largest_error_n = error_n;
    promise.at = at();
  };
  if (file.gives == SourceFile::Gives::kTube) {
    const auto& felt = runs.felt();
    for (std::size_t t = 0; t < felt->felt.size(); ++t) {
      for (std::size_t i = 0; i < felt->felt[t].size(); ++i) {
        take(felt->felt[t][i].force_n, [&] {
          return std::vector{static_cast<double>(t + 1), static_cast<double>(i + 1)};
        });
      }
    }
  } else {
    for (const auto& point : runs.points()) take(model.evaluate(point).force_n, [&] { return point; });
  }
  promise.tolerance_n = std::max(promise.tolerance_n, rounded(promise.largest_error_n));
  return promise;
}

}  // namespace tactus::bundle
