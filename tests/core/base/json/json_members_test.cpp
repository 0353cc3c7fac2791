#include "core/base/json/json_members.h"

#include <gtest/gtest.h>
#include <limits>
#include <string>

namespace tactus::base {
namespace {

/// What `read` says of `text`: the error, or `fine`.
template <class Read>
std::string said(const std::string& text, Read read) {
  const auto document = JsonDocument::parse(text);
  EXPECT_TRUE(document) << text;
  std::optional<Error> error;
  JsonMembers members(document->root(), error);
  read(members);
  return error ? error->message() : "fine";
}

TEST(JsonMembers, ReadEachKind) {
  double number = 0;
  std::optional<double> there, absent;
  int whole = 0;
  std::uint64_t seed = 0;
  bool flag = false;
  std::string text;
  std::map<std::string, double> numbers;
  std::optional<std::size_t> word;
  constexpr std::string_view kWords[] = {"a", "b"};
  EXPECT_EQ(said(R"({ "n": 0.5, "t": 2, "i": 3, "s": 18446744073709551615, "f": true, "x": "hello", "w": "b",
                      "m": { "one": 1, "two": 2 } })",
                 [&](JsonMembers& members) {
                   members.number("n", number, {0, 1});
                   members.number("t", there, {0, 10});
                   members.number("absent", absent, {0, 10});
                   members.integer("i", whole, {0, 10});
                   members.integer("s", seed);
                   members.flag("f", flag);
                   members.text("x", text);
                   word = members.word("w", kWords);
                   members.numbers("m", numbers, {0, 10});
                   members.finish();
                 }),
            "fine");
  EXPECT_EQ(number, 0.5);
  EXPECT_EQ(there, 2);
  EXPECT_FALSE(absent);
  EXPECT_EQ(whole, 3);
  EXPECT_EQ(seed, std::numeric_limits<std::uint64_t>::max());
  EXPECT_TRUE(flag);
  EXPECT_EQ(text, "hello");
  EXPECT_EQ(word, 1u);
  EXPECT_EQ(numbers, (std::map<std::string, double>{{"one", 1}, {"two", 2}}));
}

TEST(JsonMembers, SayWhatWhereFoundAndWanted) {
  double number = 7;
  int whole = 7;
  std::uint64_t seed = 7;
  const auto readNumber = [&](JsonMembers& members) { members.number("n", number, {0, 1}); };
  EXPECT_EQ(said(R"({ "n": 2 })", readNumber), "/n: found the number 2, wanted a number in [0, 1]");
  EXPECT_EQ(said(R"({ "n": "2" })", readNumber), "/n: found the string '2', wanted a number in [0, 1]");
  EXPECT_EQ(number, 7) << "a refused value leaves the target";
  EXPECT_EQ(said(R"({ "i": 2.5 })",
                 [&](JsonMembers& members) {
                   members.integer("i", whole, {0, 9});
                 }),
            "/i: found the number 2.5, wanted a whole number");
  EXPECT_EQ(said(R"({ "s": -1 })", [&](JsonMembers& members) { members.integer("s", seed); }),
            "/s: found the number -1, wanted a whole number from 0 to 18446744073709551615");
  EXPECT_EQ(said("{}", [](JsonMembers& members) { members.require("name"); }),
            "found no member 'name', wanted the member 'name'");
  EXPECT_EQ(said(R"({ "n": 0, "nn": 0 })",
                 [&](JsonMembers& members) {
                   members.number("n", number, {0, 1});
                   members.finish();
                 }),
            "/nn: found the member 'nn', wanted one of n");
}

TEST(JsonMembers, TheFirstErrorStays) {
  double number = 0;
  EXPECT_EQ(said(R"({ "a": 5, "b": 6, "c": 7 })",
                 [&](JsonMembers& members) {
                   members.number("b", number, {0, 1});
                   members.number("a", number, {0, 1});
                   members.finish();
                 }),
            "/b: found the number 6, wanted a number in [0, 1]");
}

}  // namespace
}  // namespace tactus::base
