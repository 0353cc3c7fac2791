#include "elicitation/force/force_frequency.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/check.h"
#include "core/base/error.h"
#include "core/fuzzy/membership.h"
#include "elicitation/force/force_end.h"
#include "elicitation/force/force_term_parts.h"

namespace tactus::elicitation {
namespace {

/// Places of the coarse grid, the points among them.
constexpr std::size_t kGridPlaces = 240;
/// Price of a narrow ramp beside a sum of squares that is at most 2: enough to decide where points leave a ramp open,
/// too little to move one that they hold.
constexpr double kWidthPrice = 1e-9;
/// Steps of the search around an end, in multiples of the present step.
constexpr std::array<double, 9> kSteps = {-8, -4, -2, -1, 0, 1, 2, 4, 8};
constexpr double kFinestStep = 1e-8;  // of the universe
/// Distances that are equal but for their last bits count as equal.
constexpr double kSlack = 1e-9;
constexpr double kForbidden = std::numeric_limits<double>::infinity();
constexpr int kMostRounds = 500;
constexpr double kRounding = 1e6;  // ends are multiples of a micronewton

/// A place for the end of a ramp, `x` in [0, 1] of the universe; a place at a point lies before or behind it.
struct Place {
  double x = 0;
  std::size_t points_before = 0;

  bool operator<(const Place& other) const { return x != other.x ? x < other.x : points_before < other.points_before; }
  bool operator==(const Place&) const = default;
};

/// Sums of squares of a stretch of points.
class Costs {
 public:
  Costs(std::span<const FrequencyPoint> points, double min_n, double max_n)
      : points_(points), terms_(points.front().shares.size()), alone_(terms_, std::vector<double>{0}) {
    for (const auto& point : points) {
      x_.push_back((point.force_n - min_n) / (max_n - min_n));
      total_ += point.weight;
    }
    for (std::size_t i = 1; i < x_.size(); ++i) finest_ = std::min(finest_, (x_[i] - x_[i - 1]) * (1 - kSlack));
    for (const auto& point : points) {
      for (std::size_t k = 0; k < terms_; ++k) {
        alone_[k].push_back(alone_[k].back() + point.weight / total_ * squares(point, k, 0));
      }
    }
  }

  const std::vector<double>& x() const { return x_; }
  std::size_t terms() const { return terms_; }

  /// Term `k` alone, from one end to the other.
  double core(std::size_t k, const Place& from, const Place& to) const {
    return alone_[k][to.points_before] - alone_[k][from.points_before];
  }

  /// The ramp from term `k` to the next.
  double ramp(std::size_t k, const Place& from, const Place& to) const {
    const double width = to.x - from.x;
    double cost = kWidthPrice * (1 - width) * (1 - width);
    if (from.points_before == to.points_before) {
      const bool outside = from.points_before == 0 || to.points_before == x_.size();
      return outside || width >= finest_ / static_cast<double>(2 * terms_ - 2) ? cost : kForbidden;
    }
    if (width < finest_) return kForbidden;
    for (std::size_t i = from.points_before; i < to.points_before; ++i) {
      cost += points_[i].weight / total_ * squares(points_[i], k, (x_[i] - from.x) / width);
    }
    return cost;
  }

 private:
  /// Where the term after `k` has membership `next` and `k` the rest.
  static double squares(const FrequencyPoint& point, std::size_t k, double next) {
    double sum = 0;
    for (std::size_t j = 0; j < point.shares.size(); ++j) {
      const double membership = j == k ? 1 - next : j == k + 1 ? next : 0;
      sum += (membership - point.shares[j]) * (membership - point.shares[j]);
    }
    return sum;
  }

