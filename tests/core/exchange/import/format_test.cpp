// Formats told apart, encodings, and what is no model at all.
#include "tests/core/exchange/import/imported.h"

namespace tactus::exchange {
namespace {

TEST(ImportFormat, IsToldFromTheContent) {
  const std::string rule = "  rule: if x is low then y is small\n";
  const auto format = [](const std::string& text, const std::string& file) {
    const auto read = ReadFile::read(text, file);
    return read ? std::string(name(read->format())) : read.error().message();
  };
  EXPECT_EQ(format(fll(rule), "a.fis"), "fll");
  EXPECT_EQ(format(fcl("RULE 1 : IF x IS low THEN y IS small;\n"), "a.txt"), "fcl");
  EXPECT_EQ(format(fis("1 0, 1 (1) : 1\n"), "a"), "fis");
  EXPECT_EQ(format("(* a note *)\n" + fcl(""), "a"), "fcl");
  EXPECT_EQ(format("% a note\n" + fis(""), "a"), "fis");
  EXPECT_EQ(
      format("hello", "a.txt"),
      "a.txt: found 'hello', wanted the beginning of FLL ('Engine:'), FCL ('FUNCTION_BLOCK') or FIS ('[System]')");
  EXPECT_EQ(
      format("", "a.txt"),
      "a.txt: found no text, wanted the beginning of FLL ('Engine:'), FCL ('FUNCTION_BLOCK') or FIS ('[System]')");
  EXPECT_EQ(format("hello", "a.FLL"),
            "a.FLL: line 1, column 1: found 'hello', wanted a key and a value, as in 'enabled: true'");
  EXPECT_EQ(ReadFile::read(fll(rule), "a.fll", ImportFormat::kFis).error().message(),
            "a.fll: line 1, column 1: found 'Engine: pair', wanted a key and a value, as in Name='x'");
}

TEST(ImportFormat, OtherFormatsAreNamed) {
  const auto refused = [](const std::string& bytes) { return imported(bytes, "a.fis").refusal; };
  EXPECT_EQ(refused("MATLAB 5.0 MAT-file, Platform"),
            "a.fis: found a MAT-file of MATLAB, which is no text, wanted FLL, FCL or FIS");
  EXPECT_EQ(refused("PK\x03\x04zip"), "a.fis: found a compressed file, wanted FLL, FCL or FIS");
  EXPECT_EQ(refused("<?xml version=\"1.0\"?>\n<FuzzySystem name=\"x\">"),
            "a.fis: found FML (IEEE 1855), which Tactus writes and does not read, wanted FLL, FCL or FIS");
  EXPECT_EQ(refused("{\"format\": 1}"),
            "a.fis: found JSON, perhaps a model of Tactus, which needs no import, wanted FLL, FCL or FIS");
}

TEST(ImportFormat, Encodings) {
  const std::string rule = "  rule: if x is low then y is small\n";
  std::string latin = fll(rule);
  latin.insert(8, "gro\xDF ");
  const auto from = imported(latin, "a.fll");
  ASSERT_TRUE(from.model) << from.refusal;
  EXPECT_EQ(from.model->name, "gro\xC3\x9F pair");
  warns(from, "a.fll: the text is not UTF-8 and is read as Windows-1252; names may have wrong letters");
  std::string zero = fll(rule);
  zero[20] = '\0';
  EXPECT_EQ(imported(zero, "a.fll").refusal, "a.fll: line 2, column 8: found a zero byte, wanted text");
  EXPECT_EQ(imported(std::string(kMostImportBytes + 1, ' '), "a.fll").refusal,
            "a.fll: found 2097153 bytes, wanted at most 2097152");
  EXPECT_EQ(imported("\x81\x81\xFF\xFE\x81", "a.fll").refusal,
            "a.fll: found bytes that are no text, wanted FLL, FCL or FIS in UTF-8");
}

TEST(ImportFormat, HugeFilesEndSoon) {
  std::string variables = "Engine: x\n";
  for (int i = 0; i < 20000; ++i) variables += "InputVariable: v" + std::to_string(i) + "\n";
  EXPECT_EQ(imported(variables, "a.fll").refusal,
            "a.fll: line 102, column 16: found variable 101, 'v100', wanted at most 100");
  std::string terms = "Engine: x\nInputVariable: x\n";
  for (int i = 0; i < 20000; ++i) terms += "term: t" + std::to_string(i) + " Triangle 0 1 2\n";
  EXPECT_EQ(imported(terms, "a.fll").refusal, "a.fll: line 503, column 7: found term 501, 't500', wanted at most 500");
  std::string rules;
  for (int i = 0; i < 20000; ++i) rules += "  rule: if x is low and z is high then y is small\n";
  EXPECT_TRUE(imported(fll(rules), "a.fll").model);
}

TEST(ImportFormat, FllThatIsNotWhatItShouldBe) {
  const std::string plain = fll("  rule: if x is low then y is small\n");
  const auto refused = [&plain](const std::string& from, const std::string& to) {
    std::string text = plain;
    text.replace(text.find(from), from.size(), to);
    return imported(text, "a.fll").refusal;
  };
  EXPECT_EQ(refused("enabled: true", "enabeld: true"),
            "a.fll: line 3, column 3: found the key 'enabeld', wanted a key of FLL that fits here (enabled?)");
  EXPECT_EQ(refused("enabled: true", "enabled: yes"), "a.fll: line 3, column 12: found 'yes', wanted true or false");
  EXPECT_EQ(refused("range: 0.000 10.000", "range: 10 0"),
            "a.fll: line 4, column 10: found '10 0', wanted two numbers, the lower one first");
  EXPECT_EQ(refused("rule: if x", "rule: when x"), "a.fll: line 28, column 9: found 'when', wanted IF in a rule");
  EXPECT_EQ(refused("y is small", "y is small z"),
            "a.fll: line 28, column 37: found 'z', wanted AND, OR, THEN or the end of the rule");
  EXPECT_EQ(refused("defuzzifier: Centroid 1000", "defuzzifier: WeightedAverage TakagiSugeno"),
            "a.fll: line 17, column 16: found the defuzzifier 'WeightedAverage' of a Takagi-Sugeno or Tsukamoto "
            "system, wanted "
            "Centroid, all that Tactus has");
  EXPECT_EQ(refused("aggregation: Maximum", "aggregation: none"),
            "a.fll: line 16, column 16: found no aggregation, wanted Maximum, all that Tactus has");
  EXPECT_EQ(refused("activation: General", "activation: Proportional"),
            "a.fll: line 27, column 15: found the activation 'Proportional', wanted General: Tactus takes all rules");
  EXPECT_EQ(refused("range: 0.000 10.000", "range: -inf inf"), "");
}

}  // namespace
}  // namespace tactus::exchange
