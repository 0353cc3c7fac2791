// Turns the samples of the servo into the channels of a recording (docs/study-file.md, "Feeling a model").
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/haptics/servo/sample.h"
#include "core/study/session_records.h"

namespace tactus::workbench {

class FeelRecorder {
 public:
  /// An input of the model that is a condition of tube or patient.
  struct Condition {
    std::string id;
    std::string unit;
    double value = 0;
  };

  /// The first sample that is added is time 0. `rate_hz`: of the servo.
  FeelRecorder(double rate_hz, const std::vector<Condition>& conditions);

  /// Whether these are the conditions that it began with, in other values.
  bool has(const std::vector<Condition>& conditions) const;
  /// From the next sample on; as many as at the beginning.
  void setConditions(const std::vector<double>& values) { conditions_ = values; }
  /// Whether samples of the servo between the last one that was added and `next` are missing.
  bool isGapBefore(const haptics::Sample& next) const { return last_tick_ && next.tick != *last_tick_ + 1; }
  /// `depth_mm` as the model counts it; `placement` from 1.
  void add(const haptics::Sample& sample, double depth_mm, int placement);

  /// Seconds since the first sample.
  double lengthS() const { return length_s_; }
  /// Seconds since the last piece was taken.
  double pieceS() const;
  /// What was added since the last call; the time goes on from piece to piece. Nothing where that was nothing.
  std::optional<study::Recording> takePiece();

 private:
  study::Recording empty_;  ///< the channels without samples
  study::Recording piece_;
  std::vector<double> conditions_;
  std::optional<std::int64_t> start_ns_;
  std::optional<std::uint64_t> last_tick_;
  double length_s_ = 0;
};

/// The values of the channel `name`; null where there is none.
const std::vector<double>* channelOf(const study::Recording& recording, const std::string& name);

}  // namespace tactus::workbench
