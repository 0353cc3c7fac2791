#include "app/bundle/sources.h"

#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

#include "app/bundle/program_run.h"
#include "core/base/check.h"
#include "core/base/files/file.h"
#include "core/base/files/unfinished.h"
#include "core/base/tables/csv.h"
#include "core/base/text.h"
#include "core/exchange/c_source.h"
#include "core/exchange/js_source.h"
#include "core/exchange/tube_source.h"
#include "core/fuzzy/compiled_model.h"

namespace tactus::bundle {
namespace {

namespace fs = std::filesystem;
using Gives = SourceFile::Gives;

constexpr std::size_t kMostBytes = std::size_t{64} << 20U;

/// Reads points and writes their forces, all digits of them.
constexpr std::string_view kForceInC = R"(#include <stdio.h>
#include "force_model.h"
int main(void) {
  double inputs[FORCE_MODEL_INPUTS];
  for (;;) {
    int i, fired;
    for (i = 0; i < FORCE_MODEL_INPUTS; ++i) {
      if (scanf("%lf", &inputs[i]) != 1) return 0;
    }
    printf("%.17g\n", force_model(inputs, &fired));
  }
}
)";

/// Reads steps, each with its conditions; the first number says 0 a step, 1 the first of a tube, 2 other conditions.
constexpr std::string_view kTubeInC = R"(#include <stdio.h>
#include "tube.h"
int main(void) {
  tube_state tube;
  double conditions[TUBE_CONDITIONS + 1], position_mm, dt_s;
  int what, held, i;
  while (scanf("%d %lf %d %lf", &what, &position_mm, &held, &dt_s) == 4) {
    for (i = 0; i < TUBE_CONDITIONS; ++i) {
      if (scanf("%lf", &conditions[i]) != 1) return 1;
    }
    if (what == 1) tube_start(&tube, conditions);
    if (what == 2) tube_change(&tube, conditions, 0.05);
    printf("%.17g\n", tube_step(&tube, position_mm, held, dt_s));
  }
  return 0;
}
)";

constexpr std::string_view kRowsInJs = R"(const rows = require('fs').readFileSync(0, 'utf8').trim().split('\n')
  .map((row) => row.trim().split(/\s+/).map(Number));
)";

constexpr std::string_view kForceInJs = R"(const { forceModel } = require('./force_model.js');
console.log(rows.map((row) => forceModel(row).force).join('\n'));
)";

constexpr std::string_view kTubeInJs = R"(const { tubeStart, tubeChange, tubeStep } = require('./tube.js');
let tube = null;
console.log(rows.map(([what, position, held, dt, ...conditions]) => {
  if (what === 1) tube = tubeStart(conditions);
  if (what === 2) tubeChange(tube, conditions, 0.05);
  return tubeStep(tube, position, held, dt);
}).join('\n'));
)";

/// A folder for what is run, which is removed.
class WorkFolder {
 public:
  WorkFolder() {
    std::error_code ignored;
    work_ =
        base::makeUnfinishedFolder((fs::temp_directory_path(ignored) / "tactus-run").string(), base::kUnfinishedEnding);
  }
  ~WorkFolder() {
    std::error_code ignored;
    if (isOpen()) fs::remove_all(work_.path, ignored);
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

  bool isOpen() const { return work_.descriptor.isOpen(); }
  const std::string& path() const { return work_.path; }
  bool write(const std::string& name, std::string_view text) const {
    return base::writeFileAtomically(file(name), text).has_value();
  }
  std::string file(const std::string& name) const { return work_.path + "/" + name; }

 private:
  base::Unfinished work_;
};

std::optional<std::vector<double>> numbersOf(const std::string& path, std::size_t wanted) {
  const auto output = base::readFile(path, kMostBytes);
  if (!output) return std::nullopt;
  std::vector<double> out;
  std::string_view rest = *output;
  for (std::size_t end = rest.find('\n'); end != std::string_view::npos; end = rest.find('\n')) {
    const auto force = base::parseNumber(rest.substr(0, end));
    if (!force) return std::nullopt;
    out.push_back(*force);
    rest.remove_prefix(end + 1);
  }
  if (out.size() != wanted) return std::nullopt;
  return out;
}

/// What `file` writes for `input`, `wanted` numbers.
std::optional<std::vector<double>> ranOn(const Sources& sources, const SourceFile& file, const std::string& input,
                                         std::size_t wanted, const std::stop_token& stop) {
  TACTUS_CHECK(file.gives != Gives::kNothing);
  const WorkFolder work;
  if (!work.isOpen() || !work.write("in", input)) return std::nullopt;
  const bool tube = file.gives == Gives::kTube;
  const std::string language = file.path.substr(0, file.path.find('/') + 1);
  std::vector<std::string> c_files;
  for (const SourceFile& one : sources.files) {
    if (!one.path.starts_with(language)) continue;
    const std::string name = one.path.substr(language.size());
    if (!work.write(name, one.bytes)) return std::nullopt;
    if (name.ends_with(".c")) c_files.push_back(work.file(name));
  }
  std::vector<std::string> command;
  if (language == "c/") {
    if (!work.write("main.c", tube ? kTubeInC : kForceInC)) return std::nullopt;
    std::vector<std::string> compile = {"cc", "-std=c99", "-O1", work.file("main.c")};
    compile.insert(compile.end(), c_files.begin(), c_files.end());
    compile.insert(compile.end(), {"-o", work.file("main"), "-lm"});
    if (runProgram(compile, work.path(), stop) != Ran::kWell) return std::nullopt;
    command = {work.file("main")};
  } else {
    if (!work.write("main.js", std::string(kRowsInJs) + std::string(tube ? kTubeInJs : kForceInJs)))
      return std::nullopt;
    command = {"node", work.file("main.js")};
  }
  if (runProgram(command, work.path(), stop) != Ran::kWell) return std::nullopt;
  return numbersOf(work.file("out"), wanted);
}

}  // namespace

