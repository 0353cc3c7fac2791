#include "core/model_io/model_file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <limits>
#include <set>
#include <string>

#include "core/base/files/file.h"
#include "core/fuzzy/compiled_model.h"

#include "tests/support/ngt_model.h"
#include "tests/support/temp_folder.h"

namespace tactus::model_io {
namespace {

std::string golden(const std::string& name) { return std::string(TACTUS_GOLDEN_DIR) + "/models/" + name; }

std::string contents(const std::string& path) { return base::readFile(path, kMostModelFileBytes).value(); }

TEST(ModelFile, ReadsTheExample) {
  const auto read = readModel(golden("example.tactus.json"));
  ASSERT_TRUE(read.has_value()) << read.error().message();
  EXPECT_TRUE(read->warnings.empty());
  const fuzzy::ForceModel& model = read->model;
  EXPECT_EQ(model.name, "Example: two experts");
  EXPECT_EQ(model.created_utc, "2026-11-21T08:00:00Z");
  ASSERT_TRUE(model.provenance.has_value());
  EXPECT_EQ(model.provenance->settings[1], (fuzzy::NamedJson{"weights", R"({ "S2": 2, "S4": 1 })"}));
  EXPECT_EQ(model.provenance->notes, "Shows every key of the format. Größe, 深さ and 🙂 are fine in labels.");
  ASSERT_EQ(model.inputs.size(), 2U);
  EXPECT_EQ(model.inputs[0].terms[1], (fuzzy::Term{"medium", "Medium", fuzzy::Shape::kTriangle, {0.2, 0.5, 0.8}}));
  EXPECT_EQ(model.output.unit, "N");
  EXPECT_EQ(model.output.max, 1.1);
  EXPECT_EQ(model.implication, fuzzy::Implication::kClip);
  EXPECT_EQ(model.default_force_n, 0.25);
  EXPECT_EQ(model.accepted_holes, std::vector<std::string>{"depth beyond the nasopharynx"});
  ASSERT_EQ(model.experts.size(), 2U);
  EXPECT_EQ(model.experts[0].weight, 2);
  ASSERT_EQ(model.experts[0].overrides.size(), 1U);
  EXPECT_EQ(model.experts[0].overrides[0].terms[1], (fuzzy::Term{"bend", "Bend", fuzzy::Shape::kGaussian, {100, 5}}));
  EXPECT_EQ(model.experts[1].rules[0],
            (fuzzy::Rule{{{"lubrication", "well"}, {"depth", "nasal_cavity"}}, "very_small", 1, true}));
  EXPECT_EQ(model.experts[1].rules[1].weight, 0.5);
  EXPECT_FALSE(model.experts[1].rules[2].enabled);
  EXPECT_EQ(model.renderer, fuzzy::RendererParameters{});
  ASSERT_EQ(model.checks.size(), 4U);
  EXPECT_EQ(model.checks[3], (fuzzy::Check{{0.5, 300}, 0.25, false}));
  using Kind = fuzzy::Contract::Kind;
  ASSERT_EQ(model.contracts.size(), 5U);
  EXPECT_EQ(model.contracts[0],
            (fuzzy::Contract{
                "smoother", Kind::kNeverRaises, "lubrication", "", "", 0, 0, false, {{"depth", "nasal_cavity"}}}));
  EXPECT_EQ(model.contracts[2], (fuzzy::Contract{"no knock", Kind::kNoStep, "depth", "", "", 1, 1, true, {}}));
  EXPECT_EQ(model.events, (std::vector<fuzzy::TubeEvent>{{"nasopharynx", 0.6}}));
  EXPECT_EQ(model.extra, (std::vector<fuzzy::NamedJson>{{"x_simulator", R"({ "scene": "NGT", "revision": 7 })"}}));
}

TEST(ModelFile, WritesTheExampleAsItStands) {
  const auto read = readModel(golden("example.tactus.json"));
  ASSERT_TRUE(read.has_value()) << read.error().message();
  EXPECT_EQ(formatModel(read->model), contents(golden("example.tactus.json")));
}

TEST(ModelFile, OptionalKeysHaveTheirDefaults) {
  const auto read = readModel(golden("minimal.tactus.json"));
  ASSERT_TRUE(read.has_value()) << read.error().message();
  const fuzzy::ForceModel& model = read->model;
  EXPECT_FALSE(model.provenance.has_value());
  EXPECT_EQ(model.default_force_n, 0);
  EXPECT_TRUE(model.accepted_holes.empty());
  EXPECT_FALSE(model.renderer.has_value());
  EXPECT_TRUE(model.checks.empty());
  EXPECT_TRUE(model.experts[0].overrides.empty());
  EXPECT_EQ(model.experts[0].rules[0].weight, 1);
  EXPECT_TRUE(model.experts[0].rules[0].enabled);
  EXPECT_EQ(model.implication, fuzzy::Implication::kScale);
  for (const char* const key :
       {"provenance", "default_force_n", "accepted_holes", "renderer", "checks", "contracts", "events"}) {
    EXPECT_EQ(formatModel(model).find(key), std::string::npos) << key;
  }
}

TEST(ModelFile, AModelWrittenByHandNeedsNoLabelsAndNoOrigin) {
  const auto read = parseModel(R"({"format": "tactus-force-model", "version": 1, "name": "by hand",
    "provenance": {"notes": "typed in"},
    "inputs": [{"id": "x", "unit": "mm", "min": 0, "max": 1,
                "terms": [{"id": "low", "shape": "triangle", "points": [0, 0, 1]}]}],
    "output": {"id": "force", "unit": "N", "min": 0, "max": 1,
               "terms": [{"id": "some", "label": "", "shape": "triangle", "points": [0, 0.5, 1]}]},
    "inference": {"conjunction": "min", "implication": "clip", "aggregation": "max", "defuzzification": "centroid"},
    "experts": [{"id": "me", "weight": 1, "rules": [{"if": {"x": "low"}, "then": "some"}]}]})",
                               "hand.json");
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_TRUE(read->warnings.empty());
  const fuzzy::ForceModel& model = read->model;
  EXPECT_EQ(model.created_utc + model.generator, "");
  EXPECT_EQ(model.inputs[0].label, "x");
  EXPECT_EQ(model.inputs[0].terms[0].label, "low");
  EXPECT_EQ(model.output.terms[0].label, "");  // an empty label stays one
  EXPECT_EQ(model.experts[0].label, "me");
  ASSERT_TRUE(model.provenance);
  EXPECT_EQ(model.provenance->notes, "typed in");
  EXPECT_TRUE(model.provenance->study.empty() && model.provenance->settings.empty());
  const auto again = parseModel(formatModel(model), "written.json");
  ASSERT_TRUE(again);
  EXPECT_EQ(again->model, model);
}

