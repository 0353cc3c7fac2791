#include "tests/vm/uhid_node.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <linux/input.h>
#include <memory>
#include <unistd.h>
#include <utility>

namespace tactus::vm {
namespace {

[[noreturn]] void giveUp(const char* what) {
  std::printf("uhid: %s: %s\n", what, std::strerror(errno));
  std::exit(2);
}

/// Events are 4.4 KB and begin as zeros.
std::unique_ptr<uhid_event> newEvent(std::uint32_t type) {
  auto event = std::make_unique<uhid_event>();
  event->type = type;
  return event;
}

void send(int fd, const uhid_event& event) {
  if (write(fd, &event, sizeof event) != static_cast<ssize_t>(sizeof event)) giveUp("write");
}

template <std::size_t N>
void copyText(const std::string& text, std::uint8_t (&out)[N]) {
  std::copy_n(text.begin(), std::min(text.size(), N - 1), out);
}

}  // namespace

UhidNode::UhidNode(const UhidIdentity& identity, std::span<const std::uint8_t> descriptor, UhidHandlers handlers)
    : fd_(open("/dev/uhid", O_RDWR | O_CLOEXEC)), handlers_(std::move(handlers)) {
  if (fd_ < 0) giveUp("/dev/uhid");
  const auto event = newEvent(UHID_CREATE2);
  uhid_create2_req& request = event->u.create2;
  if (descriptor.size() > sizeof request.rd_data) giveUp("the descriptor is too long");
  copyText(identity.name, request.name);
  copyText(identity.serial, request.uniq);
  request.bus = BUS_USB;  // hidapi leaves out virtual ones
  request.vendor = identity.vendor;
  request.product = identity.product;
  request.rd_size = static_cast<std::uint16_t>(descriptor.size());
  std::ranges::copy(descriptor, request.rd_data);
  send(fd_, *event);
}

UhidNode::~UhidNode() {
  send(fd_, *newEvent(UHID_DESTROY));
  close(fd_);
}

void UhidNode::serve() {
  const auto event = newEvent(0);
  if (read(fd_, event.get(), sizeof *event) <= 0) giveUp("read");
  answer(*event);
}

void UhidNode::answer(const uhid_event& event) {
  switch (event.type) {
    case UHID_OUTPUT: handlers_.output({event.u.output.data, event.u.output.size}); break;
    case UHID_SET_REPORT: {
      const bool accepted = handlers_.set_feature({event.u.set_report.data, event.u.set_report.size});
      const auto reply = newEvent(UHID_SET_REPORT_REPLY);
      reply->u.set_report_reply.id = event.u.set_report.id;
      reply->u.set_report_reply.err = accepted ? 0 : EIO;
      send(fd_, *reply);
      break;
    }
    case UHID_GET_REPORT: {
      const std::vector<std::uint8_t> report = handlers_.get_feature(event.u.get_report.rnum);
      const auto reply = newEvent(UHID_GET_REPORT_REPLY);
      reply->u.get_report_reply.id = event.u.get_report.id;
      reply->u.get_report_reply.err = report.empty() ? EIO : 0;
      reply->u.get_report_reply.size = static_cast<std::uint16_t>(report.size());
      std::ranges::copy(report, reply->u.get_report_reply.data);
      send(fd_, *reply);
      break;
    }
    default:  // start, stop, open, close: nothing to do
      break;
  }
}

void UhidNode::sendInput(std::span<const std::uint8_t> report) {
  const auto event = newEvent(UHID_INPUT2);
  event->u.input2.size = static_cast<std::uint16_t>(report.size());
  std::ranges::copy(report, event->u.input2.data);
  send(fd_, *event);
}

}  // namespace tactus::vm
