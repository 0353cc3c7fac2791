#include "core/store/connection.h"

#include <SQLiteCpp/Statement.h>
#include <algorithm>
#include <cerrno>
#include <chrono>
#include <fcntl.h>
#include <filesystem>
#include <mutex>
#include <set>
#include <sqlite3.h>
#include <string_view>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>
#include <utility>

#include "core/base/files/file.h"
#include "core/base/text.h"
#include "core/store/journal_file.h"
#include "core/store/opening.h"
#include "core/store/record_checksum.h"

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

namespace {

constexpr off_t kOurByte = off_t{1} << 62;
/// SQLite's "Database File Format" and os.h: the bytes that a reader shares and a writer has alone.
constexpr off_t kSharedFirst = 0x40000002;
constexpr off_t kSharedBytes = 510;
constexpr std::chrono::milliseconds kBetweenTries{10};

struct flock lockOf(short type, off_t first, off_t bytes) {
  struct flock lock {};
  lock.l_type = type;
  lock.l_whence = SEEK_SET;
  lock.l_start = first;
  lock.l_len = bytes;
  return lock;
}

/// The files that this process holds. Without it a second opening would have to open the file to learn that it is held,
/// and its close would drop SQLite's locks.
class Holdings {
 public:
  bool add(dev_t device, ino_t inode) {
    const std::lock_guard guard(mutex_);
    return files_.emplace(device, inode).second;
  }
  void remove(dev_t device, ino_t inode) {
    const std::lock_guard guard(mutex_);
    files_.erase({device, inode});
  }

 private:
  std::mutex mutex_;
  std::set<std::pair<dev_t, ino_t>> files_;
};

Holdings& holdings() {
  static Holdings all;
  return all;
}

bool isTaken(int error) { return error == EAGAIN || error == EACCES; }

}  // namespace

StudyLock::StudyLock(const std::string& path, Kind kind, int timeout_ms) {
  if (kind == Kind::kNone) return;
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(timeout_ms);
  while (!tryToTake(path, kind)) {
    if (std::chrono::steady_clock::now() >= end) throw Refusal{describeFailure(path, {SQLITE_BUSY})};
    std::this_thread::sleep_for(kBetweenTries);
  }
}

StudyLock::~StudyLock() { release(); }

std::optional<StudyLock::File> StudyLock::named(const std::string& path) {
  struct stat info {};
  if (::stat(path.c_str(), &info) != 0) return std::nullopt;
  return File{info.st_dev, info.st_ino};
}

bool StudyLock::tryToTake(const std::string& path, Kind kind) {
  const auto file = named(path);
  if (!file) return true;  // SQLite says why
  if (!holdings().add(file->device, file->inode)) return false;
  held_ = file;
  const bool writing = kind == Kind::kWriting;
  descriptor_ = base::Descriptor(::open(path.c_str(), (writing ? O_RDWR : O_RDONLY) | O_NONBLOCK | O_CLOEXEC));
  struct stat opened {};
  if (!descriptor_.isOpen() || ::fstat(descriptor_.number(), &opened) != 0) {
    release();
    return true;
  }
  // Until the lock is there, the name may have gone to another file.
  struct flock lock = lockOf(writing ? F_WRLCK : F_RDLCK, kOurByte, 1);
  const bool taken = ::fcntl(descriptor_.number(), F_OFD_SETLK, &lock) != 0 && isTaken(errno);
  if (!taken && File{opened.st_dev, opened.st_ino} == *held_ && isNamed(path)) return true;
  release();
  return false;
}

void StudyLock::release() {
  descriptor_.close();
  if (held_) holdings().remove(held_->device, held_->inode);
  held_.reset();
}

bool StudyLock::isNamed(const std::string& path) const { return !held_ || named(path) == held_; }

bool StudyLock::renew() const {
  if (!held_) return true;
  struct flock lock = lockOf(F_WRLCK, kSharedFirst, kSharedBytes);
  return ::fcntl(descriptor_.number(), F_SETLK, &lock) == 0 || !isTaken(errno);
}

