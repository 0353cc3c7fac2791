// What is on a disk for sure and what is only on its way, for one file.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/random.h"

namespace tactus::store {

class CrashPicture {
 public:
  /// `bytes` are on the disk already.
  explicit CrashPicture(std::string bytes) : synced_(std::move(bytes)) {}

  void write(std::size_t offset, std::string_view bytes) { pending_.push_back({offset, std::string(bytes), false}); }
  void truncate(std::size_t size) { pending_.push_back({size, {}, true}); }
  /// Everything on its way has arrived.
  void sync();

  /// The file after a crash: each sector of each pending write is there or not, as `random` says.
  std::string after(base::Random& random) const;

 private:
  struct Change {
    std::size_t offset;  ///< or the new length
    std::string bytes;
    bool is_length;
  };
  static void apply(std::string& file, const Change& change);

  std::string synced_;
  std::vector<Change> pending_;
};

}  // namespace tactus::store
