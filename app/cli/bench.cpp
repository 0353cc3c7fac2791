// Run time against error on this machine: the exact centroid by every entry point of libtactus beside sampled
// centroids.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>

#include "app/certify/certificate.h"
#include "app/cli/commands.h"
#include "app/cli/model_arguments.h"
#include "app/cli/terminal.h"
#include "core/analysis/force_difference.h"
#include "core/base/error.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"
#include "core/fuzzy/batch.h"
#include "core/fuzzy/scene.h"

namespace tactus::cli {
namespace {

using analysis::Sampling;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kBenchPoints = 1024;
constexpr std::size_t kFewestPoints = 16;     // of a slow method
constexpr std::size_t kScenesFreeInputs = 2;  // as in a hand-held scene: depth and speed

/// What other tools use: fuzzylite's and MATLAB's defaults, and finer ones.
constexpr Sampling kSampled[] = {{Sampling::Rule::kMidpoint, 100},    {Sampling::Rule::kLinspace, 101},
                                 {Sampling::Rule::kMidpoint, 1'000},  {Sampling::Rule::kLinspace, 1'001},
                                 {Sampling::Rule::kMidpoint, 10'000}, {Sampling::Rule::kLinspace, 10'001}};

struct BenchRow {
  std::string method;
  std::string entry = {};  ///< of libtactus; empty: none
  double ns = 0;           ///< for one point, the fastest round
  double largest_error_n = 0;
  double rms_error_n = 0;
  std::size_t points = 0;
};

double secondsSince(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

/// The time of one call of `round` in s: the fastest of as many as fit into `seconds`, at least one.
double fastest(const std::function<void()>& round, double seconds) {
  const auto begin = Clock::now();
  double best = 0;
  do {
    const auto start = Clock::now();
    round();
    const double took = secondsSince(start);
    best = best == 0 ? took : std::min(best, took);
  } while (secondsSince(begin) < seconds);
  return best;
}

/// Fills in the row's errors and its number of points.
void measureErrors(BenchRow& row, const std::vector<double>& forces, const std::vector<fuzzy::Evaluation>& exact) {
  double squares = 0;
  for (std::size_t p = 0; p < forces.size(); ++p) {
    if (!exact[p].fired || std::isnan(forces[p])) continue;
    const double error_n = std::abs(forces[p] - exact[p].force_n);
    row.largest_error_n = std::max(row.largest_error_n, error_n);
    squares += error_n * error_n;
    ++row.points;
  }
  if (row.points > 0) row.rms_error_n = std::sqrt(squares / static_cast<double>(row.points));
}

std::vector<std::vector<double>> columnsOf(const std::vector<std::vector<double>>& points, std::size_t first) {
  std::vector<std::vector<double>> columns(points.front().size() - first);
  for (const auto& point : points) {
    for (std::size_t i = first; i < point.size(); ++i) columns[i - first].push_back(point[i]);
  }
  return columns;
}

std::vector<std::span<const double>> spansOf(const std::vector<std::vector<double>>& columns) {
  return std::vector<std::span<const double>>(columns.begin(), columns.end());
}

class Bench {
 public:
  Bench(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled, double seconds)
      : compiled_(compiled), points_(analysis::boxPoints(model, kBenchPoints)), seconds_(seconds) {
    const std::size_t inputs = model.inputs.size();
    first_free_ = inputs > kScenesFreeInputs ? inputs - kScenesFreeInputs : 0;
    forces_.resize(points_.size());
    fired_.resize(points_.size());
    for (std::size_t i = 0; i < first_free_; ++i) {
      fixed_.push_back((model.inputs[i].min + model.inputs[i].max) / 2);
    }
  }

  std::vector<BenchRow> exactRows() {
    const auto exact = exactAt(points_);
    std::vector<BenchRow> rows;
    rows.push_back(timed("exact, one point", "tactus_force", exact, [this] {
      for (std::size_t p = 0; p < points_.size(); ++p) forces_[p] = compiled_.evaluate(points_[p]).force_n;
    }));
    const auto columns = columnsOf(points_, 0);
    const auto spans = spansOf(columns);
    rows.push_back(timed("exact, a batch", "tactus_force_batch", exact, [&] {
      fuzzy::evaluateBatch(compiled_, spans, {forces_, fired_});
    }));
    return rows;
  }

  /// All inputs but the last two fixed.
  base::Result<std::vector<BenchRow>> sceneRows() {
    std::vector<std::optional<double>> fixed(points_.front().size());
    auto points = points_;
    for (std::size_t i = 0; i < first_free_; ++i) {
      fixed[i] = fixed_[i];
      for (auto& point : points) point[i] = fixed_[i];
    }
    TACTUS_TRY(const auto scene, fuzzy::Scene::specialize(compiled_, fixed));
    const auto exact = exactAt(points);
    std::vector<BenchRow> rows;
    rows.push_back(timed("scene, one point", "tactus_scene_force", exact, [&] {
      for (std::size_t p = 0; p < points.size(); ++p) {
        forces_[p] = scene.evaluate(std::span(points[p]).subspan(first_free_)).force_n;
      }
    }));
    const auto columns = columnsOf(points, first_free_);
    const auto spans = spansOf(columns);
    rows.push_back(timed("scene, a batch", "tactus_scene_force_batch", exact, [&] {
      scene.evaluateBatch(spans, {forces_, fired_});
    }));
    return rows;
  }

  BenchRow sampledRow(const Sampling& sampling) const {
    const bool midpoint = sampling.rule == Sampling::Rule::kMidpoint;
    BenchRow row{.method = (midpoint ? "midpoint:" : "linspace:") + std::to_string(sampling.count)};
    // A slow method gets fewer points: as many as its time allows. Each point is timed by itself, because a round would
    // be longer than what a busy machine leaves a program at a time.
    const double one_s = fastest([&] { analysis::evaluateSampled(compiled_, points_.front(), sampling); }, 0);
    const auto most = static_cast<std::size_t>(std::clamp(seconds_ / std::max(one_s, 1e-9), 0.0, 1e9));
    const auto some = std::span(points_).first(std::clamp(most, kFewestPoints, points_.size()));
    std::vector<double> forces(some.size());
    double sum_s = 0;
    for (std::size_t p = 0; p < some.size(); ++p) {
      const auto force = [&] { forces[p] = analysis::evaluateSampled(compiled_, some[p], sampling).force_n; };
      sum_s += std::min({fastest(force, 0), fastest(force, 0), fastest(force, 0)});
    }
    row.ns = 1e9 * sum_s / static_cast<double>(some.size());
    measureErrors(row, forces, exactAt({some.begin(), some.end()}));
    return row;
  }

 private:
  std::vector<fuzzy::Evaluation> exactAt(const std::vector<std::vector<double>>& points) const {
    std::vector<fuzzy::Evaluation> out;
    for (const auto& point : points) out.push_back(compiled_.evaluate(point));
    return out;
  }

  BenchRow timed(const char* method, const char* entry, const std::vector<fuzzy::Evaluation>& exact,
                 const std::function<void()>& round) {
    BenchRow row{.method = method, .entry = entry};
    row.ns = 1e9 * fastest(round, seconds_) / static_cast<double>(points_.size());
    measureErrors(row, forces_, exact);
    return row;
  }

  const fuzzy::CompiledModel& compiled_;
  std::vector<std::vector<double>> points_;
  double seconds_;
  std::size_t first_free_ = 0;
  std::vector<double> fixed_;
  std::vector<double> forces_;
  std::vector<std::uint8_t> fired_;
};

std::string benchText(const BenchOptions& options, const fuzzy::ForceModel& model, const std::vector<BenchRow>& rows) {
  const std::string cpu = certify::processor();
  std::string text = base::oneLine(options.model) + ": experts " + std::to_string(model.experts.size()) +
                     (cpu.empty() ? std::string() : "; " + base::oneLine(cpu)) + '\n';
  text += padded("method", 22) + rightAligned("ns a point", 12) + rightAligned("largest error", 16) +
          rightAligned("rms error (" + model.output.unit + ")", 16) + rightAligned("points", 8) + '\n';
  for (const BenchRow& row : rows) {
    text += padded(row.method, 22) + rightAligned(base::formatFixed(row.ns, 0), 12) +
            rightAligned(certify::scientific(row.largest_error_n), 16) +
            rightAligned(certify::scientific(row.rms_error_n), 16) + rightAligned(std::to_string(row.points), 8) + '\n';
  }
  return text +
         "Errors are against one point of the exact centroid, itself within 1e-12 of the output's range.\n"
         "The fastest round counts; points without a firing rule have no error.\n";
}

std::string benchJson(const BenchOptions& options, const fuzzy::ForceModel& model, const std::vector<BenchRow>& rows) {
  base::JsonWriter json;
  json.beginObject().key("model").value(options.model).key("experts").value(model.experts.size());
  json.key("processor").value(certify::processor()).key("rows").beginArray();
  for (const BenchRow& row : rows) {
    json.beginObject(base::JsonWriter::Layout::kInline).key("method").value(row.method).key("entry");
    row.entry.empty() ? json.null() : json.value(row.entry);
    json.key("ns").value(row.ns).key("largest_error_n").value(row.largest_error_n);
    json.key("rms_error_n").value(row.rms_error_n).key("points").value(row.points).endObject();
  }
  json.endArray().endObject();
  return json.text();
}

}  // namespace

base::Result<Output> bench(const BenchOptions& options) {
  TACTUS_TRY(const auto opened, openedModel(options.model));
  Bench bench(opened.model, opened.compiled, options.seconds);
  auto rows = bench.exactRows();
  auto scenes = bench.sceneRows();
  if (!scenes) return inFile(scenes.error(), options.model);
  rows.insert(rows.end(), scenes->begin(), scenes->end());
  for (const Sampling& sampling : kSampled) rows.push_back(bench.sampledRow(sampling));
  return Output{options.json ? benchJson(options, opened.model, rows) : benchText(options, opened.model, rows),
                opened.warnings};
}

}  // namespace tactus::cli
