#include "tests/stress/fcm_agreement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <vector>

#include "core/base/text.h"
#include "elicitation/clustering/fcm.h"

#include "tests/reference/fcm_reference.h"

namespace tactus::stress {
namespace {

using base::formatNumber;
using Centres = std::vector<long double>;

constexpr double kJError = 1e-11;  // relative: sums of at most 240 terms, memberships of a few roundings each
constexpr int kSteps = 30;         // of a start; J falls all the way, so an early end is a fair bound too

class Check {
 public:
  explicit Check(const FcmInput& input) : input_(input), problem_{input.samples, input.weights, input.m} {
    for (std::size_t i = 0; i < input.samples.size(); ++i) {
      const double weight = input.weights.empty() ? 1 : input.weights[i];
      if (weight == 0) continue;
      distinct_.insert(input.samples[i]);
      total_weight_ += weight;
    }
    const double largest = std::max(std::abs(*distinct_.begin()), std::abs(*distinct_.rbegin()));
    const long double ulp = std::nextafter(largest, INFINITY) - static_cast<long double>(largest);
    // Centres and shifted samples are rounded to doubles, which changes J by at most this and its mixed term.
    ulp_ = ulp;
    rounding_ = total_weight_ * ulp * ulp;
  }

  FcmAgreement run(base::Random& random, int starts, bool grid) {
    elicitation::FcmSettings settings;
    settings.clusters = input_.clusters;
    settings.m = input_.m;
    const auto result = input_.weights.empty() ? elicitation::fuzzyCMeans(input_.samples, settings)
                                               : elicitation::fuzzyCMeans(input_.samples, input_.weights, settings);
    if (!result) {
      out_.refused = true;
      if (distinct_.size() >= input_.clusters && !tooClose(result.error())) say("refused: " + result.error().message());
      return std::move(out_);
    }
    if (distinct_.size() < input_.clusters) say("not refused: fewer distinct values than clusters");
    out_.iterations = result->iterations;
    out_.unfinished = result->stop == elicitation::FcmStop::kIterationLimit;
    checkCentres(*result);
    checkMemberships(*result);
    if (out_.disagreement) return std::move(out_);
    const Centres centres(result->centres.begin(), result->centres.end());
    objective_ = reference::fcmObjective(problem_, centres);
    checkObjective(*result);
    for (int start = 0; start < starts; ++start) tryStart(random);
    if (grid) tryGrid();
    for (const auto& other : result->other_minima) {
      compare({other.centres.begin(), other.centres.end()}, "another minimum it reports");
    }
    return std::move(out_);
  }

 private:
  void say(const std::string& what) {
    if (!out_.disagreement) out_.disagreement = what;
  }

  /// Values of which some differ by no more than rounding beside the range.
  bool tooClose(const base::Error& error) const {
    double least = INFINITY;
    for (auto it = std::next(distinct_.begin()); it != distinct_.end(); ++it)
      least = std::min(least, *it - *std::prev(it));
    const double size = std::max(std::abs(*distinct_.begin()), std::abs(*distinct_.rbegin()));
    return error.found.starts_with("clusters too close") && least <= 1e-13 * size;
  }

  void checkCentres(const elicitation::FcmResult& result) {
    const auto& centres = result.centres;
    if (centres.size() != input_.clusters) return say("wrong number of centres");
    for (std::size_t k = 0; k < centres.size(); ++k) {
      if (!std::isfinite(centres[k])) return say("a centre is not finite");
      if (centres[k] < *distinct_.begin() || centres[k] > *distinct_.rbegin()) {
        return say("centre " + formatNumber(centres[k]) + " lies outside the data");
      }
      if (k > 0 && !(centres[k] > centres[k - 1])) return say("centres are not ascending and distinct");
    }
  }

