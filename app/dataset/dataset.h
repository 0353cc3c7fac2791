// A study as a data set for publication, in the layout of a standard (docs/study-export.md).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/study/records.h"

namespace tactus::dataset {

enum class Layout {
  kPsychDs,  ///< Psych-DS: the study's tables, described in one JSON-LD file
  kBids,     ///< BIDS 1.10: Motion-BIDS for strokes, `beh` for judgements and rules, `phenotype` for answers
};

struct DataSet {
  std::size_t participants = 0;
  std::size_t files = 0;
  std::vector<std::string> notes;  ///< one sentence each: what is left out
};

/// Writes `study` into `folder` as session::shareable leaves it: without codes, exact years, dates, places and notes.
/// `seed` draws the order of the participants; the receivers must not know it. `version` is that of this program. The
/// folder appears completely or not at all. It must be new, empty, or an earlier data set of the same layout, which is
/// replaced. Refused too: a study without participants.
base::Result<DataSet> writeDataSet(const study::Study& study, Layout layout, const std::string& folder,
                                   std::uint64_t seed, std::string_view version);

}  // namespace tactus::dataset
