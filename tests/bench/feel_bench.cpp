// Run time against error of what the hand feels: ticks, scene economy, speeds from counts, the simulated hand, and
// edits. Prints tables and writes them to feel.txt and feel.csv.
#include <CLI/CLI.hpp>
#include <iostream>

#include "core/base/files/file.h"

#include "tests/bench/feel_edits.h"
#include "tests/bench/feel_results.h"
#include "tests/bench/feel_ticks.h"
#include "tests/bench/fuzzylite_peer.h"
#include "tests/bench/machine.h"

namespace tactus::bench {
namespace {

struct Options {
  std::string out;
  int rounds = 200;
  int live_edits = 400;
};

int run(const Options& options) {
  FeelResults results;
  results.circumstances = machineLines();
  results.circumstances.push_back("fuzzylite: " + fuzzyliteVersion());
  results.circumstances.push_back(
      "Model: S4's 45 rules with five depth terms, and synthetic variations of it as further experts; every motion is "
      "simulated");
  results.parts = {measureTicks(options.rounds), measureEdits(options.live_edits)};
  const std::string tables = feelTables(results);
  std::cout << tables;

  if (options.out.empty()) return 0;
  if (auto made = base::makeFolder(options.out); !made) {
    std::cerr << made.error().message() << '\n';
    return 1;
  }
  for (const auto& [file, text] : {std::pair{"/feel.txt", tables}, std::pair{"/feel.csv", feelCsv(results)}}) {
    if (auto written = base::writeFileAtomically(options.out + file, text); !written) {
      std::cerr << written.error().message() << '\n';
      return 1;
    }
  }
  std::cout << "\nWritten: " << options.out << "/feel.txt, feel.csv\n";
  return 0;
}

}  // namespace
}  // namespace tactus::bench

int main(int argc, char** argv) {
  tactus::bench::Options options;
  CLI::App app{"Run time against error of what the hand feels"};
  app.add_option("--out", options.out, "folder for feel.txt and feel.csv; without it nothing is written");
  app.add_option("--rounds", options.rounds, "turns of each contender")->check(CLI::Range(1, 100000));
  app.add_option("--live-edits", options.live_edits, "edits on a servo thread, a few milliseconds each; 0: none")
      ->check(CLI::Range(0, 1000000));
  CLI11_PARSE(app, argc, argv);
  return tactus::bench::run(options);
}