namespace {

/// Instructions of SQLite's machine, some hundred million of which take a second. A study needs about one per byte for
/// its dearest query.
constexpr int kStepsBetweenLooks = 100'000;
constexpr long long kFreeSteps = 200'000'000;
constexpr long long kStepsPerByte = 20;

std::string absolute(const std::string& path) { return std::filesystem::absolute(path).string(); }

/// `path` as a URI that SQLite opens without locks and without a journal.
std::string immutableUri(const std::string& path) {
  std::string uri = "file:";
  for (const char c : absolute(path)) {
    if (c == '%' || c == '?' || c == '#') {
      constexpr std::string_view kDigits = "0123456789ABCDEF";
      const auto byte = static_cast<unsigned char>(c);
      uri += '%';
      uri += kDigits[byte >> 4U];
      uri += kDigits[byte & 15U];
    } else {
      uri += c;
    }
  }
  return uri + "?immutable=1";
}

// Debian's SQLite takes names that begin with `file:` for URIs; an absolute path never does.
std::string sqliteName(const std::string& path, Connection::Mode mode) {
  return mode == Connection::Mode::kImmutable ? immutableUri(path) : absolute(path);
}

int openFlags(Connection::Mode mode) {
  return mode == Connection::Mode::kImmutable ? SQLite::OPEN_READONLY | SQLite::OPEN_URI : SQLite::OPEN_READWRITE;
}

/// Of the system of files of SQLite that locks nothing.
constexpr std::string_view kWithoutLocks = "unix-none";

StudyLock::Kind lockFor(Connection::Mode mode, const std::string& vfs) {
  if (mode == Connection::Mode::kImmutable || vfs == kWithoutLocks) return StudyLock::Kind::kNone;
  return mode == Connection::Mode::kReadWrite ? StudyLock::Kind::kWriting : StudyLock::Kind::kReading;
}

/// The number of the system's last error with the journal, the file, or anything: each file remembers its own, while
/// that of the connection may be left over from something else.
int lastReason(sqlite3* database) {
  int number = 0;
  sqlite3_file* journal = nullptr;
  sqlite3_file_control(database, "main", SQLITE_FCNTL_JOURNAL_POINTER, &journal);
  if (journal != nullptr && journal->pMethods != nullptr) {
    journal->pMethods->xFileControl(journal, SQLITE_FCNTL_LAST_ERRNO, &number);
  }
  if (!base::isReason(number)) sqlite3_file_control(database, "main", SQLITE_FCNTL_LAST_ERRNO, &number);
  return base::isReason(number) ? number : sqlite3_system_errno(database);
}

}  // namespace

Connection::Connection(const std::string& path, Mode mode, const std::string& vfs)
    : path_(path),
      vfs_(vfs),
      mode_(mode),
      lock_(path, lockFor(mode, vfs), kBusyTimeoutMs),
      database_(sqliteName(path, mode).c_str(), openFlags(mode), kBusyTimeoutMs, vfs.empty() ? nullptr : vfs.c_str()) {
  sqlite3_extended_result_codes(database_.getHandle(), 1);
  leaveJournalOnClose(true);
  addRecordChecksum(database_.getHandle());
  sqlite3_progress_handler(database_.getHandle(), kStepsBetweenLooks, &Connection::onProgress, this);
  // Exclusive before the first access: the whole file is ours, and the index of the journal stays in memory.
  database_.exec("PRAGMA locking_mode = EXCLUSIVE");
  database_.exec("PRAGMA trusted_schema = OFF");
  database_.exec("PRAGMA cell_size_check = ON");
  database_.exec("PRAGMA mmap_size = 0");
  database_.exec("PRAGMA recursive_triggers = ON");
  database_.exec("PRAGMA foreign_keys = ON");
  if (mode == Mode::kQueryOnly) database_.exec("PRAGMA query_only = ON");
  if (pragma("foreign_keys") != 1) {
    refuse(ErrorCode::kSchema, {}, "a library of SQLite without foreign keys", "one with them");
  }
  if (mode == Mode::kReadWrite && sqlite3_db_readonly(database_.getHandle(), "main") == 1) {
    Error reason = whyNotWritable(path_);
    if (reason.found.empty()) {
      reason = {ErrorCode::kIo, {}, {}, "a file that the system opens for reading only", "a study that can be changed"};
    }
    throw Refusal{std::move(reason)};
  }
}

