// Files that other people wrote: the examples of fuzzylite, where its package is installed. Each loads with the forces
// that fuzzylite computes, or is refused with a reason that holds.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iostream>
#include <iterator>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "core/analysis/centroid_bound.h"
#include "core/base/random.h"
#include "core/exchange/import/import_model.h"
#include "core/fuzzy/compiled_model.h"

#include "tests/support/fuzzylite_program.h"

namespace tactus::exchange {
namespace {

constexpr const char* kFolder = "/usr/share/doc/fuzzylite/examples";
constexpr int kPointsOfFile = 100;
constexpr double kShareOfFile = 1e-9;  // of the output's range: what a program may differ that computes the same

/// Every reason for which one of these files may be refused: the part of the sentence, and what the file must hold.
const std::map<std::string, std::string> kReasons = {
    {"a system of the type", "Type *= *'?(sugeno|tsukamoto|hybrid)"},
    {"of a Takagi-Sugeno or Tsukamoto system", "WeightedAverage|WeightedSum|COGS"},
    {"found the defuzzifier 'MeanOfMaximum'", "MeanOfMaximum"},
    {"found the defuzzifier 'MM'", "METHOD : MM"},
    {"found the defuzzifier 'mom'", "DefuzzMethod *= *'mom'"},
    {"found the disjunction", "OR : ASUM|disjunction: AlgebraicSum|OrMethod *= *'probor'"},
    {"found the aggregation", "ACCU : ASUM|a(ggregation|ccumulation): AlgebraicSum|AggMethod *= *'?(probor|sum)"},
    {"found the hedge", "very|extremely|seldom|somewhat|-?[0-9]\\.[0-9]*[1-9]"},
    {"wanted a trapezoid, a triangle, a Gaussian",
     "Sigmoid|sigmf|Concave|concavemf|Cosine|cosinemf|ZShape|zmf|Constant|Linear|Function"},
    {"in a condition, wanted inputs", "(if|IF) [A-Za-z]+ is"},
    {"asks for no term", "\n0\\.000"},
};

std::string contentOf(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::vector<std::filesystem::path> realFiles() {
  std::vector<std::filesystem::path> out;
  if (!std::filesystem::is_directory(kFolder)) return out;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kFolder)) {
    const std::string extension = entry.path().extension();
    if (extension == ".fll" || extension == ".fcl" || extension == ".fis") out.push_back(entry.path());
  }
  std::sort(out.begin(), out.end());
  return out;
}

bool hasReason(const std::string& refusal, const std::string& content) {
  return std::any_of(kReasons.begin(), kReasons.end(), [&](const auto& reason) {
    return refusal.find(reason.first) != std::string::npos && std::regex_search(content, std::regex(reason.second));
  });
}

class RealFiles : public testing::Test {
 protected:
  void SetUp() override {
    if (program_.isThere() && !realFiles().empty()) return;
    std::cout << "SKIPPED: the examples of fuzzylite are not installed, so no files of other people are read here\n";
    GTEST_SKIP();
  }

  /// The cells of the centroid that the output `index` of a file states.
  std::size_t cellsIn(const std::string& content, const std::string& format, std::size_t index) const {
    static const std::regex centroid("defuzzifier: Centroid ([0-9]+)");
    if (format != "fll") return program_.cellsOfFcl();
    auto found = std::sregex_iterator(content.begin(), content.end(), centroid);
    for (std::size_t i = 0; i < index && found != std::sregex_iterator(); ++i) ++found;
    return found == std::sregex_iterator() ? program_.cellsOfFcl() : std::stoul((*found)[1]);
  }

  /// The model of output `index` of `count` has the values that fuzzylite computes.
  void expectSame(const fuzzy::ForceModel& model, const std::string& content, const std::string& format,
                  std::size_t index, std::size_t count) {
    const auto compiled = fuzzy::compile(model);
    ASSERT_TRUE(compiled);
    base::Random random(23);
    std::vector<std::vector<double>> points(kPointsOfFile);
    for (auto& point : points) {
      for (const fuzzy::Variable& input : model.inputs)
        point.push_back(input.min + (input.max - input.min) * random.uniform());
    }
    const auto wanted = program_.outputs(content, format, points);
    ASSERT_EQ(wanted.size(), kPointsOfFile * count);
    const analysis::Sampling sampling{analysis::Sampling::Rule::kMidpoint, cellsIn(content, format, index)};
    for (std::size_t p = 0; p < points.size(); ++p) {
      const auto found = analysis::evaluateSampled(*compiled, points[p], sampling, 0);
      const double of_program = wanted[p * count + index];
      if (std::isnan(of_program)) {
        EXPECT_FALSE(found.fired && !std::isnan(found.force_n)) << p;
        continue;
      }
      EXPECT_NEAR(found.force_n, of_program, kShareOfFile * (model.output.max - model.output.min)) << "point " << p;
      ++compared_;
    }
  }

  support::FuzzyliteProgram program_;
  int compared_ = 0;
};

TEST_F(RealFiles, LoadWithTheirForcesOrAreRefusedForAReason) {
  int loaded = 0;
  int refused = 0;
  for (const auto& path : realFiles()) {
    SCOPED_TRACE(path);
    const std::string content = contentOf(path);
    const std::string format = path.extension().string().substr(1);
    const auto file = ReadFile::read(content, path.filename());
    if (!file) {
      ++refused;
      EXPECT_TRUE(hasReason(file.error().message(), content)) << file.error().message();
      continue;
    }
    const auto outputs = file->outputs();
    for (std::size_t i = 0; i < outputs.size(); ++i) {
      const auto model = file->model(outputs[i]);
      if (!model) {
        ++refused;
        EXPECT_TRUE(hasReason(model.error().message(), content)) << model.error().message();
        continue;
      }
      ++loaded;
      expectSame(*model, content, format, i, outputs.size());
    }
  }
  std::cout << loaded << " outputs loaded, " << refused << " refused; " << compared_ << " values compared\n";
  EXPECT_GE(loaded + refused, 30);
  EXPECT_GE(loaded, 10);
}

}  // namespace
}  // namespace tactus::exchange
