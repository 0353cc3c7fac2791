#include "elicitation/clustering/fcm_relocation.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "elicitation/clustering/fcm_pass.h"

namespace tactus::elicitation {
namespace {

constexpr std::size_t kMostPlaces = 48;

struct Relocation {
  double objective = std::numeric_limits<double>::infinity();
  std::vector<double> centres;
};

}  // namespace

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

}  // namespace tactus::elicitation
