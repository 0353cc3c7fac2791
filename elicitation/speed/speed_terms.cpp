#include "elicitation/speed/speed_terms.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "core/base/check.h"
#include "core/base/statistics.h"
#include "core/base/text.h"

namespace tactus::elicitation {
namespace {

constexpr double kLastStep = 1e-8;  // of y: Newton's error is quadratic, so what remains is below rounding
constexpr int kMostSteps = 200;     // bisection of the range of y needs fewer
constexpr double kLowestY = -740;   // e^y is then the smallest double: the point lies on the center

/// Membership in the other clusters by that in `cluster`, 1/u - 1, and its slope.
struct Odds {
  double value = 0;
  double slope = 0;
};

Odds oddsAt(double x, std::span<const double> centres, std::size_t cluster, double exponent) {
  const double own = x - centres[cluster];
  if (own == 0) return {};
  Odds out;
  for (std::size_t k = 0; k < centres.size(); ++k) {
    if (k == cluster) continue;
    const double other = x - centres[k];
    const double ratio = std::abs(own / other);  // infinite on another center, whose membership is 1
    const double odds = exponent == 2 ? ratio * ratio : std::pow(ratio, exponent);
    out.value += odds;
    out.slope += odds * exponent * (1 / own - 1 / other);
  }
  return out;
}

}  // namespace

// With y = ln of the distances to the two centers by each other, ln(1/u - 1) is exponent * y if there is no third
// center, and nearly so otherwise: Newton's steps in y, inside a bracket.
double membershipEdge(std::span<const double> centres, std::size_t cluster, std::size_t neighbor, double m,
                      double alpha) {
  const double centre = centres[cluster];
  const double gap = centres[neighbor] - centre;  // negative if the neighbor lies below
  const double exponent = 2 / (m - 1);
  const double wanted = 1 / alpha - 1;
  const auto pointAt = [&](double y) {
    const double ratio = std::exp(y);
    return centre + gap * (ratio / (1 + ratio));
  };

  // With the neighbor alone the membership is alpha at `high`. At `low` every other cluster has at most its share.
  double high = std::log(wanted) / exponent;
  double low = high;
  if (centres.size() > 2) {
    const double share = std::exp((std::log(wanted) - std::log(static_cast<double>(centres.size() - 1))) / exponent);
    double nearest = std::abs(gap) / (1 + share);
    const bool has_behind = gap > 0 ? cluster > 0 : cluster + 1 < centres.size();
    if (has_behind) nearest = std::min(nearest, std::abs(centre - centres[gap > 0 ? cluster - 1 : cluster + 1]));
    const double own = share * nearest;
    low = std::log(own / (std::abs(gap) - own));
  }
  low = std::max(low, kLowestY);
  high = std::max(high, low);

  double y = high;
  for (int step = 0; step < kMostSteps && low < high; ++step) {
    const double x = pointAt(y);
    const Odds odds = oddsAt(x, centres, cluster, exponent);
    (odds.value > wanted ? high : low) = y;
    // d x / d y = (x - v)(v' - x)/(v' - v).
    const double slope = odds.slope / odds.value * (x - centre) * (centres[neighbor] - x) / gap;
    const double newton = y + std::log(wanted / odds.value) / slope;
    const bool inside = newton >= low && newton <= high;
    const double next = inside ? newton : low + (high - low) / 2;
    const bool last = next == y || (inside && std::abs(next - y) <= kLastStep);
    y = next;
    if (last) break;
  }

  // Rounding may have left the point on the wrong side.
  double x = pointAt(y);
  const double unit = std::numeric_limits<double>::epsilon() * std::max(std::abs(x), std::abs(centre));
  for (double back = unit; x != centre && 1 / (1 + oddsAt(x, centres, cluster, exponent).value) < alpha; back *= 2) {
    x = gap > 0 ? std::max(centre, x - back) : std::min(centre, x + back);
  }
  return x;
}

namespace {

double average(const std::vector<double>& values, std::span<const double> weights, Averaging averaging) {
  if (averaging == Averaging::kMedian) return base::median(values);
  if (averaging == Averaging::kMean) return base::mean(values);
  // Weights of at most 2 add up without overflow; a power of two costs no digit.
  const int largest = std::ilogb(*std::max_element(weights.begin(), weights.end()));
  double sum = 0;
  double total = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double weight = std::scalbn(weights[i], -largest);
    sum += weight * values[i];
    total += weight;
  }
  return sum / total;
}

}  // namespace