TEST(ModelFile, TheGoldenModelIsTheOneBuiltByHand) {
  const auto read = readModel(golden("ngt.tactus.json"));
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(read->model, support::s4Shifted());
}

TEST(ModelFile, RendererMembersHaveTheirDefaults) {
  std::string text = contents(golden("minimal.tactus.json"));
  text.replace(text.rfind('}'), 1, R"(, "renderer": { "stiffness_n_mm": 0.5 } })");
  const auto read = parseModel(text, "m.json");
  ASSERT_TRUE(read.has_value()) << read.error().message();
  fuzzy::RendererParameters wanted;
  wanted.stiffness_n_mm = 0.5;
  EXPECT_EQ(read->model.renderer, wanted);
}

TEST(ModelFile, ByteOrderMarkAndWindowsLineEndsAreFine) {
  std::string text = "\xEF\xBB\xBF";
  for (const char c : contents(golden("minimal.tactus.json"))) {
    if (c == '\n') text += '\r';
    text += c;
  }
  EXPECT_TRUE(parseModel(text, "m.json").has_value());
}

TEST(ModelFile, UnknownDeeperKeysAreDroppedWithAWarning) {
  std::string text = contents(golden("minimal.tactus.json"));
  text.replace(text.find("\"label\": \"All\""), 0, "\"colour\": { \"r\": 1 }, ");
  text.replace(text.find("\"then\""), 0, "\"comment~1\": null, ");
  const auto read = parseModel(text, "m.json");
  ASSERT_TRUE(read.has_value()) << read.error().message();
  EXPECT_EQ(read->warnings, (std::vector<std::string>{"m.json: /inputs/0/terms/0/colour: unknown key, dropped",
                                                      "m.json: /experts/0/rules/0/comment~01: unknown key, dropped"}));
  EXPECT_EQ(formatModel(read->model).find("colour"), std::string::npos);
}

