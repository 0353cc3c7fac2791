// What speaks for a shared library and for a module of JavaScript.
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <dlfcn.h>
#include <optional>
#include <unistd.h>
#include <vector>

#include "app/certify/foreign_program.h"
#include "core/base/json/json_members.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"

namespace tactus::certify {
namespace {

using base::JsonMembers;
using base::JsonWriter;
using base::required;

constexpr double kFadeS = 0.05;  // of another scene, as the protocol has it

std::string errorLine(const std::string& sentence) { return lineOf("error").value(sentence).endObject().text(); }

/// The functions of a shared library that was made of a bundle's C source.
class Library {
 public:
  /// Nothing, where `error` then says why.
  static std::optional<Library> open(const std::string& path, std::string& error) {
    void* const handle = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    Library out;
    out.name_ = path.substr(path.rfind('/') + 1);
    if (handle != nullptr) out.find(handle, "force_model", out.force_);
    if (out.force_ == nullptr) {
      error = dlerror();
      return std::nullopt;
    }
    out.find(handle, "tube_start", out.start_);
    out.find(handle, "tube_change", out.change_);
    out.find(handle, "tube_step", out.step_);
    return out;
  }

  /// The answer to a line; empty where it has none.
  base::Result<std::string> answer(std::string_view line) {
    return base::readJson(line, "", [&](JsonMembers& members, std::optional<base::Error>& error) {
      if (members.has("hello")) return hello();
      if (members.has("force")) return force(*members.object("force"), error);
      if (!hasTube()) return std::string();
      if (members.has("step")) return step(*members.object("step"), error);
      if (members.has("tube")) takeScene(*members.object("tube"), error);
      return std::string();
    });
  }

 private:
  template <class Function>
  static void find(void* handle, const char* name, Function& function) {
    function = reinterpret_cast<Function>(dlsym(handle, name));
  }

  bool hasTube() const { return start_ != nullptr && change_ != nullptr && step_ != nullptr; }

  std::string hello() const {
    JsonWriter json = lineOf("hello");
    json.value("tactus-certify").key("version").value(1).key("program").value("the shared library " + name_);
    return json.key("tube").value(hasTube()).endObject().text();
  }

  std::string force(base::JsonValue question, std::optional<base::Error>& error) const {
    JsonMembers asked(question, error);
    double id = 0;
    std::vector<double> inputs;
    asked.number(required("id"), id);
    asked.numbers(required("inputs"), inputs);
    int fired = 0;
    const double force_n = force_(inputs.data(), &fired);
    JsonWriter json = lineOf("force");
    json.beginObject().key("id").value(id).key("force_n").value(force_n).key("fired").value(fired != 0);
    return json.endObject().endObject().text();
  }

  std::string step(base::JsonValue question, std::optional<base::Error>& error) {
    JsonMembers asked(question, error);
    double id = 0;
    double position_mm = 0;
    double dt_s = 0;
    bool held = false;
    asked.number(required("id"), id);
    asked.number(required("position_mm"), position_mm);
    asked.flag(required("held"), held);
    asked.number(required("dt_s"), dt_s);
    const double force_n = step_(state_.data(), position_mm, held ? 1 : 0, dt_s);
    // The state begins with force_n and depth_mm.
    double depth_mm = 0;
    std::memcpy(&depth_mm, state_.data() + sizeof(double), sizeof depth_mm);
    JsonWriter json = lineOf("step");
    json.beginObject().key("id").value(id).key("force_n").value(force_n).key("depth_mm").value(depth_mm);
    return json.endObject().endObject().text();
  }

  void takeScene(base::JsonValue scene, std::optional<base::Error>& error) {
    JsonMembers members(scene, error);
    const bool is_start = members.has("start");
    const auto inside = members.object(is_start ? "start" : "scene");
    const auto values = inside ? inside->find("conditions") : std::nullopt;
    if (!values) return;
    std::vector<double> conditions;
    for (const base::JsonValue value : *values) conditions.push_back(value.number());
    if (is_start) {
      start_(state_.data(), conditions.data());
    } else {
      change_(state_.data(), conditions.data(), kFadeS);
    }
  }

