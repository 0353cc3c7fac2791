// Many writes in one transaction, for imports and simulated studies.
#pragma once

#include "core/base/error.h"

namespace tactus::store {

class StudyFile;

/// While a batch is open, all writes to its file belong to it: they are acknowledged by `commit`, all or none.
/// One at a time; it must not outlive the file. A session with a person writes without a batch, one commit per record.
class Batch {
 public:
  static base::Result<Batch> begin(StudyFile& file);

  Batch(Batch&& other) noexcept;
  Batch& operator=(Batch&&) = delete;
  /// Takes back what was not committed.
  ~Batch();

  /// Commits and syncs; an error, and nothing written, where one of the writes failed.
  base::Result<void> commit();

 private:
  explicit Batch(StudyFile& file) : file_(&file) {}

  StudyFile* file_;
};

/// Whether writes to the file go into a batch now.
bool isInBatch(const StudyFile& file);

/// Runs `work`, which returns a Result<void>, so that all its writes are committed or none: in a batch of its own, or
/// as a part of the one that is open.
template <class Work>
base::Result<void> inOneBatch(StudyFile& file, Work work) {
  if (isInBatch(file)) return work();
  auto batch = Batch::begin(file);
  if (!batch) return tl::unexpected(batch.error());
  if (auto done = work(); !done) return done;
  return batch->commit();
}

}  // namespace tactus::store
