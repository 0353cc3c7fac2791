#include "core/haptics/hid/hidapi_transport.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <hidapi/hidapi.h>
#include <linux/hidraw.h>
#include <string_view>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/text.h"
#include "core/haptics/hid/report_descriptor.h"

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

namespace {

/// hidapi's texts are wide; what is not ASCII in them is of no use in a message.
std::string narrowed(const wchar_t* text) {
  std::string out;
  for (; text != nullptr && *text != 0; ++text) out += *text < 0x80 ? static_cast<char>(*text) : '?';
  return out.empty() ? "an error without a text" : out;
}

base::Result<std::vector<std::uint8_t>> askKernel(const std::string& path) {
  const auto refuse = [&](const char* what) {
    return base::inFile(base::fail(base::ErrorCode::kIo, what, std::strerror(errno), "a HID device").value(), path);
  };
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return refuse("report descriptor");
  int size = 0;
  hidraw_report_descriptor raw{};
  const bool has_size = ::ioctl(file, HIDIOCGRDESCSIZE, &size) >= 0 && size >= 0 && size <= HID_MAX_DESCRIPTOR_SIZE;
  raw.size = has_size ? static_cast<__u32>(size) : 0;
  const bool has_bytes = has_size && ::ioctl(file, HIDIOCGRDESC, &raw) >= 0;
  if (!has_bytes) {
    const auto error = refuse("report descriptor");
    ::close(file);
    return error;
  }
  ::close(file);
  return std::vector<std::uint8_t>(raw.value, raw.value + raw.size);
}

}  // namespace

base::Result<std::unique_ptr<HidTransport>> HidapiTransport::open(const std::string& path) {
  auto lock = NodeLock::take(path);
  if (!lock) return tl::unexpected(lock.error());
  hid_device* const reads = hid_open_path(path.c_str());
  hid_device* const writes = reads != nullptr ? hid_open_path(path.c_str()) : nullptr;
  if (writes == nullptr) {
    auto error = base::fail(base::ErrorCode::kIo, "", narrowed(hid_error(nullptr)),
                            "a HID device that may be opened (docs/devices.md: permission)");
    if (reads != nullptr) hid_close(reads);
    return base::inFile(error.value(), path);
  }
  return std::unique_ptr<HidTransport>(new HidapiTransport(path, *std::move(lock), reads, writes));
}

HidapiTransport::~HidapiTransport() {
  hid_close(reads_);
  hid_close(writes_);
}

tl::unexpected<base::Error> HidapiTransport::failed(hid_device_* handle, const char* what) const {
  return base::inFile(
      base::fail(base::ErrorCode::kIo, what, narrowed(hid_error(handle)), "a device that answers").value(), path_);
}

base::Result<std::vector<std::uint8_t>> HidapiTransport::descriptor() {
  // hidapi has a call for this from 0.14 on only.
  auto asked = askKernel(path_);
  if (asked) return asked;
  auto kept = descriptorOfNode(path_);
  return kept ? kept : asked;
}

base::Result<void> HidapiTransport::write(std::span<const std::uint8_t> report) {
  const int written = hid_write(writes_, report.data(), report.size());
  if (written < 0 || static_cast<std::size_t>(written) < report.size()) return failed(writes_, "output report");
  return {};
}

base::Result<void> HidapiTransport::sendFeature(std::span<const std::uint8_t> report) {
  if (hid_send_feature_report(writes_, report.data(), report.size()) < 0) return failed(writes_, "feature report");
  return {};
}

base::Result<std::size_t> HidapiTransport::getFeature(std::span<std::uint8_t> report) {
  const int length = hid_get_feature_report(writes_, report.data(), report.size());
  if (length < 0) return failed(writes_, "feature report");
  return static_cast<std::size_t>(length);
}

base::Result<std::size_t> HidapiTransport::readTimeout(std::span<std::uint8_t> room, int timeout_ms) {
  errno = 0;
  const int length = hid_read_timeout(reads_, room.data(), room.size(), timeout_ms);
  if (length < 0 && errno == EINTR) return std::size_t{0};
  if (length < 0) return failed(reads_, "input report");
  return static_cast<std::size_t>(length);
}

base::Result<std::vector<std::uint8_t>> descriptorOfNode(const std::string& path, const std::string& system_folder) {
  const auto file =
      std::filesystem::path(system_folder) / std::filesystem::path(path).filename() / "device" / "report_descriptor";
  TACTUS_TRY(const auto bytes, base::readFile(file.string(), ReportDescriptor::kMostBytes));
  return std::vector<std::uint8_t>(bytes.begin(), bytes.end());
}

}  // namespace tactus::haptics
