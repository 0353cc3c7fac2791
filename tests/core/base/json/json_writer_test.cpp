#include "core/base/json/json_writer.h"

#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

namespace tactus::base {
namespace {

using Layout = JsonWriter::Layout;

TEST(JsonWriter, BlocksAndLines) {
  JsonWriter json;
  json.beginObject().key("a").value(1).key("b").beginArray();
  json.beginObject(Layout::kInline).key("c").value("{").key("d").beginArray().value(true).null().endArray().endObject();
  json.beginObject(Layout::kInline).endObject().beginArray().endArray();
  json.endArray().key("e").beginObject().endObject();
  const std::vector<double> numbers = {0.5, -2};
  json.key("f").values(numbers).key("g").raw("[ 1 ]").endObject();
  EXPECT_EQ(
      json.text(),
      "{\n  \"a\": 1,\n  \"b\": [\n    { \"c\": \"{\", \"d\": [true, null] },\n    {},\n    []\n  ],\n  \"e\": {},\n"
      "  \"f\": [0.5, -2],\n  \"g\": [ 1 ]\n}\n");
}

TEST(JsonWriter, ObjectsInsideALine) {
  JsonWriter json;
  json.beginArray(Layout::kInline).beginObject().key("a").beginObject().endObject().endObject();
  json.beginArray().value("x").endArray().endArray();
  EXPECT_EQ(json.text(), "[{ \"a\": {} }, [\"x\"]]\n");
}

TEST(JsonWriter, Strings) {
  using namespace std::string_view_literals;
  EXPECT_EQ(jsonString("a\"\\/\b\n\r\t\0\x1f ä🙂"sv), R"("a\"\\/\u0008\n\r\t\u0000\u001f ä🙂")");
  // DEL, C1 and the writing direction stay data, but reach no terminal; what is no UTF-8 would be no JSON.
  EXPECT_EQ(jsonString("\x7f\u009b\u202e\xff"), R"("\u007f\u009b\u202e\ufffd")");
}

TEST(JsonWriter, Numbers) {
  EXPECT_EQ(jsonNumber(0.1 + 0.2), "0.30000000000000004");
  EXPECT_EQ(jsonNumber(5), "5");
  EXPECT_EQ(jsonNumber(std::numeric_limits<double>::quiet_NaN()), "null");
  EXPECT_EQ(jsonNumber(-std::numeric_limits<double>::infinity()), "null");
}

}  // namespace
}  // namespace tactus::base
