#include "elicitation/clustering/fcm.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "core/base/check.h"
#include "core/base/error.h"
#include "core/base/random.h"
#include "core/base/text.h"
#include "elicitation/clustering/fcm_data.h"
#include "elicitation/clustering/fcm_pass.h"
#include "elicitation/clustering/fcm_starts.h"

namespace tactus::elicitation {

/// The lowest minimum of J that the starts lead to (part of fcm.h).
struct FcmSearch {
  FcmDescent kept;
  std::vector<FcmDescent> others;  ///< other minima by ascending J; those of the entries unless J is close
  int passes = 0;                  ///< over all samples
  bool canceled = false;
};

/// Searches from coarse to fine: descends from all starts on a few hundred entries, from their distinct minima on all
/// entries, and from the candidates for the lowest minimum on all samples. `data`: more distinct values than clusters.
/// Four times settings.starts are made for up to 64 distinct values, and for m above 3 if the first ones disagree.
FcmSearch searchMinima(const FcmData& data, const FcmSettings& settings);

namespace {

// Starts that may lead from a minimum of J to a lower one: one center is removed and placed elsewhere (part of fcm.h).

constexpr std::size_t kMostPlaces = 48;

struct Relocation {
  double objective = std::numeric_limits<double>::infinity();
  std::vector<double> centres;
};

/// Up to `most` starts, those with the lowest J. Each differs from `centres` (ascending) by one center, moved to one of
/// at most 48 entries spread over the data. Each is ascending and distinct.
std::vector<std::vector<double>> relocations(const FcmEntries& entries, const std::vector<double>& centres, double m,
                                             std::size_t most) {
  const FcmData data = entries.view();
  FcmPass pass(centres.size(), m);
  FcmSums sums;
  const std::size_t places = std::min(kMostPlaces, entries.size());
  std::vector<Relocation> all;
  for (std::size_t k = 0; k < centres.size(); ++k) {
    std::vector<double> rest = centres;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(k));
    for (std::size_t i = 0; i < places; ++i) {
      const double place = entries.values[places == 1 ? 0 : i * (entries.size() - 1) / (places - 1)];
      const auto at = std::lower_bound(rest.begin(), rest.end(), place);
      if (place == centres[k] || (at != rest.end() && *at == place)) continue;
      std::vector<double> moved = rest;
      moved.insert(moved.begin() + (at - rest.begin()), place);
      pass.run(data, moved, sums);
      all.push_back({sums.objective, std::move(moved)});
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.objective < b.objective; });
  std::vector<std::vector<double>> out;
  for (std::size_t i = 0; i < std::min(most, all.size()); ++i) out.push_back(std::move(all[i].centres));
  return out;
}

constexpr std::size_t kMostForStarts = 512;  // more entries are made coarser for the starts
constexpr std::size_t kCoarse = 256;
constexpr std::size_t kMostRefined = 8;   // minima that are followed beyond the starts
constexpr double kRoughTolerance = 1e-7;  // for starts on coarse entries, far below what coarseness costs
constexpr double kMinimaApartM = 3;       // above it J has minima at single samples
constexpr std::size_t kFewEntries = 64;
constexpr int kStartsFactor = 4;      // beyond kMinimaApartM
constexpr int kMostRelocations = 12;  // of few entries; of more, which have smoother J and cost time, the next
constexpr int kMostRelocationsOfMany = 3;
constexpr std::size_t kRelocatedMinima = 6;
constexpr std::size_t kRelocationsTried = 8;
constexpr double kSameMinimum = 1e-5;      // of the gaps between centers: nearer results are one minimum
constexpr double kEqualObjective = 1e-12;  // relative difference of J that rounding explains
constexpr double kAnyObjective = std::numeric_limits<double>::infinity();
constexpr double kCloseObjective = 0.01;  // what condensing may change in J, by far

bool same(const std::vector<double>& a, const std::vector<double>& b) {
  double gap = std::numeric_limits<double>::infinity();
  double change = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (k > 0) gap = std::min(gap, a[k] - a[k - 1]);
    change = std::max(change, std::abs(a[k] - b[k]));
  }
  return a.size() == 1 || change <= kSameMinimum * gap;
}

