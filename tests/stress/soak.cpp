// Many random and adversarial models against exact rationals.
#include <CLI/CLI.hpp>
#include <algorithm>

#include "core/base/text.h"
#include "core/model_io/model_file.h"

#include "tests/stress/agreement.h"
#include "tests/stress/hard_model.h"
#include "tests/stress/soak_runner.h"
#include "tests/support/random_model.h"

namespace tactus::stress {
namespace {

/// Ordinary, adversarial and hard models in turn.
fuzzy::ForceModel modelNumber(std::uint64_t number, base::Random& random) {
  switch (number % 4) {
    case 0: return support::randomModel(random, {.gaussians = false, .adversarial = false});
    case 1: return support::randomModel(random, {.gaussians = false, .adversarial = true});
    default: return hardModel(random);
  }
}

bool soakModels(const SoakOptions& options, int points) {
  std::uint64_t above_four_ulps = 0;
  double largest_share = 0;
  double largest_ulps = 0;
  const auto run = [&](std::uint64_t number) {
    base::Random random = caseRandom(options, number);
    const fuzzy::ForceModel model = modelNumber(number, random);
    const Agreement found = checkBuildment(model, random, points);
    const auto note = [&, share = found.largest_share, ulps = found.largest_ulps] {
      largest_share = std::max(largest_share, share);
      largest_ulps = std::max(largest_ulps, ulps);
      if (ulps > 4) ++above_four_ulps;
    };
    return SoakCase{note, found.disagreement ? *found.disagreement + '\n' + model_io::formatModel(model) : ""};
  };
  const auto summary = [&] {
    return "largest error " + base::formatFixed(largest_share, 3) + " of the bound; batch and scene within " +
           base::formatFixed(largest_ulps, 1) + " ulp of one point (above 4 ulp: " + std::to_string(above_four_ulps) +
           " models)";
  };
  return soak(options, "soak --points " + std::to_string(points), run, summary);
}

}  // namespace
}  // namespace tactus::stress

int main(int argc, char** argv) {
  tactus::stress::SoakOptions options{.count = 100000};
  int points = 6;
  CLI::App app{"Random and adversarial models under every evaluator, against exact rational arithmetic"};
  addSoakOptions(app, options);
  app.add_option("--points", points, "points for each model")->check(CLI::Range(1, 1000));
  CLI11_PARSE(app, argc, argv);
  return tactus::stress::soakModels(options, points) ? 0 : 1;
}
