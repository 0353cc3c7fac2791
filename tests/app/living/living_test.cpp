// The section in which a model moves: its numbers are those of the evaluator, and a page that was changed says so.
#include "app/living/living.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "app/report/html.h"
#include "core/analysis/force_balance.h"
#include "core/base/random.h"
#include "core/base/text.h"

#include "tests/support/chromium.h"
#include "tests/support/invented_experts.h"
#include "tests/support/ngt_model.h"
#include "tests/support/random_model.h"
#include "tests/support/temp_folder.h"
#include "tests/support/well_formed.h"

namespace tactus::living {
namespace {

std::string pageOf(const fuzzy::ForceModel& model, bool simulated = false) {
  const auto compiled = fuzzy::compile(model);
  EXPECT_TRUE(compiled);
  const auto section = sectionOf(model, *compiled, simulated);
  EXPECT_TRUE(section);
  report::HtmlPage page("A model", "for a test");
  page.style(section->style);
  page.screenSection("Try the model", report::Markup::raw(section->html));
  return page.html();
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  if (at != std::string::npos) text.replace(at, from.size(), to);
  return text;
}

/// `page` with the last digit of its first check changed.
std::string withAnotherCheck(std::string page) {
  const std::size_t end = page.find(';', page.find("\"checks\""));
  page[end - 1] = page[end - 1] == '1' ? '2' : '1';
  return page;
}

std::string withoutScripts(std::string page) {
  for (std::size_t at = page.find("<script"); at != std::string::npos; at = page.find("<script")) {
    const std::string end = "</script>";
    page.erase(at, page.find(end, at) + end.size() - at);
  }
  return page;
}

/// The scripts of the page without a browser: `page` is its text, `context` has what they define.
constexpr const char* kLoad = R"js(
const vm = require('vm'), fs = require('fs');
const page = fs.readFileSync(__dirname + '/page.html', 'utf8');
const scripts = [...page.matchAll(/<script([^>]*)>([^]*?)<\/script>/g)];
const texts = scripts.map(([, , text]) => text);
const context = vm.createContext({ TextEncoder });
const data = JSON.parse(texts[scripts.findIndex(([, attributes]) => attributes.includes('json'))]);
for (const text of texts) {
  if (/forceModel\(inputs|tubeStep|livingNumbers = /.test(text) && !text.includes('document')) vm.runInContext(text, context);
}
const { livingNumbers: numbers, FORCE_MODEL, forceModel, forceModelExpert } = context;
const engine = { forceModel, forceModelExpert };
const rows = fs.readFileSync(__dirname + '/in', 'utf8').trim().split('\n').map((row) => row.split(' ').map(Number));
)js";

class LivingNumbers : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("node --version >/dev/null 2>&1") != 0)
      GTEST_SKIP() << "node is not installed, so the scripts of the page were not run";
  }

  /// The lines that `script` prints for the page.
  std::vector<std::string> run(const std::string& page, const std::string& script, const std::string& input = "0\n") {
    std::ofstream(folder_.file("page.html")) << page;
    std::ofstream(folder_.file("in")) << input;
    std::ofstream(folder_.file("run.js")) << kLoad << script;
    const std::string command = "node " + folder_.file("run.js") + " >" + folder_.file("out");
    EXPECT_EQ(std::system(command.c_str()), 0);
    std::vector<std::string> lines;
    std::ifstream file(folder_.file("out"));
    for (std::string line; std::getline(file, line);) lines.push_back(line);
    return lines;
  }

  /// The balance of every point: a line each, `force id share pull id share pull …`.
  void expectSameBalance(const fuzzy::ForceModel& model, base::Random& random, int count, double tolerance) {
    const auto compiled = fuzzy::compile(model);
    ASSERT_TRUE(compiled);
    std::vector<std::vector<double>> points;
    std::string input;
    for (int p = 0; p < count; ++p) {
      points.push_back(support::randomPoint(random, model));
      for (std::size_t i = 0; i < points.back().size(); ++i)
        input += (i == 0 ? "" : " ") + base::formatNumber(points.back()[i]);
      input += '\n';
    }
    const auto lines = run(pageOf(model), R"js(
console.log(rows.map((point) => {
  const found = numbers.balance(FORCE_MODEL, point, engine);
  return [found.force, ...found.words.flatMap((word) => [word.id, word.share, word.pull])].join('\t');
}).join('\n'));
)js",
                           input);
    ASSERT_EQ(lines.size(), points.size());
    const double range = model.output.max - model.output.min;
    for (std::size_t p = 0; p < points.size(); ++p) {
      const auto explanation = analysis::explain(model, *compiled, points[p]);
      ASSERT_TRUE(explanation);
      const auto wanted = analysis::forceBalance(model, *explanation);
      std::istringstream words(lines[p]);
      std::string field;
      std::getline(words, field, '\t');
      EXPECT_NEAR(base::parseNumber(field).value(), compiled->evaluate(points[p]).force_n, 1e-12 * range);
      std::map<std::string, std::pair<double, double>> found;
      double sum = 0;
      for (std::string id, share, pull; std::getline(words, id, '\t') && std::getline(words, share, '\t');) {
        std::getline(words, pull, '\t');
        found[id] = {base::parseNumber(share).value(), base::parseNumber(pull).value()};
        sum += found[id].second;
      }
      EXPECT_NEAR(sum, 0, tolerance * range) << lines[p];
      ASSERT_EQ(found.size(), wanted.words.size()) << lines[p];
      for (const auto& word : wanted.words) {
        ASSERT_TRUE(found.contains(word.term)) << word.term;
        EXPECT_NEAR(found[word.term].first, word.share, tolerance) << word.term << ", " << lines[p];
        EXPECT_NEAR(found[word.term].second, word.pull_n, tolerance * range) << word.term << ", " << lines[p];
      }
    }
  }

  support::TempFolder folder_;
};

