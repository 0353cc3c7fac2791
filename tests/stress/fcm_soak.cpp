// Many random small inputs under the clustering.
#include <CLI/CLI.hpp>
#include <algorithm>

#include "core/base/text.h"

#include "tests/stress/fcm_agreement.h"
#include "tests/stress/soak_runner.h"

namespace tactus::stress {
namespace {

constexpr std::uint64_t kGridEvery = 16;

bool soakInputs(const SoakOptions& options, int starts) {
  std::uint64_t refused = 0;
  std::uint64_t unfinished = 0;
  double largest_j_error = 0;
  int most_iterations = 0;
  const auto run = [&](std::uint64_t number) {
    base::Random random = caseRandom(options, number);
    const FcmInput input = randomFcmInput(random);
    const FcmAgreement found = checkClustering(input, random, starts, number % kGridEvery == 0);
    const auto note = [&, found] {
      refused += found.refused ? 1 : 0;
      unfinished += found.unfinished ? 1 : 0;
      largest_j_error = std::max(largest_j_error, found.largest_j_error);
      most_iterations = std::max(most_iterations, found.iterations);
    };
    return SoakCase{note, found.disagreement ? *found.disagreement + '\n' + input.describe() : ""};
  };
  const auto summary = [&] {
    return std::to_string(refused) + " refused for too few distinct values; J within " +
           base::formatNumber(largest_j_error) + " of its definition; at most " + std::to_string(most_iterations) +
           " iterations, " + std::to_string(unfinished) + " ran out of them";
  };
  return soak(options, "fcm_soak --starts " + std::to_string(starts), run, summary);
}

}  // namespace
}  // namespace tactus::stress

int main(int argc, char** argv) {
  tactus::stress::SoakOptions options{.count = 1000000};
  int starts = 2;
  CLI::App app{"Random small inputs under the clustering, against a textbook iteration in long double and a grid"};
  addSoakOptions(app, options);
  app.add_option("--starts", starts, "other starts for each input")->check(CLI::Range(0, 1000));
  CLI11_PARSE(app, argc, argv);
  return tactus::stress::soakInputs(options, starts) ? 0 : 1;
}
