// A HID device made of software: the Linux kernel presents it like one on USB. Needs /dev/uhid.
#pragma once

#include <cstdint>
#include <functional>
#include <linux/uhid.h>
#include <span>
#include <string>
#include <vector>

namespace tactus::vm {

struct UhidIdentity {
  std::string name;
  std::string serial;
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
};

/// What the device does with the reports of the host. The first byte of each report is its id.
struct UhidHandlers {
  std::function<void(std::span<const std::uint8_t> report)> output;
  /// False: refused.
  std::function<bool(std::span<const std::uint8_t> report)> set_feature;
  /// The whole report with its id; empty: the device has none of this id.
  std::function<std::vector<std::uint8_t>(std::uint8_t id)> get_feature;
};

class UhidNode {
 public:
  /// Plugged in at once. Stops the program when /dev/uhid refuses.
  UhidNode(const UhidIdentity& identity, std::span<const std::uint8_t> descriptor, UhidHandlers handlers);
  /// Unplugs.
  ~UhidNode();
  UhidNode(const UhidNode&) = delete;
  UhidNode& operator=(const UhidNode&) = delete;

  /// To wait for: readable when the kernel has something for the device.
  int descriptor() const noexcept { return fd_; }
  /// Handles one event of the kernel.
  void serve();
  void sendInput(std::span<const std::uint8_t> report);

 private:
  void answer(const uhid_event& event);

  int fd_;
  UhidHandlers handlers_;
};

}  // namespace tactus::vm
