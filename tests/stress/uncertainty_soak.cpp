// How often the 95 % band "others" of studies with 12 invented nurses holds the force of their population.
#include <CLI/CLI.hpp>
#include <array>
#include <iostream>
#include <string>
#include <vector>

#include "core/base/text.h"
#include "elicitation/uncertainty/force_bands.h"

#include "tests/stress/band_population.h"
#include "tests/stress/soak_runner.h"

namespace tactus::stress {
namespace {

using elicitation::ForceTermsFrom;

constexpr int kPeople = 12;
constexpr std::size_t kReplicates = 300;
constexpr double kLeast = 0.92;
constexpr double kMost = 0.97;
constexpr std::array<ForceTermsFrom, 2> kWays = {ForceTermsFrom::kVote, ForceTermsFrom::kThresholds};

/// Which bands hold their truth, by way and point.
using Holds = std::array<std::vector<int>, kWays.size()>;

bool soakBands(const SoakOptions& options) {
  const auto points = bandPoints();
  std::array<std::vector<double>, kWays.size()> truth_n;
  for (std::size_t way = 0; way < kWays.size(); ++way) truth_n[way] = populationForces(kWays[way]);
  Holds held;
  for (auto& one : held) one.assign(points.size(), 0);
  int studies = 0;

  const auto run = [&](std::uint64_t number) {
    Holds holds;
    for (std::size_t way = 0; way < kWays.size(); ++way) {
      auto random = caseRandom(options, number);  // the same nurses both ways
      const auto one = inventedStudy(kPeople, kWays[way], random);
      auto bands = elicitation::ForceBands::of(
          one.study, one.built, one.settings,
          {.points = points, .seed = number + 1, .replicates = kReplicates, .again = false, .split = false});
      if (!bands) return SoakCase{[] {}, bands.error().message()};
      while (bands->add(kReplicates)) {
      }
      const auto band = bands->band(elicitation::BandKind::kOthers);
      for (std::size_t p = 0; p < points.size(); ++p) {
        holds[way].push_back(band.points[p].low_n <= truth_n[way][p] && truth_n[way][p] <= band.points[p].high_n ? 1
                                                                                                                 : 0);
      }
    }
    return SoakCase{[&held, &studies, holds] {
                      ++studies;
                      for (std::size_t way = 0; way < kWays.size(); ++way) {
                        for (std::size_t p = 0; p < holds[way].size(); ++p) held[way][p] += holds[way][p];
                      }
                    },
                    {}};
  };
  const auto share = [&](std::size_t way) {
    int sum = 0;
    for (const int one : held[way]) sum += one;
    return static_cast<double>(sum) / static_cast<double>(std::max(1, studies)) / static_cast<double>(points.size());
  };
  const auto summary = [&] {
    std::string text = std::to_string(studies) + " studies of " + std::to_string(kPeople);
    for (std::size_t way = 0; way < kWays.size(); ++way) {
      text += "; " + std::string(name(kWays[way])) + " " + base::formatFixed(100 * share(way), 1) + " % (";
      for (std::size_t p = 0; p < points.size(); ++p) {
        text += (p > 0 ? " " : "") + base::formatFixed(100.0 * held[way][p] / std::max(1, studies), 1);
      }
      text += ")";
    }
    return text;
  };
  if (!soak(options, "uncertainty_soak", run, summary)) return false;
  bool all_right = true;
  for (std::size_t way = 0; way < kWays.size(); ++way)
    all_right = all_right && share(way) >= kLeast && share(way) <= kMost;
  if (!all_right) std::cout << "wanted a coverage of 92 to 97 % over the points, each way\n";
  return all_right;
}

}  // namespace
}  // namespace tactus::stress

int main(int argc, char** argv) {
  tactus::stress::SoakOptions options{.count = 500};
  CLI::App app{"Coverage of the bands around the averaged force"};
  addSoakOptions(app, options);
  CLI11_PARSE(app, argc, argv);
  return tactus::stress::soakBands(options) ? 0 : 1;
}
