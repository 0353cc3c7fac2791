// Run time against error: our evaluators, a sampled centroid, a look-up table, fuzzylite and Octave, all in one run on
// the same points of the same model. Prints tables, writes them to inference.txt, inference.csv and inference.svg.
#include <CLI/CLI.hpp>
#include <iostream>
#include <sstream>

#include "core/base/check.h"
#include "core/base/files/file.h"
#include "core/base/text.h"

#include "tests/bench/cases.h"
#include "tests/bench/chart.h"
#include "tests/bench/contenders.h"
#include "tests/bench/costs.h"
#include "tests/bench/fuzzylite_peer.h"
#include "tests/bench/machine.h"
#include "tests/bench/octave_peer.h"
#include "tests/bench/results.h"

namespace tactus::bench {
namespace {

constexpr std::size_t kOctavePoints = 100;
constexpr int kOctaveSamples = 101;  ///< its default

struct Options {
  std::string out;
  int rounds = 300;
  std::size_t exact_points = 500;
  bool costs = true;
};

/// The cases; contenders point into them.
struct Cases {
  explicit Cases(std::size_t exact_points)
      : clip(makeCase("one expert, clip", oneExpert(fuzzy::Implication::kClip), nothingFixed(), exact_points)),
        scale(makeCase("one expert, scale", oneExpert(fuzzy::Implication::kScale), nothingFixed(), exact_points)),
        four(makeCase("four experts, clip", syntheticExperts(4), nothingFixed(), exact_points)),
        scene(makeCase("one expert, clip, scene", oneExpert(fuzzy::Implication::kClip), sceneOfNgt(), exact_points)),
        scene_scale(
            makeCase("one expert, scale, scene", oneExpert(fuzzy::Implication::kScale), sceneOfNgt(), exact_points)),
        scene_four(makeCase("four experts, clip, scene", syntheticExperts(4), sceneOfNgt(), exact_points)) {}

  static std::vector<std::optional<double>> nothingFixed() { return std::vector<std::optional<double>>(4); }

