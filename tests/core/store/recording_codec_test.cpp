#include "core/store/recording_codec.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "core/base/random.h"

namespace tactus::store {
namespace {

using study::Recording;

// `TREC`, layout 1, one channel, two samples, 1000 Hz (0x408F400000000000), `depth` `mm`, 1.5 (0x3FF8…) and -2
// (0xC000…).
const std::string kBody(
    "TREC\x01\x00\x01\x00\x02\x00\x00\x00\x00\x00\x00\x00\x00\x40\x8F\x40\x05"
    "depth\x02mm\x00\x00\x00\x00\x00\x00\xF8\x3F\x00\x00\x00\x00\x00\x00\x00\xC0",
    4 + 2 + 2 + 4 + 8 + 6 + 3 + 16);

TEST(RecordingCodec, BytesAreAsDocumented) {
  const auto bytes = encodeRecording({1000, {{"depth", "mm", {1.5, -2}}}});
  ASSERT_TRUE(bytes);
  ASSERT_EQ(bytes->size(), kBody.size() + 4);
  EXPECT_EQ(bytes->substr(0, kBody.size()), kBody);
  // From python3: zlib.crc32 of the bytes above, little-endian.
  EXPECT_EQ(bytes->substr(kBody.size()), std::string("\x6B\x2C\xA8\xF8", 4));
}

TEST(RecordingCodec, EveryDoubleComesBackAsItWas) {
  base::Random random(5);
  Recording recording{333.25, {{"depth", "mm", {}}, {"force", "N", {}}, {"µ-track", "µm", {}}}};
  for (int i = 0; i < 500; ++i) {
    recording.channels[0].values.push_back(random.normal());
    recording.channels[1].values.push_back(std::ldexp(random.uniform(), random.below(2000) - 1060));
    recording.channels[2].values.push_back(i % 2 == 0 ? -0.0 : std::numeric_limits<double>::denorm_min());
  }
  const auto read = decodeRecording(*encodeRecording(recording));
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(*read, recording);
  EXPECT_TRUE(std::signbit(read->channels[2].values[0]));
  EXPECT_EQ(*decodeRecording(*encodeRecording({1000, {}})), (Recording{1000, {}}));
  EXPECT_EQ(*decodeRecording(*encodeRecording({1000, {{"depth", "mm", {}}}})),
            (Recording{1000, {{"depth", "mm", {}}}}));
}

TEST(RecordingCodec, EveryChangedByteAndEveryCutIsFoundOut) {
  const auto bytes = *encodeRecording({1000, {{"depth", "mm", {1.5, -2}}}});
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    for (unsigned bit = 0; bit < 8; ++bit) {
      auto changed = bytes;
      changed[at] = static_cast<char>(static_cast<unsigned char>(changed[at]) ^ (1U << bit));
      EXPECT_FALSE(decodeRecording(changed)) << at;
    }
    EXPECT_FALSE(decodeRecording(bytes.substr(0, at)));
  }
  EXPECT_FALSE(decodeRecording(bytes + "x"));
}

TEST(RecordingCodec, WhatCannotBeStoredIsRefused) {
  const auto message = [](const Recording& recording) {
    const auto bytes = encodeRecording(recording);
    return bytes ? "" : bytes.error().message();
  };
  EXPECT_NE(message({0, {}}).find("wanted a rate above 0"), std::string::npos);
  EXPECT_NE(message({std::nan(""), {}}), "");
  EXPECT_NE(message({1000, {{"a", "mm", {1, 2}}, {"b", "N", {1}}}}).find("channels of 2 and 1 samples"),
            std::string::npos);
  EXPECT_NE(message({1000, {{"a", "mm", {1, std::nan("")}}}}).find("nan in the channel 'a'"), std::string::npos);
  EXPECT_NE(message({1000, {{std::string(256, 'a'), "mm", {1}}}}), "");
}

}  // namespace
}  // namespace tactus::store
