// The reference curves over the plot, and the difference between the model and each of them.
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/workbench/model/open_model.h"
#include "core/base/error.h"
#include "core/fuzzy/force_model.h"

namespace tactus::procedure {
struct Procedure;
}

namespace tactus::workbench {

/// A reference curve: a force curve from another source (another method, a measurement) to compare with the model.
struct ReferenceCurve {
  QString file;                 ///< path; empty: of the procedure's pack
  QString name;                 ///< name of the series; without series the name of the file
  std::string input;            ///< id of the input on the x axis
  std::vector<double> x;        ///< ascending, in the unit of the input
  std::vector<double> force_n;  ///< one per place; NaN: a gap
  std::size_t color = 0;        ///< index of its color (referencePen)
};

/// Limits of a file; a larger file is refused.
inline constexpr std::size_t kMostReferences = 6;
inline constexpr std::size_t kMostReferencePoints = 100'000;

/// Reads the CSV file `path`. It needs one column named after an input of `model` (`depth` or `depth_mm`) and one
/// column of the force (`force` or `force_n`). An optional column `series` holds the name of the curve of each row. The
/// places of a series ascend; an empty force is a gap. Other columns are ignored. Refused: no column of an input or
/// several, no column of the force, places that do not ascend, a curve of fewer than two points, a file above the
/// limits.
base::Result<std::vector<ReferenceCurve>> readReferences(const QString& path, const fuzzy::ForceModel& model);

/// A curve of the model at ascending places.
struct SampledForce {
  std::span<const double> x;
  std::span<const double> force_n;  ///< NaN if no rule fires
};

/// The difference between a curve of the model and a reference, where both have a force.
struct ReferenceDifference {
  double rms_n = 0;
  double largest_n = 0;   ///< |difference|
  double largest_at = 0;  ///< its place on the x axis
  double from = 0;        ///< the compared range; gaps inside it are left out
  double to = 0;
};

/// Compares `force` with `reference`. Both are taken as straight between their points; `force` must include the places
/// of both curves. The mean square is an integral over the range: the mean of (d0^2 + d0 d1 + d1^2) / 3 over the
/// pieces. So it does not depend on the sampling of the reference. Nothing if the two have no piece in common.
std::optional<ReferenceDifference> compare(const ReferenceCurve& reference, const SampledForce& force);

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
  /// Adds the forces that others published of the procedure of the model, as flat lines over their stretch of the way:
  /// one for each end of a range. Ends with `changed` or `refused`.
  void addPublished(const procedure::Procedure& procedure);
  /// Adds `curves`; those with the same names are replaced. Ends with `changed` or `refused`. `from`: where they come
  /// from, for the sentence.
  void add(std::vector<ReferenceCurve> curves, const QString& from);
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
