#include "elicitation/speed/membership_edge.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

}  // namespace tactus::elicitation
