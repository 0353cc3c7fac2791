#include "app/bundle/sources.h"

#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

#include "app/bundle/file_errors.h"
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

/// Reads a number of points, these points, then steps; writes all forces, all digits of them. A step comes with its
/// conditions, and begins with 0, with 1 as the first of a tube, or with 2 where the conditions are others.
constexpr std::string_view kMainInC = R"(#include <stdio.h>
#include "force_model.h"
#ifdef WITH_TUBE
#include "tube.h"
static int steps(void) {
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
#else
static int steps(void) { return 0; }
#endif
int main(void) {
  double inputs[FORCE_MODEL_INPUTS];
  long points, p;
  int i, fired;
  if (scanf("%ld", &points) != 1) return 1;
  for (p = 0; p < points; ++p) {
    for (i = 0; i < FORCE_MODEL_INPUTS; ++i) {
      if (scanf("%lf", &inputs[i]) != 1) return 1;
    }
    printf("%.17g\n", force_model(inputs, &fired));
  }
  return steps();
}
)";

constexpr std::string_view kMainInJs = R"(const { forceModel } = require('./force_model.js');
const rows = require('fs').readFileSync(0, 'utf8').trim().split('\n')
  .map((row) => row.trim().split(/\s+/).map(Number));
const [points] = rows.shift();
const out = rows.splice(0, points).map((row) => forceModel(row).force);
if (rows.length > 0) {
  const { tubeStart, tubeChange, tubeStep } = require('./tube.js');
  let tube = null;
  for (const [what, position, held, dt, ...conditions] of rows) {
    if (what === 1) tube = tubeStart(conditions);
    if (what === 2) tubeChange(tube, conditions, 0.05);
    out.push(tubeStep(tube, position, held, dt));
  }
}
console.log(out.join('\n'));
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

/// `c/` or `js/`.
std::string languageOf(const SourceFile& file) { return file.path.substr(0, file.path.find('/') + 1); }

/// What the sources of `language` write for `input`, `wanted` numbers.
std::optional<std::vector<double>> ranOn(const Sources& sources, const std::string& language, const std::string& input,
                                         std::size_t wanted, const std::stop_token& stop) {
  const WorkFolder work;
  if (!work.isOpen() || !work.write("in", input)) return std::nullopt;
  std::vector<std::string> compile = {"cc", "-std=c99", "-O1", work.file("main.c"), "-o", work.file("main")};
  for (const SourceFile& one : sources.files) {
    if (!one.path.starts_with(language)) continue;
    const std::string name = one.path.substr(language.size());
    if (!work.write(name, one.bytes)) return std::nullopt;
    if (name.ends_with(".c")) compile.push_back(work.file(name));
    if (one.gives == Gives::kTube) compile.emplace_back("-DWITH_TUBE");
  }
  compile.emplace_back("-lm");
  std::vector<std::string> command = {work.file("main")};
  if (language == "c/") {
    if (!work.write("main.c", kMainInC) || runProgram(compile, work.path(), stop) != Ran::kWell) return std::nullopt;
  } else {
    if (!work.write("main.js", kMainInJs)) return std::nullopt;
    command = {"node", work.file("main.js")};
  }
  if (runProgram(command, work.path(), stop) != Ran::kWell) return std::nullopt;
  return numbersOf(work.file("out"), wanted);
}

void writeSteps(const FeltTraces& felt, std::string& input) {
  for (const render::TubeTrace& trace : felt.traces) {
    const render::TubeStep* before = nullptr;
    for (const render::TubeStep& step : trace.steps) {
      const char* const what = before == nullptr ? "1 " : step.conditions != before->conditions ? "2 " : "0 ";
      input +=
          what + base::formatNumber(step.position_mm) + (step.held ? " 1 " : " 0 ") + base::formatNumber(step.dt_s);
      for (const double value : step.conditions) input += ' ' + base::formatNumber(value);
      input += '\n';
      before = &step;
    }
  }
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

std::optional<std::span<const double>> SourceRuns::of(const SourceFile& file) {
  TACTUS_CHECK(file.gives != Gives::kNothing);
  const std::string language = languageOf(file);
  auto known = forces_.find(language);
  if (known == forces_.end()) {
    std::string input = std::to_string(points_.size()) + '\n';
    for (const auto& point : points_) {
      for (const double value : point) input += base::formatNumber(value) + ' ';
      input += '\n';
    }
    std::size_t wanted = points_.size();
    if (felt_) {
      writeSteps(*felt_, input);
      for (const render::TubeTrace& trace : felt_->traces) wanted += trace.steps.size();
    }
    known = forces_.emplace(language, ranOn(sources_, language, input, wanted, stop_)).first;
  }
  if (!known->second) return std::nullopt;
  const std::span<const double> all(*known->second);
  return file.gives == Gives::kTube ? all.subspan(points_.size()) : all.first(points_.size());
}

}  // namespace tactus::bundle
