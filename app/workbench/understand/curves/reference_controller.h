// The reference curves over the plot, and the difference between the model and each of them.
#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/workbench/model/open_model.h"
#include "app/workbench/understand/curves/reference_curve.h"

namespace tactus::workbench {

class SceneController;

/// Thread: gui.
class ReferenceController : public QObject {
  Q_OBJECT

 public:
  explicit ReferenceController(const SceneController& scene, QObject* parent = nullptr);

  /// All open curves, also those for another input than the one on the x axis.
  const std::vector<ReferenceCurve>& all() const { return references_; }
  /// The curves for the input on the x axis, in the same order.
  std::vector<ReferenceCurve> shown() const;

  /// The expert to compare with; nothing: the mean.
  std::optional<std::size_t> expert() const { return expert_; }
  /// For each shown curve the difference to the current curve of the model. Computed at the first call after a change.
  /// Nothing if the two have no range in common.
  const std::vector<std::optional<ReferenceDifference>>& differences() const;
  /// `RMS 0.043 N · largest 0.12 N at 92 mm · over 0 to 150 mm`.
  QString differenceText(const std::optional<ReferenceDifference>& difference) const;

 public slots:
  /// Adds the curves of the CSV file `path`; curves with the same names are replaced. Ends with `changed` or `refused`.
  /// A model must be open.
  void open(const QString& path);
  void remove(const QString& name);
  void setExpert(std::optional<std::size_t> expert);

 signals:
  void changed();
  /// One sentence: what, where, what was found, what was wanted.
  void refused(const QString& sentence);

 private:
  void adoptModel();
  void drop();
  std::optional<ReferenceDifference> differenceOf(const ReferenceCurve& reference) const;

  const SceneController& scene_;
  std::vector<ReferenceCurve> references_;
  std::optional<std::size_t> expert_;
  std::string expert_id_;  ///< empty: the mean
  mutable std::optional<std::vector<std::optional<ReferenceDifference>>> differences_;
};

}  // namespace tactus::workbench
