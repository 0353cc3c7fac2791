#include "core/base/error.h"

#include <gtest/gtest.h>
#include <string>

namespace tactus::base {
namespace {

TEST(Error, OneSentence) {
  EXPECT_EQ((Error{ErrorCode::kValue, "f.json", "/a", "1", "2"}).message(), "f.json: /a: found 1, wanted 2");
  EXPECT_EQ((Error{ErrorCode::kIo, "f.json", "", "nothing", "a file"}).message(),
            "f.json: found nothing, wanted a file");
  EXPECT_EQ((Error{ErrorCode::kIo, "two\nlines", "", "\t", "\x7f"}).message(),
            "two\\x0alines: found \\x09, wanted \\x7f");
}

TEST(Error, APlaceOfAnyLengthStaysShort) {
  const Error error{ErrorCode::kSchema, "f", std::string(1000, '/'), "a", "b"};
  EXPECT_EQ(error.message(), "f: " + std::string(300, '/') + "…: found a, wanted b");
}

TEST(Error, TheFirstFileStays) {
  const auto error = inFile(inFile(fail(ErrorCode::kData, "here", "x", "y").value(), "inner").value(), "outer").value();
  EXPECT_EQ(error.file, "inner");
  EXPECT_EQ(error.code, ErrorCode::kData);
}

TEST(Error, QuotedTextIsShortAndHarmless) {
  EXPECT_EQ(base::quoted(""), "''");
  EXPECT_EQ(base::quoted(std::string_view("a\n\0\x1b[31m", 8)), "'a\\x0a\\x00\\x1b[31m'");
  EXPECT_EQ(base::quoted(std::string(60, 'x')), "'" + std::string(60, 'x') + "'");
  EXPECT_EQ(base::quoted(std::string(61, 'x')), "'" + std::string(60, 'x') + "…'");
  // The 60th byte is in the middle of a character, which goes as a whole.
  EXPECT_EQ(base::quoted(std::string(59, 'x') + "äö"), "'" + std::string(59, 'x') + "…'");
}

TEST(Error, NothingInAMessageSteersATerminalOrTurnsItsText) {
  // C1 (CSI as U+009B), the controls of the writing direction of UAX #9, the separators of lines, and bytes that are no
  // UTF-8, which an 8-bit terminal may take for C1.
  EXPECT_EQ(oneLine("a\u009b31mb"), "a\\u009b31mb");
  EXPECT_EQ(oneLine("N\u202e10\u202c"), "N\\u202e10\\u202c");
  EXPECT_EQ(oneLine("\u061c\u200e\u200f\u202a\u2066\u2069\u2028\u2029"),
            "\\u061c\\u200e\\u200f\\u202a\\u2066\\u2069\\u2028\\u2029");
  EXPECT_EQ(oneLine("\x9b\xff\xc3"), "\\x9b\\xff\\xc3");
  EXPECT_EQ(oneLine("größe 🙂 – \u200d"), "größe 🙂 – \u200d") << "letters, dashes and joiners stay";
  EXPECT_EQ(oneLine(oneLine("a\x1b\u202e")), oneLine("a\x1b\u202e"));
  EXPECT_EQ(quoted("\u009b"), "'\\u009b'");
  EXPECT_EQ((Error{ErrorCode::kIo, "e\u202evil", "\u009b", "\x1b[2J", "\x7f"}).message(),
            "e\\u202evil: \\u009b: found \\x1b[2J, wanted \\x7f");
}

TEST(Error, TextOfSeveralLinesKeepsThem) { EXPECT_EQ(plainLines("a\nb\x1b\r\u0085\n"), "a\nb\\x1b\\x0d\\u0085\n"); }

TEST(Error, EveryCodeHasItsText) {
  for (int code = 1; code <= static_cast<int>(ErrorCode::kData); ++code) {
    EXPECT_NE(describe(static_cast<ErrorCode>(code)), "unknown error") << code;
  }
}

}  // namespace
}  // namespace tactus::base
