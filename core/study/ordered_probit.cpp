#include "core/study/ordered_probit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core/base/check.h"

namespace tactus::study {
namespace {

constexpr double kLeastSigmaN = 1e-3;
constexpr int kMostIterations = 100;
constexpr double kConverged = 1e-12;  // of the Newton decrement: the thresholds then hold to about a micronewton
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double density(double z) { return std::isinf(z) ? 0 : std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi); }
double tail(double z) { return std::erfc(z / std::numbers::sqrt2) / 2; }

/// Probability between two points of the standard normal distribution, without cancellation in the upper tail.
double between(double low, double high) { return low > 0 ? tail(low) - tail(high) : tail(-high) - tail(-low); }

/// The judgements with the used terms numbered without holes.
struct Used {
  std::vector<TermAtForce> judgements;
  std::vector<std::size_t> terms;  ///< used terms, ascending
};

Used usedTerms(std::span<const TermAtForce> judgements, std::size_t term_count) {
  Used used;
  for (std::size_t term = 0; term < term_count; ++term) {
    const bool appears = std::any_of(judgements.begin(), judgements.end(),
                                     [term](const TermAtForce& judgement) { return judgement.term == term; });
    if (!appears) continue;
    for (const auto& judgement : judgements) {
      if (judgement.term == term) used.judgements.push_back({judgement.force_n, used.terms.size(), judgement.count});
    }
    used.terms.push_back(term);
  }
  return used;
}

/// Whether some force with a lower term is larger than one with a higher term.
bool overlaps(const Used& used) {
  double highest = -kInfinity;
  for (std::size_t term = 0; term < used.terms.size(); ++term) {
    double highest_here = -kInfinity;
    for (const auto& judgement : used.judgements) {
      if (judgement.term != term) continue;
      if (judgement.force_n < highest) return true;
      highest_here = std::max(highest_here, judgement.force_n);
    }
    highest = std::max(highest, highest_here);
  }
  return false;
}

/// Parameters: the thresholds over sigma, then 1 / sigma.
using Vector = std::vector<double>;

struct Likelihood {
  double log = 0;
  Vector gradient;
  std::vector<Vector> information;  ///< minus the second derivatives
};

/// A judgement's bounds in standard units are a[term - 1] - b F and a[term] - b F.
Likelihood likelihoodAt(const Vector& parameters, const Used& used) {
  const std::size_t cuts = used.terms.size() - 1;
  Likelihood l{0, Vector(cuts + 1), std::vector<Vector>(cuts + 1, Vector(cuts + 1))};
  for (const auto& [force_n, term, count] : used.judgements) {
    const double shift = parameters[cuts] * force_n;
    const double low = term == 0 ? -kInfinity : parameters[term - 1] - shift;
    const double high = term == cuts ? kInfinity : parameters[term] - shift;
    const double probability = between(low, high);
    if (!(probability > 0)) {
      l.log = -kInfinity;
      return l;
    }
    l.log += count * std::log(probability);
    // First and second derivatives of log P by the two bounds.
    const double by_high = density(high) / probability;
    const double by_low = -density(low) / probability;
    const double high_high = (std::isinf(high) ? 0 : -high * by_high) - by_high * by_high;
    const double low_low = (std::isinf(low) ? 0 : -low * by_low) - by_low * by_low;
    const double high_low = -by_high * by_low;
    Vector d_high(cuts + 1);
    Vector d_low(cuts + 1);
    if (term < cuts) d_high[term] = 1;
    if (term > 0) d_low[term - 1] = 1;
    d_high[cuts] = d_low[cuts] = -force_n;
    for (std::size_t r = 0; r <= cuts; ++r) {
      l.gradient[r] += count * (by_high * d_high[r] + by_low * d_low[r]);
      for (std::size_t c = 0; c <= cuts; ++c) {
        l.information[r][c] -= count * (high_high * d_high[r] * d_high[c] + low_low * d_low[r] * d_low[c] +
                                        high_low * (d_high[r] * d_low[c] + d_low[r] * d_high[c]));
      }
    }
  }
  return l;
}

/// Solves a small symmetric system by Gaussian elimination with pivots; empty where it is singular.
Vector solved(std::vector<Vector> a, Vector b) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i) {
      if (std::abs(a[i][k]) > std::abs(a[pivot][k])) pivot = i;
    }
    if (!(std::abs(a[pivot][k]) > 1e-14)) return {};
    std::swap(a[k], a[pivot]);
    std::swap(b[k], b[pivot]);
    for (std::size_t i = k + 1; i < n; ++i) {
      const double factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j < n; ++j) a[i][j] -= factor * a[k][j];
      b[i] -= factor * b[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) b[k] -= a[k][j] * b[j];
    b[k] /= a[k][k];
  }
  return b;
}