Connection::~Connection() {
  // What lies under the journal's name then belongs to the file that took the study's.
  if (!opening && !lock_.isNamed(path_)) leaveJournalOnClose(true);
  if (!opening) return;
  // Where the close fails, nothing is lost: the next opening works the journal in.
  leaveJournalOnClose(true);
  database_.tryExec("ROLLBACK");
  startWork();
  try {
    opening->close();
    leaveJournalOnClose(false);
  } catch (const SQLite::Exception&) {
  } catch (const Refusal&) {
  }
  opening.reset();
}

void Connection::beginWrite() {
  if (opening) opening->beginWrite();
}

void Connection::countCommit() {
  if (opening) opening->countCommit();
}

void Connection::acknowledge() {
  if (opening) opening->acknowledge();
}

void Connection::startWork(long long more_bytes) {
  steps_ = 0;
  if (more_bytes > 0) more_bytes_ = more_bytes;
}

int Connection::onProgress(void* self) {
  auto& connection = *static_cast<Connection*>(self);
  connection.steps_ += kStepsBetweenLooks;
  if (connection.steps_ < kFreeSteps) return 0;
  const long long bytes = std::max(identityOf(connection.path_).bytes, 0LL) +
                          std::max(identityOf(journalOf(connection.path_)).bytes, 0LL) + connection.more_bytes_;
  return connection.steps_ < kFreeSteps + bytes * kStepsPerByte ? 0 : 1;
}

SQLite::Statement& Connection::kept(const std::string& sql) {
  const auto found = kept_.find(sql);
  return found != kept_.end() ? found->second : kept_.try_emplace(sql, database_, sql).first->second;
}

std::string Connection::answerOf(const std::string& sql) {
  SQLite::Statement statement(database_, sql);
  std::string answer;
  // To the end: an error that only comes when a statement ends would be lost with the statement.
  while (statement.executeStep()) answer = statement.getColumn(0).getString();
  return answer;
}

long long Connection::pragma(const std::string& name) {
  return base::parseInteger(answerOf("PRAGMA " + name)).value_or(0);
}

void Connection::leaveJournalOnClose(bool leave) {
  sqlite3_db_config(database_.getHandle(), SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, leave ? 1 : 0, nullptr);
}

void Connection::startJournal() {
  leaveJournalOnClose(false);
  const std::string mode = answerOf("PRAGMA journal_mode = WAL");
  if (mode != "wal") refuse(ErrorCode::kIo, {}, "a file without a write-ahead journal", "one that can have it");
  database_.exec("PRAGMA synchronous = FULL");
  database_.exec("PRAGMA secure_delete = ON");
}

std::string Connection::firstFinding(const std::string& check) {
  SQLite::Statement statement(database_, "PRAGMA " + check);
  if (!statement.executeStep()) return {};
  std::string finding = statement.getColumn(0).getString();
  if (check == "foreign_key_check") finding = "a row of " + finding + " without the row it belongs to";
  return finding == "ok" ? std::string() : finding;
}

base::Error Connection::describe(const SQLite::Exception& exception) {
  return describeFailure(path_, failureOf(exception, lastReason(database_.getHandle())));
}

void Connection::requireStudyFile() {
  const int id = applicationId();
  if (id == kApplicationId) return;
  if (id != kApplicationIdBeforeRelease) {
    refuse(base::ErrorCode::kSyntax, {}, "a database of another program", "a Tactus study file");
  }
  refuse(base::ErrorCode::kVersion, {},
         "a study of a Tactus from before the release (version " + std::to_string(version()) + " of its tables)",
         "a study of version 1; export it with the last Tactus that opens it (tactus study export STUDY FOLDER), and "
         "import the folder here");
}

}  // namespace tactus::store
