// Any bytes into a session of the live link, for fuzzing: the first byte says how they are cut into pieces.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <string_view>

#include "app/link/client_session.h"
#include "core/base/check.h"
#include "core/base/text.h"

#include "tests/support/ngt_model.h"

namespace tactus::link {

/// Stops the program where the session breaks what it promises. Returns everything that it sent.
inline std::string driveSession(std::string_view bytes) {
  static const ServedModel model{1,
                                 *fuzzy::compile(support::s4FiveRegions()),
                                 std::make_shared<const std::string>("{\"model\":{\"serial\":1}}\n"),
                                 {"lubrication", "neck_flexion", "depth", "speed"}};
  const SessionNeeds needs{model, "0123456789abcdef", "fuzz", true};
  const std::size_t piece = bytes.empty() ? 1 : 1 + static_cast<unsigned char>(bytes.front());
  if (!bytes.empty()) bytes.remove_prefix(1);
  ClientSession session;
  std::string sent;
  while (!bytes.empty() && session.phase() != ClientSession::Phase::kEnding) {
    TACTUS_CHECK(session.wantsInput());
    session.receive(bytes.substr(0, piece));
    bytes.remove_prefix(std::min(piece, bytes.size()));
    while (session.hasWork()) {
      session.work(3, needs);
      if (const auto felt = session.takeFelt())
        TACTUS_CHECK(std::abs(felt->depth_mm) <= kFarthestFelt && std::abs(felt->force_n) <= kFarthestFelt);
      // A slow client: it takes a part of what is there.
      const auto output = session.output();
      const std::size_t taken = output.size() - output.size() / 3;
      sent += output.substr(0, taken);
      session.sent(taken);
    }
  }
  for (auto output = session.output(); !output.empty(); output = session.output()) {
    sent += output;
    session.sent(output.size());
  }
  TACTUS_CHECK(sent.empty() || sent.back() == '\n');
  TACTUS_CHECK(base::isUtf8(sent));
  const bool has_ended = session.phase() == ClientSession::Phase::kEnding;
  TACTUS_CHECK(has_ended == (sent.find("{\"error\":") != std::string::npos));
  return sent;
}

}  // namespace tactus::link
