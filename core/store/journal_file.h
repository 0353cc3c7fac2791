// The journal beside a study, read from the disk without SQLite, because SQLite silently skips unreadable parts of a
// journal. Private to core/store.
#pragma once

#include <optional>
#include <string>

namespace tactus::store {

/// A mark that the program writes after a commit is synced: the number of acknowledged commits of this opening. It is
/// stored in the last bytes of the journal's reserved space. The mark itself is not synced, so after a power failure it
/// may be too small, never too large.
struct AcknowledgmentMark {
  static constexpr int kBytes = 36;
  static constexpr int kFromEnd = 512;  ///< a separate sector at the end of the file

  std::string token;  ///< 16 bytes (opening.h)
  long long commits = 0;

  std::string bytes() const;
  static std::optional<AcknowledgmentMark> in(const std::string& bytes);
};

/// See "Write-Ahead Log File Format" in SQLite's "Database File Format", section 4.
struct JournalFile {
  bool is_there = false;
  long long bytes = 0;
  bool has_header = false;       ///< with a valid checksum
  long long commits = 0;         ///< commits that SQLite will read
  long long readable_bytes = 0;  ///< up to the end of the last of these commits
  /// Whether the part after them lies completely inside the file and was never written in this round of the journal.
  /// Then no commit followed.
  bool ends_in_file = false;
  /// Ends of transactions of the same round after the point where reading must stop.
  long long commits_behind = 0;
  std::optional<AcknowledgmentMark> mark;

  bool isEmpty() const { return bytes == 0; }
};

/// Reads the journal `path`. An unreadable journal counts as missing.
JournalFile readJournal(const std::string& path);

/// `<path>-wal`.
std::string journalOf(const std::string& path);

}  // namespace tactus::store
