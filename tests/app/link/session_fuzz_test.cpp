#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/base/random.h"

#include "tests/app/link/session_drive.h"

namespace tactus::link {
namespace {

/// `text` with some bytes changed, doubled, left out or put elsewhere.
std::string damaged(std::string text, base::Random& random) {
  for (int edits = random.below(6); edits > 0 && !text.empty(); --edits) {
    const auto at = static_cast<std::size_t>(random.below(static_cast<int>(text.size())));
    const auto length = static_cast<std::size_t>(random.below(12));
    switch (random.below(5)) {
      case 0: text[at] = static_cast<char>(random.below(256)); break;
      case 1: text.erase(at, length); break;
      case 2:
        text.insert(at, text.substr(static_cast<std::size_t>(random.below(static_cast<int>(text.size()))), length));
        break;
      case 3: text.insert(at, length * 20, "[{\"\\\n0"[random.below(6)]); break;
      default: text.insert(at, random.below(2) == 0 ? "1e999" : "\xff");
    }
  }
  return text;
}

TEST(SessionFuzz, AnyBytesAreAnsweredOrRefusedInWholeLines) {
  const std::string good =
      "{\"hello\":\"tactus-link\",\"version\":1,\"token\":\"0123456789abcdef\",\"want\":[\"model\",\"state\"],"
      "\"state_hz\":50,\"name\":\"x\"}\n{\"ask\":{\"id\":1,\"inputs\":[1,45,30,30]}}\n"
      "{\"felt\":{\"time_s\":1,\"depth_mm\":20,\"speed_mm_s\":3,\"force_n\":0.2,\"conditions\":{\"depth\":1}}}\n"
      "{\"ask\":{\"id\":\"two\",\"inputs\":[0.5,0,-1e3,1E2]}}\n";
  base::Random random(18);
  int answered = 0;
  int refused = 0;
  for (int i = 0; i < 20'000; ++i) {
    const std::string sent = driveSession(static_cast<char>(random.below(256)) + damaged(good, random));
    for (std::size_t at = 0; at < sent.size();) {
      const auto end = sent.find('\n', at);
      ASSERT_TRUE(nlohmann::json::accept(sent.substr(at, end - at))) << sent;
      at = end + 1;
    }
    answered += sent.find("\"answer\"") != std::string::npos ? 1 : 0;
    refused += sent.find("\"error\"") != std::string::npos ? 1 : 0;
  }
  EXPECT_GT(answered, 2000);
  EXPECT_GT(refused, 2000);
}

}  // namespace
}  // namespace tactus::link