  void checkMemberships(const elicitation::FcmResult& result) {
    std::vector<double> u(result.centres.size());
    for (const double x : input_.samples) {
      elicitation::fcmMemberships(x, result.centres, input_.m, u);
      const double sum = std::accumulate(u.begin(), u.end(), 0.0);
      if (!(std::abs(sum - 1) <= 1e-14) || *std::min_element(u.begin(), u.end()) < 0)
        say("memberships do not sum to 1");
    }
  }

  void checkObjective(const elicitation::FcmResult& result) {
    if (!result.objective_log10) {
      if (objective_ > rounding_) say("J is said to be 0");
      return;
    }
    const long double reported = std::pow(10.0L, static_cast<long double>(*result.objective_log10));
    // The logarithm of J keeps fewer digits: its own rounding times J.
    const long double tolerance =
        kJError * objective_ + 4 * rounding_ + 4 * ulp_ * std::sqrt(objective_ * total_weight_);
    const long double allowed = result.objective ? tolerance : tolerance + 1e-12L * objective_;
    const long double found = result.objective ? *result.objective : reported;
    if (!(std::abs(found - objective_) <= allowed)) {
      say("J is said to be " + formatNumber(static_cast<double>(found / objective_)) + " times what it is");
    }
    if (objective_ > 1e20L * rounding_) {
      out_.largest_j_error = std::max(out_.largest_j_error, static_cast<double>(std::abs(found / objective_ - 1)));
    }
  }

  void compare(const Centres& centres, const std::string& where) {
    const long double other = reference::fcmObjective(problem_, centres);
    if (objective_ > other * (1 + kJError) + 4 * rounding_) {
      out_.largest_j_excess = std::max(out_.largest_j_excess, static_cast<double>(objective_ / other - 1));
      std::vector<std::string> texts;
      for (const long double centre : centres) texts.push_back(formatNumber(static_cast<double>(centre)));
      say("J is " + formatNumber(static_cast<double>(objective_ / other)) + " times that of " + where + ": " +
          base::joined(texts, ", "));
    }
  }

  void tryStart(base::Random& random) {
    const std::vector<double> values(distinct_.begin(), distinct_.end());
    std::set<double> chosen;
    while (chosen.size() < input_.clusters) {
      chosen.insert(values[static_cast<std::size_t>(random.below(static_cast<int>(values.size())))]);
    }
    Centres centres(chosen.begin(), chosen.end());
    // Off the samples: at large m a centre on a sample stays there.
    for (long double& centre : centres) centre += (values.back() - values.front()) * 0.01L * random.normal();
    std::sort(centres.begin(), centres.end());
    compare(reference::fcmFixedPoint(problem_, std::move(centres), kSteps).centres, "a random start");
  }

  /// Every choice of centres from a grid over the range and the samples themselves.
  void tryGrid() {
    std::set<double> places = distinct_;
    for (int i = 1; i < 12; ++i) {
      places.insert(*distinct_.begin() + (*distinct_.rbegin() - *distinct_.begin()) * i / 12);
    }
    const std::vector<double> grid(places.begin(), places.end());
    std::vector<std::size_t> at(input_.clusters);
    std::iota(at.begin(), at.end(), 0U);
    while (true) {
      Centres centres;
      for (const std::size_t i : at) centres.push_back(grid[i]);
      compare(centres, "the grid");
      std::size_t k = at.size();
      while (k > 0 && at[k - 1] == grid.size() - at.size() + k - 1) --k;
      if (k == 0) return;
      ++at[k - 1];
      for (std::size_t l = k; l < at.size(); ++l) at[l] = at[l - 1] + 1;
    }
  }

  const FcmInput& input_;
  reference::FcmProblem problem_;
  std::set<double> distinct_;
  double total_weight_ = 0;
  long double rounding_ = 0;
  long double ulp_ = 0;
  long double objective_ = 0;
  FcmAgreement out_;
};

}  // namespace

FcmAgreement checkClustering(const FcmInput& input, base::Random& random, int starts, bool grid) {
  return Check(input).run(random, starts, grid && input.clusters <= 3 && input.samples.size() <= 14);
}

}  // namespace tactus::stress
