// The JavaScript of a model and of its tube, run by Node, gives the forces of the evaluator and of the renderer.
#include "core/exchange/js_source.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "core/base/random.h"
#include "core/base/text.h"
#include "core/exchange/tube_source.h"
#include "core/fuzzy/compiled_model.h"
#include "core/render/tube_checks.h"

#include "tests/support/ngt_model.h"
#include "tests/support/random_model.h"
#include "tests/support/temp_folder.h"

namespace tactus::exchange {
namespace {

/// Reads rows of numbers from the file `in`: points, and of each the forces of the mean and of every expert.
constexpr const char* kForces = R"(
const { FORCE_MODEL, forceModel, forceModelExpert } = require('./force_model.js');
const rows = require('fs').readFileSync(__dirname + '/in', 'utf8').trim().split('\n').map((row) => row.split(' ').map(Number));
console.log(rows.map((point) => {
  const all = [forceModel(point), ...FORCE_MODEL.experts.map((_, e) => forceModelExpert(e, point))];
  return all.map(({ force, fired }) => force + ' ' + (fired ? 1 : 0)).join(' ');
}).join('\n'));
)";

/// Reads position, held, dt and conditions; a row of one number begins another tube.
constexpr const char* kTube = R"(
const { tubeStart, tubeChange, tubeStep } = require('./tube.js');
const rows = require('fs').readFileSync(__dirname + '/in', 'utf8').trim().split('\n').map((row) => row.split(' ').map(Number));
let tube = null, before = '';
const out = [];
for (const [position, held, dt, ...conditions] of rows) {
  if (held === undefined) { tube = null; continue; }
  if (!tube) tube = tubeStart(conditions);
  else if (String(conditions) !== before) tubeChange(tube, conditions, 0.05);
  before = String(conditions);
  const force = tubeStep(tube, position, held, dt);
  out.push([force, tube.depth_mm, tube.phase, tube.stroke].join(' '));
}
console.log(out.join('\n'));
)";

class JsSource : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("node --version >/dev/null 2>&1") != 0)
      GTEST_SKIP() << "node is not installed, so the JavaScript was not run";
  }

  /// What `script` prints, row by row.
  std::vector<std::vector<double>> run(const std::string& script, const std::string& input) {
    std::ofstream(folder_.file("run.js")) << script;
    std::ofstream(folder_.file("in")) << input;
    const std::string command = "node " + folder_.file("run.js") + " >" + folder_.file("out");
    EXPECT_EQ(std::system(command.c_str()), 0);
    std::vector<std::vector<double>> out;
    std::ifstream file(folder_.file("out"));
    for (std::string line; std::getline(file, line);) {
      auto& row = out.emplace_back();
      std::istringstream words(line);
      for (std::string word; words >> word;)
        row.push_back(word == "NaN" ? std::nan("") : base::parseNumber(word).value());
    }
    return out;
  }

  void expectSameForces(const fuzzy::ForceModel& model, base::Random& random, int points) {
    std::ofstream(folder_.file("force_model.js")) << jsForce(model);
    const auto compiled = fuzzy::compile(model);
    ASSERT_TRUE(compiled);
    std::vector<std::vector<double>> all;
    std::string input;
    for (int p = 0; p < points; ++p) {
      all.push_back(support::randomPoint(random, model));
      for (std::size_t i = 0; i < all.back().size(); ++i)
        input += (i == 0 ? "" : " ") + base::formatNumber(all.back()[i]);
      input += '\n';
    }
    const auto found = run(kForces, input);
    ASSERT_EQ(found.size(), all.size());
    const double most_n = 1e-12 * (model.output.max - model.output.min);
    for (std::size_t p = 0; p < all.size(); ++p) {
      ASSERT_EQ(found[p].size(), 2 * (1 + model.experts.size()));
      for (std::size_t k = 0; k <= model.experts.size(); ++k) {
        const auto wanted = k == 0 ? compiled->evaluate(all[p]) : compiled->evaluateExpert(k - 1, all[p]);
        ASSERT_NEAR(found[p][2 * k], wanted.force_n, most_n) << p << ", " << k;
        ASSERT_EQ(found[p][2 * k + 1] != 0, wanted.fired) << p << ", " << k;
      }
    }
  }

  support::TempFolder folder_;
};

