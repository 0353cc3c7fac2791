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
                   members.refuseOthers();
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
            "/i: found the number 2.5, wanted a whole number from 0 to 9");
  EXPECT_EQ(said(R"({ "s": -1 })", [&](JsonMembers& members) { members.integer("s", seed); }),
            "/s: found the number -1, wanted a whole number from 0 to 18446744073709551615");
  std::string text = "kept";
  EXPECT_EQ(said(R"({ "x": "" })", [&](JsonMembers& members) { members.text("x", text); }),
            "/x: found the string '', wanted a text that is not empty");
  EXPECT_EQ(said(R"({ "x": null })", [&](JsonMembers& members) { members.textOrEmpty("x", text); }),
            "/x: found null, wanted a string");
  EXPECT_EQ(text, "kept");
  EXPECT_EQ(said("{}", [&](JsonMembers& members) { members.text(required("name"), text); }),
            "found no key 'name', wanted a key 'name' with a text that is not empty");
  constexpr std::string_view kWords[] = {"a", "b", "c"};
  EXPECT_EQ(said("{}", [&](JsonMembers& members) { members.word(required("w"), kWords); }),
            "found no key 'w', wanted a key 'w' with 'a', 'b' or 'c'");
  EXPECT_EQ(said(R"({ "w": "d" })", [&](JsonMembers& members) { members.word("w", kWords); }),
            "/w: found the string 'd', wanted 'a', 'b' or 'c'");
  std::vector<std::string> list;
  EXPECT_EQ(said(R"({ "l": ["a", 2] })", [&](JsonMembers& members) { members.texts("l", list); }),
            "/l/1: found the number 2, wanted a string");
  std::vector<JsonMembers::NamedText> named;
  EXPECT_EQ(said(R"({ "o": { "a/b": "" } })", [&](JsonMembers& members) { members.texts("o", named); }),
            "/o/a~1b: found the string '', wanted a text that is not empty");
}

TEST(JsonMembers, KnowTheFormatAndTheVersion) {
  const auto read = [](JsonMembers& members) {
    members.format("tactus-x");
    members.version(required("version"));
  };
  EXPECT_EQ(said(R"({ "format": "tactus-x", "version": 1 })", read), "fine");
  EXPECT_EQ(said(R"({ "format": "other", "version": 1 })", read),
            "/format: found the string 'other', wanted 'tactus-x'");
  EXPECT_EQ(said(R"({ "format": "tactus-x" })", read), "found no key 'version', wanted a key 'version' with a number");
  EXPECT_EQ(said(R"({ "format": "tactus-x", "version": 2 })", read),
            "/version: found version 2, newer than this program, wanted at most version 1");
  EXPECT_EQ(said(R"({ "format": "tactus-x", "version": 0.5 })", read), "/version: found version 0.5, wanted version 1");
}

TEST(JsonMembers, AnErrorInsideATextFollowsItsPlace) {
  EXPECT_EQ(said(R"({ "x": "IF" })",
                 [](JsonMembers& members) {
                   members.refuse("x", Error{ErrorCode::kSyntax, {}, "column 3", "the end", "a condition"});
                 }),
            "/x: column 3: found the end, wanted a condition");
}

TEST(JsonMembers, UnknownKeysAreRefusedOrReturned) {
  double number = 7;
  const std::string text = R"({ "n": 0, "nn": 0, "m": 1 })";
  EXPECT_EQ(said(text,
                 [&](JsonMembers& members) {
                   members.number("n", number, {0, 1});
                   members.refuseOthers();
                 }),
            "/nn: found an unknown key, wanted 'n'");
  EXPECT_EQ(said(text,
                 [&](JsonMembers& members) {
                   members.number("n", number, {0, 1});
                   const auto others = members.others();
                   ASSERT_EQ(others.size(), 2u);
                   EXPECT_EQ(others[0].pointer(), "/nn");
                   EXPECT_EQ(others[1].pointer(), "/m");
                 }),
            "fine");
}

TEST(ReadJson, GivesTheObjectOrTheFirstErrorWithItsFile) {
  const auto read = [](JsonMembers& members, auto&) {
    double number = 0;
    members.number(required("n"), number);
    return number;
  };
  EXPECT_EQ(readJson(R"({ "n": 3 })", "f.json", read), 3);
  EXPECT_EQ(readJson(R"({ "n": true })", "f.json", read).error().message(), "f.json: /n: found true, wanted a number");
  EXPECT_EQ(readJson("{ \n", "f.json", read).error().file, "f.json");
}

TEST(JsonMembers, TheFirstErrorStays) {
  double number = 0;
  EXPECT_EQ(said(R"({ "a": 5, "b": 6, "c": 7 })",
                 [&](JsonMembers& members) {
                   members.number("b", number, {0, 1});
                   members.number("a", number, {0, 1});
                   members.refuseOthers();
                 }),
            "/b: found the number 6, wanted a number in [0, 1]");
}

}  // namespace
}  // namespace tactus::base