  Case clip, scale, four, scene, scene_scale, scene_four;
};

std::vector<Contender> contendersOf(const Cases& cases) {
  std::vector<Contender> out;
  for (const auto& [all, scene] : {std::pair{&cases.clip, &cases.scene}, std::pair{&cases.four, &cases.scene_four},
                                   std::pair{&cases.scale, &cases.scene_scale}}) {
    out.push_back(onePoint(*all));
    out.push_back(batch(*all));
    out.push_back(sceneOnePoint(*scene));
    out.push_back(sceneBatch(*scene));
    for (const Case* about : {all, scene}) {
      for (Contender& contender : cSource(*about)) out.push_back(std::move(contender));
    }
  }
  // AVX-512 has the same kernel for one point as AVX2.
  for (const fuzzy::Kernels& kernels : fuzzy::supportedKernels()) {
    if (kernels.name == "avx512") continue;
    for (const Case* about : {&cases.clip, &cases.four}) out.push_back(onePoint(*about, kernels));
  }
  for (const int samples : {50, 100, 200, 500, 1000, 10000}) out.push_back(sampledCentroid(cases.clip, samples));
  for (const int samples : {100, 1000}) out.push_back(sampledCentroid(cases.scale, samples));
  for (const int size : {16, 32, 64, 128, 256, 512, 1024}) out.push_back(lookUpTable(cases.scene, size));
  const auto add_peer = [&out](const Case& about, int resolution) {
    if (auto peer = fuzzylite(about, resolution)) out.push_back(std::move(*peer));
  };
  for (const int resolution : {50, 100, 200, 1000}) add_peer(cases.clip, resolution);
  add_peer(cases.scene, 100);
  add_peer(cases.scale, 100);
  return out;
}

std::vector<double> allForces(const Contender& contender) {
  std::vector<double> forces_n(contender.job.count);
  contender.job.run(0, forces_n);
  return forces_n;
}

void addOctave(const Case& about, Results& results) {
  const auto run = runOctave(about, kOctavePoints, kOctaveSamples);
  if (!run) {
    results.circumstances.push_back("Octave: not measured: " + run.error().message());
    return;
  }
  results.circumstances.push_back("Octave: fuzzy logic toolkit, " + std::to_string(kOctavePoints) +
                                  " points in one call, timed by itself after the others");
  results.contenders.push_back({about.name,
                                "Octave",
                                kOctaveSamples,
                                {run->evaluation_ns, run->evaluation_ns},
                                errorAgainstExact(about, run->forces_n),
                                differenceFromOnePoint(about, run->forces_n)});
}

void compare(const Options& options, Results& results) {
  const Cases cases(options.exact_points);
  const std::vector<Contender> contenders = contendersOf(cases);
  std::vector<Job> jobs;
  for (const auto& contender : contenders) jobs.push_back(contender.job);
  const auto timed = timeInterleaved(jobs, {.rounds = options.rounds});
  for (std::size_t i = 0; i < contenders.size(); ++i) {
    const Contender& contender = contenders[i];
    const auto forces_n = allForces(contender);
    results.contenders.push_back({contender.about->name, contender.family, contender.setting, timed.timings[i],
                                  errorAgainstExact(*contender.about, forces_n),
                                  differenceFromOnePoint(*contender.about, forces_n)});
    if (contender.about == &cases.clip && contender.family == "fuzzylite" && contender.setting == 100) {
      results.unit_ns = timed.timings[i].median_ns;
    }
  }
  addOctave(cases.clip, results);
  results.circumstances.push_back("Sum of all forces computed: " + base::formatNumber(timed.checksum));
}

void measureCosts(const Options& options, Results& results) {
  const std::vector<CostJob> costs = costJobs();
  std::vector<Job> jobs;
  for (const auto& cost : costs) jobs.push_back(cost.job);
  const Case clip = makeCase("one expert, clip", oneExpert(fuzzy::Implication::kClip), Cases::nothingFixed(), 0);
  if (const auto unit = fuzzylite(clip, 100)) jobs.push_back(unit->job);
  const auto timed = timeInterleaved(jobs, {.rounds = std::max(5, options.rounds / 5)});
  for (std::size_t i = 0; i < costs.size(); ++i) {
    results.costs.push_back({costs[i].part, costs[i].value, costs[i].what, timed.timings[i]});
  }
  if (jobs.size() > costs.size()) results.cost_unit_ns = timed.timings.back().median_ns;
}

int run(const Options& options) {
  Results results;
  results.circumstances = machineLines();
  results.circumstances.push_back(
      "Model: S4's 45 rules with five depth terms (fires everywhere); 10,000 shuffled points; errors against exact "
      "rationals at " +
      std::to_string(options.exact_points) + " of them");
  results.circumstances.push_back("Scenes and tables: lubrication " + base::formatNumber(kFixedLubrication) +
                                  ", neck flexion " + base::formatNumber(kFixedNeckFlexionDeg) +
                                  " deg; four experts: S4 and three synthetic variations");
  results.circumstances.push_back("fuzzylite: " + fuzzyliteVersion());
  compare(options, results);
  if (options.costs) measureCosts(options, results);
  std::ostringstream tables;
  printTables(results, tables);
  std::cout << tables.str();

  if (options.out.empty()) return 0;
  if (auto made = base::makeFolder(options.out); !made) {
    std::cerr << made.error().message() << '\n';
    return 1;
  }
  for (const auto& [file, text] :
       {std::pair{"/inference.txt", tables.str()}, std::pair{"/inference.csv", csvText(results)},
        std::pair{"/inference.svg", chartSvg(results)}}) {
    if (auto written = base::writeFileAtomically(options.out + file, text); !written) {
      std::cerr << written.error().message() << '\n';
      return 1;
    }
  }
  std::cout << "\nWritten: " << options.out << "/inference.txt, inference.csv, inference.svg\n";
  return 0;
}

}  // namespace
}  // namespace tactus::bench

int main(int argc, char** argv) {
  tactus::bench::Options options;
  CLI::App app{"Run time against error of the inference, ours and others'"};
  app.add_option("--out", options.out,
                 "folder for inference.txt, inference.csv and inference.svg; without it nothing is written");
  app.add_option("--rounds", options.rounds, "turns of each contender")->check(CLI::Range(1, 100000));
  app.add_option("--exact-points", options.exact_points, "points compared with exact rationals")
      ->check(CLI::Range(1, 10000));
  app.add_flag("!--no-costs", options.costs, "leave out larger models, set-up and tasks");
  CLI11_PARSE(app, argc, argv);
  return tactus::bench::run(options);
}
