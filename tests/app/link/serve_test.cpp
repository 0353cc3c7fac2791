// `tactus serve` as a program of its own.
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <spawn.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include "core/base/files/checksums.h"
#include "core/base/files/file.h"
#include "core/base/text.h"
#include "core/model_io/model_file.h"

#include "tests/app/link/test_client.h"
#include "tests/support/ngt_model.h"
#include "tests/support/temp_folder.h"

extern char** environ;

namespace tactus::link {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string readText(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The program while it serves.
class Program {
 public:
  explicit Program(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"tactus", "serve"});
    std::vector<char*> argv;
    for (auto& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    int out[2];
    int err[2];
    if (::pipe2(out, O_CLOEXEC) != 0 || ::pipe2(err, O_CLOEXEC) != 0) std::abort();
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, out[1], 1);
    posix_spawn_file_actions_adddup2(&actions, err[1], 2);
    if (::posix_spawn(&pid_, TACTUS_PROGRAM_PATH, &actions, nullptr, argv.data(), environ) != 0) std::abort();
    posix_spawn_file_actions_destroy(&actions);
    ::close(out[1]);
    ::close(err[1]);
    out_ = base::Descriptor(out[0]);
    err_ = base::Descriptor(err[0]);
    if (const std::string line = lineOf(out_); !line.empty()) listening_ = json::parse(line);
  }
  ~Program() {
    if (pid_ > 0) end(SIGTERM);
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// What it says when it listens; null if it ended instead.
  const json& listening() const { return listening_; }
  std::uint16_t port() const { return listening_.at("listening").at("port").get<std::uint16_t>(); }
  std::string token() const {
    return std::string(base::trimmed(readText(listening_.at("token_file").get<std::string>()).substr(0, 32)));
  }
  /// The next line on standard error; empty at its end. Waits for it.
  std::string errorLine() { return lineOf(err_); }
  /// Ends it; its exit status, or 128 and the signal.
  int end(int signal_number) {
    ::kill(pid_, signal_number);
    return wait();
  }
  int wait() {
    int status = 0;
    ::waitpid(std::exchange(pid_, -1), &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

 private:
  static std::string lineOf(const base::Descriptor& stream) {
    std::string line;
    for (char c = 0; ::read(stream.number(), &c, 1) == 1 && c != '\n';) line += c;
    return line;
  }

  pid_t pid_ = -1;
  base::Descriptor out_;
  base::Descriptor err_;
  json listening_;
};

class Serve : public testing::Test {
 protected:
  void SetUp() override { writeModel("first"); }

  void writeModel(const std::string& name) {
    fuzzy::ForceModel model = support::s4FiveRegions();
    model.name = name;
    ASSERT_TRUE(model_io::writeModel(model, model_));
  }
  /// The exit status and the error of a call that does not serve.
  std::pair<int, std::string> refusal(const std::vector<std::string>& arguments) {
    Program program(arguments);
    EXPECT_TRUE(program.listening().is_null());
    std::string sentences;
    for (std::string line = program.errorLine(); !line.empty(); line = program.errorLine()) sentences += line + '\n';
    return {program.wait(), sentences};
  }
  static std::string nameIn(const std::string& line) {
    return json::parse(line).at("model").at("file").at("name").get<std::string>();
  }
  TestClient greeted(const Program& program) {
    TestClient client(program.port());
    EXPECT_TRUE(client.send(helloOf(program.token())));
    EXPECT_EQ(json::parse(client.line()).at("hello"), "tactus-link");
    return client;
  }

  support::TempFolder folder_;
  std::string model_ = folder_.file("model.tactus.json");
};

TEST_F(Serve, SaysWhereItListensAndCleansUpWhenItIsInterrupted) {
  const std::string socket = folder_.file("link.sock");
  Program program({model_, "--socket", socket});
  ASSERT_FALSE(program.listening().is_null()) << program.errorLine();
  EXPECT_EQ(program.listening().size(), 2U);
  EXPECT_EQ(program.listening().at("listening").size(), 2U);
  EXPECT_EQ(program.listening().at("listening").at("socket"), socket);
  const std::string token_file = program.listening().at("token_file");
  EXPECT_EQ(fs::status(token_file).permissions(), fs::perms::owner_read | fs::perms::owner_write);

  TestClient client = greeted(program);
  const json model = json::parse(client.line()).at("model");
  EXPECT_EQ(model.at("serial"), 1);
  EXPECT_EQ(model.at("sha256"), base::sha256(readText(model_))) << "what sha256sum says of the file";

  EXPECT_EQ(program.end(SIGTERM), 0);
  EXPECT_EQ(program.errorLine(), "");
  EXPECT_FALSE(fs::exists(socket));
  EXPECT_FALSE(fs::exists(fs::path(token_file).parent_path()));
  EXPECT_EQ(client.line(), "");

  Program again({model_});
  EXPECT_TRUE(again.listening().at("listening").at("socket").is_null());
  EXPECT_EQ(again.end(SIGINT), 0);
}

TEST_F(Serve, AnswersAreThoseOfEval) {
  Program program({model_});
  TestClient client = greeted(program);
  client.line();
  std::string points = "lubrication,neck_flexion,depth,speed\n";
  for (int i = 0; i < 300; ++i) {
    const std::string row = std::to_string((i % 11) * 0.1) + ',' + std::to_string((i % 19) * 5) + ',' +
                            std::to_string(i * 1.9) + ',' + std::to_string((i * 37) % 300);
    points += row + '\n';
    ASSERT_TRUE(client.send(R"({"ask":{"id":)" + std::to_string(i) + R"(,"inputs":[)" + row + "]}}\n"));
  }
  const std::string table = folder_.file("points.csv");
  const std::string result = folder_.file("forces.csv");
  ASSERT_TRUE(base::writeFileAtomically(table, points));
  const std::string command =
      std::string(TACTUS_PROGRAM_PATH) + " eval " + model_ + " --in " + table + " --out " + result;
  ASSERT_EQ(std::system(command.c_str()), 0);
  std::ifstream rows(result);
  std::string row;
  std::getline(rows, row);
  for (int i = 0; i < 300; ++i) {
    std::getline(rows, row);
    const std::string line = client.line();
    const auto fired = row.rfind(',');
    const auto force = row.rfind(',', fired - 1);
    // The digits themselves: both write the shortest text that reads back equal.
    const std::string wanted = R"("force_n":)" + row.substr(force + 1, fired - force - 1) +
                               ",\"fired\":" + (row.substr(fired + 1) == "1" ? "true" : "false");
    EXPECT_NE(line.find(wanted), std::string::npos) << line << " against " << row;
  }
}

TEST_F(Serve, WatchesTheFileAndKeepsTheLastGoodModel) {
  Program program({model_, "--watch"});
  TestClient client = greeted(program);
  EXPECT_EQ(nameIn(client.line()), "first");
  writeModel("second");  // replaced, as programs do
  EXPECT_EQ(nameIn(client.line()), "second");
  // Written into, as some editors do, with a broken state in between.
  const std::string whole = readText(model_);
  std::ofstream(model_) << whole.substr(0, whole.size() / 2) << std::flush;
  const std::string broken = program.errorLine();
  EXPECT_EQ(broken.find("tactus: the last good model is served on: " + model_ + ": line "), 0U) << broken;
  fs::remove(model_);
  EXPECT_NE(program.errorLine().find("No such file"), std::string::npos);
  writeModel("third");
  const std::string line = client.line();
  EXPECT_EQ(nameIn(line), "third");
  EXPECT_EQ(json::parse(line).at("model").at("serial"), 3);
  EXPECT_EQ(program.end(SIGTERM), 0);
}

TEST_F(Serve, ATokenFileOfTheUserIsKept) {
  const std::string path = folder_.file("token");
  std::string token;
  for (int i = 0; i < 2; ++i) {
    Program program({model_, "--token-file", path});
    ASSERT_EQ(program.listening().at("token_file"), path);
    greeted(program);
    EXPECT_EQ(program.end(SIGTERM), 0);
    EXPECT_EQ(fs::status(path).permissions(), fs::perms::owner_read | fs::perms::owner_write);
    if (i == 1) {
      EXPECT_EQ(readText(path), token);
    }
    token = readText(path);
  }
}

TEST_F(Serve, WhatCannotBeServedIsOneSentence) {
  Program taken({model_});
  const auto [status, sentence] = refusal({model_, "--port", std::to_string(taken.port())});
  const std::string empty = folder_.file("empty");
  std::ofstream{empty};
  EXPECT_EQ(status, 1);
  EXPECT_EQ(sentence, "tactus: port " + std::to_string(taken.port()) +
                          ": found another program that uses it, wanted a free port; 0 takes any\n");
  for (const auto& [arguments, words] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{folder_.file("none.json")}, "No such file or directory"},
           {{model_, "--socket", folder_.file("none/s")}, "No such file or directory"},
           {{model_, "--socket", folder_.file(std::string(110, 's'))}, "at most 107 bytes"},
           {{model_, "--token-file", folder_.file("none/t")}, "No such file or directory"},
           {{model_, "--token-file", model_}, "found a token file that others may read"},
           {{empty}, "empty"}}) {
    const auto [exit, said] = refusal(arguments);
    EXPECT_EQ(exit, 1) << words;
    EXPECT_NE(said.find(words), std::string::npos) << said;
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
  }
  EXPECT_EQ(refusal({model_, "--port", "65536"}).first, 2);
  EXPECT_EQ(refusal({model_, "--port", "-1"}).first, 2);
  EXPECT_EQ(refusal({}).first, 2);
  EXPECT_EQ(taken.end(SIGTERM), 0);
}

}  // namespace
}  // namespace tactus::link
