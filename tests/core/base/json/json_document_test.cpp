#include "core/base/json/json_document.h"

#include <gtest/gtest.h>
#include <string>

namespace tactus::base {
namespace {

std::string errorOf(std::string_view text) {
  const auto document = JsonDocument::parse(text);
  return document.has_value() ? "accepted" : document.error().message();
}

TEST(JsonDocument, ValuesKnowTheirPlace) {
  const auto document = JsonDocument::parse(R"({ "a": [1, { "b/c": [[], "x"] }], "~": { "k": null } })");
  ASSERT_TRUE(document.has_value());
  const JsonValue root = document->root();
  EXPECT_EQ(root.pointer(), "");
  std::vector<std::string> places;
  for (const JsonValue child : root) places.push_back(child.pointer());
  EXPECT_EQ(places, (std::vector<std::string>{"/a", "/~0"}));
  const JsonValue array = *root.find("a");
  const JsonValue object = *++array.begin();
  EXPECT_EQ(object.pointer(), "/a/1");
  const JsonValue inner = *object.find("b/c");
  EXPECT_EQ((*++inner.begin()).pointer(), "/a/1/b~1c/1");
  EXPECT_EQ(root.find("~")->find("k")->pointer(), "/~0/k");
  EXPECT_FALSE(root.find("b").has_value());
  EXPECT_EQ(root.json(), R"({ "a": [1, { "b/c": [[], "x"] }], "~": { "k": null } })");
}

TEST(JsonDocument, NumbersAreTheNearestDoubles) {
  const auto document = JsonDocument::parse(
      R"({ "v": [0.1, 1e22, -2.5E-3, 5e-324, 1.7976931348623157e308, 9007199254740993, 123456789012345678901] })");
  ASSERT_TRUE(document.has_value());
  std::vector<double> values;
  const JsonValue array = *document->root().find("v");
  for (const JsonValue value : array) values.push_back(value.number());
  EXPECT_EQ(values, (std::vector<double>{0.1, 1e22, -0.0025, 5e-324, 1.7976931348623157e308, 9007199254740992.0,
                                         123456789012345678901.0}));
}

TEST(JsonDocument, SyntaxErrorsSayWhereAndWhat) {
  EXPECT_EQ(errorOf(""), "found an empty text, wanted JSON");
  EXPECT_EQ(errorOf(" \r\n\t"), "found an empty text, wanted JSON");
  EXPECT_EQ(errorOf("{ \"a\": 1"), "line 1, column 9: found the end of the text, wanted the rest of the JSON");
  EXPECT_EQ(errorOf("{\n \"a\": \"tex"), "line 2, column 11: found the end of the text, wanted the rest of the JSON");
  EXPECT_EQ(errorOf("{\n\n  \"ä\": nul }"), "line 3, column 8: found 'nul', wanted correct JSON");
  EXPECT_EQ(errorOf("{ \"a\" 12.5 }"), "line 1, column 7: found '12.5', wanted correct JSON");
  EXPECT_EQ(errorOf("{ \"a\": 1. }"), "line 1, column 8: found '1.', wanted correct JSON");
  EXPECT_EQ(errorOf("{ \"a\" \"b\" }"), "line 1, column 7: found the string '\"b\"', wanted correct JSON");
  EXPECT_EQ(errorOf("{ 'a': 1 }"), "line 1, column 3: found ''', wanted correct JSON");
  EXPECT_EQ(errorOf("{ \"a\": 1 } x"), "line 1, column 12: found 'x', wanted correct JSON");
  EXPECT_EQ(errorOf("{ \"a\": 01 }"), "line 1, column 8: found '01', wanted correct JSON");
  EXPECT_EQ(errorOf("{ \"a\": [1, 2,\n] }"),
            "line 1, column 13: found a comma before ']', wanted no comma after the last value");
  EXPECT_EQ(errorOf("{ \"a\": NaN }"),
            "line 1, column 8: found 'NaN', wanted a number: JSON has no NaN and no infinity");
  EXPECT_EQ(errorOf("{ \"a\": -Infinity }"),
            "line 1, column 8: found '-Infinity', wanted a number: JSON has no NaN and no infinity");
  EXPECT_EQ(errorOf("{ \"a\": \"x\ny\" }"),
            "line 1, column 10: found the control character '\\x0a' in a string, wanted an escape such as \\n, or the "
            "end of the string");
  EXPECT_EQ(errorOf("{ \"a\": \"\\q\" }"),
            "line 1, column 10: found an unknown escape in a string, wanted one of \\\" \\\\ \\/ \\b \\f \\n \\r \\t "
            "\\uXXXX");
}

TEST(JsonDocument, TextThatIsNotUtf8IsRefused) {
  using namespace std::string_view_literals;
  EXPECT_EQ(errorOf("{ \"a\": \"caf\xE9\" }"),
            "line 1, column 12: found bytes that are not UTF-8, wanted JSON in UTF-8");
  EXPECT_EQ(errorOf("\xFF\xFE{\0}\0"sv), "line 1, column 4: found a zero byte, wanted JSON in UTF-8");
  EXPECT_EQ(errorOf("\x80\x81"), "line 1, column 1: found bytes that are not UTF-8, wanted JSON in UTF-8");
  EXPECT_EQ(errorOf("é"), "line 1, column 1: found 'é', wanted correct JSON");
  EXPECT_EQ(errorOf("{ }\0garbage"sv), "line 1, column 4: found a zero byte, wanted JSON in UTF-8");
}

TEST(JsonDocument, DoubledKeysAreRefusedAtAnyDepth) {
  EXPECT_EQ(errorOf(R"({ "a": 1, "b": 2, "a": 1 })"), "/a: found the key 'a' twice, wanted each key once");
  EXPECT_EQ(errorOf(R"({ "a": [0, { "b": { "c": 1, "\u0063": 1 } }] })"),
            "/a/1/b/c: found the key 'c' twice, wanted each key once");
  EXPECT_EQ(errorOf(R"({ "a": { "b": 1 }, "b": { "b": 1 } })"), "accepted");
}

TEST(JsonDocument, NumbersBeyondADoubleAreRefused) {
  EXPECT_EQ(errorOf(R"({ "a": [0, 1e999] })"),
            "/a/1: found the number '1e999', wanted a number in the range of a double");
  EXPECT_EQ(errorOf(R"({ "a": -1e-999 })"), "/a: found the number '-1e-999', wanted a number in the range of a double");
}

TEST(JsonDocument, NestingIsBounded) {
  const auto nested = [](std::size_t levels) {
    return "{ \"deep\": " + std::string(levels - 1, '[') + std::string(levels - 1, ']') + " }";
  };
  EXPECT_EQ(errorOf(nested(64)), "accepted");
  EXPECT_EQ(errorOf(nested(65)), "/deep: found values nested deeper than the limit, wanted at most 64 levels");
  EXPECT_EQ(errorOf("{ \"deep\": " + std::string(std::size_t{30} << 20U, '[')),
            "/deep: found values nested deeper than the limit, wanted at most 64 levels");
}

}  // namespace
}  // namespace tactus::base
