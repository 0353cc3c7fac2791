#include "experiments/stroke_speeds.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

#include "core/base/statistics.h"
#include "experiments/speed_from_positions.h"
#include "experiments/stroke.h"

namespace tactus::experiments {
namespace {

const std::vector<double>* channel(const study::Recording& recording, std::string_view name) {
  for (const auto& candidate : recording.channels) {
    if (candidate.name == name) return &candidate.values;
  }
  return nullptr;
}

SpeedStatistics statisticsOf(const std::string& level, int number, std::size_t strokes,
                             std::span<const double> speeds_mm_s) {
  return {level, number, strokes, speeds_mm_s.size(), base::mean(speeds_mm_s), base::standardDeviation(speeds_mm_s)};
}

}  // namespace

base::Result<std::vector<double>> strokeSpeeds(const study::StrokeRecord& record) {
  const std::string place = record.level + ", stroke " + std::to_string(record.number);
  const auto& recording = record.recording;
  if (record.first >= record.last || record.last > recording.size()) {
    return base::fail(base::ErrorCode::kData, place, "a stroke outside its recording", "first < last within it");
  }
  if (const auto* const speed = channel(recording, "speed")) {
    return std::vector<double>(speed->begin() + static_cast<std::ptrdiff_t>(record.first),
                               speed->begin() + static_cast<std::ptrdiff_t>(record.last));
  }
  const auto* const depth = channel(recording, "depth");
  if (depth == nullptr) return base::fail(base::ErrorCode::kData, place, "no channel 'depth'", "one");
  std::vector<double> time_s;
  if (const auto* const recorded = channel(recording, "time")) {
    time_s = *recorded;
  } else {
    for (std::size_t i = 0; i < depth->size(); ++i) time_s.push_back(static_cast<double>(i) / recording.sample_rate_hz);
  }
  const auto motion = speedFromPositions(time_s, *depth);
  if (!motion) return tl::unexpected(motion.error());
  constexpr double kRoundingS = 1e-9;  // time stamps are sums of steps
  const double from_s = time_s[record.first] - kRoundingS;
  const double to_s = time_s[record.last - 1] + kRoundingS;
  std::vector<double> speeds;
  for (const auto& sample : motion->samples) {
    if (sample.time_s >= from_s && sample.time_s <= to_s) speeds.push_back(sample.speed_mm_s);
  }
  if (speeds.empty()) return base::fail(base::ErrorCode::kData, place, "less than a millisecond", "a longer stroke");
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
    const auto speeds = strokeSpeeds(record);
    if (!speeds) return tl::unexpected(speeds.error());
    session.strokes.push_back(statisticsOf(record.level, record.number, 1, *speeds));
    auto level =
        std::find_if(levels.begin(), levels.end(), [&](const Level& known) { return known.id == record.level; });
    if (level == levels.end()) level = levels.insert(level, Level{record.level, 0, {}});
    ++level->strokes;
    level->speeds_mm_s.insert(level->speeds_mm_s.end(), speeds->begin(), speeds->end());
  }
  for (const auto& level : levels) {
    session.levels.push_back(statisticsOf(level.id, 0, level.strokes, level.speeds_mm_s));
  }
  return session;
}

}  // namespace tactus::experiments
