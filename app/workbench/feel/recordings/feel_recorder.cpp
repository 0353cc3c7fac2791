#include "app/workbench/feel/recordings/feel_recorder.h"

#include <algorithm>
#include <utility>

namespace tactus::workbench {

FeelRecorder::FeelRecorder(double rate_hz, const std::vector<Condition>& conditions) {
  empty_.sample_rate_hz = rate_hz;
  empty_.channels = {{"time", "s", {}},        {"position", "mm", {}},     {"speed", "mm/s", {}},
                     {"depth", "mm", {}},      {"slip_speed", "mm/s", {}}, {"stretch", "mm", {}},
                     {"model_force", "N", {}}, {"source_force", "N", {}},  {"force", "N", {}},
                     {"button", "1", {}},      {"stroke", "1", {}},        {"placement", "1", {}},
                     {"limited", "1", {}}};
  for (const Condition& condition : conditions) {
    empty_.channels.push_back({condition.id, condition.unit, {}});
    conditions_.push_back(condition.value);
  }
  piece_ = empty_;
}

bool FeelRecorder::has(const std::vector<Condition>& conditions) const {
  const auto first = empty_.channels.end() - static_cast<std::ptrdiff_t>(conditions_.size());
  return std::equal(first, empty_.channels.end(), conditions.begin(), conditions.end(),
                    [](const study::Channel& channel, const Condition& condition) {
                      return channel.name == condition.id && channel.unit == condition.unit;
                    });
}

void FeelRecorder::add(const haptics::Sample& sample, double depth_mm, int placement) {
  if (!start_ns_) start_ns_ = sample.time_ns;
  last_tick_ = sample.tick;
  length_s_ = static_cast<double>(sample.time_ns - *start_ns_) * 1e-9;
  auto channel = piece_.channels.begin();
  const auto put = [&](double value) { (channel++)->values.push_back(value); };
  put(length_s_);
  put(sample.position_mm);
  put(sample.speed_mm_s);
  put(depth_mm);
  put(sample.slip_speed_mm_s);
  put(sample.stretch_mm);
  put(sample.model_force_n);
  put(sample.source_force_n);
  put(sample.force_n);
  put(sample.enabled ? 1 : 0);
  put(sample.stroke);
  put(placement);
  put(sample.limited);
  for (const double value : conditions_) put(value);
}

double FeelRecorder::pieceS() const {
  return piece_.size() == 0 ? 0 : length_s_ - piece_.channels.front().values.front();
}

std::optional<study::Recording> FeelRecorder::takePiece() {
  if (piece_.size() == 0) return std::nullopt;
  return std::exchange(piece_, empty_);
}

const std::vector<double>* channelOf(const study::Recording& recording, const std::string& name) {
  for (const study::Channel& channel : recording.channels) {
    if (channel.name == name) return &channel.values;
  }
  return nullptr;
}

}  // namespace tactus::workbench