TEST_F(JsSource, HasTheForcesOfTheEvaluator) {
  base::Random random(31);
  for (const auto& model : {support::s4AsPrinted(), support::s4FiveRegions()}) expectSameForces(model, random, 3000);
}

TEST_F(JsSource, HasTheForcesOfRandomModelsAlsoWithGaussians) {
  base::Random random(32);
  for (int m = 0; m < 12; ++m) {
    SCOPED_TRACE("model " + std::to_string(m));
    expectSameForces(support::randomModel(random, {.gaussians = m % 2 == 1, .adversarial = m % 3 == 2}), random, 400);
    if (HasFatalFailure()) return;
  }
}

TEST_F(JsSource, HasTheTubeOfTheRenderer) {
  auto model = support::s4FiveRegions();
  model.renderer.emplace();
  model.renderer->depth_offset_mm = 15;
  model.inputs[2].terms.push_back({"bell", "Bell", fuzzy::Shape::kGaussian, {140, 9.5}});
  model.events = {{model.inputs[2].terms[1].id, 0.6}, {"bell", 0.9}};
  std::ofstream(folder_.file("force_model.js")) << jsForce(model);
  std::ofstream(folder_.file("tube.js")) << jsTube(model).value();
  const auto inputs = render::tubeInputs(model);
  const auto compiled = fuzzy::compile(model);
  ASSERT_TRUE(inputs && compiled);
  std::string input;
  std::vector<render::TubeFeel> wanted;
  for (const auto& trace : render::tubeTraces(model, *inputs)) {
    render::TubeRun run(model, *inputs, *compiled);
    input += "0\n";
    for (const auto& step : trace.steps) {
      wanted.push_back(run.step(step).value());
      input += base::formatNumber(step.position_mm) + (step.held ? " 1 " : " 0 ") + base::formatNumber(step.dt_s);
      for (const double value : step.conditions) input += " " + base::formatNumber(value);
      input += '\n';
    }
  }
  const auto found = run(kTube, input);
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    ASSERT_NEAR(found[i][0], wanted[i].force_n, 1e-12) << i;
    ASSERT_NEAR(found[i][1], wanted[i].depth_mm, 1e-9) << i;
    ASSERT_EQ(found[i][2], wanted[i].phase) << i;
    ASSERT_EQ(found[i][3], wanted[i].stroke) << i;
  }
}

/// A page has neither modules nor `require`: both scripts put their functions beside its own.
TEST_F(JsSource, IsAScriptForAPageToo) {
  const auto model = support::s4FiveRegions();
  std::ofstream(folder_.file("force_model.js")) << jsForce(model);
  std::ofstream(folder_.file("tube.js")) << jsTube(model).value();
  const auto found = run(R"(
const vm = require('vm'), fs = require('fs');
const page = vm.createContext({});
for (const file of ['force_model.js', 'tube.js']) vm.runInContext(fs.readFileSync(__dirname + '/' + file, 'utf8'), page);
console.log(vm.runInContext('forceModel([1, 45, 130, 250]).force', page));
console.log(vm.runInContext('let t = tubeStart([1, 45]); for (let i = 0; i < 400; ++i) tubeStep(t, i * 0.1, 1, 0.001); t.stroke', page));
)",
                         "");
  const auto compiled = fuzzy::compile(model);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(found[0][0], compiled->evaluate(std::vector{1.0, 45.0, 130.0, 250.0}).force_n, 1e-12);
  EXPECT_EQ(found[1][0], 1);
}

TEST(JsSourceText, IsSmallAndEndsNoPage) {
  auto model = support::s4FiveRegions();
  model.name = "</script><b>";
  model.inputs[0].label = "</script>";
  while (model.experts.size() < 4) {
    model.experts.push_back(model.experts.front());
    model.experts.back().id += std::to_string(model.experts.size());
  }
  const std::string force = jsForce(model);
  const std::string tube = jsTube(model).value();
  EXPECT_EQ(force.find("</script>"), std::string::npos);
  EXPECT_EQ(tube.find("</script>"), std::string::npos);
  EXPECT_LE(force.size() + tube.size(), 40'000U);
  EXPECT_EQ(tube.find("double"), std::string::npos);
  EXPECT_EQ(tube.find("->"), std::string::npos);
}

}  // namespace
}  // namespace tactus::exchange