Sources sourcesOf(const fuzzy::ForceModel& model, const exchange::Origin& origin) {
  Sources out;
  if (auto force = exchange::cSource(model, {}, origin)) {
    out.files.push_back({"c/force_model.h", "c", std::move(force->header), Gives::kNothing});
    out.files.push_back({"c/force_model.c", "c", std::move(force->source), Gives::kForce});
  } else {
    out.warnings.push_back("c/force_model.c is left out: " + force.error().message());
    return out;
  }
  auto tube = exchange::cTube(model, origin);
  if (tube) {
    out.files.push_back({"c/tube.h", "tube-c", std::move(tube->header), Gives::kNothing});
    out.files.push_back({"c/tube.c", "tube-c", std::move(tube->source), Gives::kTube});
  }
  out.files.push_back({"js/force_model.js", "js", exchange::jsForce(model, origin), Gives::kForce});
  if (auto script = exchange::jsTube(model, origin)) {
    out.files.push_back({"js/tube.js", "tube-js", std::move(*script), Gives::kTube});
  } else {
    out.warnings.push_back("c/tube.c, js/tube.js and checks_tube.csv are left out: " + script.error().message());
  }
  return out;
}

std::optional<FeltTraces> feltTraces(const fuzzy::ForceModel& model) {
  const auto inputs = render::tubeInputs(model);
  const auto compiled = fuzzy::compile(model);
  if (!inputs || !compiled) return std::nullopt;
  FeltTraces out;
  for (const std::size_t input : inputs->conditions) out.conditions.push_back(model.inputs[input].id);
  out.traces = render::tubeTraces(model, *inputs);
  for (const render::TubeTrace& trace : out.traces) {
    render::TubeRun run(model, *inputs, *compiled);
    auto& felt = out.felt.emplace_back();
    for (const render::TubeStep& step : trace.steps) {
      const auto one = run.step(step);
      if (!one) return std::nullopt;
      felt.push_back(*one);
    }
  }
  return out;
}

std::string formatTubeChecks(const FeltTraces& felt) {
  std::vector<std::string> columns = {"trace", "step", "position_mm", "held", "dt_s"};
  columns.insert(columns.end(), felt.conditions.begin(), felt.conditions.end());
  columns.insert(columns.end(), {"force_n", "depth_mm", "phase", "stroke"});
  base::CsvWriter csv(columns);
  for (std::size_t t = 0; t < felt.traces.size(); ++t) {
    const render::TubeTrace& trace = felt.traces[t];
    for (std::size_t i = 0; i < trace.steps.size(); ++i) {
      const render::TubeStep& step = trace.steps[i];
      const render::TubeFeel& one = felt.felt[t][i];
      csv.cell(trace.name).cell(static_cast<long long>(i + 1)).cell(step.position_mm).cell(step.held ? 1 : 0);
      csv.cell(step.dt_s);
      for (const double value : step.conditions) csv.cell(value);
      csv.cell(one.force_n).cell(one.depth_mm).cell(one.phase).cell(static_cast<long long>(one.stroke)).endRow();
    }
  }
  return csv.text();
}

std::optional<std::vector<double>> forcesOf(const Sources& sources, const SourceFile& file,
                                            const std::vector<std::vector<double>>& points,
                                            const std::stop_token& stop) {
  std::string input;
  for (const auto& point : points) {
    for (const double value : point) input += base::formatNumber(value) + ' ';
    input += '\n';
  }
  return ranOn(sources, file, input, points.size(), stop);
}

std::optional<std::vector<double>> forcesOf(const Sources& sources, const SourceFile& file, const FeltTraces& felt,
                                            const std::stop_token& stop) {
  std::string input;
  std::size_t steps = 0;
  for (const render::TubeTrace& trace : felt.traces) {
    const render::TubeStep* before = nullptr;
    for (const render::TubeStep& step : trace.steps) {
      const char* const what = before == nullptr ? "1 " : step.conditions != before->conditions ? "2 " : "0 ";
      input +=
          what + base::formatNumber(step.position_mm) + (step.held ? " 1 " : " 0 ") + base::formatNumber(step.dt_s);
      for (const double value : step.conditions) input += ' ' + base::formatNumber(value);
      input += '\n';
      before = &step;
      ++steps;
    }
  }
  return ranOn(sources, file, input, steps, stop);
}

}  // namespace tactus::bundle
