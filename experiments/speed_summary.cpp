#include "experiments/speed_summary.h"

#include <set>

#include "core/base/statistics.h"

namespace tactus::experiments {
namespace {

struct Group {
  const study::SpeedSample* first;
  std::vector<double> speeds_mm_s;
  std::set<int> strokes;
};

bool belongs(const Group& group, const study::SpeedSample& sample) {
  return group.first->participant == sample.participant && group.first->level == sample.level;
}

/// The group of `sample`, made where there is none. Samples of one group mostly stand together: look there first.
Group& groupOf(std::vector<Group>& groups, std::size_t& last, const study::SpeedSample& sample) {
  if (last < groups.size() && belongs(groups[last], sample)) return groups[last];
  for (last = 0; last < groups.size(); ++last) {
    if (belongs(groups[last], sample)) return groups[last];
  }
  groups.push_back({&sample, {}, {}});
  return groups.back();
}

}  // namespace

std::vector<SpeedSummary> summarizeSpeeds(std::span<const study::SpeedSample> samples) {
  std::vector<Group> groups;
  std::size_t last = 0;
  for (const auto& sample : samples) {
    Group& group = groupOf(groups, last, sample);
    group.speeds_mm_s.push_back(sample.speed_mm_s);
    group.strokes.insert(sample.stroke);
  }
  std::vector<SpeedSummary> summaries;
  for (const auto& group : groups) {
    summaries.push_back({group.first->participant, group.first->level, group.strokes.size(), group.speeds_mm_s.size(),
                         base::mean(group.speeds_mm_s), base::standardDeviation(group.speeds_mm_s)});
  }
  return summaries;
}

}  // namespace tactus::experiments
