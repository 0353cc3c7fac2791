// Turns what SQLite refuses into one sentence for the person. Private to core/store.
#pragma once

#include <SQLiteCpp/Exception.h>
#include <string>

#include "core/base/error.h"

namespace tactus::store {

/// Thrown inside core/store only, where SQLiteCpp throws too; `guarded` (connection.h) turns both into a Result.
struct Refusal {
  base::Error error;
};

[[noreturn]] void refuse(base::ErrorCode code, std::string place, std::string found, std::string wanted);

/// What SQLite said while it worked on a study file.
struct SqliteFailure {
  int code = 0;           ///< extended result code
  int system_errno = 0;   ///< of the last failed system call, or 0
  std::string what = {};  ///< SQLite's own words
};

/// `system_errno`: where the connection is there to be asked for it.
SqliteFailure failureOf(const SQLite::Exception& exception, int system_errno = 0);

/// The sentence about `path` for a failure of SQLite.
base::Error describeFailure(const std::string& path, const SqliteFailure& failure);

/// Whether the file or its folder keeps us from writing: the error to say so, or an empty `found`.
base::Error whyNotWritable(const std::string& path);

}  // namespace tactus::store
