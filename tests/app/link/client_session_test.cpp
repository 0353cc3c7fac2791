#include "app/link/client_session.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/link/link_lines.h"
#include "core/base/files/checksums.h"
#include "core/model_io/model_file.h"

#include "tests/support/ngt_model.h"

namespace tactus::link {
namespace {

using Phase = ClientSession::Phase;

const std::string kSessionToken = "0123456789abcdef0123456789abcdef";
const std::string kHello =
    R"({"hello":"tactus-link","version":1,"token":")" + kSessionToken + R"(","want":["model","state"]})";

class ClientSessionTest : public testing::Test {
 protected:
  static ServedModel served(std::uint64_t serial) {
    const auto model = support::s4FiveRegions();
    const std::string text = model_io::formatModel(model);
    return {serial,
            *fuzzy::compile(model),
            std::make_shared<const std::string>(modelLine(serial, "x", text)),
            {"lubrication", "neck_flexion", "depth", "speed"}};
  }

  /// Everything that is sent while `bytes` come in, line by line.
  std::vector<std::string> say(std::string_view bytes) {
    session_.receive(bytes);
    return work();
  }
  std::vector<std::string> work() {
    std::vector<std::string> lines;
    std::string text;
    do {
      session_.work(64, {model_, kSessionToken, "tactus test", has_place_});
      for (auto output = session_.output(); !output.empty(); output = session_.output()) {
        text += output;
        session_.sent(output.size());
      }
    } while (session_.hasWork());
    for (std::size_t at = 0; at < text.size();) {
      const auto end = text.find('\n', at);
      lines.push_back(text.substr(at, end - at));
      at = end == std::string::npos ? text.size() : end + 1;
    }
    return lines;
  }
  std::string errorOf(const std::vector<std::string>& lines) {
    return lines.size() == 1 ? nlohmann::json::parse(lines[0]).value("error", "no error") : "no line";
  }
  /// The error that this first line brings.
  std::string refusal(const std::string& line) {
    session_ = {};
    const std::string error = errorOf(say(line + '\n'));
    EXPECT_EQ(session_.phase(), Phase::kEnding) << line;
    return error;
  }

  ServedModel model_ = served(3);
  bool has_place_ = true;
  ClientSession session_;
};

TEST_F(ClientSessionTest, AHelloIsAnsweredAndTheModelFollows) {
  const auto lines = say(kHello + '\n');
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0], R"({"hello":"tactus-link","version":1,"program":"tactus test"})");
  EXPECT_EQ(lines[1] + '\n', *model_.line);
  EXPECT_EQ(session_.phase(), Phase::kGreeted);
}

TEST_F(ClientSessionTest, AHelloMayComeByteByByteAndKeysOfLaterVersionsAreIgnored) {
  const std::string hello = R"({ "later" : [1,{"x":2}], "name":"Sim\u0007", )" + kHello.substr(1) + "\r\n";
  std::vector<std::string> lines;
  for (const char c : hello) {
    for (auto& line : say({&c, 1})) lines.push_back(line);
  }
  EXPECT_EQ(lines.size(), 2U);
  EXPECT_EQ(session_.hello().name, "Sim\\x07");
  EXPECT_TRUE(session_.hello().token.empty()) << "a secret is not kept longer than needed";
}

TEST_F(ClientSessionTest, WhatIsWantedIsSent) {
  std::string hello = R"({"hello":"tactus-link","version":1,"token":")" + kSessionToken + R"(","want":[]})";
  EXPECT_EQ(say(hello + '\n').size(), 1U);
  EXPECT_FALSE(session_.isDue(0));
  session_ = {};
  hello = R"({"hello":"tactus-link","version":1,"token":")" + kSessionToken + R"("})";
  EXPECT_EQ(say(hello + '\n').size(), 2U) << "without want: the model";
}

