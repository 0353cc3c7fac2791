// Small models of other programs for the tests of the importers, and their forces.
#pragma once

#include <gtest/gtest.h>
#include <optional>
#include <string>
#include <vector>

#include "core/exchange/import/import_model.h"
#include "core/fuzzy/compiled_model.h"

namespace tactus::exchange {

/// What came of a text.
struct Imported {
  std::optional<fuzzy::ForceModel> model;
  std::vector<std::string> warnings;
  std::string refusal;  ///< the sentence; empty where the model was loaded
};

inline Imported imported(std::string bytes, const std::string& file, const std::string& output = {}) {
  Imported out;
  const auto read = ReadFile::read(std::move(bytes), file);
  if (!read) {
    out.refusal = read.error().message();
    return out;
  }
  auto model = read->model(output);
  out.warnings = read->warnings();
  if (model) {
    out.model = std::move(*model);
  } else {
    out.refusal = model.error().message();
  }
  return out;
}

/// The force at a point, which some rule must answer.
inline double force(const Imported& from, const std::vector<double>& point) {
  EXPECT_TRUE(from.model) << from.refusal;
  if (!from.model) return -1;
  const auto compiled = fuzzy::compile(*from.model);
  EXPECT_TRUE(compiled) << compiled.error().message();
  if (!compiled) return -1;
  const auto result = compiled->evaluate(point);
  EXPECT_TRUE(result.fired);
  return result.force_n;
}

inline bool fires(const Imported& from, const std::vector<double>& point) {
  EXPECT_TRUE(from.model) << from.refusal;
  if (!from.model) return false;
  const auto compiled = fuzzy::compile(*from.model);
  EXPECT_TRUE(compiled);
  return compiled && compiled->evaluate(point).fired;
}

inline bool warns(const Imported& from, const std::string& sentence) {
  for (const std::string& warning : from.warnings) {
    if (warning.find(sentence) != std::string::npos) return true;
  }
  std::string all;
  for (const std::string& warning : from.warnings) all += warning + "\n";
  ADD_FAILURE() << "no warning '" << sentence << "' in\n" << all << from.refusal;
  return false;
}

// Two inputs and an output whose triangles are symmetric: alone, `small` is a force of 2 and `large` one of 6;
// together, scaled by the strengths s and t, the force is (2 s + 6 t) / (s + t). Each test adds rules.

inline std::string fll(const std::string& rules, const std::string& more_terms = {}, const std::string& norms = {}) {
  return "Engine: pair\n"
         "InputVariable: x\n"
         "  enabled: true\n"
         "  range: 0.000 10.000\n"
         "  lock-range: false\n"
         "  term: low Trapezoid 0.000 0.000 2.000 4.000\n"
         "  term: high Trapezoid 2.000 4.000 10.000 10.000\n" +
         more_terms +
         "InputVariable: z\n"
         "  range: 0 10\n"
         "  term: low Trapezoid 0 0 2 4\n"
         "  term: high Trapezoid 2 4 10 10\n"
         "OutputVariable: y\n"
         "  enabled: true\n"
         "  range: 0.000 8.000\n"
         "  lock-range: false\n"
         "  aggregation: Maximum\n"
         "  defuzzifier: Centroid 1000\n"
         "  default: nan\n"
         "  lock-previous: false\n"
         "  term: small Triangle 1 2 3\n"
         "  term: large Triangle 5 6 7\n"
         "RuleBlock: rules\n"
         "  enabled: true\n" +
         (norms.empty() ? "  conjunction: Minimum\n  disjunction: Maximum\n  implication: AlgebraicProduct\n"
                          "  activation: General\n"
                        : norms) +
         rules;
}

inline std::string fcl(const std::string& rules, const std::string& defuzzify = "METHOD : COG; DEFAULT := 0;",
                       const std::string& norms = "AND : MIN; OR : MAX; ACT : PROD; ACCU : MAX;") {
  return "FUNCTION_BLOCK pair\n"
         "VAR_INPUT\n"
         "  x : REAL;\n"
         "  z : REAL;\n"
         "END_VAR\n"
         "VAR_OUTPUT y : REAL; END_VAR\n"
         "FUZZIFY x\n"
         "  TERM low := (0, 1) (2, 1) (4, 0);\n"
         "  TERM high := (2, 0) (4, 1) (10, 1);\n"
         "END_FUZZIFY\n"
         "FUZZIFY z\n"
         "  TERM low := (0, 1) (2, 1) (4, 0);\n"
         "  TERM high := (2, 0) (4, 1) (10, 1);\n"
         "END_FUZZIFY\n"
         "DEFUZZIFY y\n"
         "  TERM small := (1, 0) (2, 1) (3, 0);\n"
         "  TERM large := (5, 0) (6, 1) (7, 0);\n"
         "  RANGE := (0 .. 8);\n  " +
         defuzzify + "\nEND_DEFUZZIFY\nRULEBLOCK rules\n  " + norms + "\n" + rules +
         "END_RULEBLOCK\nEND_FUNCTION_BLOCK\n";
}

inline std::string fis(const std::string& rules, const std::string& system = {}) {
  return "[System]\nName='pair'\nType='mamdani'\nVersion=2.0\nNumInputs=2\nNumOutputs=1\n" +
         (system.empty()
              ? "AndMethod='min'\nOrMethod='max'\nImpMethod='prod'\nAggMethod='max'\nDefuzzMethod='centroid'\n"
              : system) +
         "\n[Input1]\nName='x'\nRange=[0 10]\nNumMFs=2\nMF1='low':'trapmf',[-10 0 2 4]\nMF2='high':'trapmf',[2 4 10 "
         "20]\n"
         "\n[Input2]\nName='z'\nRange=[0 10]\nNumMFs=2\nMF1='low':'trapmf',[0 0 2 4]\nMF2='high':'trapmf',[2 4 10 10]\n"
         "\n[Output1]\nName='y'\nRange=[0 8]\nNumMFs=2\nMF1='small':'trimf',[1 2 3]\nMF2='large':'trimf',[5 6 7]\n"
         "\n[Rules]\n" +
         rules;
}

/// At x = z = 3 the strengths of the two rules of a test are 0.5 and 0.25.
inline constexpr double kAtThree = (2 * 0.5 + 6 * 0.25) / 0.75;

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

}  // namespace tactus::exchange
