#include "tests/core/store/faulty_disk.h"

#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <new>
#include <sqlite3.h>
#include <sstream>
#include <unistd.h>

#include "tests/core/store/crash_picture.h"

namespace tactus::store {
namespace {

std::string bytesOfFile(const std::string& path) {
  std::ostringstream out;
  out << std::ifstream(path, std::ios::binary).rdbuf();
  return out.str();
}

}  // namespace

struct FaultyDisk::State {
  sqlite3_vfs vfs{};
  sqlite3_vfs* real = nullptr;
  std::map<std::string, CrashPicture> files;

  enum class Plan { kNone, kFail, kPicture, kKill } plan = Plan::kNone;
  long long operation = 0;
  long long at = 0;
  Fault fault = Fault::kDiskFull;
  bool for_good = false;
  bool struck = false;
  std::string folder;
  std::uint64_t seed = 0;

  void start(Plan next, long long where) {
    plan = next;
    at = where;
    operation = 0;
    struck = false;
  }

  void takePicture() {
    base::Random random(seed);
    for (const auto& [path, picture] : files) {
      const auto name = std::filesystem::path(path).filename();
      std::ofstream(std::filesystem::path(folder) / name, std::ios::binary) << picture.after(random);
    }
  }

  /// Counts an operation; returns the error that it must fail with, or SQLITE_OK.
  int count(bool is_sync) {
    ++operation;
    if (plan == Plan::kPicture && operation == at) {
      struck = true;
      takePicture();
    }
    if (plan == Plan::kKill && operation == at) ::kill(::getpid(), SIGKILL);
    if (plan != Plan::kFail || operation < at || (operation > at && !for_good)) return SQLITE_OK;
    struck = true;
    if (fault == Fault::kDiskFull) return is_sync ? SQLITE_IOERR_FSYNC : SQLITE_FULL;
    if (fault == Fault::kSyncError) return is_sync ? SQLITE_IOERR_FSYNC : SQLITE_OK;
    return is_sync ? SQLITE_IOERR_FSYNC : SQLITE_IOERR_WRITE;
  }
};

namespace {

/// SQLite allocates this; the real file follows it in memory.
struct File {
  sqlite3_file base;
  FaultyDisk::State* disk;
  const char* path;  ///< SQLite keeps it as long as the file; null for temporary files, which need no picture
};

File* self(sqlite3_file* file) { return reinterpret_cast<File*>(file); }
sqlite3_file* real(sqlite3_file* file) { return reinterpret_cast<sqlite3_file*>(self(file) + 1); }
const sqlite3_io_methods* realMethods(sqlite3_file* file) { return real(file)->pMethods; }

CrashPicture* pictureOf(sqlite3_file* file) {
  if (self(file)->path == nullptr) return nullptr;
  const auto found = self(file)->disk->files.find(self(file)->path);
  return found == self(file)->disk->files.end() ? nullptr : &found->second;
}

int writeFile(sqlite3_file* file, const void* bytes, int count, sqlite3_int64 offset) {
  if (const int error = self(file)->disk->count(false); error != SQLITE_OK) return error;
  const int code = realMethods(file)->xWrite(real(file), bytes, count, offset);
  if (auto* picture = pictureOf(file); code == SQLITE_OK && picture != nullptr) {
    picture->write(static_cast<std::size_t>(offset),
                   {static_cast<const char*>(bytes), static_cast<std::size_t>(count)});
  }
  return code;
}

int truncateFile(sqlite3_file* file, sqlite3_int64 size) {
  if (const int error = self(file)->disk->count(false); error != SQLITE_OK) return error;
  const int code = realMethods(file)->xTruncate(real(file), size);
  if (auto* picture = pictureOf(file); code == SQLITE_OK && picture != nullptr) {
    picture->truncate(static_cast<std::size_t>(size));
  }
  return code;
}

int syncFile(sqlite3_file* file, int /*flags*/) {
  if (const int error = self(file)->disk->count(true); error != SQLITE_OK) return error;
  // The picture stands for the disk, so the real one need not be waited for.
  if (auto* picture = pictureOf(file); picture != nullptr) picture->sync();
  return SQLITE_OK;
}

int closeFile(sqlite3_file* file) { return realMethods(file)->xClose(real(file)); }
int readFile(sqlite3_file* file, void* bytes, int count, sqlite3_int64 offset) {
  return realMethods(file)->xRead(real(file), bytes, count, offset);
}
int fileSize(sqlite3_file* file, sqlite3_int64* size) { return realMethods(file)->xFileSize(real(file), size); }
int lockFile(sqlite3_file* file, int level) { return realMethods(file)->xLock(real(file), level); }
int unlockFile(sqlite3_file* file, int level) { return realMethods(file)->xUnlock(real(file), level); }
int checkReserved(sqlite3_file* file, int* out) { return realMethods(file)->xCheckReservedLock(real(file), out); }
int fileControl(sqlite3_file* file, int operation, void* argument) {
  // The size would be changed behind our back.
  if (operation == SQLITE_FCNTL_SIZE_HINT || operation == SQLITE_FCNTL_CHUNK_SIZE) return SQLITE_NOTFOUND;
  return realMethods(file)->xFileControl(real(file), operation, argument);
}
int sectorSize(sqlite3_file* /*file*/) { return 512; }
// No promise that a sector is written whole, that order is kept, or that neighbors are safe.
int characteristics(sqlite3_file* /*file*/) { return 0; }

// Version 1: no shared memory, so the study must hold its file alone, as it promises.
const sqlite3_io_methods kMethods = {1,           closeFile,  readFile,        writeFile,  truncateFile,
                                     syncFile,    fileSize,   lockFile,        unlockFile, checkReserved,
                                     fileControl, sectorSize, characteristics, nullptr,    nullptr,
                                     nullptr,     nullptr,    nullptr,         nullptr};

FaultyDisk::State* diskOf(sqlite3_vfs* vfs) { return static_cast<FaultyDisk::State*>(vfs->pAppData); }

int openFile(sqlite3_vfs* vfs, const char* path, sqlite3_file* file, int flags, int* out_flags) {
  auto* disk = diskOf(vfs);
  new (file) File{{nullptr}, disk, path};
  const int code = disk->real->xOpen(disk->real, path, real(file), flags, out_flags);
  if (realMethods(file) != nullptr) file->pMethods = &kMethods;
  if (code == SQLITE_OK && path != nullptr) disk->files.insert_or_assign(path, CrashPicture(bytesOfFile(path)));
  return code;
}

int deleteFile(sqlite3_vfs* vfs, const char* path, int sync_folder) {
  diskOf(vfs)->files.erase(path);
  return diskOf(vfs)->real->xDelete(diskOf(vfs)->real, path, sync_folder);
}
int accessFile(sqlite3_vfs* vfs, const char* path, int flags, int* out) {
  return diskOf(vfs)->real->xAccess(diskOf(vfs)->real, path, flags, out);
}
int fullPath(sqlite3_vfs* vfs, const char* path, int size, char* out) {
  return diskOf(vfs)->real->xFullPathname(diskOf(vfs)->real, path, size, out);
}
int randomness(sqlite3_vfs* vfs, int count, char* out) {
  return diskOf(vfs)->real->xRandomness(diskOf(vfs)->real, count, out);
}
int sleepFor(sqlite3_vfs* vfs, int microseconds) { return diskOf(vfs)->real->xSleep(diskOf(vfs)->real, microseconds); }
int currentTime(sqlite3_vfs* vfs, double* out) { return diskOf(vfs)->real->xCurrentTime(diskOf(vfs)->real, out); }
int lastError(sqlite3_vfs* vfs, int size, char* out) {
  return diskOf(vfs)->real->xGetLastError(diskOf(vfs)->real, size, out);
}

}  // namespace

FaultyDisk::FaultyDisk(std::string name) : state_(std::make_unique<State>()), name_(std::move(name)) {
  state_->real = sqlite3_vfs_find(nullptr);
  sqlite3_vfs& vfs = state_->vfs;
  vfs.iVersion = 1;
  vfs.szOsFile = static_cast<int>(sizeof(File)) + state_->real->szOsFile;
  vfs.mxPathname = state_->real->mxPathname;
  vfs.zName = name_.c_str();
  vfs.pAppData = state_.get();
  vfs.xOpen = openFile;
  vfs.xDelete = deleteFile;
  vfs.xAccess = accessFile;
  vfs.xFullPathname = fullPath;
  vfs.xRandomness = randomness;
  vfs.xSleep = sleepFor;
  vfs.xCurrentTime = currentTime;
  vfs.xGetLastError = lastError;
  sqlite3_vfs_register(&vfs, 0);
}

FaultyDisk::~FaultyDisk() { sqlite3_vfs_unregister(&state_->vfs); }

void FaultyDisk::failAt(long long operation, Fault fault, bool for_good) {
  state_->start(State::Plan::kFail, operation);
  state_->fault = fault;
  state_->for_good = for_good;
}

void FaultyDisk::pictureAt(long long operation, const std::string& folder, std::uint64_t seed) {
  state_->start(State::Plan::kPicture, operation);
  state_->folder = folder;
  state_->seed = seed;
}

void FaultyDisk::killAt(long long operation) { state_->start(State::Plan::kKill, operation); }

void FaultyDisk::heal() { state_->start(State::Plan::kNone, 0); }
long long FaultyDisk::operations() const { return state_->operation; }
bool FaultyDisk::struck() const { return state_->struck; }

}  // namespace tactus::store