TEST_F(ClientSessionTest, AWrongHelloIsOneSentenceAndTheEnd) {
  const auto with = [](const std::string& members) { return R"({"hello":"tactus-link",)" + members + "}"; };
  const std::string token = R"("token":")" + kSessionToken + '"';
  EXPECT_EQ(refusal(with(R"("version":1,"token":"0123456789abcdef0123456789abcdee")")),
            "hello: found another token, wanted the one in the server's token file");
  EXPECT_EQ(refusal(with(R"("version":1,"token":"0123")")),
            "hello: found another token, wanted the one in the server's token file");
  EXPECT_EQ(refusal(with(R"("version":2,)" + token)),
            "line 1 of the client: /version: found version 2, newer than this program, wanted at most version 1");
  EXPECT_EQ(refusal(with(token)), "line 1 of the client: found no key 'version', wanted a key 'version' with a number");
  EXPECT_EQ(refusal(with(R"("version":1)")),
            "line 1 of the client: found no key 'token', wanted a key 'token' with a text that is not empty");
  EXPECT_NE(refusal(with(R"("version":1,"want":["modell"],)" + token)).find("found the word 'modell'"),
            std::string::npos);
  EXPECT_NE(refusal(with(R"("version":1,"state_hz":0,)" + token)).find("/state_hz: found "), std::string::npos);
  EXPECT_NE(refusal(with(R"("version":1,"state_hz":1001,)" + token)).find("1000"), std::string::npos);
  EXPECT_NE(refusal(R"({"hello":"other-link","version":1,)" + token + "}").find("'tactus-link'"), std::string::npos);
  EXPECT_EQ(refusal("GET / HTTP/1.1").find("line 1 of the client: "), 0U);
  EXPECT_EQ(refusal("").find("line 1 of the client: "), 0U);
  EXPECT_NE(refusal(R"({"ask":{"id":1,"inputs":[]}})").find("found the member 'ask'"), std::string::npos)
      << "nothing is answered before the hello";
  has_place_ = false;
  EXPECT_NE(refusal(kHello).find("try again"), std::string::npos);
}

