// The long run of the stroke segmentation against ground truth: segmentation_soak [streams] [first seed].
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "core/base/text.h"
#include "experiments/stroke_segmentation.h"

#include "tests/experiments/simulated_stream.h"

namespace tactus::experiments {
namespace {

struct Tally {
  std::size_t streams = 0;
  std::size_t strokes = 0;
  std::size_t wrong_streams = 0;
  std::size_t not_accepted = 0;
  std::vector<double> errors_ms;
};

void run(const SimulatedStream& stream, std::uint64_t seed, Tally& tally) {
  const auto found = *findStrokes(stream.samples);
  ++tally.streams;
  tally.strokes += stream.strokes.size();
  if (found.size() != stream.strokes.size()) {
    std::printf("seed %llu: %zu strokes, %zu found\n", static_cast<unsigned long long>(seed), stream.strokes.size(),
                found.size());
    ++tally.wrong_streams;
    return;
  }
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (found[i].verdict != StrokeVerdict::kAccepted) ++tally.not_accepted;
    tally.errors_ms.push_back(1000 * std::abs(found[i].start_s - stream.strokes[i].start_s));
    tally.errors_ms.push_back(1000 * std::abs(found[i].end_s - stream.strokes[i].end_s));
  }
}

/// Prints the tally; whether it is good: at most one edge in a thousand beyond 10 ms, none beyond 50 ms. The rare ones
/// are ends of strokes that turn into a fast return without any rest, where tremor looks like the last of the stroke.
bool report(const char* name, Tally& tally) {
  auto& errors = tally.errors_ms;
  std::sort(errors.begin(), errors.end());
  const auto at = [&](double share) {
    return errors.empty() ? 0 : errors[static_cast<std::size_t>(share * static_cast<double>(errors.size() - 1))];
  };
  const auto beyond = static_cast<std::size_t>(
      std::count_if(errors.begin(), errors.end(), [](double error_ms) { return error_ms > 10; }));
  std::printf("%s: %zu streams, %zu strokes; streams with a missing or invented stroke %zu, not accepted %zu;\n", name,
              tally.streams, tally.strokes, tally.wrong_streams, tally.not_accepted);
  std::printf("  edges: median %.2f ms, 99 %% %.2f, 99.9 %% %.2f, largest %.2f; beyond 10 ms: %zu of %zu\n", at(0.5),
              at(0.99), at(0.999), at(1), beyond, errors.size());
  return tally.wrong_streams == 0 && tally.not_accepted == 0 && 1000 * beyond <= errors.size() && at(1) <= 50;
}

int soak(std::uint64_t streams, std::uint64_t first) {
  StreamRecipe hard;
  hard.noise_mm = 0.05;
  hard.tremor_least_mm = 0.3;
  hard.uneven = true;
  StreamRecipe steady;
  steady.tremor_least_mm = steady.tremor_most_mm = 0;
  Tally usual_tally;
  Tally hard_tally;
  Tally steady_tally;
  for (std::uint64_t seed = first; seed < first + streams; ++seed) {
    run(simulatedStream(seed), seed, usual_tally);
    if (seed % 4 == 0) run(simulatedStream(seed, hard), seed, hard_tally);
    if (seed % 4 == 1) run(simulatedStream(seed, steady), seed, steady_tally);
  }
  const bool usual_good = report("tremor 0.1 to 0.3 mm, noise 0.02 mm", usual_tally);
  const bool hard_good = report("tremor 0.3 mm, noise 0.05 mm, uneven samples", hard_tally);
  const bool steady_good = report("no tremor", steady_tally);
  return usual_good && hard_good && steady_good ? 0 : 1;
}

}  // namespace
}  // namespace tactus::experiments

int main(int argc, char** argv) {
  const auto number = [&](int place, long long otherwise) {
    return argc > place ? tactus::base::parseInteger(argv[place]).value_or(otherwise) : otherwise;
  };
  return tactus::experiments::soak(static_cast<std::uint64_t>(number(1, 1000)),
                                   static_cast<std::uint64_t>(number(2, 1)));
}
