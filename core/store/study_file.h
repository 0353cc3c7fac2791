// A study file: one SQLite database that keeps all records of a study and loses none (docs/study-file.md).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/store/migrations.h"
#include "core/study/record_id.h"

namespace tactus::store {

// Whether a study file can be opened for reading only.

/// Why the study file `path` cannot be opened for writing: it, or its folder, may not be written to. Nothing where it
/// can be, or is not there.
std::optional<base::Error> readOnlyReason(const std::string& path);

class Connection;

/// The initial data of a new study.
struct NewStudy {
  study::RecordId id;
  std::string name;
  std::int64_t created_utc_ms = 0;
  std::string program;  ///< name and version of the creating program
};

enum class Access {
  kReadWrite,
  /// Changes nothing. Reads the journal left by a crash and leaves it in place.
  kReadOnly,
};

struct OpenOptions {
  Access access = Access::kReadWrite;
  /// Name of a registered sqlite3_vfs for file access; empty: the system's. Tests register one that fails or loses
  /// writes.
  std::string vfs = {};
};

/// What happened to a study before or while it was opened and a person should know.
struct Notice {
  enum class Kind {
    kJournal,  ///< records that were lost, or may have been, with a journal that was missing, cut or damaged
    kErasure,  ///< an erasure that was interrupted; `erase` (withdrawal.h) finishes it
  };
  Kind kind = Kind::kJournal;
  std::string sentence;  ///< without a capital and a full stop, as the message of an error; it does not name the study

  bool operator==(const Notice&) const = default;
};

/// An open study file. While it is open no other program can open it. Records are written and read by the functions of
/// the other headers of this folder; each write returns after it was committed and synced, so it survives a crash of
/// the program and of the machine.
/// Thread: the one that opened it.
class StudyFile {
 public:
  /// Creates the file `path`, which must not exist. It appears completely or not at all.
  static base::Result<StudyFile> create(const std::string& path, const NewStudy& study,
                                        const OpenOptions& options = {});

  /// Opens the file `path`. A file of an older version is upgraded after a copy of it is made beside it (migrations.h);
  /// if the upgrade fails, the file is unchanged.
  /// Returns an error in one sentence for: a missing file, a file that is not a study, a damaged file, a file open
  /// elsewhere, missing permissions for file or folder, and, for writing, a study of a newer version.
  static base::Result<StudyFile> open(const std::string& path, const OpenOptions& options = {});

  StudyFile(StudyFile&&) noexcept;
  StudyFile& operator=(StudyFile&&) noexcept;
  ~StudyFile();

  /// Moves all data to the one file, removes the journal, and closes. The destructor does the same without reporting
  /// failures. No data is lost after a failure; the next opening applies the journal.
  base::Result<void> close();

  const std::string& path() const { return path_; }
  Access access() const { return access_; }
  /// Schema version, from 1.
  int version() const { return version_; }

  /// Of this opening; an erasure that was interrupted only where the study is open for writing.
  const std::vector<Notice>& notices() const { return notices_; }

  /// For core/store only.
  Connection& connection() const;

 private:
  StudyFile(std::unique_ptr<Connection> connection, Access access, int version, std::vector<Notice> notices);

  std::unique_ptr<Connection> connection_;
  std::string path_;
  Access access_ = Access::kReadWrite;
  int version_ = 0;
  std::vector<Notice> notices_;
};

/// Version of the running SQLite, for reports.
std::string sqliteVersion();

}  // namespace tactus::store