/// Adds `found` unless the same place is there already.
void addDistinct(std::vector<FcmDescent>& list, FcmDescent found) {
  const auto known = [&](const FcmDescent& other) { return same(other.centres, found.centres); };
  if (std::none_of(list.begin(), list.end(), known)) list.push_back(std::move(found));
}

/// By J; of equal ones the first found comes first.
void sortByObjective(std::vector<FcmDescent>& list) {
  std::stable_sort(list.begin(), list.end(),
                   [](const FcmDescent& a, const FcmDescent& b) { return a.objective < b.objective; });
}

/// Brings the lowest to the front. Where rounding alone could decide, the one that was found first.
void lowestFirst(std::vector<FcmDescent>& list) {
  auto best = list.begin();
  for (auto it = list.begin(); it != list.end(); ++it) {
    if (it->objective < best->objective * (1 - kEqualObjective)) best = it;
  }
  std::rotate(list.begin(), best, best + 1);
}

class Search {
 public:
  Search(const FcmData& data, const FcmSettings& settings) : data_(data), settings_(settings) {
    if (settings.keep_going) {
      before_pass_ = [this](double change) { return goesOn(change); };
      before_full_pass_ = [this](double change) {
        ++out_.passes;
        return goesOn(change);
      };
    } else {
      before_full_pass_ = [this](double) { return ++out_.passes > 0; };
    }
  }

  FcmSearch run() {
    if (!goesOn(1)) return std::move(out_);
    const FcmEntries entries = condense(data_);
    const bool fine = entries.size() <= kMostForStarts;
    const FcmEntries coarse = fine ? FcmEntries{} : coarser(entries, std::max(kCoarse, 8 * settings_.clusters));
    std::vector<FcmDescent> list = tryStarts(fine ? entries : coarse, fine ? settings_.tolerance : kRoughTolerance);
    if (!fine) list = refined(entries.view(), std::move(list), kAnyObjective, before_pass_);
    if (!entries.exact) list = refined(data_, std::move(list), kCloseObjective, before_full_pass_);
    if (out_.canceled) return std::move(out_);
    lowestFirst(list);
    out_.kept = std::move(list.front());
    list.erase(list.begin());
    std::erase_if(list, [](const FcmDescent& other) { return !other.minimum; });
    sortByObjective(list);
    out_.others = std::move(list);
    return std::move(out_);
  }

 private:
  bool goesOn(double change) {
    if (!out_.canceled && settings_.keep_going) {
      out_.canceled = !settings_.keep_going({out_.passes, std::min(change / data_.range(), 1.0)});
    }
    return !out_.canceled;
  }

  std::vector<FcmDescent> tryStarts(const FcmEntries& entries, double tolerance) {
    FcmSettings settings = settings_;
    settings.tolerance = std::max(settings.tolerance, tolerance);
    const FcmData data = entries.view();
    base::Random random(settings_.seed);
    std::vector<FcmDescent> found;
    const bool few = entries.size() <= kFewEntries;
    const bool more = settings_.starts > 1 && (settings_.m > kMinimaApartM || few);
    const int starts = more ? kStartsFactor * settings_.starts : settings_.starts;
    for (int start = 0; start < std::max(starts, 1) && !out_.canceled; ++start) {
      if (start == settings_.starts && !few && found.size() == 1) break;  // J is smooth: they all agree
      std::vector<double> centres = startNumber(start, entries, random);
      if (centres.size() < settings_.clusters) continue;
      FcmDescent end = descend(data, std::move(centres), FcmBeginning::kAnywhere, settings, before_pass_);
      addDistinct(found, std::move(end));
    }
    TACTUS_CHECK(!found.empty());
    sortByObjective(found);
    if (settings_.starts > 1 && isRugged(entries)) relocateBest(entries, settings, found);
    if (found.size() > kMostRefined) found.resize(kMostRefined);
    return found;
  }

  /// Few values, many clusters or much fuzziness: so many minima that starts alone miss the lowest.
  bool isRugged(const FcmEntries& entries) const {
    return entries.size() <= kFewEntries || settings_.clusters > 4 || settings_.m > kMinimaApartM;
  }

