#include "core/store/batch.h"

#include <utility>

#include "core/store/connection.h"

namespace tactus::store {

using base::ErrorCode;
using base::Result;
using State = Connection::BatchState;

Result<Batch> Batch::begin(StudyFile& file) {
  Connection& connection = file.connection();
  auto begun = guarded(connection, [&] {
    if (!connection.isWritable()) {
      refuse(ErrorCode::kIo, {}, "a study that is open for reading only", "one that is open for writing");
    }
    if (connection.batch != State::kNone) {
      refuse(ErrorCode::kIo, {}, "a batch that is not finished", "one batch at a time");
    }
    connection.beginWrite();
    connection.database().exec("BEGIN IMMEDIATE");
    connection.batch = State::kOpen;
  });
  if (!begun) return tl::unexpected(begun.error());
  return Batch(file);
}

bool isInBatch(const StudyFile& file) { return file.connection().batch == State::kOpen; }

Batch::Batch(Batch&& other) noexcept : file_(std::exchange(other.file_, nullptr)) {}

Batch::~Batch() {
  if (file_ == nullptr) return;
  Connection& connection = file_->connection();
  connection.batch = State::kNone;
  connection.database().tryExec("ROLLBACK");
}

Result<void> Batch::commit() {
  Connection& connection = file_->connection();
  auto done = guarded(connection, [&] {
    if (connection.batch == State::kSpoiled) {
      refuse(ErrorCode::kIo, {}, "a batch in which a write failed", "one in which all succeeded");
    }
    connection.countCommit();
    connection.database().exec("COMMIT");
    connection.acknowledge();
  });
  if (!done) return done;
  connection.batch = State::kNone;
  file_ = nullptr;
  return done;
}

}  // namespace tactus::store