TEST(ModelFile, AHundredWarningsAreGivenEachAndTheRestIsCounted) {
  for (const std::size_t count : {99U, 100U, 101U, 250U}) {
    std::string keys;
    for (std::size_t k = 0; k < count; ++k) keys += "\"unknown" + std::to_string(k) + "\": 0, ";
    std::string text = contents(golden("minimal.tactus.json"));
    text.replace(text.find("\"label\": \"All\""), 0, keys);
    const auto read = parseModel(text, "m.json");
    ASSERT_TRUE(read.has_value()) << read.error().message();
    ASSERT_EQ(read->warnings.size(), std::min<std::size_t>(count, 101));
    EXPECT_EQ(read->warnings[98], "m.json: /inputs/0/terms/0/unknown98: unknown key, dropped");
    if (count > 100) {
      EXPECT_EQ(read->warnings.back(), "m.json: " + std::to_string(count - 100) + " more unknown keys dropped");
    }
  }
}

TEST(ModelFile, UnknownTopLevelKeysKeepOrderAndDigits) {
  std::string text = contents(golden("minimal.tactus.json"));
  text.replace(1, 0,
               R"( "zeta": [1.50, 18446744073709551615, 1E5, -0.1e-3], "a/b": null, "Ä": { "k": [true, "\u00e9"] },)");
  const auto read = parseModel(text, "m.json");
  ASSERT_TRUE(read.has_value()) << read.error().message();
  const std::vector<fuzzy::NamedJson> wanted = {
      {"zeta", "[1.50, 18446744073709551615, 1E5, -0.1e-3]"}, {"a/b", "null"}, {"Ä", "{ \"k\": [true, \"é\"] }"}};
  EXPECT_EQ(read->model.extra, wanted);
  const auto again = parseModel(formatModel(read->model), "m.json");
  ASSERT_TRUE(again.has_value()) << again.error().message();
  EXPECT_EQ(again->model, read->model);
}

TEST(ModelFile, TheExampleOfTheDocumentationReads) {
  const std::string page = contents(std::string(TACTUS_SOURCE_DIR) + "/docs/model-file.md");
  const auto begin = page.find("```json\n") + 8;
  const auto read = parseModel(page.substr(begin, page.find("```", begin) - begin), "docs");
  ASSERT_TRUE(read.has_value()) << read.error().message();
  EXPECT_TRUE(read->warnings.empty());
  EXPECT_EQ(read->model.checks.size(), 2U);
}

TEST(ModelFile, WritesWholeFilesOnly) {
  const support::TempFolder folder;
  fuzzy::ForceModel model = support::s4AsPrinted();
  ASSERT_TRUE(writeModel(model, folder.file("m.tactus.json")).has_value());
  const auto read = readModel(folder.file("m.tactus.json"));
  ASSERT_TRUE(read.has_value()) << read.error().message();
  EXPECT_EQ(read->model, model);

  const support::TempFolder empty;
  const std::string path = empty.file("m.tactus.json");
  const auto refused = [&](const fuzzy::ForceModel& broken) {
    const auto written = writeModel(broken, path);
    EXPECT_TRUE(empty.isEmpty());
    return written.has_value() ? std::string("written") : written.error().message();
  };
  fuzzy::ForceModel broken = model;
  broken.inputs[0].max = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refused(broken), path + ": /inputs/0/max: found nan, wanted a number in [-1e+150, 1e+150]");
  broken = model;
  broken.checks = {{{1, 45, 30, 30}, 0.2, true}};
  EXPECT_NE(refused(broken).find("/checks/0"), std::string::npos);
  broken = model;
  broken.name = "caf\xE9";
  EXPECT_NE(refused(broken).find("bytes that are not UTF-8"), std::string::npos);
  broken = model;
  broken.extra = {{"name", "1"}};
  EXPECT_EQ(refused(broken), path + ": /name: found the key 'name' twice, wanted each key once");
}

TEST(ModelFile, PublishedRulesGiveThePublishedForces) {
  // Exact forces of S4's rules as printed (Table A2) with the default terms, to the digits given there.
  fuzzy::ForceModel model = support::s4AsPrinted();
  model.checks = {{{1, 45, 30, 30}, 0.1266666666666667, true}, {{1, 60, 130, 50}, 0, false}};
  EXPECT_TRUE(parseModel(formatModel(model), "m.json").has_value());
}

}  // namespace
}  // namespace tactus::model_io
