#include <gtest/gtest.h>
#include <string>

#include "core/base/files/checksums.h"

namespace tactus::base {
namespace {

TEST(Crc32, CheckValueOfTheCatalog) {
  // The check value that every description of this CRC gives for the nine digits.
  EXPECT_EQ(crc32("123456789"), 0xCBF43926U);
  EXPECT_EQ(crc32(""), 0U);
}

TEST(Crc32, ManyBytesAtOnceOrInPiecesGiveTheSame) {
  // From python3: zlib.crc32(bytes((i * i * 7 + 3 * i + 1) & 255 for i in range(1003)))
  std::string bytes;
  for (unsigned i = 0; i < 1003; ++i) bytes += static_cast<char>((i * i * 7 + 3 * i + 1) & 255U);
  EXPECT_EQ(crc32(bytes), 0xCBC6A012U);
  for (std::size_t cut = 0; cut < 40; ++cut) {
    const std::string_view all = bytes;
    EXPECT_EQ(Crc32().add(all.substr(0, cut)).add(all.substr(cut)).value(), 0xCBC6A012U);
  }
}

TEST(Crc32, OneChangedBitChangesIt) {
  std::string bytes(1000, 'x');
  const auto before = crc32(bytes);
  for (std::size_t at = 0; at < bytes.size(); at += 37) {
    bytes[at] = static_cast<char>(bytes[at] ^ 4);
    EXPECT_NE(crc32(bytes), before);
    bytes[at] = static_cast<char>(bytes[at] ^ 4);
  }
}

TEST(Sha256, ExamplesOfTheStandard) {
  // NIST, "Examples with Intermediate Values", SHA-256, and the empty message.
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, EveryLengthAroundABlock) {
  // From coreutils: head -c N /dev/zero | tr '\0' x | sha256sum
  EXPECT_EQ(sha256(std::string(55, 'x')), "d5e285683cd4efc02d021a5c62014694958901005d6f71e89e0989fac77e4072");
  EXPECT_EQ(sha256(std::string(56, 'x')), "04c26261370ee7541549d16dee320c723e3fd14671e66a099afe0a377c16888e");
  EXPECT_EQ(sha256(std::string(63, 'x')), "75220b47218278e656f2013bb8f0c455a25eaf01e86c64924e9d48d89776d6f2");
  EXPECT_EQ(sha256(std::string(64, 'x')), "7ce100971f64e7001e8fe5a51973ecdfe1ced42befe7ee8d5fd6219506b5393c");
  EXPECT_EQ(sha256(std::string(65, 'x')), "9537c5fdf120482f7d58d25e9ed583f52c02b4e304ea814db1633ad565aed7e9");
  EXPECT_EQ(sha256(std::string(119, 'x')), "000b48d4edf0fa7bee3c6236ecd2785baa5db4eeb8bb54341b029e0d9fa5fb0c");
  EXPECT_EQ(sha256(std::string(120, 'x')), "13f05a0b594787f5ecd315edc96141bd3243203d1b7d4f0836f37308b276ba98");
}

TEST(Sha256, PiecesGiveWhatTheWholeGives) {
  std::string bytes;
  for (int i = 0; i < 300; ++i) bytes += static_cast<char>(i * 7);
  for (const std::size_t piece : {1U, 3U, 63U, 64U, 65U, 130U}) {
    Sha256 hash;
    for (std::size_t at = 0; at < bytes.size(); at += piece) hash.add(std::string_view(bytes).substr(at, piece));
    EXPECT_EQ(hash.text(), sha256(bytes)) << piece;
  }
}

}  // namespace
}  // namespace tactus::base
