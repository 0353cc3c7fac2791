// Run time against error of the clustering: ours, the textbook, R's e1071 and Octave, all in one run on the same
// simulated strokes. Prints tables and writes them to fcm.txt and fcm.csv.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <functional>
#include <iostream>

#include "core/base/check.h"
#include "core/base/files/file.h"
#include "core/base/text.h"
#include "elicitation/clustering/fcm.h"
#include "elicitation/clustering/fcm_data.h"
#include "elicitation/clustering/fcm_pass.h"
#include "elicitation/clustering/fcm_starts.h"

#include "tests/bench/fcm_peers.h"
#include "tests/bench/fcm_results.h"
#include "tests/bench/fcm_strokes.h"
#include "tests/bench/fcm_textbook.h"
#include "tests/bench/machine.h"

namespace tactus::bench {
namespace {

using elicitation::FcmSettings;
using Samples = std::vector<double>;

struct Options {
  std::string out;
  int rounds = 300;
  bool peers = true;
  bool growth = true;
};

struct Contender {
  std::string method;
  int rounds;
  std::function<std::vector<double>(const Samples&)> run;
};

std::vector<double> ours(const Samples& samples, const FcmSettings& settings) {
  const auto result = elicitation::fuzzyCMeans(samples, settings);
  TACTUS_CHECK(result.has_value());
  return result->centres;
}

/// The passes alone: from equal widths over all samples, no stand-in.
std::vector<double> oursOnAllSamples(const Samples& samples) {
  const auto data = elicitation::prepareFcmData(samples, {});
  TACTUS_CHECK(data.has_value());
  std::vector<double> centres(3);
  for (std::size_t k = 0; k < 3; ++k) centres[k] = data->low + data->range() * (static_cast<double>(k) + 0.5) / 3;
  centres = elicitation::descend(*data, centres, elicitation::FcmBeginning::kAnywhere, {}, {}).centres;
  for (double& centre : centres) centre = data->toOriginal(centre);
  return centres;
}

/// One read of the data: eight sums side by side, so that memory and not addition takes the time.
std::vector<double> read(const Samples& samples) {
  double sums[8] = {};
  for (std::size_t i = 0; i + 8 <= samples.size(); i += 8) {
    for (std::size_t j = 0; j < 8; ++j) sums[j] += samples[i + j];
  }
  double sum = 0;
  for (const double part : sums) sum += part;
  return {sum};
}

struct Timed {
  std::vector<double> times_ms;
  std::vector<double> centres;

  double median() {
    std::sort(times_ms.begin(), times_ms.end());
    return times_ms[times_ms.size() / 2];
  }
  double least() const { return *std::min_element(times_ms.begin(), times_ms.end()); }
};

/// Each contender once a round, as long as it has rounds left, so that all see the same machine.
std::vector<Timed> timeInRounds(const std::vector<Contender>& contenders, const Samples& samples) {
  std::vector<Timed> out(contenders.size());
  int rounds = 0;
  for (const auto& contender : contenders) rounds = std::max(rounds, contender.rounds);
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < contenders.size(); ++i) {
      if (round >= contenders[i].rounds) continue;
      const auto start = std::chrono::steady_clock::now();
      out[i].centres = contenders[i].run(samples);
      const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
      out[i].times_ms.push_back(taken.count());
    }
  }
  return out;
}

void addPeer(FcmResults& results, const std::string& method, std::size_t samples, const base::Result<FcmPeerRun>& run,
             const std::vector<long double>& reference) {
  if (!run) {
    results.circumstances.push_back(method + ": not measured: " + run.error().message());
    return;
  }
  FcmRow row{"comparison", samples, 3, 2, method, run->median_ms, run->min_ms, {}, {}, {}};
  row.error = largestError(run->centres, reference);
  results.rows.push_back(row);
}

/// Reads and the ratio to e1071 for the rows from `first` on, which are of the same data.
void relate(std::vector<FcmRow>& rows, std::size_t first) {
  std::optional<double> read_ms, e1071_ms;
  for (std::size_t i = first; i < rows.size(); ++i) {
    if (rows[i].method == "one read") read_ms = rows[i].median_ms;
    if (rows[i].method == "e1071, reltol 1e-15") e1071_ms = rows[i].median_ms;
  }
  for (std::size_t i = first; i < rows.size(); ++i) {
    if (read_ms) rows[i].reads = rows[i].median_ms / *read_ms;
    if (e1071_ms && rows[i].error) rows[i].ratio = *e1071_ms / rows[i].median_ms;
  }
}