  /// The lowest minimum whose relocations were not tried yet, in turn, until the lowest few were.
  void relocateBest(const FcmEntries& entries, const FcmSettings& settings, std::vector<FcmDescent>& found) {
    const FcmData data = entries.view();
    std::vector<FcmDescent> done;
    const int rounds = entries.size() <= kFewEntries ? kMostRelocations : kMostRelocationsOfMany;
    for (int round = 0; round < rounds && !out_.canceled; ++round) {
      const auto is_new = [&](const FcmDescent& one) {
        return std::none_of(done.begin(), done.end(),
                            [&](const auto& other) { return same(other.centres, one.centres); });
      };
      const auto end = found.begin() + static_cast<std::ptrdiff_t>(std::min(kRelocatedMinima, found.size()));
      const auto next = std::find_if(found.begin(), end, is_new);
      if (next == end) return;
      done.push_back(*next);
      for (auto& centres : relocations(entries, done.back().centres, settings_.m, kRelocationsTried)) {
        addDistinct(found, descend(data, std::move(centres), FcmBeginning::kAnywhere, settings, before_pass_));
      }
      sortByObjective(found);
    }
  }

  std::vector<double> startNumber(int start, const FcmEntries& entries, base::Random& random) const {
    switch (start) {
      case 0: return quantileStart(entries, settings_.clusters);
      case 1: return bestRunsStart(entries, settings_.clusters);
      case 2: return equalWidthStart(entries, settings_.clusters);
      default: break;
    }
    std::vector<double> centres = spreadStart(entries, settings_.clusters, random);
    if (settings_.m > kMinimaApartM) {  // a center on a sample would stay there
      for (std::size_t k = 1; k < centres.size(); ++k) {
        centres[k - 1] += random.uniform(0, 0.3) * (centres[k] - centres[k - 1]);
      }
    }
    return centres;
  }

  /// The same minima on finer data, as far as their J lies within the share `close` of the lowest; others as they are.
  std::vector<FcmDescent> refined(const FcmData& data, std::vector<FcmDescent> list, double close,
                                  const FcmBeforePass& before_pass) {
    sortByObjective(list);
    std::vector<FcmDescent> out;
    for (auto& coarse : list) {
      if (out_.canceled) break;
      if (!out.empty() && coarse.objective > list.front().objective * (1 + close)) {
        addDistinct(out, std::move(coarse));
        continue;
      }
      FcmDescent end = descend(data, coarse.centres, FcmBeginning::kNearMinimum, settings_, before_pass);
      end.iterations += coarse.iterations;
      addDistinct(out, std::move(end));
    }
    return out;
  }

  const FcmData& data_;
  const FcmSettings& settings_;
  FcmBeforePass before_pass_, before_full_pass_;
  FcmSearch out_;
};

}  // namespace

FcmSearch searchMinima(const FcmData& data, const FcmSettings& settings) { return Search(data, settings).run(); }

