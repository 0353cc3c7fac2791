// A sqlite3_vfs between SQLite and the system's one that breaks: it fails an operation with a given error, or takes a
// picture of what a crash of the machine would leave on the disk.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace tactus::store {

/// Registered under a name of its own while it lives; one study file at a time is reached through it.
/// The crash picture follows the promise of a disk: what was synced is there; of what was written since the last sync
/// any part may be there, in any order, in whole sectors of 512 bytes, and so may a change of the length.
class FaultyDisk {
 public:
  /// `name` for OpenOptions::vfs.
  explicit FaultyDisk(std::string name);
  ~FaultyDisk();
  FaultyDisk(const FaultyDisk&) = delete;
  FaultyDisk& operator=(const FaultyDisk&) = delete;

  const std::string& name() const { return name_; }

  enum class Fault { kDiskFull, kWriteError, kSyncError };
  /// Fails the operation number `operation` (write, change of length or sync, from 1 counted from now) and, where
  /// `for_good`, all after it: a full disk and a removed medium do not come back by themselves.
  void failAt(long long operation, Fault fault, bool for_good);
  /// Puts what a crash just before operation number `operation` from now would leave into the folder `folder`, with
  /// `seed` choosing which unsynced sectors are there. Continues as if nothing happened.
  void pictureAt(long long operation, const std::string& folder, std::uint64_t seed);
  /// Kills this process (SIGKILL) just before operation number `operation` from now.
  void killAt(long long operation);
  /// Back to a disk that works.
  void heal();

  /// Operations since the last of the calls above.
  long long operations() const;
  /// Whether the fault struck or the picture was taken.
  bool struck() const;

  struct State;

 private:
  std::unique_ptr<State> state_;
  std::string name_;
};

}  // namespace tactus::store
