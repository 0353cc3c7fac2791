#include "core/haptics/hid/hidapi_transport.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <hidapi/hidapi.h>
#include <linux/hidraw.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "core/base/files/file.h"
#include "core/haptics/hid/report_descriptor.h"

namespace tactus::haptics {
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
  const auto bytes = base::readFile(file.string(), ReportDescriptor::kMostBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  return std::vector<std::uint8_t>(bytes->begin(), bytes->end());
}

}  // namespace tactus::haptics
