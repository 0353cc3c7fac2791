// Converts SQLite's errors to one sentence for the user. Private to core/store.
#pragma once

#include <SQLiteCpp/Exception.h>
#include <string>

#include "core/base/error.h"

namespace tactus::store {

/// Thrown inside core/store only, like SQLiteCpp's exceptions. `guarded` (connection.h) converts both to a Result.
struct Refusal {
  base::Error error;
};

[[noreturn]] void refuse(base::ErrorCode code, std::string place, std::string found, std::string wanted);

/// SQLite's report of a failure on a study file.
struct SqliteFailure {
  int code = 0;           ///< extended result code
  int system_errno = 0;   ///< of the last failed system call, or 0
  std::string what = {};  ///< SQLite's own words
};

/// `system_errno`: pass it if the connection still exists to give it.
SqliteFailure failureOf(const SQLite::Exception& exception, int system_errno = 0);

/// The error about `path` for a failure of SQLite.
base::Error describeFailure(const std::string& path, const SqliteFailure& failure);

/// The error if the file or its folder prevents writing; else an error with an empty `found`.
base::Error whyNotWritable(const std::string& path);

}  // namespace tactus::store
