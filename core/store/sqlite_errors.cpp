#include "core/store/sqlite_errors.h"

#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <sqlite3.h>
#include <unistd.h>
#include <utility>

#include "core/base/files/system_reason.h"

namespace tactus::store {
namespace {

using base::Error;
using base::ErrorCode;

bool mayWrite(const std::string& path) { return ::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) == 0; }

std::string folderOf(const std::string& path) {
  const auto folder = std::filesystem::path(path).parent_path();
  return folder.empty() ? "." : folder.string();
}

bool isDiskFull(const SqliteFailure& failure) {
  return (failure.code & 0xFF) == SQLITE_FULL ||
         ((failure.code & 0xFF) == SQLITE_IOERR && (failure.system_errno == ENOSPC || failure.system_errno == EDQUOT));
}

Error ioError(const std::string& path, std::string found, std::string wanted) {
  return {ErrorCode::kIo, path, {}, std::move(found), std::move(wanted)};
}

}  // namespace

void refuse(ErrorCode code, std::string place, std::string found, std::string wanted) {
  throw Refusal{Error{code, {}, std::move(place), std::move(found), std::move(wanted)}};
}

SqliteFailure failureOf(const SQLite::Exception& exception, int system_errno) {
  // SQLiteCpp leaves the extended code out where there was no connection to ask.
  const int extended = exception.getExtendedErrorCode();
  return {extended >= 0 ? extended : exception.getErrorCode(), system_errno, exception.what()};
}

Error whyNotWritable(const std::string& path) {
  if (!mayWrite(path)) return ioError(path, "a file that may not be written to", "a study file that can be changed");
  if (!mayWrite(folderOf(path))) {
    return ioError(path, "a folder that may not be written to",
                   "a folder in which the study can keep its journal while it is open");
  }
  return {};
}

Error describeFailure(const std::string& path, const SqliteFailure& failure) {
  if (isDiskFull(failure)) {
    return ioError(path, "a full disk", "room for what is to be saved (what was saved before is still there)");
  }
  switch (failure.code & 0xFF) {
    case SQLITE_BUSY:
      return ioError(path, "a study that is open elsewhere",
                     "a study that no other program or window uses; close it there first");
    case SQLITE_NOTADB: return {ErrorCode::kSyntax, path, {}, "a file of another kind", "a Tactus study file"};
    case SQLITE_CORRUPT:
      return {ErrorCode::kMismatch,
              path,
              {},
              "a damaged file (" + failure.what + ")",
              "an intact study file; restore a backup"};
    case SQLITE_READONLY:
    case SQLITE_PERM:
    case SQLITE_AUTH:
    case SQLITE_CANTOPEN: {
      Error reason = whyNotWritable(path);
      if (!reason.found.empty()) return reason;
      return ioError(path, failure.what, "a study file and a folder that can be written to");
    }
    case SQLITE_LOCKED:  // by ourselves: with one connection, only after an error of the disk that SQLite kept to
                         // itself
    case SQLITE_IOERR: {
      std::string found = "a disk that reports an error";
      // SQLite may have called the system again since, so that a number without meaning is left.
      if (base::isReason(failure.system_errno)) found += " (" + base::systemReason(failure.system_errno) + ")";
      return ioError(path, std::move(found), "a disk that stores the study (what was saved before is still there)");
    }
    case SQLITE_INTERRUPT:
      return {ErrorCode::kLimit,
              path,
              {},
              "records that take longer to go through than those of any study of this size",
              "a study file as Tactus makes it"};
    case SQLITE_CONSTRAINT:
      return {ErrorCode::kValue,
              path,
              {},
              "a record that breaks a rule of the study file (" + failure.what + ")",
              "a record that keeps it"};
    default:
      return ioError(path, "SQLite's error " + std::to_string(failure.code) + " (" + failure.what + ")",
                     "a study file that works");
  }
}

}  // namespace tactus::store
