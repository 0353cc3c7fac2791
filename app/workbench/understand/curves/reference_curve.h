// A curve of the force from elsewhere, to be laid over those of the model: another method, a measurement.
#pragma once

#include <QString>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

struct ReferenceCurve {
  QString file;                 ///< path
  QString name;                 ///< of the series, or of the file where it has no series
  std::string input;            ///< id of the input on the x axis
  std::vector<double> x;        ///< ascending, in the unit of the input
  std::vector<double> force_n;  ///< one per place; NaN: a gap
  std::size_t color = 0;        ///< number of its color (referencePen)
};

/// Limits of a file: more is refused.
inline constexpr std::size_t kMostReferences = 6;
inline constexpr std::size_t kMostReferencePoints = 100'000;

/// Reads the CSV file `path`: a column named after an input of `model` (`depth` or `depth_mm`), a column of the force
/// (`force` or `force_n`), and optionally `series` with the name of the curve that a row belongs to. The places of a
/// series ascend; an empty force is a gap. Further columns are passed over. Refused: none or several columns of inputs,
/// no column of the force, places that do not ascend, a curve of fewer than two points, more than the limits.
base::Result<std::vector<ReferenceCurve>> readReferences(const QString& path, const fuzzy::ForceModel& model);

/// A curve of the model at ascending places.
struct SampledForce {
  std::span<const double> x;
  std::span<const double> force_n;  ///< NaN where no rule fires
};

/// How far a curve of the model is from a reference where both have a force.
struct ReferenceDifference {
  double rms_n = 0;
  double largest_n = 0;   ///< |difference|
  double largest_at = 0;  ///< where on the x axis
  double from = 0;        ///< range that was compared, gaps inside it left out
  double to = 0;
};

/// The reference runs straight between its points. `force` holds the places of both curves at least, and between two of
/// them it counts as straight too, so that the root of the mean square is an integral over the range and does not
/// depend on how densely the reference was sampled: the mean of (d0^2 + d0 d1 + d1^2) / 3 over the pieces. Nothing
/// where the two have no piece in common.
std::optional<ReferenceDifference> compare(const ReferenceCurve& reference, const SampledForce& force);

}  // namespace tactus::workbench