namespace {

using base::ErrorCode;
using base::fail;
using base::formatNumber;
using base::Result;

constexpr double kLargestM = 100;  // u^m of many clusters underflows beyond it
constexpr double kPinningM = 5;    // above it J has a minimum at nearly every sample

Result<void> checkSettings(const FcmSettings& settings) {
  if (settings.clusters < 1 || settings.clusters > kMostClusters) {
    return fail(ErrorCode::kValue, "clusters", std::to_string(settings.clusters),
                "1 to " + std::to_string(kMostClusters));
  }
  if (!(settings.m > 1 && settings.m <= kLargestM)) {
    return fail(ErrorCode::kValue, "fuzziness m", formatNumber(settings.m),
                "a number above 1 and at most " + formatNumber(kLargestM));
  }
  return {};
}

std::vector<double> original(const FcmData& data, std::vector<double> centres) {
  for (double& centre : centres) centre = data.toOriginal(centre);
  return centres;
}

void setObjective(FcmResult& result, double scaled, int exponent) {
  if (scaled == 0) {
    result.objective = 0;
    return;
  }
  result.objective_log10 = std::log10(scaled) + exponent * std::log10(2.0);
  const double value = std::ldexp(scaled, exponent);
  if (std::isnormal(value)) result.objective = value;
}

void addWarnings(FcmResult& result) {
  if (result.m > kPinningM) {
    result.warnings.push_back("Fuzziness m = " + formatNumber(result.m) +
                              " is above 5: the centers pin to single samples, and J has many minima.");
  }
  if (result.stop == FcmStop::kIterationLimit) {
    result.warnings.push_back("The iterations ran out after " + std::to_string(result.iterations) +
                              " steps; the centers are not final.");
  }
  if (!result.other_minima.empty() && result.other_minima.front().objective_ratio < 1.01) {
    result.warnings.push_back(
        "Another minimum of J is within 1 % of the one kept: the data do not decide between them.");
  }
}

Result<FcmResult> fuzzyCMeansOf(std::span<const double> samples, std::span<const double> weights,
                                const FcmSettings& settings) {
  if (auto ok = checkSettings(settings); !ok) return tl::unexpected(ok.error());
  TACTUS_TRY(const auto data, prepareFcmData(samples, weights));
  const auto distinct = distinctValues(data, settings.clusters + 1);
  if (distinct.size() < settings.clusters) {
    return fail(ErrorCode::kData, "samples",
                std::to_string(distinct.size()) + (distinct.size() == 1 ? " distinct value" : " distinct values"),
                "at least " + std::to_string(settings.clusters) + ", one for each cluster");
  }

  FcmResult result;
  result.m = settings.m;
  if (distinct.size() == settings.clusters) {
    result.centres = distinct;
    result.objective = 0;
    result.stop = FcmStop::kExact;
    addWarnings(result);
    return result;
  }

  const FcmSearch found = searchMinima(data, settings);
  if (found.canceled) {
    return fail(ErrorCode::kCancelled, "clustering", "a request to stop", "to go on to the end");
  }
  result.centres = original(data, found.kept.centres);
  if (std::adjacent_find(result.centres.begin(), result.centres.end(), std::greater_equal<>()) !=
      result.centres.end()) {
    return fail(ErrorCode::kData, "samples", "clusters too close together for the range of the values",
                "values whose clusters double precision can tell apart");
  }
  setObjective(result, found.kept.objective, data.objectiveExponent());
  result.iterations = found.kept.iterations;
  result.passes = found.passes;
  result.stop = found.kept.converged ? FcmStop::kConverged : FcmStop::kIterationLimit;
  for (const auto& other : found.others) {
    result.other_minima.push_back({original(data, other.centres), other.objective / found.kept.objective});
  }
  addWarnings(result);
  return result;
}

}  // namespace

std::string_view name(FcmStop stop) noexcept {
  switch (stop) {
    case FcmStop::kConverged: return "converged";
    case FcmStop::kExact: return "exact";
    case FcmStop::kIterationLimit: return "iteration_limit";
  }
  return "";
}

Result<FcmResult> fuzzyCMeans(std::span<const double> samples, const FcmSettings& settings) {
  return fuzzyCMeansOf(samples, {}, settings);
}

Result<FcmResult> fuzzyCMeans(std::span<const double> samples, std::span<const double> weights,
                              const FcmSettings& settings) {
  if (weights.empty() && !samples.empty()) {
    return fail(ErrorCode::kData, "weights", "none", std::to_string(samples.size()) + ", one for each sample");
  }
  return fuzzyCMeansOf(samples, weights, settings);
}

void fcmMemberships(double x, std::span<const double> centres, double m, std::span<double> memberships) noexcept {
  double nearest = std::numeric_limits<double>::infinity();
  for (const double centre : centres) nearest = std::min(nearest, std::abs(x - centre));
  double sum = 0;
  for (std::size_t k = 0; k < centres.size(); ++k) {
    const double distance = std::abs(x - centres[k]);
    memberships[k] = distance == nearest ? 1.0 : std::pow(nearest / distance, 2 / (m - 1));
    sum += memberships[k];
  }
  for (double& u : memberships) u /= sum;
}

}  // namespace tactus::elicitation