// Sums of a few products of numbers around 1: some hundred roundings.
TEST_F(LivingNumbers, HaveTheBalanceOfTactusWhy) {
  base::Random random(41);
  expectSameBalance(support::s4FiveRegions(), random, 300, 1e-11);
  expectSameBalance(support::inventedExperts(), random, 300, 1e-11);
}

// Under a Gaussian the page integrates by quadrature, and where sets meet it bisects.
TEST_F(LivingNumbers, HaveTheBalanceOfRandomModels) {
  base::Random random(42);
  for (int m = 0; m < 8; ++m) {
    SCOPED_TRACE("model " + std::to_string(m));
    expectSameBalance(support::randomModel(random, {.gaussians = m % 2 == 1, .adversarial = false}), random, 40,
                      m % 2 == 1 ? 1e-6 : 1e-9);
  }
}

constexpr const char* kVerdict = R"js(
const stored = page.match(/data-crc32="([0-9a-f]+)"/)[1];
const { count, wrong, limit } = numbers.checkAll(FORCE_MODEL, data.checks, engine);
console.log(numbers.crc32(texts.join('\n')) === stored ? 'same' : 'other');
console.log(count);
console.log(wrong);
console.log(limit);
)js";

TEST_F(LivingNumbers, TheirChecksAndTheirChecksumFindAChange) {
  const std::string page = pageOf(support::inventedExperts());
  const auto good = run(page, kVerdict);
  ASSERT_EQ(good.size(), 4U);
  EXPECT_EQ(good[0], "same");
  EXPECT_GE(base::parseNumber(good[1]).value(), 2000);
  EXPECT_EQ(good[2], "0");
  EXPECT_EQ(good[3], "1e-12");
  EXPECT_EQ(run(withAnotherCheck(page), kVerdict)[0], "other");
  EXPECT_EQ(run(replaced(page, "\"at\": [0, ", "\"at\": [1, "), kVerdict)[0], "other");
  // Whoever changes the model and its checksum too: the checks still tell.
  const auto forged = run(replaced(page, "\"weight\": 1,", "\"weight\": 9,"), kVerdict);
  EXPECT_GT(base::parseNumber(forged[2]).value(), 1000);
}

TEST_F(LivingNumbers, SayInASentenceWhereTheHandIs) {
  const auto lines = run(pageOf(support::inventedExperts()), R"js(
console.log(numbers.sentenceOf(FORCE_MODEL, { region: data.region, speed: data.speed }, [1, 60, 200, 50], engine));
const depth = structuredClone(FORCE_MODEL.inputs[2]);
console.log(numbers.moveCorner(depth, 215, 202.1074));
console.log(numbers.moveCorner(depth, 202.1074, 100));
console.log(numbers.cornersOf(depth).every(({ x }, k, all) => k === 0 || x > all[k - 1].x));
)js");
  ASSERT_EQ(lines.size(), 4U);
  // The mean of .45, .6, .5 and .58944 N, the forces of the four at this point.
  EXPECT_TRUE(lines[0].starts_with("At 200 mm ")) << lines[0];
  EXPECT_NE(lines[0].find(", pushed at 50 mm/s (slow), "), std::string::npos) << lines[0];
  EXPECT_TRUE(lines[0].ends_with(": 0.53 N; the experts say 0.45 to 0.60 N.")) << lines[0];
  EXPECT_EQ(lines[1], "202.1074");
  EXPECT_GT(base::parseNumber(lines[2]).value(), 185);  // never across the corner before it
  EXPECT_EQ(lines[3], "true");
}

