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

TEST(Error, EveryCodeHasItsText) {
  for (int code = 1; code <= static_cast<int>(ErrorCode::kData); ++code) {
    EXPECT_NE(describe(static_cast<ErrorCode>(code)), "unknown error") << code;
  }
}

}  // namespace
}  // namespace tactus::base
