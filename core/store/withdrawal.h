// The one way in which records leave a study: a participant takes back their consent.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/store/study_file.h"

namespace tactus::store {

/// A participant who withdrew: no more is known.
struct Tombstone {
  study::RecordId person;
  std::int64_t utc_ms = 0;

  bool operator==(const Tombstone&) const = default;
};

struct Withdrawal {
  long long records = 0;            ///< removed, sessions and the person counted
  std::vector<std::string> copies;  ///< files beside the study that were made before a migration and may hold the data
};

/// Removes everything of the person in one transaction and leaves a tombstone, so that no merge brings the data back;
/// then rewrites the file and empties its journal, so that nothing is left in unused pages. Models that were built with
/// the data stay, and so do copies elsewhere. Where the rewriting fails (disk full), the records are removed and the
/// error says that `eraseTraces` is to be done again.
base::Result<Withdrawal> withdraw(StudyFile& file, const study::RecordId& person, std::int64_t utc_ms);

/// The second half of `withdraw`, for when it failed.
base::Result<void> eraseTraces(StudyFile& file);

base::Result<std::vector<Tombstone>> tombstones(const StudyFile& file);

}  // namespace tactus::store
