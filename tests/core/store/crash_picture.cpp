#include "tests/core/store/crash_picture.h"

#include <algorithm>
#include <array>

namespace tactus::store {

void CrashPicture::apply(std::string& file, const Change& change) {
  if (change.is_length) {
    file.resize(change.offset);
    return;
  }
  if (file.size() < change.offset + change.bytes.size()) file.resize(change.offset + change.bytes.size());
  file.replace(change.offset, change.bytes.size(), change.bytes);
}

void CrashPicture::sync() {
  for (const Change& change : pending_) apply(synced_, change);
  pending_.clear();
}

std::string CrashPicture::after(base::Random& random) const {
  constexpr std::size_t kSector = 512;
  // Mostly some of everything; now and then nearly nothing or nearly all, which random choices alone would never give.
  const double share = std::array{0.05, 0.5, 0.95}[static_cast<std::size_t>(random.below(3))];
  std::string file = synced_;
  for (const Change& change : pending_) {
    if (change.is_length) {
      if (random.uniform() < share) apply(file, change);
      continue;
    }
    for (std::size_t at = 0; at < change.bytes.size();) {
      const std::size_t end = std::min(change.bytes.size(), at + kSector - (change.offset + at) % kSector);
      if (random.uniform() < share) apply(file, {change.offset + at, change.bytes.substr(at, end - at), false});
      at = end;
    }
  }
  return file;
}

}  // namespace tactus::store
