// A short weighted stand-in for many samples (part of fcm.h).
#pragma once

#include <cstddef>
#include <vector>

#include "elicitation/clustering/fcm_data.h"

namespace tactus::elicitation {

/// Scaled values, ascending and distinct, with the weight of the samples that each stands for.
struct FcmEntries {
  std::vector<double> values;
  std::vector<double> weights;
  bool exact = false;  ///< no samples of different value were joined

  std::size_t size() const { return values.size(); }
  /// For the passes; the entries must stay where they are.
  FcmData view() const;
};

/// Short data and data of few distinct values (quantised speeds) become exact entries: equal values are joined. Other
/// data become a histogram whose entries are the means of narrow bins: of equal width around the median, of equal
/// proportion further out, so that an outlier takes no room from the rest. One or two reads of the data; at most
/// 65,536 bins, about 2 MB.
FcmEntries condense(const FcmData& data);

/// At most about `most` entries: means of runs that are narrow and light, so that an outlier keeps a place of its own.
FcmEntries coarser(const FcmEntries& entries, std::size_t most);

}  // namespace tactus::elicitation
