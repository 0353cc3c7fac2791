// A session of a PID device on a fake line, under virtual time: what its tests share.
#pragma once

#include <array>
#include <cstdint>
#include <gtest/gtest.h>
#include <memory>
#include <vector>

#include "core/haptics/hid/pid_session.h"

#include "tests/core/haptics/hid/fake_transport.h"

namespace tactus::haptics {

class PidRun {
 public:
  explicit PidRun(support::PidModel model)
      : line(std::make_shared<FakeLine>(model)),
        transport(line),
        session(
            transport, *PidLayout::find(*ReportDescriptor::parse(*transport.descriptor())),
            [this](int ms) {
              line->now_ns += ms * std::int64_t{1'000'000};
              ++pauses;
            },
            [this] { return now(); }) {}

  std::int64_t now() const { return line->now_ns; }
  void send(double x, double y) {
    const auto done = session.send({x, y}, now());
    EXPECT_TRUE(done) << done.error().message();
  }
  std::array<double, 2> force() const {
    return line->with([this](const auto& device) { return device.force(now()); });
  }
  std::vector<Bytes> reports() const {
    std::vector<Bytes> out;
    for (const Sent& sent : line->sent()) out.push_back(sent.report);
    return out;
  }

  int pauses = 0;
  std::shared_ptr<FakeLine> line;
  FakeTransport transport;
  PidSession session;
};

}  // namespace tactus::haptics