TEST_F(LivingNumbers, NoTextOfTheModelBreaksThePage) {
  auto model = support::s4FiveRegions();
  model.name = "]]></script><!--<script>&";
  model.inputs[0].label = "</script>]]>";
  model.output.terms[0].label = "<!--<script>";
  const std::string page = pageOf(model);
  EXPECT_EQ(support::markupFault(page), "");
  const auto lines = run(page, kVerdict);
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[0], "same");
  EXPECT_EQ(lines[2], "0");
}

TEST(Living, IsSmallWellFormedAndAsksForNothing) {
  const std::string page = pageOf(support::inventedExperts(), true);
  EXPECT_LT(page.size(), 240'000U);
  EXPECT_EQ(support::markupFault(page), "");
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
  EXPECT_NE(page.find("Data of this model are simulated"), std::string::npos);
  EXPECT_EQ(page.find("src="), std::string::npos);
  EXPECT_EQ(page.find("https:"), std::string::npos);
  EXPECT_EQ(support::countOf(page, "http:"), 1U);  // the name of SVG
  EXPECT_EQ(pageOf(support::inventedExperts()).find("are simulated"), std::string::npos);
}

/// E1, E2, E3 and S4 again and again.
fuzzy::ForceModel manyExperts(std::size_t count) {
  auto model = support::inventedExperts();
  for (std::size_t e = 0; model.experts.size() < count; ++e) {
    model.experts.push_back(model.experts[e]);
    model.experts.back().id += "_" + std::to_string(e);
    model.experts.back().label = "Expert " + std::to_string(e);
  }
  return model;
}

TEST(Living, IsLeftOutForTooManyExperts) {
  const auto has_section = [](const fuzzy::ForceModel& model) {
    return sectionOf(model, *fuzzy::compile(model), false).has_value();
  };
  EXPECT_TRUE(has_section(manyExperts(kMostExperts)));
  EXPECT_FALSE(has_section(manyExperts(kMostExperts + 1)));
}

class LivingInChromium : public testing::Test {
 protected:
  void SetUp() override {
    if (!support::hasChromium()) GTEST_SKIP() << "chromium is not installed, so the page was not opened";
  }

  /// The banner after the page was opened: its class and its text.
  std::string bannerOf(const std::string& page) {
    const std::string file = folder_.file(std::to_string(++count_) + ".html");
    std::ofstream(file) << page;
    const std::string dom = support::renderedPage(file);
    const std::size_t begin = dom.find("<p id=\"living-state\"");
    EXPECT_NE(begin, std::string::npos);
    return begin == std::string::npos ? dom : dom.substr(begin, dom.find("</p>", begin) - begin);
  }

  support::TempFolder folder_;
  int count_ = 0;
};

TEST_F(LivingInChromium, IsGreenAsItWasWrittenAndRedAfterAnyChange) {
  const std::string page = pageOf(support::inventedExperts());
  const std::string good = bannerOf(page);
  EXPECT_NE(good.find("living-state right"), std::string::npos) << good;
  EXPECT_NE(good.find(" checks: all within 1e-12 N"), std::string::npos) << good;
  for (const std::string& changed :
       {replaced(page, "\"at\": [0, ", "\"at\": [1, "),                           // the model
        withAnotherCheck(page),                                                   // a check
        replaced(page, "const DAMPING_SHARE", "const DAMPING_SHARE = 1, OTHER"),  // the tube
        replaced(page, "function changed()", "function changed("),                // a script that does not run
        replaced(page, "const all = Array", "const all == Array")}) {             // the last script
    const std::string bad = bannerOf(changed);
    EXPECT_NE(bad.find("living-state wrong"), std::string::npos) << bad;
    EXPECT_NE(bad.find("Do not trust this page"), std::string::npos) << bad;
  }
}

TEST_F(LivingInChromium, ShowsTheRangeOfManyExperts) {
  const auto rendered = [this](std::size_t experts) {
    const std::string file = folder_.file(std::to_string(experts) + ".html");
    std::ofstream(file) << pageOf(manyExperts(experts));
    return support::renderedPage(file);
  };
  const auto lines = [](const std::string& dom) { return support::countOf(dom, "class=\"living-expert\""); };
  const std::string twelve = rendered(12);
  EXPECT_EQ(lines(twelve), 12U);
  const std::string all = rendered(kMostExperts);
  EXPECT_EQ(lines(all), 0U);
  EXPECT_EQ(support::countOf(all, "class=\"living-name\""), kMostExperts);
  EXPECT_GE(support::countOf(all, "class=\"living-band\""), 1U);
  EXPECT_NE(all.find("living-state right"), std::string::npos);
}

TEST_F(LivingInChromium, WithoutItsScriptsSaysThatItIsOnlyRead) {
  const std::string bare = bannerOf(withoutScripts(pageOf(support::inventedExperts())));
  EXPECT_NE(bare.find("This page can only be read here"), std::string::npos) << bare;
  EXPECT_EQ(bare.find("right"), std::string::npos) << bare;
}

}  // namespace
}  // namespace tactus::living
