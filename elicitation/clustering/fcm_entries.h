// A short weighted substitute for many samples (part of fcm.h).
#pragma once

#include <cstddef>
#include <vector>

#include "elicitation/clustering/fcm_data.h"

namespace tactus::elicitation {

/// Scaled values, ascending and distinct, each with the total weight of its samples.
struct FcmEntries {
  std::vector<double> values;
  std::vector<double> weights;
  bool exact = false;  ///< no samples of different value were joined

  std::size_t size() const { return values.size(); }
  /// The entries as data for the passes. The entries must stay in place.
  FcmData view() const;
};

/// Makes entries. Short data, and data with few distinct values (quantized speeds), give exact entries: equal values
/// are joined. Other data give a histogram; its entries are the means of narrow bins. The bins have equal width around
/// the median and equal proportion further out, so that an outlier does not widen the others. Reads the data once or
/// twice. At most 65,536 bins, about 2 MB.
FcmEntries condense(const FcmData& data);

/// About `most` entries or fewer: means of narrow, light runs, so that an outlier keeps its own entry.
FcmEntries coarser(const FcmEntries& entries, std::size_t most);

}  // namespace tactus::elicitation
