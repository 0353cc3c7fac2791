// The recordings of strokes for the screen: speed over time around each stroke, and where the stroke was marked. They
// are read from the study when they are asked for; a few are kept.
#pragma once

#include <QObject>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "app/workbench/labs/data/lab_data.h"

namespace tactus::workbench {

struct StrokeTrace {
  study::StrokeRecord record;     ///< without its recording
  std::vector<double> time_s;     ///< of each sample of the recording, from 0
  std::vector<float> speed_mm_s;  ///< at `speed_time_s`
  std::vector<double> speed_time_s;
  std::string failure;  ///< one sentence: why it has no speeds

  double durationS() const { return time_s.empty() ? 0 : time_s.back(); }
  /// The time of a mark: of sample `index`, or the end.
  double timeOf(std::size_t index) const;
  /// The sample nearest to `time_s`.
  std::size_t sampleAt(double time_s) const;
};

/// The strokes of one participant at one level: without practice, accepted or left out by the researcher.
struct StrokeSet {
  std::string participant;
  std::string level;
  std::vector<StrokeTrace> strokes;  ///< by number
};

/// Thread: gui.
class StrokeTraces : public QObject {
  Q_OBJECT

 public:
  /// `data` outlives this.
  explicit StrokeTraces(LabData& data, QObject* parent = nullptr);

  /// The set, or null while it is read; then `arrived` follows. After a change of the study the old set stays until
  /// the new one has come.
  std::shared_ptr<const StrokeSet> strokes(const std::string& participant, const std::string& level);

 signals:
  void arrived();

 private:
  struct Kept {
    std::string participant;
    std::string level;
    std::shared_ptr<const LabStudy> of;
    std::shared_ptr<const StrokeSet> set;
    bool reading = false;
  };
  void read(Kept& kept);
  void take(const std::shared_ptr<const LabStudy>& of, std::shared_ptr<const StrokeSet> set);

  LabData& data_;
  std::deque<Kept> kept_;
};

}  // namespace tactus::workbench