  std::span<const FrequencyPoint> points_;
  std::size_t terms_;
  double total_ = 0;
  std::vector<double> x_;
  double finest_ = 1;                       ///< least width of a ramp that holds a point
  std::vector<std::vector<double>> alone_;  ///< of each term, running sums over the points
};

using Places = std::vector<Place>;

void addPlace(Places& places, const std::vector<double>& points, double x) {
  const auto before = static_cast<std::size_t>(std::lower_bound(points.begin(), points.end(), x) - points.begin());
  places.push_back({x, before});
  if (before < points.size() && points[before] == x) places.push_back({x, before + 1});
}

void sortPlaces(Places& places) {
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
}

Places coarseGrid(const std::vector<double>& points) {
  Places places;
  const std::size_t taken = std::min(points.size(), kGridPlaces / 2);
  for (std::size_t i = 0; i < taken; ++i) addPlace(places, points, points[i * points.size() / taken]);
  const std::size_t even = kGridPlaces - taken;
  for (std::size_t i = 0; i <= even; ++i) {
    addPlace(places, points, static_cast<double>(i) / static_cast<double>(even));
  }
  sortPlaces(places);
  return places;
}

/// The places around `end` that are worth a try, and the points nearest to it.
Places around(const Place& end, double step, const std::vector<double>& points) {
  Places places = {end};
  for (const double steps : kSteps) addPlace(places, points, std::clamp(end.x + steps * step, 0.0, 1.0));
  if (end.points_before > 0) addPlace(places, points, points[end.points_before - 1]);
  if (end.points_before < points.size()) addPlace(places, points, points[end.points_before]);
  sortPlaces(places);
  return places;
}

/// The cheapest ascending choice of one place for each end.
struct CheapestPlaces {
  Places ends;
  double cost = kForbidden;
};

CheapestPlaces cheapest(const Costs& costs, const std::vector<Places>& candidates) {
  const Place first{0, 0};
  const Place last{1, costs.x().size()};
  std::vector<std::vector<double>> best;
  std::vector<std::vector<std::size_t>> from;
  for (std::size_t j = 0; j < candidates.size(); ++j) {
    best.emplace_back(candidates[j].size(), kForbidden);
    from.emplace_back(candidates[j].size(), 0);
    for (std::size_t b = 0; b < candidates[j].size(); ++b) {
      const Place& to = candidates[j][b];
      if (j == 0) {
        best[j][b] = costs.core(0, first, to);
        continue;
      }
      const Places& starts = candidates[j - 1];
      for (std::size_t a = 0; a < starts.size() && !(to < starts[a]); ++a) {
        const double piece = j % 2 == 1 ? costs.ramp(j / 2, starts[a], to) : costs.core(j / 2, starts[a], to);
        if (best[j - 1][a] + piece < best[j][b]) {
          best[j][b] = best[j - 1][a] + piece;
          from[j][b] = a;
        }
      }
    }
  }
  CheapestPlaces out;
  std::size_t at = 0;
  for (std::size_t b = 0; b < candidates.back().size(); ++b) {
    const double cost = best.back()[b] + costs.core(costs.terms() - 1, candidates.back()[b], last);
    if (cost < out.cost) {
      out.cost = cost;
      at = b;
    }
  }
  out.ends.resize(candidates.size());
  for (std::size_t j = candidates.size(); j-- > 0; at = from[j][at]) out.ends[j] = candidates[j][at];
  return out;
}

/// Makes ramps between the same two points equally wide: the price of narrow ones is too small for the last digits.
void shareGaps(Places& ends) {
  for (std::size_t first = 0; first < ends.size();) {
    const std::size_t gap = ends[first].points_before;
    std::size_t last = first;
    while (last < ends.size() && ends[last].points_before == gap && ends[last + 1].points_before == gap) last += 2;
    const std::size_t ramps = (last - first) / 2;
    if (ramps > 1) {
      const double begin = ends[first].x;
      const double width = (ends[last - 1].x - begin) / static_cast<double>(ramps);
      for (std::size_t k = 0; k < ramps; ++k) {
        ends[first + 2 * k].x = begin + width * static_cast<double>(k);
        ends[first + 2 * k + 1].x = begin + width * static_cast<double>(k + 1);
      }
    }
    first = std::max(last, first + 2);
  }
}

}  // namespace

std::vector<TermRamp> fitRamps(std::span<const FrequencyPoint> points, double min_n, double max_n) {
  TACTUS_CHECK(!points.empty() && min_n < max_n);
  const Costs costs(points, min_n, max_n);
  if (costs.terms() < 2) return {};
  const std::size_t ends = 2 * (costs.terms() - 1);
  CheapestPlaces choice = cheapest(costs, std::vector<Places>(ends, coarseGrid(costs.x())));
  double step = 1.0 / static_cast<double>(kGridPlaces);
  for (int round = 0; round < kMostRounds && step > kFinestStep; ++round) {
    std::vector<Places> candidates;
    for (const Place& end : choice.ends) candidates.push_back(around(end, step, costs.x()));
    CheapestPlaces better = cheapest(costs, candidates);
    const bool moved = better.cost < choice.cost;
    if (moved) choice = std::move(better);
    // A small gain is the rounding of the sums; the step shrinks all the same.
    if (!moved || step < 1e-6) step /= 2;
  }
  shareGaps(choice.ends);
  std::vector<TermRamp> ramps;
  const auto place = [&](const Place& end) {
    const double force_n = std::round((min_n + end.x * (max_n - min_n)) * kRounding) / kRounding;
    return std::clamp(force_n, min_n, max_n);
  };
  for (std::size_t k = 0; k < ends; k += 2) ramps.push_back({place(choice.ends[k]), place(choice.ends[k + 1])});
  return ramps;
}

namespace {

FrequencyStep stepOf(const VoteStep& counts) {
  FrequencyStep step{counts.force_n, std::accumulate(counts.votes.begin(), counts.votes.end(), 0), {}};
  if (step.votes == 0) return step;
  for (const int votes : counts.votes) step.shares.push_back(static_cast<double>(votes) / step.votes);
  return step;
}

double rmsError(const fuzzy::Variable& output, std::span<const FrequencyPoint> points, const ForceTerms& fitted) {
  double squares = 0;
  double answers = 0;
  for (const auto& point : points) {
    answers += point.weight;
    for (std::size_t k = 0; k < output.terms.size(); ++k) {
      const auto* term = fuzzy::findTerm(fitted.output.terms, output.terms[k].id);
      const double membership = term == nullptr ? 0 : fuzzy::MembershipFunction::of(*term)(point.force_n);
      squares += point.weight * std::pow(membership - point.shares[k], 2);
    }
  }
  return std::sqrt(squares / (answers * static_cast<double>(output.terms.size())));
}

bool isChosen(std::span<const FrequencyPoint> points, std::size_t term) {
  return std::any_of(points.begin(), points.end(),
                     [term](const FrequencyPoint& point) { return point.shares[term] > 0; });
}

/// The ramps up to the highest term that was chosen from the fit, those above it a step wide each.
std::vector<TermRamp> allRamps(std::vector<FrequencyPoint> points, const ForceEnd& end, std::size_t highest,
                               std::size_t terms) {
  for (auto& point : points) point.shares.resize(highest + 1);
  auto ramps = fitRamps(points, 0, end.last_n);
  double begin_n = end.last_n;
  for (std::size_t k = highest + 1; k < terms; ++k) {
    const double next_n = end.stepsAbove(k - highest);
    ramps.push_back({begin_n, next_n});
    begin_n = next_n;
  }
  return ramps;
}

}  // namespace

base::Result<FrequencyTerms> frequencyTerms(const fuzzy::Variable& output, std::span<const VoteStep> steps,
                                            std::optional<double> end_n) {
  TACTUS_TRY(const auto end, forceEnd(steps, end_n));
  FrequencyTerms out;
  static_cast<ForceTerms&>(out) = emptyForceTerms(output, end);
  std::vector<FrequencyPoint> points;
  for (const auto& one : steps) {
    TACTUS_CHECK(one.votes.size() == output.terms.size());
    out.steps.push_back(stepOf(one));
    const auto& step = out.steps.back();
    if (step.votes > 0 && out.steps.size() <= end.steps) {
      points.push_back({step.force_n, static_cast<double>(step.votes), step.shares});
    }
  }

  const std::size_t terms = output.terms.size();
  std::size_t highest = terms - 1;
  while (!isChosen(points, highest)) --highest;
  const auto ramps = allRamps(points, end, highest, terms);
  if (highest + 1 < terms) endAbove(out, end, terms - 1 - highest, ramps.back().end_n);
  placeBetween(output, ramps, out);
  for (std::size_t k = 0; k < terms; ++k) {
    if (isChosen(points, k)) continue;
    const auto* term = fuzzy::findTerm(out.output.terms, output.terms[k].id);
    if (term != nullptr) addInterpolated(out, *term, end, (term->points[1] + term->points[2]) / 2);
  }
  out.rms_error = rmsError(output, points, out);
  return out;
}

}  // namespace tactus::elicitation
