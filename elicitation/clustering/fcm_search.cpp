#include "elicitation/clustering/fcm_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/check.h"
#include "core/base/random.h"
#include "elicitation/clustering/fcm_entries.h"
#include "elicitation/clustering/fcm_relocation.h"
#include "elicitation/clustering/fcm_starts.h"

namespace tactus::elicitation {
namespace {

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
      case 0:
        return quantileStart(entries, settings_.clusters);
      case 1:
        return bestRunsStart(entries, settings_.clusters);
      case 2:
        return equalWidthStart(entries, settings_.clusters);
      default:
        break;
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

}  // namespace tactus::elicitation