  std::string name_;
  double (*force_)(const double*, int*) = nullptr;
  void (*start_)(void*, const double*) = nullptr;
  void (*change_)(void*, const double*, double) = nullptr;
  double (*step_)(void*, double, int, double) = nullptr;
  alignas(std::max_align_t) std::array<unsigned char, 1 << 16> state_{};  ///< more than any tube_state takes
};

bool writeAll(int out, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = write(out, bytes.data(), bytes.size());
    if (count < 0 && errno != EINTR) return false;
    if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

}  // namespace

void answerWithLibrary(const std::string& path, int in, int out) {
  std::string error;
  auto library = Library::open(path, error);
  if (!library) {
    writeAll(out, errorLine(error));
    return;
  }
  std::string waiting;
  std::array<char, 4096> room;
  for (ssize_t got = 0; (got = read(in, room.data(), room.size())) > 0 || (got < 0 && errno == EINTR);) {
    if (got > 0) waiting.append(room.data(), static_cast<std::size_t>(got));
    for (std::size_t end = 0; (end = waiting.find('\n')) != std::string::npos; waiting.erase(0, end + 1)) {
      const auto answer = library->answer(std::string_view(waiting).substr(0, end));
      if (!writeAll(out, answer ? *answer : errorLine(answer.error().message()))) return;
    }
  }
}

std::string_view nodeScript() {
  return R"(import { createInterface } from 'node:readline';
import { readFile } from 'node:fs/promises';
import { existsSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { pathToFileURL } from 'node:url';

// What the module prints is no answer.
for (const word of ['log', 'info', 'debug']) console[word] = console.error;
const say = (line) => process.stdout.write(JSON.stringify(line) + '\n');

async function load(path) {
  try {
    return await import(pathToFileURL(path));
  } catch (error) {
    // A module without a package that says so.
    if (!(error instanceof SyntaxError)) throw error;
    return import('data:text/javascript;base64,' + (await readFile(path)).toString('base64'));
  }
}

const path = process.argv[2];
const found = {};
const wanted = ['forceModel', 'tubeStart', 'tubeChange', 'tubeStep'];
try {
  // The two files of a bundle stand side by side.
  for (const name of [basename(path), 'force_model.js', 'tube.js']) {
    const one = join(dirname(path), name);
    if (name !== basename(path) && !existsSync(one)) continue;
    const module = await load(one);
    for (const word of wanted) found[word] ??= module[word] ?? module.default?.[word] ?? globalThis[word];
  }
  if (!found.forceModel) throw new Error('found no function forceModel, wanted one that is exported');
} catch (error) {
  say({ error: basename(path) + ': ' + error.message });
  process.exit(1);
}
const has_tube = Boolean(found.tubeStart && found.tubeChange && found.tubeStep);
let tube;
let names = [];
const valuesOf = (conditions) => names.map((name) => conditions[name]);
for await (const line of createInterface({ input: process.stdin })) {
  const asked = JSON.parse(line);
  if (asked.hello) {
    names = asked.inputs.filter((name) => name !== 'depth' && name !== 'speed');
    const program = basename(path) + ' in Node ' + process.version;
    say({ hello: 'tactus-certify', version: 1, program, tube: has_tube });
  } else if (asked.force) {
    const { force, fired } = found.forceModel(asked.force.inputs);
    say({ force: { id: asked.force.id, force_n: force, fired: Boolean(fired) } });
  } else if (asked.tube?.start) {
    tube = found.tubeStart(valuesOf(asked.tube.start.conditions));
  } else if (asked.tube?.scene) {
    found.tubeChange(tube, valuesOf(asked.tube.scene.conditions), 0.05);
  } else if (asked.step) {
    const force_n = found.tubeStep(tube, asked.step.position_mm, asked.step.held, asked.step.dt_s);
    say({ step: { id: asked.step.id, force_n, depth_mm: tube.depth_mm } });
  }
}
)";
}

}  // namespace tactus::certify
