#include "app/cli/speeds_text.h"

#include <algorithm>

#include "core/base/text.h"

namespace tactus::cli {
namespace {

using base::formatFixed;
using base::JsonWriter;
using elicitation::Interval;
using elicitation::ParticipantSpeeds;
using elicitation::RampInterval;
using elicitation::SpeedIntervals;
using elicitation::StudySpeedIntervals;

std::string fixed1(double value) { return formatFixed(value, 1); }

std::string withInterval(double value, const Interval* interval) {
  if (interval == nullptr) return fixed1(value);
  return fixed1(value) + " [" + fixed1(interval->low) + ", " + fixed1(interval->high) + "]";
}

std::string shortProbability(double p) { return formatFixed(p, p < 0.001 ? 6 : 3); }

std::string participantAsText(const ParticipantSpeeds& one, const SpeedIntervals* intervals) {
  const auto& found = one.diagnostics;
  std::string text = "speeds of " + base::oneLine(one.participant) + ": " + std::to_string(one.kept) + " of " +
                     std::to_string(one.samples) + " samples\n";
  for (std::size_t k = 0; k < found.levels.size(); ++k) {
    const auto& level = found.levels[k];
    text += "  " + base::oneLine(level.level);
    text += level.samples == 0 ? " no strokes"
                               : " " + fixed1(level.mean_mm_s) + " ± " + fixed1(level.sd_mm_s) + " mm/s, strokes " +
                                     std::to_string(level.stroke_means_mm_s.size());
    text += "; center " + withInterval(one.centres[k], intervals == nullptr ? nullptr : &intervals->centres[k]);
    if (k < found.separations.size() && found.separations[k]) {
      text += "; d' to the next level " + formatFixed(*found.separations[k], 2);
    }
    text += '\n';
  }
  if (found.trend) {
    text += "  order of the levels: Jonckheere-Terpstra J " + base::formatNumber(found.trend->j) + " of " +
            base::formatNumber(found.trend->most_j) + ", p " + shortProbability(found.trend->p) +
            (found.trend->exact ? " (exact)\n" : " (normal approximation)\n");
  }
  return text + "  nearest center against level: adjusted Rand index " +
         formatFixed(found.confusion.adjusted_rand_index, 2) + ", accuracy " +
         formatFixed(found.confusion.accuracy, 2) + '\n';
}

void writeInterval(const Interval& interval, JsonWriter& json) {
  json.beginArray(JsonWriter::Layout::kInline).value(interval.low).value(interval.high).endArray();
}

void writeRamps(std::string_view key, const std::vector<elicitation::Ramp>& ramps,
                const std::vector<RampInterval>* intervals, JsonWriter& json) {
  json.key(key).beginArray();
  for (std::size_t k = 0; k < ramps.size(); ++k) {
    json.beginObject(JsonWriter::Layout::kInline).key("p").value(ramps[k].p).key("q").value(ramps[k].q);
    json.key("p_interval");
    intervals == nullptr ? static_cast<void>(json.null()) : writeInterval((*intervals)[k].p, json);
    json.key("q_interval");
    intervals == nullptr ? static_cast<void>(json.null()) : writeInterval((*intervals)[k].q, json);
    json.endObject();
  }
  json.endArray();
}

void writeLevels(const ParticipantSpeeds& one, JsonWriter& json) {
  json.key("levels").beginArray();
  for (const auto& level : one.diagnostics.levels) {
    json.beginObject(JsonWriter::Layout::kInline).key("level").value(level.level);
    json.key("strokes").value(level.stroke_means_mm_s.size()).key("samples").value(level.samples);
    json.key("mean_mm_s").value(level.mean_mm_s).key("sd_mm_s").value(level.sd_mm_s).endObject();
  }
  json.endArray().key("separations").beginArray(JsonWriter::Layout::kInline);
  for (const auto& separation : one.diagnostics.separations) {
    separation ? json.value(*separation) : json.null();
  }
  json.endArray().key("jonckheere_terpstra");
  if (const auto& trend = one.diagnostics.trend) {
    json.beginObject(JsonWriter::Layout::kInline).key("j").value(trend->j).key("most_j").value(trend->most_j);
    json.key("p").value(trend->p).key("exact").value(trend->exact).endObject();
  } else {
    json.null();
  }
}

void writeParticipant(const ParticipantSpeeds& one, const SpeedIntervals* intervals, JsonWriter& json) {
  const auto& confusion = one.diagnostics.confusion;
  json.beginObject().key("participant").value(one.participant).key("simulated").value(one.simulated);
  json.key("samples").value(one.samples).key("kept").value(one.kept);
  writeLevels(one, json);
  json.key("confusion").beginArray(JsonWriter::Layout::kInline);
  for (const auto& row : confusion.counts) {
    json.beginArray(JsonWriter::Layout::kInline);
    for (const std::size_t count : row) json.value(count);
    json.endArray();
  }
  json.endArray().key("adjusted_rand_index").value(confusion.adjusted_rand_index);
  json.key("accuracy").value(confusion.accuracy).key("centres").values(one.centres).key("centre_intervals");
  if (intervals == nullptr) {
    json.null();
  } else {
    json.beginArray(JsonWriter::Layout::kInline);
    for (const auto& interval : intervals->centres) writeInterval(interval, json);
    json.endArray();
  }
  writeRamps("ramps", one.ramps, intervals == nullptr ? nullptr : &intervals->ramps, json);
  json.endObject();
}

const SpeedIntervals* intervalsOf(const std::optional<StudySpeedIntervals>& intervals, std::size_t who) {
  return intervals ? &intervals->participants[who] : nullptr;
}

}  // namespace

std::optional<StudySpeedIntervals> speedIntervals(const study::Study& study, const elicitation::BuiltModel& built,
                                                  const elicitation::BuildSettings& settings, std::size_t replicates,
                                                  std::string& note) {
  if (replicates == 0 || built.speeds.empty()) return std::nullopt;
  auto bootstrap = elicitation::SpeedBootstrap::of(study, built, settings);
  if (!bootstrap) {
    note = "There are no intervals of the speeds: " + bootstrap.error().message() + ".";
    return std::nullopt;
  }
  bootstrap->add(replicates);
  return bootstrap->intervals();
}

std::string speedsAsText(const elicitation::BuiltModel& built, const std::optional<StudySpeedIntervals>& intervals) {
  if (built.speeds.empty()) return {};
  std::string text;
  for (std::size_t who = 0; who < built.speeds.size(); ++who) {
    text += participantAsText(built.speeds[who], intervalsOf(intervals, who));
  }
  text += "averaged ramps:";
  for (std::size_t k = 0; k < built.averaged_ramps.size(); ++k) {
    const RampInterval* interval = intervals ? &intervals->averaged[k] : nullptr;
    text += (k == 0 ? " " : "; ") +
            withInterval(built.averaged_ramps[k].p, interval == nullptr ? nullptr : &interval->p) + " to " +
            withInterval(built.averaged_ramps[k].q, interval == nullptr ? nullptr : &interval->q);
  }
  text += " mm/s\n";
  if (intervals) {
    text += "in brackets: 95 % intervals (Student's t, standard deviation of " + std::to_string(intervals->replicates) +
            " draws of whole strokes)\n";
  }
  return text;
}

void writeSpeeds(const elicitation::BuiltModel& built, const std::optional<StudySpeedIntervals>& intervals,
                 JsonWriter& json) {
  json.key("speeds").beginObject().key("replicates").value(intervals ? intervals->replicates : std::size_t{0});
  json.key("interval_method").value(elicitation::kIntervalMethod).key("coverage").value(elicitation::kCoverage);
  json.key("participants").beginArray();
  for (std::size_t who = 0; who < built.speeds.size(); ++who) {
    writeParticipant(built.speeds[who], intervalsOf(intervals, who), json);
  }
  json.endArray();
  writeRamps("averaged_ramps", built.averaged_ramps, intervals ? &intervals->averaged : nullptr, json);
  json.endObject();
}

}  // namespace tactus::cli
