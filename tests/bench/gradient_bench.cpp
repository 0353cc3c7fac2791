// What a gradient costs, in plain evaluations, and what finite differences cost in gradients; the error of both.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>

#include "core/analysis/gradient/gradient.h"
#include "core/base/check.h"

#include "tests/bench/cases.h"
#include "tests/bench/finite_differences.h"
#include "tests/bench/interleaved.h"
#include "tests/bench/machine.h"
#include "tests/support/gradient_slots.h"

namespace tactus::bench {
namespace {

using analysis::Gradient;
using analysis::GradientMethod;
using analysis::GradientModel;
using reference::Parameter;

// Long enough for many points with each of some hundreds of moved models.
constexpr double kTurnNs = 2e7;

struct Options {
  int rounds = 30;
  std::size_t exact_points = 20;
};

/// Errors of derivatives, as shares of (universe of the force) / (width of the parameter).
struct Errors {
  double largest = 0;
  double sum = 0;
  std::size_t count = 0;

  void add(double error) {
    largest = std::max(largest, error);
    sum += error;
    ++count;
  }
};

/// A way to all derivatives at a point, one per parameter.
struct Way {
  std::string name;
  std::function<void(std::span<const double> point, std::span<double> derivatives)> derivatives;
  Job job;
};

class Comparison {
 public:
  explicit Comparison(std::string name, fuzzy::ForceModel model)
      : about_(makeCase(std::move(name), std::move(model), std::vector<std::optional<double>>(4), 0)),
        parameters_(reference::ExactGradient(about_.model, pointAt(0)).parameters()) {
    for (const auto& [label, method] : {std::pair{"gradient", GradientMethod::kFastest},
                                        std::pair{"gradient, general sweep", GradientMethod::kGeneral}}) {
      const GradientModel gradients = GradientModel::of(about_.model, method).value();
      addGradient(label, gradients);
      if (method == GradientMethod::kFastest) addFreshGradient(gradients);
    }
    for (const double step : {1e-4, 1e-6, 1e-8}) addDifferences(step);
  }

  void measure(const Options& options) {
    std::vector<Job> jobs = {plainJob()};
    for (const Way& way : ways_) jobs.push_back(way.job);
    const auto timed = timeInterleaved(jobs, {.rounds = options.rounds, .turn_ns = kTurnNs});
    const double plain_ns = timed.timings[0].median_ns;
    std::cout << '\n'
              << about_.name << ": " << parameters_.size() << " parameters, plain evaluation " << std::fixed
              << std::setprecision(1) << plain_ns << " ns (minimum " << timed.timings[0].min_ns << ")\n"
              << std::left << std::setw(34) << "way" << std::right << std::setw(12) << "median ns" << std::setw(12)
              << "minimum ns" << std::setw(16) << "evaluations" << std::setw(12) << "gradients" << std::setw(15)
              << "largest error" << std::setw(12) << "mean error" << '\n';
    for (std::size_t k = 0; k < ways_.size(); ++k) {
      const Timing& timing = timed.timings[k + 1];
      const Errors errors = errorsOf(ways_[k], options.exact_points);
      std::cout << std::left << std::setw(34) << ways_[k].name << std::right << std::fixed << std::setprecision(1)
                << std::setw(12) << timing.median_ns << std::setw(12) << timing.min_ns << std::setw(16)
                << timing.median_ns / plain_ns << std::setw(12) << timing.median_ns / timed.timings[1].median_ns
                << std::scientific << std::setw(15) << errors.largest << std::setw(12)
                << errors.sum / static_cast<double>(errors.count) << '\n';
    }
    std::cout << "sum of everything computed: " << timed.checksum << '\n';
  }

 private:
  std::vector<double> pointAt(std::size_t index) const {
    const auto row = about_.points.row(index);
    return {row.begin(), row.end()};
  }

  Job plainJob() const {
    return {"plain", about_.points.count(), [this](std::size_t first, std::span<double> out) {
              for (std::size_t i = 0; i < out.size(); ++i)
                out[i] = about_.compiled.evaluate(about_.points.row(first + i)).force_n;
            }};
  }

  void addGradient(const std::string& name, const GradientModel& gradients) {
    const auto gradient = std::make_shared<Gradient>(gradients.makeGradient());
    const std::size_t slot = gradients.inputSlot(2);
    const auto derivatives = [this, gradients, gradient](std::span<const double> point, std::span<double> out) {
      gradients.evaluate(point, *gradient);
      for (std::size_t k = 0; k < out.size(); ++k) out[k] = (*gradient)[support::slotOf(gradients, parameters_[k])];
    };
    const auto run = [this, gradients, gradient, slot](std::size_t first, std::span<double> out) {
      for (std::size_t i = 0; i < out.size(); ++i) {
        gradients.evaluate(about_.points.row(first + i), *gradient);
        out[i] = gradient->force_n + (*gradient)[slot];
      }
    };
    ways_.push_back({name, derivatives, {name, about_.points.count(), run}});
  }