TEST_F(ClientSessionTest, HostileLinesAreOneSentenceAndTheEnd) {
  const auto after_hello = [this](std::string_view bytes) {
    session_ = {};
    say(kHello + '\n');
    const std::string error = errorOf(say(bytes));
    EXPECT_EQ(session_.phase(), Phase::kEnding);
    EXPECT_TRUE(say("{}\n").empty()) << "nothing is read any more";
    return error;
  };
  EXPECT_EQ(after_hello("\xff\xfe\n"), "line 2 of the client: found bytes that are not UTF-8, wanted JSON in UTF-8");
  EXPECT_NE(after_hello("{\"ask\":" + std::string(500'000, '[') + "\n").find("deeper"), std::string::npos);
  EXPECT_NE(after_hello(kHello + '\n').find("'hello'"), std::string::npos) << "one hello";
  EXPECT_NE(after_hello(R"({"ask":{"id":null,"inputs":[1]}})"
                        "\n")
                .find("/ask/id"),
            std::string::npos);
  EXPECT_NE(after_hello(R"({"ask":{"id":1,"inputs":[1,45,130]}})"
                        "\n")
                .find("found 3 numbers, wanted 4"),
            std::string::npos);
  EXPECT_NE(after_hello(R"({"ask":{"id":1,"inputs":[1,45,130,1e999]}})"
                        "\n")
                .find("1e999"),
            std::string::npos);
  EXPECT_NE(after_hello(R"({"ask":{"id":1,"inputs":[1,45,130,"x"]}})"
                        "\n")
                .find("/ask/inputs/3"),
            std::string::npos);
  EXPECT_NE(after_hello(std::string("{\"a\0\":1}\n", 9)).find("zero byte"), std::string::npos);
}

TEST_F(ClientSessionTest, ALineHasAtMostOneMiB) {
  say(kHello + '\n');
  std::string ask = R"({"ask":{"id":1,"inputs":[1,45,130,50]}})";
  ask.append(LineBuffer::kLongestLine - ask.size(), ' ');
  const auto answers = say(ask + '\n');
  ASSERT_EQ(answers.size(), 1U);
  EXPECT_NE(answers[0].find("\"answer\""), std::string::npos);

  // One byte more is refused as soon as it is there, before the line ends.
  EXPECT_NE(errorOf(say(ask + ' ')).find("line 3 of the client: found more than 1048576 bytes"), std::string::npos);
}

TEST_F(ClientSessionTest, AnswersAreThoseOfTheModelInOrder) {
  say(kHello + '\n');
  const auto lines = say(R"({"ask":{"id":7,"inputs":[1,45,30,30]}}
{"ask":{"id":"b","inputs":[0.3,45,80,170]}}
{"ask":{"id":-1,"inputs":[1,60,50,130]}}
)");
  ASSERT_EQ(lines.size(), 3U);
  const std::vector<std::vector<double>> points = {{1, 45, 30, 30}, {0.3, 45, 80, 170}, {1, 60, 50, 130}};
  const std::vector<nlohmann::json> ids = {7, "b", -1};
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto answer = nlohmann::json::parse(lines[i]).at("answer");
    const auto force = model_.compiled.evaluate(points[i]);
    EXPECT_EQ(answer.at("id"), ids[i]);
    EXPECT_EQ(answer.at("force_n").get<double>(), force.force_n);
    EXPECT_EQ(answer.at("fired").get<bool>(), force.fired);
    EXPECT_EQ(answer.at("serial").get<int>(), 3);
  }
}

const std::string kFelt = R"({"felt":{"time_s":1.5,"depth_mm":120,"speed_mm_s":-3,"force_n":0.4,"held":true,)"
                          R"("conditions":{"lubrication":0.5}}})";

TEST_F(ClientSessionTest, TheNewestPlaceOfASimulatorCounts) {
  say(kHello + '\n');
  EXPECT_FALSE(session_.takeFelt());
  std::string flood;
  for (int i = 0; i < 10'000; ++i)
    flood += R"({"felt":{"time_s":)" + std::to_string(i) +
             R"(,"depth_mm":0,"speed_mm_s":0,"force_n":0}})"
             "\n";
  EXPECT_TRUE(say(flood + kFelt + '\n').empty()) << "nothing is said to it";
  const auto felt = session_.takeFelt();
  ASSERT_TRUE(felt);
  EXPECT_EQ(*felt, (Felt{1.5, 120, -3, 0.4, {{"lubrication", 0.5}}}));
  EXPECT_FALSE(session_.takeFelt()) << "once";
  EXPECT_TRUE(session_.wantsInput());
}

TEST_F(ClientSessionTest, NonsenseAboutAPlaceIsOneSentenceAndTheEnd) {
  const auto after_hello = [this](const std::string& from, const std::string& to) {
    session_ = {};
    say(kHello + '\n');
    std::string line = kFelt;
    const auto at = line.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    line.replace(at, from.size(), to);
    const std::string error = errorOf(say(line + '\n'));
    EXPECT_EQ(session_.phase(), Phase::kEnding) << line;
    EXPECT_FALSE(session_.takeFelt()) << line;
    return error;
  };
  const auto has = [](const std::string& text, const char* part) { return text.find(part) != std::string::npos; };
  EXPECT_TRUE(has(after_hello("120", "1e999"), "1e999"));
  EXPECT_TRUE(has(after_hello("120", "NaN"), "line 2 of the client"));
  EXPECT_TRUE(has(after_hello("120", "1.1e6"), "/felt/depth_mm"));
  EXPECT_TRUE(has(after_hello("-3", "-1e300"), "/felt/speed_mm_s"));
  EXPECT_TRUE(has(after_hello("0.4", "\"much\""), "/felt/force_n"));
  EXPECT_TRUE(has(after_hello(R"("depth_mm":120,)", ""), "'depth_mm'"));
  EXPECT_TRUE(has(after_hello("lubrication", "swallow"),
                  "/felt/conditions: found 'swallow', wanted inputs of the model: lubrication, neck_flexion"));
  EXPECT_TRUE(has(after_hello("0.5", "null"), "/felt/conditions"));
  EXPECT_TRUE(has(after_hello(R"({"lubrication":0.5})", "[1]"), "/felt/conditions"));
  EXPECT_TRUE(
      has(after_hello("felt", "fell"), "found the member 'fell', wanted a line with the member 'ask' or 'felt'"));
}

TEST_F(ClientSessionTest, PlacesOfOthersGoToThoseWhoWantThem) {
  say(kHello + '\n');
  const auto line = std::make_shared<const std::string>(feltLine({1, 2, 3, 4, {{"speed", 3}}}, "Phantom \"2\""));
  EXPECT_EQ(*line, R"({"felt":{"time_s":1,"depth_mm":2,"speed_mm_s":3,"force_n":4,"conditions":{"speed":3},)"
                   R"("name":"Phantom \"2\""}})"
                   "\n");
  session_.offerFelt(line);
  EXPECT_TRUE(work().empty()) << "it does not want them";
  session_ = {};
  say(R"({"hello":"tactus-link","version":1,"token":")" + kSessionToken + R"(","want":["felt"]})" + '\n');
  session_.offerFelt(std::make_shared<const std::string>("{}\n"));
  session_.offerFelt(line);
  const auto lines = work();
  ASSERT_EQ(lines.size(), 1U) << "the newest";
  EXPECT_EQ(lines[0] + '\n', *line);
}

TEST_F(ClientSessionTest, AFloodOfQuestionsIsReadNoFasterThanItsAnswersAreTaken) {
  say(kHello + '\n');
  std::string flood;
  for (int i = 0; i < 20'000; ++i)
    flood += R"({"ask":{"id":)" + std::to_string(i) +
             R"(,"inputs":[1,45,30,30]}})"
             "\n";
  session_.receive(flood);
  for (int i = 0; i < 1000; ++i) session_.work(64, {model_, kSessionToken, "tactus test", true});
  EXPECT_FALSE(session_.hasWork());
  EXPECT_FALSE(session_.wantsInput());
  EXPECT_LT(session_.output().size(), 2 * ClientSession::kMostAnswers);
  // Every question has its answer, in order, once the client takes them.
  const auto lines = work();
  ASSERT_EQ(lines.size(), 20'000U);
  for (std::size_t i = 0; i < lines.size(); i += 997)
    EXPECT_EQ(nlohmann::json::parse(lines[i]).at("answer").at("id"), i);
  EXPECT_TRUE(session_.wantsInput());
}

TEST_F(ClientSessionTest, ASlowClientGetsTheNewestAndTheLineThatWasBegun) {
  session_.receive(kHello + '\n');
  session_.work(1, {model_, kSessionToken, "tactus test", true});
  session_.sent(session_.output().size());
  std::string read(session_.output().substr(0, 1000));  // the first half of model 3
  session_.sent(1000);
  for (std::uint64_t serial = 4; serial < 100; ++serial) session_.offer(served(serial));
  for (int i = 0; i < 50; ++i)
    session_.offerState(std::make_shared<const std::string>("{\"state\":" + std::to_string(i) + "}\n"));
  for (const auto& line : work()) read += line + '\n';

  std::vector<std::string> lines;
  for (std::size_t at = 0; at < read.size();) {
    const auto end = read.find('\n', at);
    lines.push_back(read.substr(at, end - at));
    at = end + 1;
  }
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(nlohmann::json::parse(lines[0]).at("model").at("serial"), 3);
  EXPECT_EQ(nlohmann::json::parse(lines[1]).at("model").at("serial"), 99);
  EXPECT_EQ(lines[2], "{\"state\":49}");
}

TEST_F(ClientSessionTest, StatesComeAtTheWantedRate) {
  const auto due = [this](const std::string& rate) {
    session_ = {};
    say(R"({"hello":"tactus-link","version":1,"token":")" + kSessionToken + R"(","want":["state"])" + rate + "}\n");
    int count = 0;
    for (int tick = 0; tick < 1000; ++tick) count += session_.isDue(tick * 0.001) ? 1 : 0;
    return count;
  };
  EXPECT_EQ(due(""), 100);
  EXPECT_EQ(due(R"(,"state_hz":1000)"), 1000);
  EXPECT_EQ(due(R"(,"state_hz":30)"), 30);
  EXPECT_EQ(due(R"(,"state_hz":0.1)"), 1);
  EXPECT_TRUE(session_.isDue(0)) << "a new run begins with a state";
}

TEST(ServerLines, AModelLineHoldsTheFileWithoutWhiteSpaceAndItsChecksums) {
  const std::string text = "\xEF\xBB\xBF{\n  \"a b\": \"x \\\" \\\\\",\n  \"n\": [ 1.50, -0 ]\n}\n";
  const std::string file = R"({"a b":"x \" \\","n":[1.50,-0]})";
  EXPECT_EQ(modelLine(12, "abc", text), R"({"model":{"serial":12,"sha256":"abc","sent_sha256":")" + base::sha256(file) +
                                            R"(","file":)" + file + "}}\n");
}

TEST(ServerLines, AStateLineIsThatOfTheContract) {
  LinkSetting setting;
  setting.regions = {{0, 90, "nasal_cavity"}, {90, 130, "oropharynx"}};
  setting.conditions = {{"lubrication", 1}, {"neck_flexion", 60}};
  setting.simulated = true;
  LinkState state{1.5, 90, 20.25, 19, 0.41, 0.4, true, false, 2};
  EXPECT_EQ(stateLine(state, setting),
            R"({"state":{"time_s":1.5,"depth_mm":90,"speed_mm_s":20.25,"slip_speed_mm_s":19,"force_n":0.41,)"
            R"("model_force_n":0.4,"held":true,"stroke":2,"region":"oropharynx",)"
            R"("conditions":{"lubrication":1,"neck_flexion":60},"simulated":true,"held_last":false}})"
            "\n");
  state.depth_mm = 130;  // the end belongs to the last region
  EXPECT_NE(stateLine(state, setting).find(R"("region":"oropharynx")"), std::string::npos);
  state.depth_mm = 131;
  EXPECT_NE(stateLine(state, setting).find(R"("region":null)"), std::string::npos);
}

}  // namespace
}  // namespace tactus::link
