// Many hands under the servo.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>

#include "core/base/text.h"

#include "tests/stress/feel_run.h"
#include "tests/stress/soak_runner.h"

namespace tactus::stress {
namespace {

/// What is wrong with a run, or nothing.
std::string wrong(const FeelRun& run) {
  if (run.violation) return *run.violation;
  if (run.most_transitions > 0 && run.transitions > run.most_transitions)
    return std::to_string(run.transitions) + " transitions, at most " + std::to_string(run.most_transitions);
  if (run.most_ripple_n > 0 && run.ripple_n > run.most_ripple_n)
    return "ripple " + base::formatNumber(run.ripple_n) + " N, at most " + base::formatNumber(run.most_ripple_n);
  return {};
}

bool soakRuns(const SoakOptions& options) {
  FeelRun worst;
  int tripped = 0;
  const auto run = [&](std::uint64_t number) {
    const FeelRun found = feelRun(number);
    const auto note = [&worst, &tripped, found] {
      tripped += found.tripped ? 1 : 0;
      worst.ripple_n = std::max(worst.ripple_n, found.most_ripple_n > 0 ? found.ripple_n : 0);
      worst.transitions = std::max(worst.transitions, found.most_transitions > 0 ? found.transitions : 0);
      worst.lowest_certificate_mj = std::min(worst.lowest_certificate_mj, found.lowest_certificate_mj);
      worst.largest_depth_error_mm = std::max(worst.largest_depth_error_mm, found.largest_depth_error_mm);
    };
    std::string trouble = wrong(found);
    if (!trouble.empty()) trouble += "\n" + found.what;
    return SoakCase{note, std::move(trouble)};
  };
  const auto summary = [&] {
    return "tripped " + std::to_string(tripped) + "; most transitions " + std::to_string(worst.transitions) +
           ", largest ripple " + base::formatFixed(worst.ripple_n, 4) + " N, lowest certificate " +
           base::formatNumber(worst.lowest_certificate_mj) + " mJ, largest error of the depth " +
           base::formatNumber(worst.largest_depth_error_mm) + " mm";
  };
  return soak(options, "feel_soak", run, summary);
}

}  // namespace
}  // namespace tactus::stress

int main(int argc, char** argv) {
  // A run is known by its number alone; the seed changes nothing.
  tactus::stress::SoakOptions options{.count = 50000};
  CLI::App app{"Simulated hands under the servo: stability, limits, energy and depth"};
  addSoakOptions(app, options);
  CLI11_PARSE(app, argc, argv);
  return tactus::stress::soakRuns(options) ? 0 : 1;
}
