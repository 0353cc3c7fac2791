#include "core/haptics/hid/node_lock.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <string_view>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>
#include <utility>
#include <vector>

#include "core/base/files/file.h"
#include "core/base/text.h"

namespace tactus::haptics {
namespace {

constexpr std::size_t kMostBytes = std::size_t{1} << 20U;

std::vector<std::string_view> wordsOf(std::string_view line) {
  std::vector<std::string_view> words;
  while (!(line = base::trimmed(line)).empty()) {
    const auto end = std::min(line.find(' '), line.size());
    words.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
  return words;
}

template <class Number>
std::optional<Number> numberOf(std::string_view text, int base) {
  Number number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, base);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// The process of a line of /proc/locks such as `1: FLOCK  ADVISORY  WRITE 4711 00:05:123 0 EOF`, where it is a lock of
/// ours on this node. A line with `->` waits for a lock.
std::optional<int> processOf(std::string_view line, const struct stat& node) {
  const auto words = wordsOf(line);
  if (words.size() < 6 || words[1] != "FLOCK" || words[3] != "WRITE") return std::nullopt;
  const std::string_view place = words[5];  // major:minor:inode
  const auto first = place.find(':');
  const auto last = place.rfind(':');
  if (first == std::string_view::npos || first == last) return std::nullopt;
  const auto major_number = numberOf<unsigned>(place.substr(0, first), 16);
  const auto minor_number = numberOf<unsigned>(place.substr(first + 1, last - first - 1), 16);
  const auto inode = numberOf<std::uint64_t>(place.substr(last + 1), 10);
  if (major_number != major(node.st_dev) || minor_number != minor(node.st_dev) || inode != node.st_ino)
    return std::nullopt;
  return numberOf<int>(words[4], 10);
}

/// What can be shown of it: a name comes from another program.
std::string shown(std::string_view name) {
  std::string out;
  for (const char c : name.substr(0, std::min(name.find_first_of(std::string_view("\0\n", 2)), name.size())))
    if (c > 0x20 && c < 0x7F) out += c;
  return out;
}

/// The name that a process was started by; the kernel's own keeps 15 characters only.
std::string programOf(int process, const std::string& process_folder) {
  const auto folder = std::filesystem::path(process_folder) / std::to_string(process);
  const std::string comm = shown(base::readFile((folder / "comm").string(), kMostBytes).value_or(""));
  const auto started = base::readFile((folder / "cmdline").string(), kMostBytes);
  if (!started) return comm;
  const std::string command = started->substr(0, started->find('\0'));
  std::string name = shown(std::filesystem::path(command).filename().string());
  return name.starts_with(comm) ? name : comm;
}

}  // namespace

bool NodeHolder::isThisProgram() const { return process == ::getpid(); }

std::string NodeHolder::text() const {
  return (program.empty() ? "another program" : program) + " (process " + std::to_string(process) + ")";
}

std::optional<NodeHolder> holderOf(const std::string& path, const std::string& locks_file,
                                   const std::string& process_folder) {
  struct stat node {};
  if (::stat(path.c_str(), &node) != 0) return std::nullopt;
  const auto locks = base::readFile(locks_file, kMostBytes);
  if (!locks) return std::nullopt;
  for (std::string_view rest = *locks; !rest.empty();) {
    const auto end = std::min(rest.find('\n'), rest.size());
    if (const auto process = processOf(rest.substr(0, end), node); process && *process > 0)
      return NodeHolder{*process, programOf(*process, process_folder)};
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return std::nullopt;
}

base::Result<NodeLock> NodeLock::take(const std::string& path) {
  const auto refuse = [&](std::string found, const char* wanted) {
    return base::inFile(base::fail(base::ErrorCode::kIo, "", std::move(found), wanted).value(), path);
  };
  const int file = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) return refuse(std::strerror(errno), "a HID device that may be opened (docs/devices.md: permission)");
  NodeLock lock(file);
  if (::flock(file, LOCK_EX | LOCK_NB) == 0) return lock;
  if (errno != EWOULDBLOCK) return refuse(std::strerror(errno), "a HID device that can be kept for this program");
  const auto holder = holderOf(path);
  if (holder && holder->isThisProgram())
    return refuse("a device that this program has open already", "one that is not in use");
  return refuse("a device in use by " + (holder ? holder->text() : "another program"),
                "one that no other program has open (close that program, or stop its device there)");
}

NodeLock::~NodeLock() {
  if (file_ >= 0) ::close(file_);
}

NodeLock& NodeLock::operator=(NodeLock&& other) noexcept {
  std::swap(file_, other.file_);
  return *this;
}

}  // namespace tactus::haptics
