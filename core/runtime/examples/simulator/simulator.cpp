// An example simulator: ten strokes through the force model of a bundle at 1 kHz, while the model may be edited.
//   simulator BUNDLE [--port P | --socket PATH] [--token-file FILE] [--set ID=VALUE]... [--out DIR] [--fast]
// Writes DIR/trace.csv (each millisecond) and DIR/strokes.csv. The hand is simulated.
#include <algorithm>
#include <chrono>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <tactus/tactus.hpp>
#include <thread>
#include <vector>

#include "live_link.h"
#include "scene_box.h"
#include "simulated_hand.h"

namespace {

constexpr int kStrokes = 10;
constexpr double kTickS = 0.001;
constexpr double kFadeS = 0.05;    // of an edit, as in the workbench
constexpr double kSwallowS = 0.2;  // how fast a swallow begins and ends
constexpr std::size_t kMostTicks = 600'000;
constexpr auto kPatience = std::chrono::seconds(5);  // for the first model of the live link

struct Options {
  std::string bundle;
  std::string out = ".";
  std::string token_file;
  LinkAddress link;
  std::map<std::string, double> conditions;
  bool fast = false;  // as fast as it goes, without waiting for the clock
};

struct Row {
  double time_s, position_mm;
  tactus::Feel feel;
  int stroke, held, swallows;
  unsigned long long serial;
};

int usage() {
  std::fprintf(stderr,
               "usage: simulator BUNDLE [--port P | --socket PATH] [--token-file FILE] [--set ID=VALUE]... [--out DIR] "
               "[--fast]\n");
  return 2;
}

bool readOptions(int argc, char** argv, Options& options) {
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const bool has_value = i + 1 < argc;
    if (word == "--fast") {
      options.fast = true;
    } else if (word == "--port" && has_value) {
      options.link.port = std::atoi(argv[++i]);
    } else if (word == "--socket" && has_value) {
      options.link.socket = argv[++i];
    } else if (word == "--token-file" && has_value) {
      options.token_file = argv[++i];
    } else if (word == "--out" && has_value) {
      options.out = argv[++i];
    } else if (word == "--set" && has_value && std::strchr(argv[i + 1], '=') != nullptr) {
      const std::string set = argv[++i];
      const std::string value = set.substr(set.find('=') + 1);
      char* end = nullptr;
      options.conditions[set.substr(0, set.find('='))] = std::strtod(value.c_str(), &end);
      if (value.empty() || *end != '\0') return false;
    } else if (options.bundle.empty() && word.rfind("--", 0) != 0) {
      options.bundle = word;
    } else {
      return false;
    }
  }
  return !options.bundle.empty();
}

// The model under the conditions: what is not set is in the middle of its universe, and `swallow` at its beginning.
std::unique_ptr<Scenes> scenesOf(const tactus::Model& model, const Options& options, unsigned long long serial) {
  std::map<std::string, double> rest;
  std::map<std::string, double> swallowing;
  for (std::size_t i = 0; i < model.inputs(); ++i) {
    const std::string id = model.inputId(i);
    if (std::string_view(model.inputRole(i)) != "condition") continue;
    const auto set = options.conditions.find(id);
    const double middle = (model.inputMin(i) + model.inputMax(i)) / 2;
    rest[id] = set != options.conditions.end() ? set->second : id == "swallow" ? model.inputMin(i) : middle;
    swallowing[id] = id == "swallow" && set == options.conditions.end() ? model.inputMax(i) : rest[id];
  }
  return std::make_unique<Scenes>(serial, model.renderer().depth_offset_mm, model.scene(rest), model.scene(swallowing));
}

double depthOf(const tactus::Model& model, bool end) {
  for (std::size_t i = 0; i < model.inputs(); ++i) {
    if (std::string_view(model.inputRole(i)) == "way") return end ? model.inputMax(i) : model.inputMin(i);
  }
  throw tactus::Error(TACTUS_BAD_ARGUMENT, "found a model without a way of the tip, wanted one with it");
}

// The servo loop: nothing in it allocates, waits for another thread or writes a file.
void runStrokes(SceneBox& box, LiveLink* link, tactus::Tube& tube, const Scenes* scenes, SimulatedHand hand, bool fast,
                std::vector<Row>& rows) {
  auto next = std::chrono::steady_clock::now();
  bool swallows = false;
  double force_n = 0;
  while (!hand.isDone() && rows.size() < kMostTicks) {
    const auto pose = hand.step(force_n, kTickS);
    const bool swallows_now = pose.stroke % 3 == 0;  // the patient swallows at every third stroke
    if (const Scenes* const newer = box.take()) {
      tube.scene(swallows_now ? newer->swallowing : newer->rest, kFadeS);
      box.used(*newer);
      scenes = newer;
    } else if (swallows_now != swallows) {
      tube.scene(swallows_now ? scenes->swallowing : scenes->rest, kSwallowS);
    }
    swallows = swallows_now;
    const tactus::Feel feel = tube.step(pose.position_mm, pose.held, kTickS);
    force_n = feel.force_n;  // a real simulator sends it to its device, behind limits of its own
    rows.push_back({static_cast<double>(rows.size()) * kTickS, pose.position_mm, feel, pose.stroke, pose.held ? 1 : 0,
                    swallows ? 1 : 0, scenes->serial});
    if (link != nullptr)
      link->felt(rows.back().time_s, feel.depth_mm + scenes->depth_offset_mm, feel.speed_mm_s, feel.force_n);
    if (!fast) std::this_thread::sleep_until(next += std::chrono::milliseconds(1));
  }
}

