// A reference curve or band from a CSV table.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/analysis/pull/pull_curve.h"
#include "core/base/error.h"
#include "core/fuzzy/force_model.h"

namespace tactus::cli {

struct ReadReference {
  analysis::ReferenceCurve curve;
  std::vector<std::string> warnings;
};

/// Reads the file `path`: columns named after inputs, with or without their unit (`depth`, `depth_mm`; at least one,
/// the others are at their values in `point`), and the output in the same way, or a band by `force_min`, `force_max` or
/// both. Rows without a force are gaps. At most 10,000 rows.
base::Result<ReadReference> readReference(const std::string& path, const fuzzy::ForceModel& model,
                                          std::span<const double> point);

}  // namespace tactus::cli
