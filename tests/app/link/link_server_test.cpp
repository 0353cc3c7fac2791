#include "app/link/link_server.h"

#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>
#include <sys/stat.h>

#include "app/link/client_session.h"
#include "core/base/files/checksums.h"
#include "core/model_io/model_file.h"

#include "tests/app/link/test_client.h"
#include "tests/support/ngt_model.h"
#include "tests/support/temp_folder.h"

namespace tactus::link {
namespace {

using nlohmann::json;

const std::string kToken = "0123456789abcdef0123456789abcdef";
const std::string kWants = helloOf(kToken);

/// The model with this name: every name gives another text.
fuzzy::ForceModel named(const std::string& name) {
  fuzzy::ForceModel model = support::s4FiveRegions();
  model.name = name;
  return model;
}

LinkModel served(const fuzzy::ForceModel& model) {
  auto text = std::make_shared<const std::string>(model_io::formatModel(model));
  return {*fuzzy::compile(model), [text] { return *text; }, inputIds(model)};
}

class LinkServerTest : public testing::Test {
 protected:
  void start(LinkSettings settings = {}) {
    settings.token = kToken;
    settings.program = "tactus test";
    auto started = LinkServer::start(
        std::move(settings), served(named("first")),
        [this] {
          const std::lock_guard lock(mutex_);
          changed_.notify_all();
        },
        [this] {
          const std::lock_guard lock(mutex_);
          ++told_;
          changed_.notify_all();
        });
    ASSERT_TRUE(started) << started.error().message();
    server_ = std::move(*started);
  }
  TestClient connect() { return TestClient(server_->port()); }
  /// A client that has got its hello and the model.
  TestClient greeted(std::string_view hello = kWants) {
    TestClient client = connect();
    EXPECT_TRUE(client.send(hello));
    EXPECT_EQ(client.line(), R"({"hello":"tactus-link","version":1,"program":"tactus test"})");
    return client;
  }
  /// After it the server has done all that earlier lines of this client ask for: the second answer is of a later turn.
  static void roundTrip(TestClient& client) {
    for (int i = 0; i < 2; ++i) {
      EXPECT_TRUE(client.send(R"({"ask":{"id":1,"inputs":[1,45,30,30]}})"
                              "\n"));
      EXPECT_NE(client.line().find("answer"), std::string::npos);
    }
  }
  void waitForClients(std::size_t count) {
    std::unique_lock lock(mutex_);
    EXPECT_TRUE(changed_.wait_for(lock, std::chrono::seconds(TestClient::kPatienceS),
                                  [&] { return server_->clients().size() == count; }));
  }
  static std::string nameIn(const std::string& line) {
    return json::parse(line).at("model").at("file").at("name").get<std::string>();
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  int told_ = 0;                        ///< how often something was felt
  std::unique_ptr<LinkServer> server_;  ///< last: its thread ends before what it calls is gone
};

TEST_F(LinkServerTest, AClientHasTheModelAndEachEditWithARisingSerial) {
  start();
  TestClient client = greeted();
  const json first = json::parse(client.line()).at("model");
  EXPECT_EQ(first.at("serial"), 1);
  const std::string text = model_io::formatModel(named("first"));
  EXPECT_EQ(first.at("sha256"), base::sha256(text));
  EXPECT_EQ(first.at("file"), json::parse(text));
  const auto read = model_io::parseModel(first.at("file").dump(), "line");
  ASSERT_TRUE(read) << read.error().message();

  int serial = 1;
  for (const char* name : {"second", "third", "fourth"}) {
    server_->publish(served(named(name)));
    const std::string line = client.line();
    EXPECT_EQ(nameIn(line), name);
    const json model = json::parse(line).at("model");
    EXPECT_EQ(model.at("serial"), ++serial);
    // What a client without a JSON reader does: it cuts the file out of the line and checks it.
    const auto begin = line.find("\"file\":") + 7;
    EXPECT_EQ(model.at("sent_sha256"), base::sha256(line.substr(begin, line.size() - 2 - begin)));
  }
  // The same text again is no edit.
  server_->publish(served(named("fourth")));
  server_->publish(served(named("fifth")));
  const json last = json::parse(client.line()).at("model");
  EXPECT_EQ(last.at("serial"), 5);
}

TEST_F(LinkServerTest, QuestionsAreAnsweredByTheServedModelBitByBit) {
  start();
  TestClient client = greeted(helloOf(kToken, R"("want":[])"));
  const auto compiled = *fuzzy::compile(named("first"));
  std::string asks;
  std::vector<std::vector<double>> points;
  for (int i = 0; i < 2000; ++i) {
    points.push_back({(i % 11) * 0.1, (i % 7) * 15.0, i * 0.37, i * 0.11});
    asks += json{{"ask", {{"id", i}, {"inputs", points.back()}}}}.dump() + '\n';
  }
  ASSERT_TRUE(client.send(asks));
  for (int i = 0; i < 2000; ++i) {
    const json answer = json::parse(client.line()).at("answer");
    const auto force = compiled.evaluate(points[static_cast<std::size_t>(i)]);
    ASSERT_EQ(answer.at("id"), i);
    ASSERT_EQ(answer.at("force_n").get<double>(), force.force_n);
    ASSERT_EQ(answer.at("fired").get<bool>(), force.fired);
  }
}

std::string feltAt(double depth_mm) {
  return json{{"felt", {{"time_s", 1}, {"depth_mm", depth_mm}, {"speed_mm_s", 20}, {"force_n", 0.3}}}}.dump() + '\n';
}

TEST_F(LinkServerTest, WhereSimulatorsAreIsToldOnceUntilItIsTaken) {
  start();
  TestClient first = greeted(helloOf(kToken, R"("want":[],"name":"first")"));
  TestClient second = greeted(helloOf(kToken, R"("want":["felt"],"name":"second")"));
  std::string flood;
  for (int i = 0; i < 20'000; ++i) flood += feltAt(i * 0.01);
  ASSERT_TRUE(first.send(flood));
  roundTrip(first);
  {
    const std::lock_guard lock(mutex_);
    EXPECT_EQ(told_, 1);
  }
  auto felt = server_->takeFelt();
  ASSERT_EQ(felt.size(), 1U);
  EXPECT_EQ(felt[0].felt.depth_mm, 19'999 * 0.01);
  EXPECT_EQ(felt[0].client, server_->clients()[0].number);
  EXPECT_TRUE(server_->takeFelt().empty());
  // The other client has got some of them, in order, and at last the newest; its own do not come back.
  double before_mm = -1;
  while (before_mm < 19'999 * 0.01) {
    const json line = json::parse(second.line()).at("felt");
    EXPECT_EQ(line.at("name"), "first");
    EXPECT_GT(line.at("depth_mm").get<double>(), before_mm);
    before_mm = line.at("depth_mm").get<double>();
  }
  ASSERT_TRUE(second.send(feltAt(7)));
  roundTrip(second);
  ASSERT_TRUE(first.send(feltAt(8)));
  roundTrip(first);
  felt = server_->takeFelt();
  ASSERT_EQ(felt.size(), 2U);
  EXPECT_EQ(felt[0].felt.depth_mm, 7);
  EXPECT_EQ(felt[1].felt.depth_mm, 8);
  // Nonsense of one is the end of that one alone.
  ASSERT_TRUE(first.send(R"({"felt":{"depth_mm":1}})"
                         "\n"));
  EXPECT_NE(first.line().find("error"), std::string::npos);
  waitForClients(1);
  EXPECT_EQ(json::parse(second.line()).at("felt").at("depth_mm"), 8);
}

TEST_F(LinkServerTest, AClientThatSaysNoMoreStillGetsItsAnswersThenTheEnd) {
  start();
  TestClient client = connect();
  ASSERT_TRUE(client.send(kWants + R"({"ask":{"id":1,"inputs":[1,45,30,30]}})" + "\n{\"ask\":{"));
  client.endOutput();
  client.line();
  client.line();
  EXPECT_NE(client.line().find("\"answer\""), std::string::npos);
  EXPECT_EQ(client.line(), "");
  EXPECT_TRUE(client.ended());
}

TEST_F(LinkServerTest, NonsenseIsOneSentenceAndTheEndAlsoBehindMuchMoreOfIt) {
  start();
  TestClient client = greeted();
  client.line();
  // 3 MiB without a line end: the sentence comes although most of it is on its way.
  const std::string nonsense(3 * LineBuffer::kLongestLine, 'x');
  client.send(nonsense);
  EXPECT_NE(json::parse(client.line()).at("error").get<std::string>().find("more than 1048576 bytes"),
            std::string::npos);
  EXPECT_EQ(client.line(), "");

  TestClient next = greeted();
  EXPECT_EQ(nameIn(next.line()), "first") << "the others are served on";
}

TEST_F(LinkServerTest, ASeventeenthClientGetsOneSentenceUntilOneLeaves) {
  start();
  std::vector<TestClient> clients;
  for (std::size_t i = 0; i < LinkServer::kMostClients; ++i) clients.push_back(greeted());
  TestClient late = connect();
  EXPECT_EQ(json::parse(late.line()).at("error"),
            "found as many clients as the server takes, wanted fewer: try again when one has left");
  EXPECT_EQ(late.line(), "");
  EXPECT_TRUE(late.ended());
  waitForClients(16);
  clients.pop_back();
  waitForClients(15);
  clients.push_back(greeted());
}

TEST_F(LinkServerTest, ThoseWhoSayNothingDoNotKeepOthersOut) {
  start();
  std::vector<TestClient> silent;
  for (int i = 0; i < 60; ++i) silent.push_back(connect());
  TestClient client = greeted();
  EXPECT_EQ(nameIn(client.line()), "first");
}

TEST_F(LinkServerTest, WhoSaysNothingInTimeIsToldAndClosed) {
  LinkSettings settings;
  settings.hello_time = std::chrono::milliseconds(20);
  start(std::move(settings));
  TestClient silent = connect();
  silent.send(R"({"hello":"tactus-l)");
  EXPECT_EQ(json::parse(silent.line()).at("error"), "found no hello in time, wanted it as the first line");
  EXPECT_EQ(silent.line(), "");
  EXPECT_TRUE(silent.ended());
}

TEST_F(LinkServerTest, SlowClientsGetTheNewestAndHoldUpNobody) {
  start();
  std::vector<TestClient> slow;
  for (std::size_t i = 0; i + 1 < LinkServer::kMostClients; ++i) {
    slow.emplace_back(server_->port(), 16384);
    ASSERT_TRUE(slow.back().send(kWants));
  }
  TestClient quick = greeted();
  EXPECT_EQ(nameIn(quick.line()), "first");
  // More than the system keeps for a client that does not read.
  constexpr int kEdits = 200;
  for (int i = 0; i < kEdits; ++i) {
    server_->publish(served(named("edit " + std::to_string(i))));
    EXPECT_EQ(nameIn(quick.line()), "edit " + std::to_string(i));
  }
  for (auto& client : slow) {
    client.line();
    int lines = 0;
    std::uint64_t before = 0;
    for (std::string name; name != "edit " + std::to_string(kEdits - 1); ++lines) {
      const std::string line = client.line();
      ASSERT_FALSE(line.empty());
      name = nameIn(line);
      const auto serial = json::parse(line).at("model").at("serial").get<std::uint64_t>();
      EXPECT_GT(serial, before);
      before = serial;
    }
    EXPECT_LT(lines, kEdits / 2) << "old models are left out";
  }
}

TEST_F(LinkServerTest, AFloodOfQuestionsHoldsUpNobody) {
  start();
  TestClient flooding = greeted(helloOf(kToken, R"("want":[])"));
  const std::string ask = R"({"ask":{"id":1,"inputs":[1,45,30,30]}})"
                          "\n";
  std::string flood;
  while (flood.size() < (std::size_t{1} << 20U)) flood += ask;
  // It never reads, so at some point the system takes no more of it.
  std::size_t taken = 0;
  for (std::size_t more = 1; more > 0; taken += more) more = flooding.sendSome(flood);
  TestClient quick = greeted();
  EXPECT_EQ(nameIn(quick.line()), "first");
  ASSERT_TRUE(quick.send(ask));
  EXPECT_NE(quick.line().find("\"answer\""), std::string::npos);
  EXPECT_GT(taken, 0U);
}

TEST_F(LinkServerTest, ClientsThatLeaveInTheMiddleOfALineHarmNobody) {
  start();
  TestClient quick = greeted();
  quick.line();
  for (int i = 0; i < 100; ++i) {
    TestClient gone = connect();
    gone.send(i % 3 == 0 ? R"({"hello":"tactus-li)" : i % 3 == 1 ? kWants : kWants + "{\"ask\":");
  }
  server_->publish(served(named("after")));
  EXPECT_EQ(nameIn(quick.line()), "after");
  waitForClients(1);
}

TEST_F(LinkServerTest, StatesGoToThoseWhoWantThem) {
  start();
  TestClient plain = greeted();
  plain.line();
  EXPECT_FALSE(server_->wantsStates());
  TestClient follower = greeted(helloOf(kToken, R"("want":["state"],"state_hz":500,"name":"Follower")"));
  waitForClients(2);
  EXPECT_TRUE(server_->wantsStates());
  const auto clients = server_->clients();
  ASSERT_EQ(clients.size(), 2U);
  EXPECT_EQ(clients[1].name, "Follower");
  EXPECT_EQ(clients[1].address.find("port "), 0U);

  auto setting = std::make_shared<LinkSetting>();
  setting->conditions = {{"lubrication", 1}};
  setting->simulated = true;
  LinkStates states{setting, {}};
  for (int i = 0; i < 16; ++i) states.states.push_back({i * 0.001, i * 0.1, 100, 90, 0.2, 0.1, true, false, 1});
  server_->publish(states);
  for (int i = 0; i < 16; i += 2) {
    const json state = json::parse(follower.line()).at("state");
    EXPECT_EQ(state.at("time_s").get<double>(), i * 0.001);
    EXPECT_EQ(state.at("simulated"), true);
  }
  server_->publish(served(named("second")));
  EXPECT_EQ(nameIn(plain.line()), "second") << "no state lines for who does not want them";
}

TEST_F(LinkServerTest, ASocketFileIsForItsOwnerAndRemovedAtTheEnd) {
  const support::TempFolder folder;
  const std::string path = folder.file("link.sock");
  start({0, path, {}, {}});
  struct stat info {};
  ASSERT_EQ(::lstat(path.c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 07777U, 0600U);
  TestClient client(path);
  ASSERT_TRUE(client.send(kWants));
  client.line();
  EXPECT_EQ(nameIn(client.line()), "first");
  waitForClients(1);
  EXPECT_EQ(server_->clients()[0].address, "process " + std::to_string(::getpid()));

  // A second server is refused, and takes nothing away from the first.
  const auto second = LinkServer::start({0, path, kToken, "x"}, served(named("x")));
  ASSERT_FALSE(second);
  EXPECT_NE(second.error().message().find("found a socket that another program uses"), std::string::npos);
  EXPECT_TRUE(TestClient(path).isConnected());
  server_.reset();
  EXPECT_TRUE(folder.isEmpty());
  EXPECT_EQ(client.line(), "");
}

TEST_F(LinkServerTest, ASocketFileThatACrashLeftIsReplacedAndNothingElse) {
  const support::TempFolder folder;
  const std::string path = folder.file("link.sock");
  {
    const base::Descriptor crashed(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path.copy(address.sun_path, sizeof address.sun_path - 1);
    ASSERT_EQ(::bind(crashed.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  }
  start({0, path, {}, {}});
  EXPECT_TRUE(TestClient(path).isConnected());
  server_.reset();

  const auto refusal = [&](const std::string& socket_path) {
    const auto started = LinkServer::start({0, socket_path, kToken, "x"}, served(named("x")));
    return started ? "started" : started.error().message();
  };
  std::ofstream(path) << "a file";
  EXPECT_NE(refusal(path).find("found a file that is not a socket"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(path));
  EXPECT_NE(refusal(folder.file("none/link.sock")).find("No such file or directory"), std::string::npos);
  EXPECT_NE(refusal(folder.file(std::string(120, 'x'))).find("at most 107 bytes"), std::string::npos);
}

TEST_F(LinkServerTest, ATakenPortIsOneSentence) {
  start();
  const auto second = LinkServer::start({server_->port(), {}, kToken, "x"}, served(named("x")));
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().message(), "port " + std::to_string(server_->port()) +
                                          ": found another program that uses it, wanted a free port; 0 takes any");
}

TEST_F(LinkServerTest, WithoutDescriptorsConnectionsWaitUntilThereAreSome) {
  start();
  TestClient before = greeted();
  before.line();
  rlimit usual{};
  ::getrlimit(RLIMIT_NOFILE, &usual);
  TestClient waiting = connect();  // its descriptor in this process is there; that of the server not yet
  {
    const base::Descriptor next(::dup(0));
    rlimit none = usual;
    none.rlim_cur = static_cast<rlim_t>(next.number());
    ::setrlimit(RLIMIT_NOFILE, &none);
  }
  server_->publish(served(named("second")));
  EXPECT_EQ(nameIn(before.line()), "second");
  ::setrlimit(RLIMIT_NOFILE, &usual);
  ASSERT_TRUE(waiting.send(kWants));
  EXPECT_NE(waiting.line().find("\"hello\""), std::string::npos);
}

}  // namespace
}  // namespace tactus::link
