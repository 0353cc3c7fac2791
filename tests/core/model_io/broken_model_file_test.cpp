#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "core/base/files/file.h"
#include "core/base/random.h"
#include "core/model_io/model_file.h"

#include "tests/support/temp_folder.h"

namespace tactus::model_io {
namespace {

using enum base::ErrorCode;

/// The example with `from`, which must stand in it, replaced by `to` (the first time).
std::string example(const std::string& from, const std::string& to) {
  std::string text =
      base::readFile(std::string(TACTUS_GOLDEN_DIR) + "/models/example.tactus.json", kMostModelFileBytes).value();
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  if (at != std::string::npos) text.replace(at, from.size(), to);
  return text;
}

struct Case {
  const char* from;
  const char* to;
  base::ErrorCode code;
  const char* sentence;
};

void expectRefused(const std::vector<Case>& cases) {
  for (const Case& one : cases) {
    const auto read = parseModel(example(one.from, one.to), "m.json");
    ASSERT_FALSE(read.has_value()) << one.to;
    EXPECT_EQ(read.error().message(), std::string("m.json: ") + one.sentence);
    EXPECT_EQ(read.error().code, one.code) << one.sentence;
  }
}

TEST(BrokenModelFile, AnotherFormatOrVersion) {
  expectRefused({
      {"\"tactus-force-model\"", "\"tactus-study\"", kValue,
       "/format: found the string 'tactus-study', wanted 'tactus-force-model'"},
      {"\"format\"", "\"type\"", kSchema, "found no key 'format', wanted a key 'format' with 'tactus-force-model'"},
      {"\"version\": 1", "\"version\": 2", kVersion,
       "/version: found version 2, newer than this program, wanted at most version 1"},
      {"\"version\": 1", "\"version\": 0", kValue, "/version: found version 0, wanted version 1"},
      {"\"version\": 1", "\"version\": 0.5", kValue, "/version: found version 0.5, wanted version 1"},
      {"\"version\": 1", "\"version\": \"1\"", kSchema, "/version: found the string '1', wanted a number"},
      {"\"version\": 1,\n    \"stiffness", "\"version\": 2,\n    \"stiffness", kVersion,
       "/renderer/version: found version 2, newer than this program, wanted at most version 1"},
  });
}

TEST(BrokenModelFile, Contracts) {
  expectRefused({
      {"\"kind\": \"never_raises\", \"input\": \"lubrication\"", "\"kind\": \"never_raises\"", kSchema,
       "/contracts/0: found no key 'input', wanted a key 'input' with a string"},
      {"\"id\": \"safe\"", "\"id\": \"smoother\"", kSchema,
       "/contracts/3/id: found 'smoother' twice, wanted each id once"},
      {"\"limit\": 1, \"limit_in_jnd\"", "\"limit\": 0, \"limit_in_jnd\"", kValue,
       "/contracts/2/limit: found 0, wanted a number in [1e-150, 1e+150]"},
  });
}

TEST(BrokenModelFile, MissingKeys) {
  expectRefused({
      {"\"name\"", "\"title\"", kSchema, "found no key 'name', wanted a key 'name' with a string"},
      {"\"created_utc\": ", "\"created_utc\": 1, \"made\": ", kSchema,
       "/created_utc: found the number 1, wanted a string"},
      {"\"inputs\"", "\"Inputs\"", kSchema, "found no key 'inputs', wanted a key 'inputs' with an array"},
      {"\"output\"", "\"outputs\"", kSchema, "found no key 'output', wanted a key 'output' with an object"},
      {"\"inference\"", "\"x\"", kSchema, "found no key 'inference', wanted a key 'inference' with an object"},
      {"\"experts\"", "\"x\"", kSchema, "found no key 'experts', wanted a key 'experts' with an array"},
      {"\"unit\": \"mm\",", "", kSchema, "/inputs/1: found no key 'unit', wanted a key 'unit' with a string"},
      {"\"label\": \"Well\",", "\"label\": null,", kSchema, "/inputs/0/terms/2/label: found null, wanted a string"},
      {"\"shape\": \"triangle\",", "", kSchema,
       "/inputs/0/terms/1: found no key 'shape', wanted a key 'shape' with 'trapezoid', 'triangle' or 'gaussian'"},
      {"\"then\": \"very_small\",", "", kSchema,
       "/experts/1/rules/0: found no key 'then', wanted a key 'then' with a string"},
      {", \"fired\": false", "", kSchema, "/checks/3: found no key 'fired', wanted a key 'fired' with true or false"},
  });
}

TEST(BrokenModelFile, WrongTypes) {
  expectRefused({
      {"\"max\": 600", "\"max\": \"600\"", kSchema, "/inputs/1/max: found the string '600', wanted a number"},
      {"\"max\": 600", "\"max\": null", kSchema, "/inputs/1/max: found null, wanted a number"},
      {"[0.2, 0.5, 0.8]", "[0.2, true, 0.8]", kSchema, "/inputs/0/terms/1/points/1: found true, wanted a number"},
      {"[0.2, 0.5, 0.8]", "0.5", kSchema, "/inputs/0/terms/1/points: found the number 0.5, wanted an array"},
      {"\"label\": \"Depth\"", "\"label\": 7", kSchema, "/inputs/1/label: found the number 7, wanted a string"},
      {"{ \"lubrication\": \"poor\" }", "[\"lubrication\", \"poor\"]", kSchema,
       "/experts/1/rules/1/if: found an array, wanted an object"},
      {"\"weight\": 0.5", "\"weight\": true", kSchema, "/experts/1/rules/1/weight: found true, wanted a number"},
      {"\"enabled\": false", "\"enabled\": 0", kSchema,
       "/experts/1/rules/2/enabled: found the number 0, wanted true or false"},
      {"\"settings\": {", "\"settings\": [], \"x\": {", kSchema,
       "/provenance/settings: found an array, wanted an object"},
      {"\"default_force_n\": 0.25", "\"default_force_n\": \"\"", kSchema,
       "/default_force_n: found the string '', wanted a number"},
      {"[\"depth beyond the nasopharynx\"]", "[3]", kSchema, "/accepted_holes/0: found the number 3, wanted a string"},
      {"\"slew_n_s\": 50", "\"slew_n_s\": {}", kSchema, "/renderer/slew_n_s: found an object, wanted a number"},
  });
}

TEST(BrokenModelFile, UnknownWords) {
  expectRefused({
      {"\"triangle\"", "\"bell\"", kValue,
       "/inputs/0/terms/1/shape: found the string 'bell', wanted 'trapezoid', 'triangle' or 'gaussian'"},
      {"\"clip\"", "\"larsen\"", kValue, "/inference/implication: found the string 'larsen', wanted 'clip' or 'scale'"},
      {"\"conjunction\": \"min\"", "\"conjunction\": \"product\"", kValue,
       "/inference/conjunction: found the string 'product', wanted 'min'"},
      {"\"aggregation\": \"max\"", "\"aggregation\": \"sum\"", kValue,
       "/inference/aggregation: found the string 'sum', wanted 'max'"},
      {"\"centroid\"", "\"mom\"", kValue, "/inference/defuzzification: found the string 'mom', wanted 'centroid'"},
  });
}

TEST(BrokenModelFile, ModelsThatMakeNoSense) {
  expectRefused({
      {"[0.2, 0.5, 0.8]", "[0.2, 0.5]", kSchema, "/inputs/0/terms/1/points: found 2 numbers, wanted 3 for a triangle"},
      {"[0, 0, 0.2, 0.4]", "[0, 0.3, 0.2, 0.4]", kValue,
       "/inputs/0/terms/0/points/2: found 0.2 after 0.3, wanted the points of a trapezoid in ascending order"},
      {"\"then\": \"very_small\"", "\"then\": \"tiny\"", kReference,
       "/experts/1/rules/0/then: found 'tiny', wanted a term of 'force': very_small, medium"},
      {"{ \"lubrication\": \"poor\" }", "{ \"spe\\ned\": \"poor\" }", kReference,
       "/experts/1/rules/1/if/spe\\x0aed: found 'spe\\x0aed', wanted the id of an input of the model"},
      {"{ \"lubrication\": \"poor\" }", "{ \"depth\": \"nasal_cavity\", \"depth\": \"nasal_cavity\" }", kSchema,
       "/experts/1/rules/1/if/depth: found the key 'depth' twice, wanted each key once"},
      {"{ \"lubrication\": \"poor\" }, \"then\": \"medium\"",
       "{ \"depth\": \"nasal_cavity\", \"lubrication\": \"well\" }, \"then\": \"very_small\"", kSchema,
       "/experts/1/rules/1: found a rule with the conditions and the consequent of an earlier one, wanted each rule "
       "once"},
      {"\"stiffness_n_mm\": 0.25", "\"stiffness_n_mm\": 0", kValue,
       "/renderer/stiffness_n_mm: found 0, wanted a number in (0, 10]"},
      {"[1, 60]", "[1]", kSchema, "/checks/0/in: found 1 numbers, wanted 2, one per input"},
  });
}

TEST(BrokenModelFile, ChecksThatDoNotHold) {
  expectRefused({
      {"\"force\": 0.25, \"fired\": false", "\"force\": 0.5, \"fired\": false", kMismatch,
       "/checks/3: found force 0.25, not fired, wanted force 0.5, not fired, as the file says"},
      {"\"force\": 0.25, \"fired\": false", "\"force\": 0.25, \"fired\": true", kMismatch,
       "/checks/3: found force 0.25, not fired, wanted force 0.25, fired, as the file says"},
      {"[1, 60]", "[1e999, 60]", kValue,
       "/checks/0/in/0: found the number '1e999', wanted a number in the range of a double"},
  });
  // The tolerance is 1e-12 of the output's range, here 1.1e-12 N.
  EXPECT_TRUE(parseModel(example("\"force\": 0.55,", "\"force\": 0.550000000001,"), "m.json").has_value());
  EXPECT_FALSE(parseModel(example("\"force\": 0.55,", "\"force\": 0.5500000000013,"), "m.json").has_value());
}

TEST(BrokenModelFile, EveryTruncationIsRefused) {
  const std::string whole = example("Example", "Example");
  for (std::size_t size = 0; size + 2 < whole.size(); ++size) {
    const auto read = parseModel(std::string_view(whole).substr(0, size), "m.json");
    ASSERT_FALSE(read.has_value()) << size;
    ASSERT_EQ(read.error().code, kSyntax) << size;
  }
}

TEST(BrokenModelFile, DamagedBytesNeverGiveMoreThanOneLine) {
  base::Random random(3);
  const std::string whole = example("Example", "Example");
  for (int i = 0; i < 3000; ++i) {
    std::string text = whole;
    for (int damage = 0; damage <= i % 4; ++damage) {
      const auto at = static_cast<std::size_t>(random.below(static_cast<int>(text.size())));
      if (random.below(2) == 0) {
        text[at] = static_cast<char>(random.below(256));
      } else {
        text.erase(at, 1 + static_cast<std::size_t>(random.below(30)));
      }
    }
    const auto read = parseModel(text, "m.json");
    if (read.has_value()) continue;
    const std::string sentence = read.error().message();
    EXPECT_EQ(sentence.find('\n'), std::string::npos);
    EXPECT_NE(sentence.find(", wanted "), std::string::npos) << sentence;
    EXPECT_LT(sentence.size(), 400U) << sentence;
  }
}

TEST(BrokenModelFile, NotAnObject) {
  const auto sentence = [](std::string_view text) { return parseModel(text, "m.json").error().message(); };
  EXPECT_EQ(sentence(""), "m.json: found an empty text, wanted JSON");
  EXPECT_EQ(sentence("[]"), "m.json: found JSON that is not an object, wanted an object");
  EXPECT_EQ(sentence("3"), "m.json: found JSON that is not an object, wanted an object");
  EXPECT_EQ(sentence("{}"), "m.json: found no key 'format', wanted a key 'format' with 'tactus-force-model'");
  EXPECT_EQ(sentence(std::string(kMostModelFileBytes, '[')),
            "m.json: found JSON that is not an object, wanted an object");
}

TEST(BrokenModelFile, HugeFilesAreRefusedBySize) {
  const support::TempFolder folder;
  const std::string path = folder.file("huge.json");
  std::ofstream(path).put('{');
  std::filesystem::resize_file(path, 200'000'000);
  const auto read = readModel(path);
  ASSERT_FALSE(read.has_value());
  EXPECT_EQ(read.error().code, kLimit);
  EXPECT_EQ(read.error().message(), path + ": found 200000000 bytes or more, wanted at most 33554432 bytes");
}

TEST(BrokenModelFile, FilesThatCannotBeRead) {
  const support::TempFolder folder;
  EXPECT_EQ(readModel(folder.file("none.json")).error().code, kIo);
  EXPECT_EQ(readModel(folder.file("")).error().code, kIo);
}

}  // namespace
}  // namespace tactus::model_io
