#include "tests/bench/costs.h"

#include <array>
#include <cmath>
#include <memory>

#include "core/analysis/explain.h"
#include "core/analysis/force_balance.h"
#include "core/base/check.h"
#include "core/fuzzy/batch.h"
#include "core/fuzzy/scene.h"

#include "tests/bench/cases.h"
#include "tests/bench/cost_models.h"
#include "tests/bench/fuzzylite_peer.h"

namespace tactus::bench {
namespace {

using fuzzy::CompiledModel;
using fuzzy::ForceModel;

constexpr std::size_t kPoints = 2000;
constexpr std::size_t kRepetitions = 100;  ///< of jobs that have no points

CompiledModel compiledOf(const ForceModel& model) {
  auto compiled = fuzzy::compile(model);
  TACTUS_CHECK(compiled.has_value());
  return std::move(*compiled);
}

fuzzy::Scene specialized(const CompiledModel& model, std::span<const std::optional<double>> fixed) {
  auto scene = fuzzy::Scene::specialize(model, fixed);
  TACTUS_CHECK(scene.has_value());
  return std::move(*scene);
}

/// What an evaluation needs, shared by the jobs of one model.
struct Subject {
  ForceModel model;
  CompiledModel compiled;
  Points points;
  std::vector<std::uint8_t> fired = std::vector<std::uint8_t>(kPoints);

  explicit Subject(ForceModel m)
      : model(std::move(m)), compiled(compiledOf(model)), points(randomPoints(model, kPoints)) {}
};

Job compileJob(const std::shared_ptr<Subject>& subject) {
  return {"compile", kRepetitions, [subject](std::size_t /*first*/, std::span<double> out) {
            for (double& result : out) result = static_cast<double>(compiledOf(subject->model).expertCount());
          }};
}

Job onePointJob(const std::shared_ptr<Subject>& subject) {
  return {"one point", kPoints, [subject](std::size_t first, std::span<double> out) {
            for (std::size_t i = 0; i < out.size(); ++i) {
              out[i] = subject->compiled.evaluate(subject->points.row(first + i)).force_n;
            }
          }};
}

Job batchJob(const std::shared_ptr<Subject>& subject) {
  return {"batch", kPoints, [subject](std::size_t first, std::span<double> out) {
            std::vector<std::span<const double>> columns;
            for (const auto& column : subject->points.columns) {
              columns.push_back(std::span(column).subspan(first, out.size()));
            }
            fuzzy::evaluateBatch(subject->compiled, columns, {out, {subject->fired.data(), out.size()}});
          }};
}

void addModel(std::vector<CostJob>& jobs, const std::string& part, int value, ForceModel model) {
  const auto subject = std::make_shared<Subject>(std::move(model));
  const std::string text = std::to_string(value);
  jobs.push_back({part, text, "one point", onePointJob(subject)});
  jobs.push_back({part, text, "batch", batchJob(subject)});
  jobs.push_back({part, text, "compile", compileJob(subject)});
  if (subject->model.experts.size() > 1 || part == "experts" || part == "experts with own terms") return;
  if (const PeerEvaluator peer = fuzzylitePeer(subject->model, 100)) {
    jobs.push_back({part,
                    text,
                    "fuzzylite 100 on this model",
                    {"fuzzylite", kPoints, [subject, peer](std::size_t first, std::span<double> out) {
                       const std::size_t width = subject->points.inputs;
                       peer(std::span(subject->points.rows).subspan(first * width, out.size() * width), out);
                     }}});
  }
}

/// Specializing to the fixed inputs, and the forces over a grid of the inputs that vary.
class Grid {
 public:
  Grid(const ForceModel& model, std::vector<std::optional<double>> fixed, std::size_t steps)
      : compiled_(compiledOf(model)), fixed_(std::move(fixed)) {
    std::size_t free_inputs = 0;
    std::size_t points = 1;
    for (const auto& value : fixed_) {
      if (!value) ++free_inputs, points *= steps;
    }
    std::size_t stride = points;
    for (std::size_t i = 0; i < fixed_.size(); ++i) {
      if (fixed_[i]) continue;
      stride /= steps;
      std::vector<double> column(points);
      const auto& input = model.inputs[i];
      for (std::size_t p = 0; p < points; ++p) {
        const auto step = static_cast<double>(p / stride % steps);
        column[p] = input.min + (input.max - input.min) * step / static_cast<double>(steps - 1);
      }
      columns_.push_back(std::move(column));
    }
    forces_n_.resize(points);
    fired_.resize(points);
  }

