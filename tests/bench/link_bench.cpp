// How long an edit takes until simulators have it over the live link: link_bench [MODEL]. Sixteen clients, eight of
// which never read; 500 edits of a drag, 16 ms apart as the workbench sends them, then the same while the others ask
// for forces.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <thread>
#include <vector>

#include "app/editing/edit.h"
#include "app/link/link_server.h"
#include "core/model_io/model_file.h"

#include "tests/app/link/test_client.h"
#include "tests/support/ngt_model.h"

namespace {

using namespace tactus;
using Clock = std::chrono::steady_clock;

constexpr int kEdits = 500;
const std::string kToken = "0123456789abcdef0123456789abcdef";

/// As the workbench hands a model over: its text is written by the server's thread.
link::LinkModel linkModel(editing::SharedModel model) {
  return {model->compiled, [model] { return model_io::formatModel(editing::withFreshChecks(model)->model); }};
}

void measure(const fuzzy::ForceModel& model, bool asking) {
  link::LinkSettings settings;
  settings.token = kToken;
  settings.program = "link_bench";
  auto server = std::move(*link::LinkServer::start(settings, linkModel(*editing::ready(model))));
  std::vector<link::TestClient> clients;
  for (int i = 0; i < 16; ++i) {
    clients.emplace_back(server->port());
    clients.back().send(link::helloOf(kToken));
    clients.back().line();
    if (i < 8) clients.back().line();
  }
  std::jthread asks([&](const std::stop_token& stop) {
    std::string inputs;
    for (std::size_t i = 0; i < model.inputs.size(); ++i) inputs += i == 0 ? "1" : ",1";
    while (asking && !stop.stop_requested()) {
      for (int i = 8; i < 16; ++i)
        clients[static_cast<std::size_t>(i)].sendSome(R"({"ask":{"id":1,"inputs":[)" + inputs + "]}}\n");
      std::this_thread::yield();
    }
  });
  std::vector<double> first_ms;
  std::vector<double> last_ms;
  std::vector<double> publish_us;
  for (int i = 0; i < kEdits; ++i) {
    fuzzy::ForceModel edited = model;
    edited.name += std::to_string(i);
    const auto ready = *editing::ready(std::move(edited));
    const auto start = Clock::now();
    server->publish(linkModel(ready));
    publish_us.push_back(std::chrono::duration<double, std::micro>(Clock::now() - start).count());
    for (std::size_t c = 0; c < 8; ++c) {
      clients[c].line();
      const double ms = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
      if (c == 0) first_ms.push_back(ms);
      if (c == 7) last_ms.push_back(ms);
    }
    std::this_thread::sleep_until(start + std::chrono::milliseconds(16));
  }
  const auto print = [](const char* what, std::vector<double> values, const char* unit) {
    std::sort(values.begin(), values.end());
    std::printf("  %-34s median %8.3f  99 %% %8.3f  largest %8.3f %s\n", what, values[values.size() / 2],
                values[values.size() * 99 / 100], values.back(), unit);
  };
  std::printf("%s\n", asking ? "while eight clients ask without reading" : "eight clients read, eight never do");
  print("edit until the first client has it", first_ms, "ms");
  print("edit until the eighth has it", last_ms, "ms");
  print("handing over, in the window's thread", publish_us, "us");
}

}  // namespace

int main(int argc, char** argv) {
  auto read = argc > 1 ? model_io::readModel(argv[1])
                       : base::Result<model_io::ReadModel>(model_io::ReadModel{support::s4FiveRegions(), {}});
  if (!read) {
    std::fprintf(stderr, "%s\n", read.error().message().c_str());
    return 1;
  }
  std::printf("model of %zu bytes, %zu checks\n", model_io::formatModel(read->model).size(), read->model.checks.size());
  measure(read->model, false);
  measure(read->model, true);
}
