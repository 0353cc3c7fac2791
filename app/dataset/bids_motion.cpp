// Strokes as Motion-BIDS: numbers without a header, a description and a table of channels beside them.
#include <cmath>
#include <map>
#include <tuple>

#include "app/dataset/bids.h"
#include "app/dataset/sidecar.h"
#include "app/dataset/tsv.h"
#include "core/base/text.h"

namespace tactus::dataset {
namespace {

constexpr std::string_view kTask = "insertion";

/// Where strokes on a device without force are among the data, they are accepted.
std::string_view systemOf(const study::Participant& participant) {
  return participant.virtual_device ? "virtual" : "stylus";
}

using Stroke = std::vector<const study::SpeedSample*>;
using StrokeKey = std::tuple<std::string, std::string, int>;  ///< participant, level, number

std::map<StrokeKey, Stroke> strokesOf(const study::Study& study) {
  std::map<StrokeKey, Stroke> strokes;
  for (const auto& sample : study.speeds) strokes[{sample.participant, sample.level, sample.stroke}].push_back(&sample);
  return strokes;
}

/// The mean rate in Hz, rounded to a millionth; 0 where the times do not tell it.
double rateOf(const Stroke& stroke) {
  const double length_s = stroke.back()->time_s - stroke.front()->time_s;
  if (stroke.size() < 2 || !(length_s > 0)) return 0;
  return std::round(static_cast<double>(stroke.size() - 1) / length_s * 1e6) / 1e6;
}

std::string samplesText(const Stroke& stroke) {
  TsvWriter table;
  for (const auto* sample : stroke) {
    std::vector<std::string> cells = {base::formatNumber(sample->time_s), base::formatNumber(sample->depth_mm),
                                      base::formatNumber(sample->speed_mm_s)};
    table.row(sample == stroke.front() ? differentTexts(std::move(cells)) : cells);
  }
  return table.text();
}

std::string channelsText() {
  TsvWriter table({"name", "component", "type", "tracked_point", "units"});
  table.row({"time_s", "", "LATENCY", "tube", "s"});
  table.row({"depth_mm", "", "POS", "tube", "mm"});
  table.row({"speed_mm_s", "", "VEL", "tube", "mm/s"});
  return table.text();
}

std::string motionText(const std::string& level, double rate_hz, const study::Participant& participant) {
  Sidecar sidecar;
  sidecar.member("TaskName", kTask);
  // The validator for Node refuses members of our own here.
  sidecar.member("TaskDescription",
                 "Push a tube forward in one stroke; the speed that was asked for: " + level +
                     (participant.simulated ? ". Simulated by a program, not measured" : "") +
                     (participant.virtual_device ? ". VIRTUAL: on a device that gives no force" : ""));
  sidecar.member("SamplingFrequency", rate_hz);
  sidecar.member("TrackingSystemName", systemOf(participant));
  sidecar.member("RecordingType", "continuous");
  sidecar.member("MotionChannelCount", 3.0).member("TrackedPointsCount", 1.0);
  sidecar.member("POSChannelCount", 1.0).member("VELChannelCount", 1.0).member("LATENCYChannelCount", 1.0);
  return sidecar.text();
}

std::string twoDigits(int number) { return (number < 10 ? "0" : "") + std::to_string(number); }

}  // namespace

std::vector<std::string> writeMotion(const PublishedStudy& published, FileSet& files) {
  std::map<std::string, const study::Participant*> people;
  for (const auto& participant : published.study().participants) people[participant.code] = &participant;
  Labels levels;
  std::size_t left_out = 0;
  for (const auto& [key, stroke] : strokesOf(published.study())) {
    const auto& [participant, level, number] = key;
    const double rate_hz = rateOf(stroke);
    if (rate_hz <= 0) {
      ++left_out;
      continue;
    }
    const std::string path = subject(participant) + "/motion/" + subject(participant) + "_task-" + std::string(kTask) +
                             "_tracksys-" + std::string(systemOf(*people.at(participant))) + "_acq-" +
                             levels.of(level) + "_run-" + twoDigits(number) + '_';
    files.add(path + "motion.tsv", samplesText(stroke));
    files.add(path + "motion.json", motionText(level, rate_hz, *people.at(participant)));
    files.add(path + "channels.tsv", channelsText());
  }
  if (left_out == 0) return {};
  return {std::to_string(left_out) + (left_out == 1 ? " stroke is" : " strokes are") +
          " left out: a single sample, or no time between the samples, gives no sampling frequency."};
}

}  // namespace tactus::dataset