  double compute() {
    const std::vector<std::span<const double>> columns(columns_.begin(), columns_.end());
    specialized(compiled_, fixed_).evaluateBatch(columns, {forces_n_, fired_});
    return forces_n_.back();
  }

 private:
  CompiledModel compiled_;
  std::vector<std::optional<double>> fixed_;
  std::vector<std::vector<double>> columns_;
  std::vector<double> forces_n_;
  std::vector<std::uint8_t> fired_;
};

Job gridJob(const ForceModel& model, std::vector<std::optional<double>> fixed, std::size_t steps) {
  const auto grid = std::make_shared<Grid>(model, std::move(fixed), steps);
  return {"grid", kRepetitions, [grid](std::size_t /*first*/, std::span<double> out) {
            for (double& result : out) result = grid->compute();
          }};
}

Job specializeJob(const ForceModel& model) {
  return {"specialize", kRepetitions,
          [compiled = compiledOf(model), fixed = sceneOfNgt()](std::size_t /*first*/, std::span<double> out) {
            for (double& result : out) result = static_cast<double>(specialized(compiled, fixed).freeInputCount());
          }};
}

/// All that `tactus why` computes at a point where several rules fire.
Job whyJob(const ForceModel& model) {
  return {"why", kRepetitions, [model, compiled = compiledOf(model)](std::size_t /*first*/, std::span<double> out) {
            constexpr std::array<double, 4> kPoint = {kFixedLubrication, kFixedNeckFlexionDeg, 130, 120};
            const auto felt_n = [](double force_n) { return std::hypot(0.04, 0.12 * force_n); };
            for (double& result : out) {
              const auto explanation = analysis::explain(model, compiled, kPoint);
              const auto moves = analysis::counterfactuals(model, compiled, kPoint, felt_n);
              TACTUS_CHECK(explanation.has_value() && moves.has_value());
              result = analysis::forceBalance(model, *explanation).force_n + static_cast<double>(moves->size());
            }
          }};
}

void addSetUpAndTasks(std::vector<CostJob>& jobs) {
  const ForceModel one = oneExpert(fuzzy::Implication::kClip);
  const ForceModel four = syntheticExperts(4);
  const std::string what = "time";
  jobs.push_back({"set-up", "compile one expert", what, compileJob(std::make_shared<Subject>(one))});
  jobs.push_back({"set-up", "compile four experts", what, compileJob(std::make_shared<Subject>(four))});
  jobs.push_back({"set-up", "specialize one expert", what, specializeJob(one)});
  jobs.push_back({"set-up", "specialize four experts", what, specializeJob(four)});
  if (fuzzylitePeer(one, 100)) {
    jobs.push_back({"set-up",
                    "fuzzylite: build the engine",
                    what,
                    {"engine", kRepetitions, [one](std::size_t /*first*/, std::span<double> out) {
                       for (double& result : out) result = fuzzylitePeer(one, 100) ? 1 : 0;
                     }}});
  }
  jobs.push_back(
      {"task", "256 x 256 surface, four experts, specializing included", what, gridJob(four, sceneOfNgt(), 256)});
  auto along_depth = sceneOfNgt();
  along_depth.back() = 50;
  jobs.push_back(
      {"task", "500-point depth curve, four experts, specializing included", what, gridJob(four, along_depth, 500)});
  jobs.push_back({"task", "why, four experts", what, whyJob(four)});
  jobs.push_back({"task", "why, 100 experts with own terms", what, whyJob(syntheticExperts(100, true))});
}

}  // namespace

std::vector<CostJob> costJobs() {
  std::vector<CostJob> jobs;
  for (const int rules : {45, 128, 256, 512, 1024, 2048, 4096}) addModel(jobs, "rules", rules, modelWithRules(rules));
  for (const int terms : {3, 5, 8, 16, 32, 64}) addModel(jobs, "terms", terms, modelWithTerms(terms));
  for (int inputs = 1; inputs <= 8; ++inputs) addModel(jobs, "inputs", inputs, modelWithInputs(inputs));
  for (const int experts : {1, 4, 16, 64, 256, 1024}) addModel(jobs, "experts", experts, syntheticExperts(experts));
  for (const int experts : {1, 4, 16, 64, 256, 1024}) {
    addModel(jobs, "experts with own terms", experts, syntheticExperts(experts, true));
  }
  addSetUpAndTasks(jobs);
  return jobs;
}

}  // namespace tactus::bench
