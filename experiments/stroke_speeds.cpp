#include "experiments/stroke_speeds.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include "core/base/error.h"
#include "core/base/statistics.h"
#include "experiments/stroke.h"

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

namespace {

const std::vector<double>* channel(const study::Recording& recording, std::string_view name) {
  for (const auto& candidate : recording.channels) {
    if (candidate.name == name) return &candidate.values;
  }
  return nullptr;
}

std::string placeOf(const study::StrokeRecord& record) {
  return record.level + ", stroke " + std::to_string(record.number);
}

base::Result<void> checkPlace(const study::StrokeRecord& record) {
  if (record.first < record.last && record.last <= record.recording.size()) return {};
  return base::fail(base::ErrorCode::kData, placeOf(record), "a stroke outside its recording",
                    "first < last within it");
}

/// Far below what a device can tell apart, and short in a table.
double rounded(double value) { return std::round(value * 1e6) / 1e6; }

SpeedStatistics statisticsOf(const std::string& level, int number, std::size_t strokes,
                             std::span<const double> speeds_mm_s) {
  return {level, number, strokes, speeds_mm_s.size(), base::mean(speeds_mm_s), base::standardDeviation(speeds_mm_s)};
}

}  // namespace

base::Result<std::vector<MotionSample>> strokeMotion(const study::StrokeRecord& record) {
  const std::string place = placeOf(record);
  if (auto ok = checkPlace(record); !ok) return tl::unexpected(ok.error());
  const auto& recording = record.recording;
  const auto* const depth = channel(recording, "depth");
  if (depth == nullptr) return base::fail(base::ErrorCode::kData, place, "no channel 'depth'", "one");
  std::vector<double> time_s;
  if (const auto* const recorded = channel(recording, "time")) {
    time_s = *recorded;
  } else {
    time_s.reserve(depth->size());
    for (std::size_t i = 0; i < depth->size(); ++i) time_s.push_back(static_cast<double>(i) / recording.sample_rate_hz);
  }
  std::vector<MotionSample> samples;
  samples.reserve(record.last - record.first);
  if (const auto* const speed = channel(recording, "speed")) {
    for (std::size_t i = record.first; i < record.last; ++i) samples.push_back({time_s[i], (*depth)[i], (*speed)[i]});
    return samples;
  }
  // The derivative looks beyond both ends of the stroke where the recording does.
  const auto motion = speedFromPositions(time_s, *depth);
  if (!motion) return base::fail(base::ErrorCode::kData, place, motion.error().found, motion.error().wanted);
  constexpr double kRoundingS = 1e-9;  // time stamps are sums of steps
  const double start_s = time_s[record.first];
  const double end_s = time_s[record.last - 1];
  const double start_mm = (*depth)[record.first];
  for (const auto& sample : motion->samples) {
    if (sample.time_s < start_s - kRoundingS || sample.time_s > end_s + kRoundingS) continue;
    samples.push_back(
        {rounded(sample.time_s - start_s), rounded(sample.depth_mm - start_mm), rounded(sample.speed_mm_s)});
  }
  if (samples.empty()) return base::fail(base::ErrorCode::kData, place, "less than a millisecond", "a longer stroke");
  return samples;
}

base::Result<std::vector<double>> strokeSpeeds(const study::StrokeRecord& record) {
  if (auto ok = checkPlace(record); !ok) return tl::unexpected(ok.error());
  if (const auto* const speed = channel(record.recording, "speed")) {
    return std::vector<double>(speed->begin() + static_cast<std::ptrdiff_t>(record.first),
                               speed->begin() + static_cast<std::ptrdiff_t>(record.last));
  }
  TACTUS_TRY(const auto motion, strokeMotion(record));
  std::vector<double> speeds;
  speeds.reserve(motion.size());
  for (const auto& sample : motion) speeds.push_back(sample.speed_mm_s);
  return speeds;
}

base::Result<SessionSpeeds> speedStatistics(std::span<const study::StrokeRecord> records) {
  std::set<study::RecordId> corrected;
  for (const auto& record : records) {
    if (record.entry.supersedes) corrected.insert(*record.entry.supersedes);
  }
  struct Level {
    std::string id;
    std::size_t strokes = 0;
    std::vector<double> speeds_mm_s;
  };
  std::vector<Level> levels;
  SessionSpeeds session;
  for (const auto& record : records) {
    if (record.practice || corrected.contains(record.entry.id)) continue;
    if (record.verdict != name(StrokeVerdict::kAccepted)) continue;
    TACTUS_TRY(const auto speeds, strokeSpeeds(record));
    session.strokes.push_back(statisticsOf(record.level, record.number, 1, speeds));
    auto level =
        std::find_if(levels.begin(), levels.end(), [&](const Level& known) { return known.id == record.level; });
    if (level == levels.end()) level = levels.insert(level, Level{record.level, 0, {}});
    ++level->strokes;
    level->speeds_mm_s.insert(level->speeds_mm_s.end(), speeds.begin(), speeds.end());
  }
  for (const auto& level : levels) {
    session.levels.push_back(statisticsOf(level.id, 0, level.strokes, level.speeds_mm_s));
  }
  return session;
}

}  // namespace tactus::experiments
