// The speed lab without widgets: its settings, what is computed from them, and which participants are on the page.
#pragma once

#include <QObject>
#include <QString>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/workbench/labs/data/lab_data.h"
#include "app/workbench/labs/speed/speed_clusters.h"
#include "elicitation/tracing/sources.h"

namespace tactus::workbench {

// What one stroke moves: the averaged force with and without it, as a sentence.

/// Thread: gui. The comparison runs on a thread of its own.
class StrokeInfluence : public QObject {
  Q_OBJECT

 public:
  /// `model` outlives this.
  explicit StrokeInfluence(LabModel& model, QObject* parent = nullptr);

  /// Asks about a stroke that counts; `which` is its name on the screen. Until `stop`, the answer follows the model.
  void ask(const elicitation::StrokeKey& stroke, const QString& which);
  void stop();
  const std::optional<elicitation::StrokeKey>& asked() const { return asked_; }
  /// One sentence; while it is computed, it says so; empty if nothing is asked.
  QString sentence() const;

 signals:
  void told();

 private:
  struct Asked {
    BuiltStudy built;
    elicitation::StrokeKey stroke;
    QString which;
  };

  LabModel& model_;
  std::optional<elicitation::StrokeKey> asked_;
  QString which_;
  Computed<Asked, QString> answer_;
};

/// The objective J of fuzzy C-means (paper, Eq. 1) against the iteration of the textbook's algorithm.
struct ObjectiveTrace {
  std::vector<double> objective;  ///< at the start, then after each iteration, (mm/s)²
  bool converged = false;         ///< the centers moved by less than a millionth of the data's range
};

/// Alternates memberships and centers (Bezdek 1981) from the quantiles (k + 1/2) / c of `samples`, up to 100 times. It
/// finds the nearest minimum and needs more iterations than elicitation::fuzzyCMeans, which follows J's curvature;
/// what both end at is the same where the start leads to the lowest minimum. Empty for samples that cannot be
/// clustered, or if `keep_going` says no.
ObjectiveTrace objectiveTrace(std::span<const double> samples, std::size_t clusters, double m,
                              const std::function<bool()>& keep_going);

/// Thread: gui. The clustering runs on a thread of its own.
class SpeedLab : public QObject {
  Q_OBJECT

 public:
  static constexpr std::size_t kPerPage = 4;

  /// `data` outlives this.
  explicit SpeedLab(LabData& data, QObject* parent = nullptr);

  /// Nothing is computed while the lab is hidden.
  void setSeen(bool seen) { work_.hold(*this, seen); }
  /// The newest result; null before the first one, and without a study.
  const std::shared_ptr<const SpeedResult>& result() const { return result_; }
  /// `result` has the settings of now. While a slider moves faster than the clusters, those of a moment ago are shown.
  bool isCurrent() const { return current_; }
  /// J against the iteration for the participants on the page, in their order; may be shorter while it is computed.
  const std::vector<ObjectiveTrace>& objectives() const { return objectives_; }
  Computation& work() { return work_; }
  LabData& data() { return data_; }

  const elicitation::SpeedTermSettings& settings() const { return data_.settings().speed; }
  elicitation::Averaging averaging() const { return data_.settings().averaging; }
  std::size_t clusters() const { return clusters_; }
  void setAlpha(double alpha);
  void setFuzziness(double m);
  void setTrim(double share);
  void setCentres(elicitation::SpeedCentres centres);
  void setAveraging(elicitation::Averaging averaging);
  void setDefaults();
  /// Another number than terms shows clusters alone: the model keeps one for each term.
  void setClusters(std::size_t clusters);

  std::size_t pages() const;
  std::size_t page() const { return page_; }
  void setPage(std::size_t page);
  /// The participants on the page: [first, last) of the result.
  std::pair<std::size_t, std::size_t> shown() const;

 signals:
  void resultChanged();
  /// `settings`, `averaging` or `clusters` changed.
  void settingsChanged();
  void pageChanged();

 private:
  struct Inputs {
    LabInputs from;
    std::size_t clusters = 3;
    std::size_t page = 0;
  };
  struct Found {
    std::shared_ptr<const SpeedResult> result;
    std::optional<std::vector<ObjectiveTrace>> objectives = {};  ///< once they are computed
  };
  using FoundCell = Computed<Inputs, Found>;
  static FoundCell::Answer compute(const Inputs& inputs, const RunOf<Found>& run, SpeedClusters& calculation);
  void onResult();
  template <class Change>
  void change(Change apply);

  LabData& data_;
  std::shared_ptr<const SpeedResult> result_;
  std::vector<ObjectiveTrace> objectives_;
  bool current_ = false;
  std::size_t clusters_ = 3;
  std::size_t page_ = 0;
  FoundCell work_;
};

// The recordings of strokes for the screen: speed over time around each stroke, and where the stroke was marked. They
// are read from the study when they are asked for; a few are kept.

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
  void setStrokes(const std::shared_ptr<const LabStudy>& of, std::shared_ptr<const StrokeSet> set);

  LabData& data_;
  std::deque<Kept> kept_;
};

}  // namespace tactus::workbench
