// Many writes in one transaction, for imports and simulated studies.
#pragma once

#include "core/base/error.h"

namespace tactus::store {

class StudyFile;

/// While a batch is open, all writes to its file belong to it. `commit` acknowledges them, all or none. One batch at a
/// time; it must not outlive the file. A session with a participant writes without a batch, one commit per record.
class Batch {
 public:
  static base::Result<Batch> begin(StudyFile& file);

  Batch(Batch&& other) noexcept;
  Batch& operator=(Batch&&) = delete;
  /// Rolls back uncommitted writes.
  ~Batch();

  /// Commits and syncs. If one of the writes failed, returns an error and writes nothing.
  base::Result<void> commit();

 private:
  explicit Batch(StudyFile& file) : file_(&file) {}

  StudyFile* file_;
};

/// Whether writes to the file currently go into a batch.
bool isInBatch(const StudyFile& file);

/// Runs `work`, which returns a Result<void>, so that all its writes are committed or none. Uses the open batch, or
/// else a batch of its own.
template <class Work>
base::Result<void> inOneBatch(StudyFile& file, Work work) {
  if (isInBatch(file)) return work();
  TACTUS_TRY(auto batch, Batch::begin(file));
  if (auto done = work(); !done) return done;
  return batch.commit();
}

}  // namespace tactus::store
