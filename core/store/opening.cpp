#include "core/store/opening.h"

#include <cstdint>
#include <sqlite3.h>
#include <sys/stat.h>

#include "core/store/journal_file.h"
#include "core/store/query.h"
#include "core/store/record_checksum.h"

namespace tactus::store {
namespace {

void bindBytes(SQLite::Statement& statement, int parameter, const std::string& bytes) {
  if (bytes.empty()) {
    statement.bind(parameter);
  } else {
    statement.bind(parameter, bytes.data(), static_cast<int>(bytes.size()));
  }
}

}  // namespace

OpeningRow readOpening(Connection& connection) {
  Query query(connection,
              "SELECT token, previous, commits, is_open, journal_bytes, crc32 = record_crc32('opening', one, token,"
              " previous, commits, is_open, journal_bytes) FROM main.opening");
  if (!query.next()) refuse(base::ErrorCode::kMismatch, "opening", "no row", "an intact study file");
  OpeningRow row;
  row.token = query.text();
  row.previous = query.text();
  row.commits = query.integer();
  row.is_open = query.flag();
  row.journal_bytes = query.integer();
  if (!query.flag()) {
    refuse(base::ErrorCode::kMismatch, "opening", "a row that does not fit its CRC-32", "an intact study file");
  }
  return row;
}

std::string newToken() {
  std::string token(16, '\0');
  sqlite3_randomness(static_cast<int>(token.size()), token.data());
  return token;
}

OpeningWriter::OpeningWriter(Connection& connection)
    : update_(connection.database(),
              "UPDATE opening SET token = ?1, previous = ?2, commits = ?3, is_open = ?4, journal_bytes = ?5,"
              " crc32 = record_crc32('opening', one, ?1, ?2, ?3, ?4, ?5)") {}

void OpeningWriter::write(const OpeningRow& row) {
  bindBytes(update_, 1, row.token);
  bindBytes(update_, 2, row.previous);
  update_.bind(3, static_cast<std::int64_t>(row.commits));
  update_.bind(4, row.is_open ? 1 : 0);
  update_.bind(5, static_cast<std::int64_t>(row.journal_bytes));
  update_.exec();
  update_.reset();
}

namespace {

using base::ErrorCode;

/// Beyond the 1000 pages after which SQLite works the journal in, so that the room hardly ever has to grow. Most of it
/// is a hole that takes no place on the disk.
constexpr long long kRoomBytes = 8LL << 20;
/// Room that is kept behind the last commit for the next one.
constexpr long long kSpareBytes = 2LL << 20;
/// As many pages as SQLite waits for by itself.
constexpr int kCheckpointFrames = 1000;
constexpr long long kWalFrameHeaderBytes = 24;

[[noreturn]] void refuseGone(const std::string& found) {
  refuse(ErrorCode::kIo, {}, found,
         "the files that were opened; what is written now would be lost, so back the open study up under a new name");
}

[[noreturn]] void refuseOtherWriter() {
  refuse(ErrorCode::kIo, {}, "a study that another program has written to while it was open here",
         "one writer; this record was not written, all before it are in the file: close the study and open it again");
}

/// Of the file without its journal; empty where it cannot be read.
std::string tokenOnDisk(const std::string& path) {
  try {
    Connection on_disk(path, Connection::Mode::kImmutable, {});
    return readOpening(on_disk).token;
  } catch (const SQLite::Exception&) {
    return {};
  } catch (const Refusal&) {
    return {};
  }
}

}  // namespace

FileIdentity identityOf(const std::string& path) {
  struct stat info {};
  if (::stat(path.c_str(), &info) != 0) return {};
  return {info.st_dev, info.st_ino, info.st_size, info.st_mtim.tv_sec * 1'000'000'000LL + info.st_mtim.tv_nsec};
}

Opening::Opening(Connection& connection)
    : connection_(connection),
      row_(readOpening(connection)),
      writer_(std::make_unique<OpeningWriter>(connection)),
      page_bytes_(connection.pragma("page_size")),
      study_(identityOf(connection.path())) {
  sqlite3_wal_hook(connection.database().getHandle(), &Opening::afterCommit, this);
}

Opening::~Opening() { sqlite3_wal_hook(connection_.database().getHandle(), nullptr, nullptr); }

sqlite3_file* Opening::journal() const {
  sqlite3_file* file = nullptr;
  sqlite3_file_control(connection_.database().getHandle(), "main", SQLITE_FCNTL_JOURNAL_POINTER, &file);
  if (file == nullptr || file->pMethods == nullptr) {
    refuse(ErrorCode::kIo, {}, "a study without its journal", "one that can have it");
  }
  return file;
}

void Opening::makeRoom(long long bytes) {
  sqlite3_file* file = journal();
  int code = file->pMethods->xTruncate(file, bytes);
  if (code == SQLITE_OK) code = file->pMethods->xSync(file, SQLITE_SYNC_FULL);
  if (code != SQLITE_OK) throw SQLite::Exception("the journal could not be made", code);
  room_bytes_ = bytes;
  mark_.clear();
}

void Opening::commit(const OpeningRow& row) {
  SQLite::Transaction transaction(connection_.database(), SQLite::TransactionBehavior::IMMEDIATE);
  writer_->write(row);
  transaction.commit();
  row_ = row;
}

void Opening::beginWrite() {
  requireNoOtherWriter();
  if (is_established_) return;
  requireSameStudy(identityOf(connection_.path()));
  if (!connection_.lock().isNamed(connection_.path()))
    refuseGone("another file in the place of the study: it was replaced while it was open");
  if (!is_drawn_) {
    if (room_bytes_ == 0) makeRoom(kRoomBytes);
    commit({newToken(), row_.token, row_.commits + 1, true, room_bytes_});
    is_drawn_ = true;
  }
  Query checkpoint(connection_, "PRAGMA wal_checkpoint(PASSIVE)");
  const bool free = checkpoint.next() && checkpoint.integer() == 0;
  const auto frames = free ? checkpoint.integer() : -1;
  if (!free || checkpoint.integer() != frames) {
    refuse(ErrorCode::kIo, {}, "a journal that could not be worked in", "a study that no other program uses");
  }
  checkpointed_ = false;
  study_ = identityOf(connection_.path());
  journal_ = identityOf(journalOf(connection_.path()));
  writeMark();
  is_established_ = true;
}

void Opening::countCommit() {
  requireNoOtherWriter();
  OpeningRow row = row_;
  ++row.commits;
  row.journal_bytes = room_bytes_;
  writer_->write(row);
}

int Opening::afterCommit(void* self, sqlite3* database, const char* schema, int frames) {
  auto* opening = static_cast<Opening*>(self);
  opening->frames_end_ = frames * (kWalFrameHeaderBytes + opening->page_bytes_);
  if (frames >= kCheckpointFrames) {
    // Where it fails, the journal just grows on; the commit is safe in it.
    sqlite3_wal_checkpoint_v2(database, schema, SQLITE_CHECKPOINT_PASSIVE, nullptr, nullptr);
    opening->checkpointed_ = true;
  }
  return SQLITE_OK;
}

void Opening::acknowledge() {
  ++row_.commits;
  if (frames_end_ + kSpareBytes > room_bytes_) {
    try {
      makeRoom(frames_end_ + kRoomBytes);
    } catch (const SQLite::Exception&) {  // on a full disk: the commit is safe without, and the next one tries again
    }
  }
  writeMark();
  requireSameFiles();
}

void Opening::writeMark() {
  const long long at = room_bytes_ - AcknowledgmentMark::kFromEnd;
  if (at < frames_end_ + kSpareBytes / 2) return;
  sqlite3_file* file = journal();
  const std::string bytes = AcknowledgmentMark{row_.token, row_.commits}.bytes();
  // A mark that cannot be written is only missing: the commit is safe without it.
  const int code = file->pMethods->xWrite(file, bytes.data(), static_cast<int>(bytes.size()), at);
  mark_ = code == SQLITE_OK ? bytes : std::string();
  mark_at_ = at;
}

// Files that lost their names are left to `acknowledge`: nobody else writes to them, and a copy of the open study saves
// what is in them.
void Opening::requireNoOtherWriter() const {
  const FileIdentity study = identityOf(connection_.path());
  if (study.isThere() && study.isSameFileAs(study_)) requireSameStudy(study);
  const FileIdentity there = identityOf(journalOf(connection_.path()));
  if (is_established_ && there.isThere() && there.isSameFileAs(journal_)) {
    requireSameJournal(there);
    requireOwnMark();
  }
  if (!connection_.lock().renew()) refuseOtherWriter();
}

void Opening::requireOwnMark() const {
  if (mark_.empty()) return;
  sqlite3_file* file = journal();
  std::string found(mark_.size(), '\0');
  const int code = file->pMethods->xRead(file, found.data(), static_cast<int>(found.size()), mark_at_);
  if (code == SQLITE_OK && found != mark_) refuseOtherWriter();
}

void Opening::requireSameJournal(const FileIdentity& journal) const {
  if (!journal.isThere()) refuseGone("the study's journal gone: it was deleted or moved while the study was open");
  if (!journal.isSameFileAs(journal_)) refuseGone("another file in the place of the study's journal");
  if (journal.bytes < room_bytes_) refuseGone("a journal that was cut while the study was open");
}

void Opening::requireSameStudy(const FileIdentity& study) const {
  if (!study.isThere()) refuseGone("the study file gone: it was deleted or moved while it was open");
  if (!study.isSameFileAs(study_))
    refuseGone("another file in the place of the study: it was replaced while it was open");
  if (study.bytes < study_.bytes) refuseGone("a study file that was cut while it was open");
  if (study.changed_ns != study_.changed_ns && !checkpointed_) {
    // Written to, and not by us: perhaps only touched, perhaps overwritten in place.
    if (tokenOnDisk(connection_.path()) != row_.token)
      refuseGone("a study file that was overwritten while it was open");
  }
}

void Opening::requireSameFiles() {
  const FileIdentity study = identityOf(connection_.path());
  requireSameStudy(study);
  requireSameJournal(identityOf(journalOf(connection_.path())));
  study_ = study;
  checkpointed_ = false;
}

void Opening::truncateJournal() {
  room_bytes_ = 0;
  mark_.clear();
  Query truncate(connection_, "PRAGMA wal_checkpoint(TRUNCATE)");
  if (!truncate.next() || truncate.integer() != 0) {
    refuse(ErrorCode::kIo, {}, "a journal that could not be emptied", "a study that no other program uses");
  }
  frames_end_ = 0;
  study_.bytes = 0;  // a file that was rewritten may be shorter
  checkpointed_ = true;
}

void Opening::emptyJournal() {
  requireNoOtherWriter();
  if (is_drawn_) commit({row_.token, row_.previous, row_.commits + 1, true, 0});
  truncateJournal();
  if (!is_established_) return;
  makeRoom(kRoomBytes);
  commit({row_.token, row_.previous, row_.commits + 1, true, room_bytes_});
  connection_.database().exec("PRAGMA wal_checkpoint(PASSIVE)");
  writeMark();
  requireSameFiles();
}

void Opening::close() {
  requireNoOtherWriter();
  if (is_drawn_) commit({row_.token, row_.previous, row_.commits + 1, false, 0});
  writer_.reset();
  truncateJournal();
  if (is_established_) requireSameFiles();
}

}  // namespace tactus::store
