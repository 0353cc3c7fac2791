// What a force of the C source costs beside libtactus, one point and a batch, in one run: c_source_bench MODEL...
// Each line of a table is the source under one compiler. 80,000 random points in chunks of 2,000; each chunk's time is
// the least of 40 rounds, and all other chunks come between two rounds, so that no branch predictor has learned the
// points.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>
#include <tactus/tactus.hpp>
#include <vector>

#include "core/base/check.h"
#include "core/base/random.h"
#include "core/exchange/c_source.h"
#include "core/model_io/model_file.h"

#include "tests/bench/loaded_source.h"

namespace tactus::bench {
namespace {

constexpr std::size_t kChunk = 2000;
constexpr std::size_t kChunks = 40;
constexpr std::size_t kPoints = kChunk * kChunks;
constexpr int kRounds = 40;
constexpr const char* kCompilers[] = {"gcc -O2", "gcc -O3 -march=x86-64-v3", "gcc -O3 -march=native", "clang -O2",
                                      "clang -O2 -march=native"};

/// Forces of `count` points from `first` on.
using Work = std::function<void(std::size_t first, double* force_n)>;

struct Contender {
  std::string name;
  std::array<Work, 2> work;  ///< one point after the other; a batch
  std::array<std::vector<double>, 2> force_n;
  std::array<std::vector<double>, 2> best_ns;  ///< of each chunk
};

double nowNs() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e9 + static_cast<double>(now.tv_nsec);
}

/// The source under `compiler`, unless that is missing.
bool addSource(const exchange::CSource& source, const std::string& compiler, const std::vector<double>& points,
               std::size_t inputs, std::vector<Contender>& contenders) {
  const auto loaded = loadSource(source, compiler);
  if (!loaded) return false;
  const auto force = [force = loaded->force, &points, inputs](std::size_t first, double* out) {
    int fired = 0;
    for (std::size_t p = 0; p < kChunk; ++p) out[p] = force(points.data() + (first + p) * inputs, &fired);
  };
  const auto batch = [batch = loaded->batch, &points, inputs, fired = std::vector<unsigned char>(kChunk)](
                         std::size_t first, double* out) mutable {
    batch(points.data() + first * inputs, kChunk, out, fired.data());
  };
  contenders.push_back({compiler, {force, batch}, {}, {}});
  return true;
}

void measure(std::vector<Contender>& contenders) {
  for (Contender& one : contenders) {
    one.force_n.fill(std::vector<double>(kPoints));
    one.best_ns.fill(std::vector<double>(kChunks, 1e30));
  }
  for (int round = 0; round < kRounds; ++round) {
    for (Contender& one : contenders) {
      for (std::size_t kind = 0; kind < 2; ++kind) {
        for (std::size_t chunk = 0; chunk < kChunks; ++chunk) {
          const double start = nowNs();
          one.work[kind](chunk * kChunk, one.force_n[kind].data() + chunk * kChunk);
          one.best_ns[kind][chunk] = std::min(one.best_ns[kind][chunk], nowNs() - start);
        }
      }
    }
  }
}

void print(const std::vector<Contender>& contenders) {
  const auto ns = [](const Contender& one, std::size_t kind) {
    double sum = 0;
    for (const double best : one.best_ns[kind]) sum += best;
    return sum / kPoints;
  };
  const Contender& ours = contenders.front();
  for (const Contender& one : contenders) {
    std::printf("%-26s", one.name.c_str());
    for (std::size_t kind = 0; kind < 2; ++kind) {
      double error_n = 0;
      for (std::size_t p = 0; p < kPoints; ++p)
        error_n = std::max(error_n, std::abs(one.force_n[kind][p] - ours.force_n[0][p]));
      std::printf("  %s %6.1f ns (%.2f) difference %.1e N", kind == 0 ? "point" : "batch", ns(one, kind),
                  ns(one, kind) / ns(ours, kind), error_n);
    }
    std::printf("\n");
  }
}

void compare(const std::string& path) {
  const auto read = model_io::readModel(path);
  if (!read) {
    std::fprintf(stderr, "%s\n", read.error().message().c_str());
    std::exit(1);
  }
  const auto source = exchange::cSource(read->model);
  TACTUS_CHECK(source.has_value());
  const auto model = Model::open(path);
  const std::size_t inputs = model.inputs();
  std::vector<double> points;
  base::Random random(7);
  for (std::size_t i = 0; i < kPoints * inputs; ++i) {
    const double low = model.inputMin(i % inputs);
    points.push_back(low + random.uniform() * (model.inputMax(i % inputs) - low));
  }
  std::vector<Contender> contenders;
  contenders.push_back({"libtactus",
                        {[&](std::size_t first, double* out) {
                           for (std::size_t p = 0; p < kChunk; ++p)
                             out[p] = tactus_force(model.get(), points.data() + (first + p) * inputs, nullptr);
                         },
                         [&, fired = std::vector<unsigned char>(kChunk)](std::size_t first, double* out) mutable {
                           model.batch(points.data() + first * inputs, kChunk, out, fired.data());
                         }},
                        {},
                        {}});
  for (const char* const compiler : kCompilers) {
    if (!addSource(*source, compiler, points, inputs, contenders)) std::printf("%s: not measured\n", compiler);
  }
  measure(contenders);
  std::printf("%s\n", model.name().c_str());
  print(contenders);
}

}  // namespace
}  // namespace tactus::bench

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: c_source_bench MODEL...\n");
    return 2;
  }
  for (int i = 1; i < argc; ++i) tactus::bench::compare(argv[i]);
}
