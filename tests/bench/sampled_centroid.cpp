// A sampled centroid, done as well as one can: what the exact one has to beat.
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/check.h"

#include "tests/bench/contenders.h"

namespace tactus::bench {
namespace {

constexpr std::size_t kLanes = 8;  ///< partial sums that a vector unit can keep apart

/// The output terms of one expert at equally spaced samples.
class SampledSet {
 public:
  SampledSet(const fuzzy::CompiledModel& model, std::size_t samples)
      : clip_(model.implication() == fuzzy::Implication::kClip), places_(padded(samples)), heights_(padded(samples)) {
    const double cell = (model.outputMax() - model.outputMin()) / static_cast<double>(samples);
    for (std::size_t s = 0; s < samples; ++s) places_[s] = model.outputMin() + cell * (static_cast<double>(s) + 0.5);
    for (const auto& term : model.outputTerms(0)) {
      std::vector<double> memberships(places_.size());
      for (std::size_t s = 0; s < samples; ++s) memberships[s] = term(places_[s]);
      memberships_.push_back(std::move(memberships));
    }
  }

  std::size_t termCount() const { return memberships_.size(); }

  double centroid(std::span<const double> strengths) {
    std::fill(heights_.begin(), heights_.end(), 0.0);
    for (std::size_t t = 0; t < strengths.size(); ++t) {
      if (strengths[t] > 0) raise(memberships_[t].data(), strengths[t], clip_, heights_.data(), heights_.size());
    }
    return ratio(places_.data(), heights_.data(), heights_.size());
  }

 private:
  /// The padding has height 0 and counts for nothing.
  static std::size_t padded(std::size_t samples) { return (samples + kLanes - 1) / kLanes * kLanes; }

  __attribute__((target_clones("avx512f", "avx2", "default"))) static void raise(const double* membership,
                                                                                 double strength, bool clip,
                                                                                 double* height, std::size_t count) {
    if (clip) {
      for (std::size_t s = 0; s < count; ++s) {
        const double clipped = membership[s] < strength ? membership[s] : strength;
        height[s] = height[s] < clipped ? clipped : height[s];
      }
    } else {
      for (std::size_t s = 0; s < count; ++s) {
        const double scaled = membership[s] * strength;
        height[s] = height[s] < scaled ? scaled : height[s];
      }
    }
  }

  __attribute__((target_clones("avx512f", "avx2", "default"))) static double ratio(const double* place,
                                                                                   const double* height,
                                                                                   std::size_t count) {
    std::array<double, kLanes> area{};
    std::array<double, kLanes> moment{};
    for (std::size_t s = 0; s < count; s += kLanes) {
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        area[lane] += height[s + lane];
        moment[lane] += height[s + lane] * place[s + lane];
      }
    }
    double total_area = 0;
    double total_moment = 0;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      total_area += area[lane];
      total_moment += moment[lane];
    }
    return total_moment / total_area;
  }

  bool clip_;
  std::vector<double> places_;
  std::vector<double> heights_;
  std::vector<std::vector<double>> memberships_;
};

}  // namespace

Contender sampledCentroid(const Case& about, int samples) {
  TACTUS_CHECK(about.compiled.expertCount() == 1);
  auto run = [&about, set = SampledSet(about.compiled, static_cast<std::size_t>(samples))](
                 std::size_t first, std::span<double> out) mutable {
    std::array<double, fuzzy::kMostTerms> room;
    const std::span<double> strengths(room.data(), set.termCount());
    for (std::size_t i = 0; i < out.size(); ++i) {
      about.compiled.strengths(0, about.points.row(first + i), strengths);
      out[i] = set.centroid(strengths);
    }
  };
  return {"sampled centroid",
          samples,
          &about,
          {about.name + ": sampled centroid, " + std::to_string(samples) + " samples", about.points.count(), run}};
}

}  // namespace tactus::bench