base::Result<std::vector<Ramp>> alphaCutRamps(std::span<const double> centres, double m, double alpha) {
  if (!(alpha > 0.5 && alpha <= 1)) {
    return base::fail(base::ErrorCode::kValue, "alpha", base::formatNumber(alpha), "a number above 0.5 and at most 1");
  }
  std::vector<Ramp> ramps;
  for (std::size_t k = 0; k + 1 < centres.size(); ++k) {
    TACTUS_CHECK(centres[k] < centres[k + 1]);
    if (alpha == 1) {
      ramps.push_back({centres[k], centres[k + 1]});
    } else {
      ramps.push_back({membershipEdge(centres, k, k + 1, m, alpha), membershipEdge(centres, k + 1, k, m, alpha)});
    }
  }
  return ramps;
}

std::string_view name(SpeedCentres centres) noexcept {
  return centres == SpeedCentres::kLevelMeans ? "level_means" : "clusters";
}

std::string_view name(Averaging averaging) noexcept {
  switch (averaging) {
    case Averaging::kMean: return "mean";
    case Averaging::kWeightedMean: return "weighted_mean";
    case Averaging::kMedian: return "median";
  }
  return "";
}

std::vector<Ramp> averageRamps(std::span<const std::vector<Ramp>> ramps, std::span<const double> weights,
                               Averaging averaging) {
  TACTUS_CHECK(!ramps.empty());
  TACTUS_CHECK(averaging != Averaging::kWeightedMean || weights.size() == ramps.size());
  std::vector<Ramp> out;
  for (std::size_t k = 0; k < ramps.front().size(); ++k) {
    std::vector<double> p;
    std::vector<double> q;
    for (const auto& list : ramps) {
      TACTUS_CHECK(list.size() == ramps.front().size());
      p.push_back(list[k].p);
      q.push_back(list[k].q);
    }
    out.push_back({average(p, weights, averaging), average(q, weights, averaging)});
  }
  return out;
}

double speedUniverseMax(double default_max_mm_s, double largest_centre_mm_s, std::span<const Ramp> ramps) {
  double need = largest_centre_mm_s;
  for (const Ramp& ramp : ramps) need = std::max(need, ramp.q);
  return need <= default_max_mm_s ? default_max_mm_s : std::ceil(need / 100) * 100;
}

std::vector<fuzzy::Term> speedTerms(const fuzzy::Variable& variable, std::span<const Ramp> ramps) {
  TACTUS_CHECK(variable.terms.size() == ramps.size() + 1);
  std::vector<fuzzy::Term> terms;
  for (std::size_t k = 0; k < variable.terms.size(); ++k) {
    const Ramp low = k == 0 ? Ramp{variable.min, variable.min} : ramps[k - 1];
    const Ramp high = k == ramps.size() ? Ramp{variable.max, variable.max} : ramps[k];
    terms.push_back(
        {variable.terms[k].id, variable.terms[k].label, fuzzy::Shape::kTrapezoid, {low.p, low.q, high.p, high.q}});
  }
  return terms;
}

std::vector<study::SpeedSample> trimStrokes(std::span<const study::SpeedSample> samples, double share) {
  if (share <= 0) return {samples.begin(), samples.end()};
  std::map<std::tuple<std::string_view, std::string_view, int>, double> peaks;
  const auto stroke_of = [](const study::SpeedSample& sample) {
    return std::tuple<std::string_view, std::string_view, int>(sample.participant, sample.level, sample.stroke);
  };
  for (const auto& sample : samples) {
    auto& peak = peaks.try_emplace(stroke_of(sample), sample.speed_mm_s).first->second;
    peak = std::max(peak, sample.speed_mm_s);
  }
  std::vector<study::SpeedSample> kept;
  for (const auto& sample : samples) {
    if (sample.speed_mm_s >= share * peaks.at(stroke_of(sample))) kept.push_back(sample);
  }
  return kept;
}

}  // namespace tactus::elicitation
