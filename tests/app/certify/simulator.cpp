// A simulator that speaks the protocol of docs/certify.md with libtactus: `simulator MODEL [HOW [AT]] [--listen PATH]`.
// HOW it is wrong, at question AT (1): off, hang, die, crash, nan, id, nonsense, endless, flood, late, error, child,
// notube, other, silent.
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <netinet/in.h>
#include <nlohmann/json.hpp>
#include <string>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>
#include <vector>

#include "tactus/tactus.h"

namespace {

using nlohmann::json;

class Simulator {
 public:
  Simulator(const std::string& model, std::string how, int at) : how_(std::move(how)), at_(at) {
    if (tactus_model_open(model.c_str(), &model_, nullptr, 0) != TACTUS_OK) std::exit(3);
  }

  /// The answer to a line; empty for none.
  std::string answer(const std::string& line) {
    const json asked = json::parse(line);
    if (asked.contains("hello")) {
      if (how_ == "silent") ::pause();
      json said = {{"hello", "tactus-certify"}, {"version", 1}, {"program", "the simulator of the tests"}};
      said["model_sha256"] = how_ == "other" ? std::string(64, '0') : asked["model_sha256"].get<std::string>();
      if (how_ == "notube") said["tube"] = false;
      return said.dump();
    }
    if (asked.contains("tube")) {
      const bool is_start = asked["tube"].contains("start");
      takeScene(asked["tube"][is_start ? "start" : "scene"]["conditions"], is_start);
      return {};
    }
    if (asked.contains("end")) std::exit(0);
    const bool is_force = asked.contains("force");
    const json& question = asked[is_force ? "force" : "step"];
    json said = {{"id", question["id"]}};
    if (is_force) {
      const auto inputs = question["inputs"].get<std::vector<double>>();
      int fired = 0;
      said["force_n"] = tactus_force(model_, inputs.data(), &fired);
      said["fired"] = fired != 0;
    } else {
      tactus_feel feel{};
      feel.size = sizeof feel;
      (void)tactus_tube_step(tube_, question["position_mm"], question["held"] ? 1 : 0, question["dt_s"], &feel);
      said["force_n"] = feel.force_n;
      said["depth_mm"] = feel.depth_mm;
    }
    if (++asked_ == at_) spoil(said);
    const std::string out = late_.empty() ? json{{is_force ? "force" : "step", said}}.dump() : late_;
    late_.clear();
    return out;
  }

 private:
  void takeScene(const json& conditions, bool is_start) {
    std::vector<std::size_t> fixed;
    std::vector<double> values;
    for (std::size_t i = 0; i < tactus_model_inputs(model_); ++i) {
      const std::string id = tactus_model_input_id(model_, i);
      if (!conditions.contains(id)) continue;
      fixed.push_back(i);
      values.push_back(conditions[id]);
    }
    tactus_scene* scene = nullptr;
    if (tactus_scene_make(model_, fixed.data(), values.data(), fixed.size(), &scene, nullptr, 0) != TACTUS_OK)
      std::exit(4);
    if (is_start) {
      tactus_tube_free(tube_);
      if (tactus_tube_make(scene, &tube_, nullptr, 0) != TACTUS_OK) std::exit(5);
    } else {
      tactus_tube_scene(tube_, scene, 0.05);
    }
    tactus_scene_free(scene);
  }

  void spoil(json& said) {
    if (how_ == "off") said["force_n"] = said["force_n"].get<double>() + 1e-6;
    if (how_ == "nan") said["force_n"] = std::nan("");  // null in JSON
    if (how_ == "id") said["id"] = 9999;
    if (how_ == "hang") ::pause();
    if (how_ == "die") {
      std::cerr << "loading\nno license\n";
      std::exit(7);
    }
    if (how_ == "crash") std::raise(SIGSEGV);
    if (how_ == "nonsense") late_ = "force: 0.41";
    if (how_ == "error") late_ = R"({"error":"the motor is off"})";
    if (how_ == "endless") {
      const std::string part(1 << 16, 'x');
      while (std::fwrite(part.data(), 1, part.size(), stdout) == part.size()) {
      }
    }
    if (how_ == "flood") std::cerr << std::string(4 << 20, 'e');
    if (how_ == "late") ::usleep(600'000);
    if (how_ == "child") {
      if (const pid_t child = ::fork(); child == 0) {
        for (;;) ::pause();
      } else {
        std::ofstream("child.txt") << child;
      }
      ::pause();
    }
  }

  tactus_model* model_ = nullptr;
  tactus_tube* tube_ = nullptr;
  std::string how_;
  int at_;
  int asked_ = 0;
  std::string late_;  ///< in the place of the answer
};

/// A connection to whoever comes first to the socket file `path`, or to a port of the loopback that is written there.
int connectionAt(const std::string& path, bool tcp) {
  int listening = -1;
  if (tcp) {
    listening = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    if (::bind(listening, reinterpret_cast<sockaddr*>(&address), size) != 0 || ::listen(listening, 1) != 0 ||
        ::getsockname(listening, reinterpret_cast<sockaddr*>(&address), &size) != 0)
      std::exit(6);
    std::ofstream(path + ".new") << ntohs(address.sin_port);
  } else {
    listening = ::socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    (path + ".new").copy(address.sun_path, sizeof address.sun_path - 1);
    if (::bind(listening, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0 || ::listen(listening, 1) != 0)
      std::exit(6);
  }
  std::rename((path + ".new").c_str(), path.c_str());  // whoever sees it may connect
  return ::accept(listening, nullptr, nullptr);
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() > 2 && (words[words.size() - 2] == "--unix" || words[words.size() - 2] == "--tcp")) {
    const int connection = connectionAt(words.back(), words[words.size() - 2] == "--tcp");
    ::dup2(connection, 0);
    ::dup2(connection, 1);
    words.resize(words.size() - 2);
  }
  Simulator simulator(words.at(0), words.size() > 1 ? words[1] : "",
                      words.size() > 2 ? std::atoi(words[2].c_str()) : 1);
  for (std::string line; std::getline(std::cin, line);) {
    const std::string answer = simulator.answer(line);
    if (!answer.empty()) std::cout << answer << '\n' << std::flush;
  }
}
