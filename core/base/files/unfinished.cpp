#include "core/base/files/unfinished.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <mutex>
#include <random>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <vector>

namespace tactus::base {
namespace {

constexpr std::string_view kLetters = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
constexpr std::size_t kRandomLetters = 6;
constexpr int kMostDraws = 100;
constexpr std::size_t kKeptNames = 64;

std::string drawnName(const std::string& path, std::string_view ending) {
  std::random_device device;
  std::uniform_int_distribution<std::size_t> letter(0, kLetters.size() - 1);
  std::string name = path + std::string(ending);
  for (std::size_t i = 0; i < kRandomLetters; ++i) name += kLetters[letter(device)];
  return name;
}

/// Whether the open file or folder still has the name `path`.
bool isNamed(const Descriptor& descriptor, const std::string& path) {
  struct stat open_one {};
  struct stat named {};
  return ::fstat(descriptor.number(), &open_one) == 0 && ::lstat(path.c_str(), &named) == 0 &&
         open_one.st_dev == named.st_dev && open_one.st_ino == named.st_ino;
}

bool takeIntoUse(const Descriptor& descriptor) { return ::flock(descriptor.number(), LOCK_EX | LOCK_NB) == 0; }

/// The names that this process has drawn. Most are gone again soon: their files were renamed.
struct DrawnNames {
  std::recursive_mutex mutex;
  std::vector<std::string> names;

  void add(const std::string& name) {
    if (names.size() >= kKeptNames) {
      std::error_code ignored;
      std::erase_if(names, [&](const std::string& one) { return !std::filesystem::exists(one, ignored); });
    }
    names.push_back(name);
  }
};

DrawnNames& drawnNames() {
  static auto* const kNames = new DrawnNames;  // never destroyed: a signal may come at the very end
  return *kNames;
}

std::atomic<int> exchanges{0};
static_assert(std::atomic<int>::is_always_lock_free);

/// Draws names until `make` finds one free; what `make` opened, in use.
template <class Make>
Unfinished draw(const std::string& path, std::string_view ending, Make make) {
  const Exchange exchange;
  for (int i = 0; i < kMostDraws; ++i) {
    std::string name = drawnName(path, ending);
    Descriptor descriptor(make(name));
    if (!descriptor.isOpen() && errno == EEXIST) continue;
    // Some file systems have no locks; then nothing there is ever taken for unused.
    if (!descriptor.isOpen() || !takeIntoUse(descriptor) || isNamed(descriptor, name)) {
      if (descriptor.isOpen()) drawnNames().add(name);
      return {std::move(name), std::move(descriptor)};
    }
    // Between the making and the lock another program has taken it for a leftover and deleted it.
  }
  return {path, Descriptor()};
}

}  // namespace

Unfinished makeUnfinishedFile(const std::string& path, mode_t mode) {
  return draw(path, kUnfinishedEnding, [mode](const std::string& name) {
    return ::open(name.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode);
  });
}

Unfinished makeUnfinishedFolder(const std::string& path, std::string_view ending) {
  return draw(path, ending, [](const std::string& name) {
    return ::mkdir(name.c_str(), 0700) == 0 ? ::open(name.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC) : -1;
  });
}

void removeUnfinished() noexcept {
  DrawnNames& drawn = drawnNames();
  const std::lock_guard lock(drawn.mutex);
  std::error_code ignored;
  for (const std::string& name : drawn.names) std::filesystem::remove_all(name, ignored);
}

Exchange::Exchange() {
  drawnNames().mutex.lock();
  ++exchanges;
}

Exchange::~Exchange() {
  --exchanges;
  drawnNames().mutex.unlock();
}

bool isExchanging() noexcept { return exchanges.load() > 0; }

bool isUnfinishedName(std::string_view name, std::string_view whole, std::string_view ending) {
  if (!name.starts_with(whole)) return false;
  name.remove_prefix(whole.size());
  if (!name.starts_with(ending)) return false;
  name.remove_prefix(ending.size());
  return name.size() == kRandomLetters && name.find_first_not_of(kLetters) == std::string_view::npos;
}

Descriptor takeUnused(const std::string& path) {
  Descriptor found(::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  return found.isOpen() && takeIntoUse(found) && isNamed(found, path) ? std::move(found) : Descriptor();
}

}  // namespace tactus::base