/// Ordered cuts at the shares of the terms, as if the force told nothing.
Vector startOf(const Used& used) {
  Vector start(used.terms.size());
  double count = 0;
  for (const auto& judgement : used.judgements) count += judgement.count;
  double below = 0;
  for (std::size_t cut = 0; cut + 1 < used.terms.size(); ++cut) {
    for (const auto& judgement : used.judgements) below += judgement.term == cut ? judgement.count : 0;
    double low = -10;
    double high = 10;
    for (int i = 0; i < 60; ++i) {
      const double middle = (low + high) / 2;
      (tail(-middle) < below / count ? low : high) = middle;
    }
    start[cut] = low;
  }
  return start;
}

/// The maximum of the likelihood, or nothing.
std::optional<Vector> maximize(const Used& used) {
  Vector at = startOf(used);
  Likelihood here = likelihoodAt(at, used);
  for (int round = 0; round < kMostIterations; ++round) {
    const Vector step = solved(here.information, here.gradient);
    if (step.empty()) return std::nullopt;
    double decrement = 0;
    for (std::size_t i = 0; i < step.size(); ++i) decrement += step[i] * here.gradient[i];
    if (decrement < kConverged) return at;
    double length = 1;
    Likelihood there;
    Vector next(at.size());
    do {
      for (std::size_t i = 0; i < at.size(); ++i) next[i] = at[i] + length * step[i];
      there = likelihoodAt(next, used);
      length /= 2;
    } while (there.log < here.log && length > 1e-10);
    if (there.log < here.log) return std::nullopt;
    at = std::move(next);
    here = std::move(there);
  }
  return std::nullopt;
}

/// The force that separates the terms up to `term` from the higher ones with the fewest on the wrong side.
std::optional<double> midpoint(std::span<const TermAtForce> judgements, std::size_t term) {
  std::vector<double> forces;
  bool lower = false;
  bool higher = false;
  for (const auto& judgement : judgements) {
    forces.push_back(judgement.force_n);
    (judgement.term <= term ? lower : higher) = true;
  }
  if (!lower || !higher) return std::nullopt;
  std::sort(forces.begin(), forces.end());
  forces.erase(std::unique(forces.begin(), forces.end()), forces.end());
  double fewest = kInfinity;
  double first = forces.front();
  double last = forces.front();
  for (std::size_t i = 0; i + 1 < forces.size(); ++i) {
    const double place = (forces[i] + forces[i + 1]) / 2;
    double wrong = 0;
    for (const auto& judgement : judgements) {
      if ((judgement.term <= term) != (judgement.force_n < place)) wrong += judgement.count;
    }
    if (wrong < fewest) first = place;
    if (wrong <= fewest) last = place;
    fewest = std::min(fewest, wrong);
  }
  return (first + last) / 2;
}

}  // namespace

std::string_view name(TermThresholds::Method method) noexcept {
  return method == TermThresholds::Method::kOrderedProbit ? "ordered_probit" : "midpoints";
}

TermThresholds termThresholds(std::span<const TermAtForce> judgements, std::size_t term_count) {
  TACTUS_CHECK(term_count >= 2);
  TermThresholds result;
  result.threshold_n.resize(term_count - 1);
  const Used used = usedTerms(judgements, term_count);
  if (used.terms.size() >= 2 && overlaps(used)) {
    const auto maximum = maximize(used);
    const double precision = maximum ? maximum->back() : 0;
    if (precision > 0 && 1 / precision >= kLeastSigmaN) {
      result.method = TermThresholds::Method::kOrderedProbit;
      result.sigma_n = 1 / precision;
      for (std::size_t cut = 0; cut + 1 < used.terms.size(); ++cut) {
        for (std::size_t term = used.terms[cut]; term < used.terms[cut + 1]; ++term) {
          result.threshold_n[term] = (*maximum)[cut] / precision;
        }
      }
      return result;
    }
  }
  for (std::size_t term = 0; term + 1 < term_count; ++term) result.threshold_n[term] = midpoint(judgements, term);
  return result;
}

}  // namespace tactus::study
