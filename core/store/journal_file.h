// The journal beside a study as it lies on the disk, read without SQLite, which passes over in silence whatever it
// cannot read in a journal. Private to core/store.
#pragma once

#include <optional>
#include <string>

namespace tactus::store {

/// What the program says after a commit was synced: this many commits of this opening were acknowledged. It stands in
/// the last bytes of the journal's room and is not synced itself, so after a power cut it may say too little, never too
/// much.
struct AcknowledgmentMark {
  static constexpr int kBytes = 36;
  static constexpr int kFromEnd = 512;  ///< a sector of its own at the end of the file

  std::string token;  ///< 16 bytes (opening_row.h)
  long long commits = 0;

  std::string bytes() const;
  static std::optional<AcknowledgmentMark> in(const std::string& bytes);
};

/// "Write-Ahead Log File Format" in SQLite's "Database File Format", section 4.
struct JournalFile {
  bool is_there = false;
  long long bytes = 0;
  bool has_header = false;       ///< with a checksum that fits
  long long commits = 0;         ///< that SQLite will read
  long long readable_bytes = 0;  ///< up to the end of the last of them
  /// Whether what follows them lies wholly in the file and was never written in this round of the journal, so that
  /// nothing followed.
  bool ends_in_file = false;
  /// Ends of transactions of the same round behind the place where reading must stop.
  long long commits_behind = 0;
  std::optional<AcknowledgmentMark> mark;

  bool isEmpty() const { return bytes == 0; }
};

/// Reads the journal `path`; where it cannot be read it counts as not there.
JournalFile readJournal(const std::string& path);

/// `<path>-wal`.
std::string journalOf(const std::string& path);

}  // namespace tactus::store
