// The one way in which records leave a study: a participant takes back their consent.
#pragma once

#include <cstdint>
#include <optional>
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
  long long records = 0;  ///< removed, sessions and the person counted
  long long models = 0;   ///< versions of models that were cleaned of the person's rules and code
  /// Codes that another person of the file has or had too: texts and models in which they stand were left as they are.
  std::vector<std::string> shared_codes;
};

/// Removes everything of the person in one transaction: their records, their rules and code in all model versions, and
/// their code in what others wrote (`(withdrawn)` stands there instead). A tombstone stays, with salted hashes of the
/// person's codes, so that no entry, import or merge brings the data back. Then `eraseTraces`; where that fails or is
/// interrupted the records are removed and the error says that `erase` is to be done. Copies elsewhere are not
/// reached: copies.h names those that can be found.
base::Result<Withdrawal> withdraw(StudyFile& file, const study::RecordId& person, std::int64_t utc_ms);

/// The second half of `withdraw`: rewrites the file and empties its journal, so that nothing is left in unused pages,
/// and notes that the erasure is finished. Memory does not grow with the study; on the disk two more copies of it need
/// room meanwhile. Can be interrupted at any point and done again.
base::Result<void> eraseTraces(StudyFile& file);

struct Erasure {
  std::vector<study::RecordId> unfinished;  ///< whose erasure was not finished before
  long long models = 0;                     ///< versions that still named somebody who withdrew, and were cleaned
};

/// Does again what an interrupted withdrawal left undone: cleans models that name somebody who withdrew (by the hashes
/// of the tombstones), and erases the traces, also where nothing says that it is needed.
base::Result<Erasure> erase(StudyFile& file);

/// Whose erasure is not finished.
base::Result<std::vector<study::RecordId>> unfinishedErasures(const StudyFile& file);

/// By time and person.
base::Result<std::vector<Tombstone>> tombstones(const StudyFile& file);

/// When the participant who had this code withdrew, or nothing. What an older version removed left no code to compare.
base::Result<std::optional<Tombstone>> withdrawnWithCode(const StudyFile& file, const std::string& code);

}  // namespace tactus::store