#ifdef __GNUC__
std::string line(const char* format, ...) __attribute__((format(printf, 1, 2)));
#endif
std::string line(const char* format, ...) {
  char text[256];
  va_list values;
  va_start(values, format);
  std::vsnprintf(text, sizeof text, format, values);
  va_end(values);
  return text;
}

bool writeTrace(const std::string& path, const std::vector<Row>& rows) {
  std::ofstream file(path);
  file << "time_s,stroke,held,swallows,position_mm,depth_mm,speed_mm_s,force_n,model_force_n,serial,simulated\n";
  for (const Row& row : rows) {
    file << line("%.3f,%d,%d,%d,%.4f,%.4f,%.3f,%.6f,%.6f,%llu,1\n", row.time_s, row.stroke, row.held, row.swallows,
                 row.position_mm, row.feel.depth_mm, row.feel.speed_mm_s, row.feel.force_n, row.feel.model_force_n,
                 row.serial);
  }
  return file.flush().good();
}

bool writeStrokes(const std::string& path, const std::vector<Row>& rows) {
  std::ofstream file(path);
  file << "stroke,completion_time_s,from_depth_mm,to_depth_mm,largest_force_n,largest_speed_mm_s,simulated\n";
  for (std::size_t begin = 0; begin < rows.size();) {
    std::size_t end = begin;
    double held_s = 0;
    double force_n = 0;
    double speed_mm_s = 0;
    for (; end < rows.size() && rows[end].stroke == rows[begin].stroke; ++end) {
      held_s += rows[end].held * kTickS;
      force_n = std::max(force_n, rows[end].feel.force_n);
      if (rows[end].held != 0) speed_mm_s = std::max(speed_mm_s, rows[end].feel.speed_mm_s);
    }
    file << line("%d,%.3f,%.3f,%.3f,%.6f,%.3f,1\n", rows[begin].stroke, held_s, rows[begin].feel.depth_mm,
                 rows[end - 1].feel.depth_mm, force_n, speed_mm_s);
    begin = end;
  }
  return file.flush().good();
}

int simulate(Options options) {
  const double error_n = tactus::verify(options.bundle);
  std::printf("%s: verified, largest error %.3g N\n", options.bundle.c_str(), error_n);
  const auto model = tactus::Model::open(options.bundle + "/model.tactus.json");
  auto first = scenesOf(model, options, 0);
  tactus::Tube tube(first->rest);
  const double start_mm = depthOf(model, false);
  tube.place(start_mm);

  SceneBox box;
  std::unique_ptr<LiveLink> link;
  if (options.link.port != 0 || !options.link.socket.empty()) {
    std::ifstream token_file(options.token_file);
    if (!std::getline(token_file, options.link.token))
      throw tactus::Error(TACTUS_BAD_FILE,
                          options.token_file + ": found no token, wanted the token file of the server");
    link = std::make_unique<LiveLink>(options.link,
                                      [&box, options](const tactus::Model& newer, unsigned long long serial) {
                                        box.put(scenesOf(newer, options, serial));
                                      });
  }
  if (link != nullptr && !box.waitForFirst(kPatience)) std::fprintf(stderr, "no model from the live link yet\n");
  std::vector<Row> rows;
  rows.reserve(kMostTicks);
  const SimulatedHand hand(kStrokes, (depthOf(model, true) - start_mm) / kStrokes);
  runStrokes(box, link.get(), tube, first.get(), hand, options.fast, rows);
  link.reset();

  const bool written = writeTrace(options.out + "/trace.csv", rows) && writeStrokes(options.out + "/strokes.csv", rows);
  if (!written) throw tactus::Error(TACTUS_BAD_FILE, options.out + ": found a folder that cannot be written to");
  std::printf("simulated hand: %d strokes in %.3f s to a depth of %.1f mm, model %llu\n", kStrokes, rows.back().time_s,
              rows.back().feel.depth_mm, rows.back().serial);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  if (!readOptions(argc, argv, options)) return usage();
  try {
    return simulate(options);
  } catch (const tactus::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