  void addFreshGradient(const GradientModel& gradients) {
    const std::string name = "gradient, a new result each time";
    const std::size_t slot = gradients.inputSlot(2);
    const auto run = [this, gradients, slot](std::size_t first, std::span<double> out) {
      for (std::size_t i = 0; i < out.size(); ++i) {
        const Gradient gradient = gradients.evaluate(about_.points.row(first + i));
        out[i] = gradient.force_n + gradient[slot];
      }
    };
    ways_.push_back({name, ways_.front().derivatives, {name, about_.points.count(), run}});
  }

  void addDifferences(double step) {
    std::ostringstream name;
    name << "central differences, step " << step;
    const auto differences = std::make_shared<FiniteDifferences>(about_.model, parameters_, step);
    const auto derivatives = [differences](std::span<const double> point, std::span<double> out) {
      for (std::size_t k = 0; k < out.size(); ++k) out[k] = differences->derivative(k, point);
    };
    // A parameter at a time over many points: a model that moved for every evaluation would not stay in the cache.
    const auto run = [this, differences](std::size_t first, std::span<double> out) {
      for (std::size_t k = 0; k < differences->count(); ++k) {
        for (std::size_t i = 0; i < out.size(); ++i) out[i] = differences->derivative(k, about_.points.row(first + i));
      }
    };
    ways_.push_back({name.str(), derivatives, {name.str(), about_.points.count(), run}});
  }

  /// Distance from the two exact one-sided derivatives: at a kink both are right, and what lies between them.
  Errors errorsOf(const Way& way, std::size_t points) const {
    Errors errors;
    const double range_n = about_.model.output.max - about_.model.output.min;
    std::vector<double> derivatives(parameters_.size());
    for (std::size_t p = 0; p < points; ++p) {
      const auto point = pointAt(p);
      way.derivatives(point, derivatives);
      const reference::ExactGradient exact(about_.model, point);
      for (std::size_t k = 0; k < parameters_.size(); ++k) {
        const auto right = exact.derivative(parameters_[k], 1);
        const auto left = exact.derivative(parameters_[k], -1);
        // Where rules tie the first one's weight counts, and no derivative with respect to a single weight exists.
        const bool tied = parameters_[k].kind == Parameter::Kind::kWeight && exact.tied(1e-14);
        if (tied || (!right && !left)) continue;
        const auto [low, high] = std::minmax((right ? right : left)->value, (left ? left : right)->value);
        const mpq_class value = derivatives[k];
        const mpq_class error = value < low    ? mpq_class(low - value)
                                : value > high ? mpq_class(value - high)
                                               : mpq_class(0);
        errors.add(error.get_d() * widthOf(about_.model, parameters_[k]) / range_n);
      }
    }
    return errors;
  }

  Case about_;
  std::vector<Parameter> parameters_;
  std::vector<Way> ways_;
};

void run(const Options& options) {
  for (const auto& line : machineLines()) std::cout << line << '\n';
  std::cout << "Errors: against exact rational arithmetic at " << options.exact_points
            << " points, as shares of (universe of the force) / (universe of the parameter).\n"
               "Central differences: two plain evaluations per parameter, the moved models compiled beforehand, a "
               "parameter at a time over many points.\n";
  Comparison("one expert, clip", oneExpert(fuzzy::Implication::kClip)).measure(options);
  Comparison("one expert, scale", oneExpert(fuzzy::Implication::kScale)).measure(options);
  Comparison("four experts (S4 and three synthetic variations), clip", syntheticExperts(4)).measure(options);
  Comparison("four experts with terms of their own, clip", syntheticExperts(4, true)).measure(options);
}

}  // namespace
}  // namespace tactus::bench

int main(int argc, char** argv) {
  tactus::bench::Options options;
  CLI::App app{"Run time and error of gradients against finite differences"};
  app.add_option("--rounds", options.rounds, "turns of each way")->check(CLI::Range(1, 100000));
  app.add_option("--exact-points", options.exact_points, "points compared with exact rationals")
      ->check(CLI::Range(1, 10000));
  CLI11_PARSE(app, argc, argv);
  tactus::bench::run(options);
  return 0;
}
