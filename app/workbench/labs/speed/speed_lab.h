// The speed lab without widgets: its settings, what is computed from them, and which participants are on the page.
#pragma once

#include <QObject>
#include <atomic>
#include <cstddef>
#include <memory>
#include <utility>

#include "app/workbench/labs/data/lab_work.h"
#include "app/workbench/labs/speed/objective_trace.h"
#include "app/workbench/labs/speed/speed_clusters.h"
#include "app/workbench/labs/speed/speed_result.h"

namespace tactus::workbench {

/// Thread: gui. The clustering runs on a thread of its own.
class SpeedLab : public QObject {
  Q_OBJECT

 public:
  static constexpr std::size_t kPerPage = 4;

  /// `data` outlives this.
  explicit SpeedLab(LabData& data, QObject* parent = nullptr);

  /// Nothing is computed while the lab is hidden.
  void setSeen(bool seen) { work_.setWanted(seen); }
  /// The newest result; null before the first one, and without a study.
  const std::shared_ptr<const SpeedResult>& result() const { return result_; }
  /// `result` has the settings of now. While a slider moves faster than the clusters, those of a moment ago are shown.
  bool isCurrent() const { return current_; }
  /// J against the iteration for the participants on the page, in their order; may be shorter while it is computed.
  const std::vector<ObjectiveTrace>& objectives() const { return objectives_; }
  LabWork& work() { return work_; }
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
  LabWork::Deliver compute(const LabWork::Run& run);
  void take(std::shared_ptr<const SpeedResult> result, bool current);
  template <class Change>
  void change(Change apply);

  LabData& data_;
  std::shared_ptr<const SpeedResult> result_;
  std::vector<ObjectiveTrace> objectives_;
  bool current_ = false;
  std::size_t clusters_ = 3;
  std::size_t page_ = 0;
  std::atomic<std::size_t> wanted_clusters_{3};  ///< read by the work, as the next one
  std::atomic<std::size_t> wanted_page_{0};
  SpeedClusters calculation_;  ///< of the work's thread alone
  LabWork work_;               ///< last: its end waits for the work, which answers to all above
};

}  // namespace tactus::workbench
