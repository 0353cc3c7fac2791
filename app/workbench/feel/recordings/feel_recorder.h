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
  /// An input of the model that is a condition of the tube or the patient.
  struct Condition {
    std::string id;
    std::string unit;
    double value = 0;
  };

  /// The first added sample is time 0. `rate_hz`: rate of the servo.
  FeelRecorder(double rate_hz, const std::vector<Condition>& conditions);

  /// Whether `conditions` are the recorder's conditions, with any values.
  bool has(const std::vector<Condition>& conditions) const;
  /// Sets the values from the next sample on; as many values as conditions.
  void setConditions(const std::vector<double>& values) { conditions_ = values; }
  /// Whether servo samples between the last added sample and `next` are missing.
  bool isGapBefore(const haptics::Sample& next) const { return last_tick_ && next.tick != *last_tick_ + 1; }
  /// Adds a sample. `depth_mm` in the coordinates of the model; `placement` counts from 1.
  void add(const haptics::Sample& sample, double depth_mm, int placement);

  /// Seconds since the first sample.
  double lengthS() const { return length_s_; }
  /// Seconds since the end of the last piece.
  double pieceS() const;
  /// The samples added since the last call, or nothing. Times continue from piece to piece.
  std::optional<study::Recording> takePiece();

 private:
  study::Recording empty_;  ///< the channels without samples
  study::Recording piece_;
  std::vector<double> conditions_;
  std::optional<std::int64_t> start_ns_;
  std::optional<std::uint64_t> last_tick_;
  double length_s_ = 0;
};

/// The values of the channel `name`; null if there is none.
const std::vector<double>* channelOf(const study::Recording& recording, const std::string& name);

}  // namespace tactus::workbench