void compare(const Options& options, std::size_t count, FcmResults& results) {
  const Samples samples = simulatedStrokes(count);
  const auto reference = referenceCentres(samples, 3, 2);
  const bool many = count > 1000000;
  const int rounds =
      std::max(5, static_cast<int>(static_cast<double>(options.rounds) * 24000 / static_cast<double>(count)));
  const std::vector<Contender> contenders = {
      {"one read", std::max(rounds, 20), read},
      {"ours", rounds, [](const Samples& x) { return ours(x, {}); }},
      {"ours, one start", rounds, [](const Samples& x) { return ours(x, {.starts = 1}); }},
      {"ours, all samples from the start", rounds, oursOnAllSamples},
      {"textbook, stored matrix, pow", many ? 1 : 3, [](const Samples& x) { return textbookFcm(x, 3, 2); }}};
  auto timed = timeInRounds(contenders, samples);
  const std::size_t first = results.rows.size();
  for (std::size_t i = 0; i < contenders.size(); ++i) {
    FcmRow row{"comparison", count, 3, 2, contenders[i].method, timed[i].median(), timed[i].least(), {}, {}, {}};
    if (contenders[i].method != "one read") row.error = largestError(timed[i].centres, reference);
    results.rows.push_back(row);
  }
  if (options.peers) {
    addPeer(results, "e1071, default", count, runE1071(samples, 3, "list()", many ? 1 : 5), reference);
    addPeer(results, "e1071, reltol 1e-15", count, runE1071(samples, 3, "list(reltol = 1e-15)", many ? 1 : 5),
            reference);
    if (count <= 24000) addPeer(results, "Octave fcm, default", count, runOctaveFcm(samples, 3, 1), reference);
  }
  relate(results.rows, first);
}

void addGrowth(FcmResults& results, const std::string& part, const Samples& samples, const FcmSettings& settings) {
  const int rounds = samples.size() > 1000000 ? 5 : 15;
  auto timed = timeInRounds(
      {{"one read", 20, read}, {"ours", rounds, [&](const Samples& x) { return ours(x, settings); }}}, samples);
  const double median_ms = timed[1].median();
  results.rows.push_back({part,
                          samples.size(),
                          settings.clusters,
                          settings.m,
                          "ours",
                          median_ms,
                          timed[1].least(),
                          {},
                          median_ms / timed[0].median(),
                          {}});
}

void measureGrowth(FcmResults& results) {
  for (const std::size_t count : {240U, 2400U, 24000U, 240000U, 2400000U}) {
    addGrowth(results, "samples", simulatedStrokes(count), {});
  }
  Samples samples = simulatedStrokes(240000);
  for (const std::size_t clusters : {2U, 3U, 4U, 6U, 8U, 12U, 16U}) {
    addGrowth(results, "clusters", samples, {.clusters = clusters});
  }
  for (const double m : {1.05, 1.5, 2.0, 2.5, 3.0, 4.0, 6.0}) addGrowth(results, "fuzziness", samples, {.m = m});
  for (double& x : samples) x = std::round(x);
  addGrowth(results, "whole mm/s", samples, {});
  addGrowth(results, "whole mm/s", samples, {.m = 1.5});
}

int run(const Options& options) {
  FcmResults results;
  results.circumstances = machineLines();
  results.circumstances.back() +=
      "; loops of the clustering: " + std::string(elicitation::supportedFcmKernels().back().name);
  results.circumstances.push_back(
      "Data: simulated strokes (no person made them), twelve at three levels with the means of the paper's Table 1, "
      "S1");
  results.circumstances.push_back("Error: largest distance of a centre from the textbook iteration in long double");
  const std::string e1071 = options.peers ? e1071Version() : "";
  results.circumstances.push_back("e1071: " + (e1071.empty() ? "not installed or left out" : e1071) +
                                  "; peers run after ours and report their processor time, data loaded before");
  for (const std::size_t count : {24000U, 240000U, 2400000U}) compare(options, count, results);
  if (options.growth) measureGrowth(results);
  const std::string tables = fcmTables(results);
  std::cout << tables;

  if (options.out.empty()) return 0;
  if (auto made = base::makeFolder(options.out); !made) {
    std::cerr << made.error().message() << '\n';
    return 1;
  }
  for (const auto& [file, text] : {std::pair{"/fcm.txt", tables}, std::pair{"/fcm.csv", fcmCsv(results)}}) {
    if (auto written = base::writeFileAtomically(options.out + file, text); !written) {
      std::cerr << written.error().message() << '\n';
      return 1;
    }
  }
  std::cout << "\nWritten: " << options.out << "/fcm.txt, fcm.csv\n";
  return 0;
}

}  // namespace
}  // namespace tactus::bench

int main(int argc, char** argv) {
  tactus::bench::Options options;
  CLI::App app{"Run time against error of the clustering, ours and others'"};
  app.add_option("--out", options.out, "folder for fcm.txt and fcm.csv; without it nothing is written");
  app.add_option("--rounds", options.rounds, "turns of ours at 24,000 samples, fewer for more samples")
      ->check(CLI::Range(1, 100000));
  app.add_flag("!--no-peers", options.peers, "leave out R and Octave");
  app.add_flag("!--no-growth", options.growth, "leave out how the cost grows");
  CLI11_PARSE(app, argc, argv);
  return tactus::bench::run(options);
}
