#include "core/base/text.h"

#include <chrono>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

#include "core/base/clock.h"
#include "core/base/random.h"

namespace tactus::base {
namespace {

using Limits = std::numeric_limits<double>;

TEST(Text, NumbersReadBackToTheLastBit) {
  EXPECT_EQ(formatNumber(0.1), "0.1");
  EXPECT_EQ(formatNumber(600), "600");
  EXPECT_EQ(formatNumber(-Limits::infinity()), "-inf");
  EXPECT_EQ(formatNumber(-Limits::quiet_NaN()), "nan");
  EXPECT_EQ(parseNumber(formatNumber(Limits::denorm_min())), Limits::denorm_min());
  EXPECT_EQ(parseNumber(formatNumber(Limits::max())), Limits::max());
  Random random(7);
  for (int i = 0; i < 20000; ++i) {
    const std::uint64_t bits = random.next();
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    if (!std::isfinite(value)) continue;
    ASSERT_EQ(parseNumber(formatNumber(value)), value);
  }
}

TEST(Text, NumbersAreTheWholeText) {
  EXPECT_EQ(parseNumber("-1.5e3"), -1500);
  for (const char* const text : {"", " 1", "1 ", "+1", "1,5", "1.5x", "0x10", "--1", "1e999", "1e-999", "."}) {
    EXPECT_FALSE(parseNumber(text).has_value()) << text;
  }
  EXPECT_EQ(parseInteger("-42"), -42);
  for (const char* const text : {"", "1.0", "1e3", " 1", "9223372036854775808"}) {
    EXPECT_FALSE(parseInteger(text).has_value()) << text;
  }
}

TEST(Text, FixedDecimalsForPeople) {
  EXPECT_EQ(formatFixed(0.126667, 3), "0.127");
  EXPECT_EQ(formatFixed(-2, 1), "-2.0");
  EXPECT_EQ(formatFixed(Limits::quiet_NaN(), 1), "nan");
  EXPECT_EQ(formatFixed(Limits::max(), 2).size(), 312U);
}

TEST(Text, Utf8AsRfc3629Says) {
  for (const char* const good : {"", "a", "\xC2\x80", "\xDF\xBF", "\xE0\xA0\x80", "\xED\x9F\xBF", "\xEE\x80\x80",
                                 "\xF0\x90\x80\x80", "\xF4\x8F\xBF\xBF", "größe 🙂"}) {
    EXPECT_TRUE(isUtf8(good)) << good;
  }
  for (const char* const bad : {"\x80", "\xC0\x80", "\xC1\xBF", "\xC2", "\xC2g", "\xE0\x9F\xBF", "\xED\xA0\x80",
                                "\xE2\x82", "\xF0\x8F\xBF\xBF", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF"}) {
    EXPECT_FALSE(isUtf8(bad));
  }
}

TEST(Text, SmallTools) {
  EXPECT_EQ(trimmed(" \ta b\t "), "a b");
  EXPECT_EQ(trimmed(" \t"), "");
  EXPECT_EQ(lowered("ÄBc-Z"), "Äbc-z");
  EXPECT_EQ(joined(std::vector<std::string>{"a", "b"}, ", "), "a, b");
}

TEST(Text, PartsAreReplacedOnePairAfterAnother) {
  EXPECT_EQ(replaced("a-b-c", {{"-", "--"}}), "a--b--c") << "what is put in stays";
  EXPECT_EQ(replaced("</script>", {{"</", "<\\/"}, {"/", "|"}}), "<\\|script>");
  EXPECT_EQ(replaced("aaa", {{"aa", ""}}), "a");
  EXPECT_EQ(replaced("nothing", {{"x", "y"}}), "nothing");
  EXPECT_EQ(replaced("", {{"x", "y"}}), "");
}

TEST(Clock, UtcAsIso8601) {
  // Seconds from `date -u -d 2026-11-21T08:00:00Z +%s`.
  EXPECT_EQ(formatUtc(std::chrono::system_clock::from_time_t(1795248000)), "2026-11-21T08:00:00Z");
}

}  // namespace
}  // namespace tactus::base
