// A bundle is written whole, read back, and every harm to it is found.
#include "app/bundle/bundle.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <numeric>
#include <set>

#include "app/bundle/bounded_table.h"
#include "app/bundle/file_errors.h"
#include "app/figures/colors.h"
#include "core/analysis/check_points.h"
#include "core/base/files/file.h"
#include "core/base/tables/csv.h"
#include "core/contracts/contract_check.h"
#include "core/exchange/dialect.h"
#include "core/fuzzy/compiled_model.h"
#include "core/model_io/model_file.h"
#include "tactus/tactus.h"

#include "tests/support/ngt_model.h"
#include "tests/support/temp_folder.h"

namespace tactus::bundle {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kProgram = "tactus test";
constexpr double kCoarse = 0.2;  // N, for a small table

/// S4 with five regions covers every place but one that the tests accept.
Bundle ngtBundle() {
  BundleSettings settings{{}, "2026-11-22T08:00:00Z", std::string(kProgram), kCoarse};
  auto made = makeBundle(support::s4FiveRegions(), settings);
  EXPECT_TRUE(made) << made.error().message();
  return std::move(*made);
}

class BundleTest : public testing::Test {
 protected:
  void SetUp() override {
    static const Bundle bundle = ngtBundle();
    made_ = &bundle;
    ASSERT_TRUE(writeBundle(bundle, path_));
  }

  std::string contents(const std::string& name) const {
    return base::readFile(path_ + "/" + name, std::size_t{1} << 28U).value();
  }
  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path_ + "/" + name, std::ios::binary) << bytes;
  }
  tactus_status library(double* error_n = nullptr) {
    return tactus_verify(path_.c_str(), error_n, message_, sizeof message_);
  }

  support::TempFolder folder_;
  const std::string path_ = folder_.file("bundle");
  const Bundle* made_ = nullptr;
  char message_[500] = {};
};

TEST_F(BundleTest, HoldsEveryFileOfTheContract) {
  for (const char* const name :
       {"manifest.json", "model.tactus.json", "checks.csv", "experts/S4.fll", "experts/S4.iec.fcl",
        "experts/S4.fuzzylite.fcl", "experts/S4.fis", "experts/S4.fml", "c/force_model.h", "c/force_model.c",
        "c/tube.h", "c/tube.c", "checks_tube.csv", "js/force_model.js", "js/tube.js", "table/force_table.csv",
        "table/README.txt", "report.html"}) {
    EXPECT_TRUE(fs::exists(path_ + "/" + name)) << name;
  }
  EXPECT_TRUE(made_->warnings.empty());
  const auto manifest = model_io::parseManifest(contents("manifest.json"), "manifest.json");
  ASSERT_TRUE(manifest) << manifest.error().message();
  EXPECT_EQ(*manifest, made_->manifest);
  for (const auto& file : manifest->files) {
    if (file.promise) {
      EXPECT_LE(file.promise->largest_error_n, file.promise->tolerance_n) << file.path;
    }
    EXPECT_EQ(file.expert.empty(), !file.path.starts_with("experts/")) << file.path;
  }
}

TEST_F(BundleTest, IsVerifiedByTheProgramAndByTheLibrary) {
  const auto check = verifyBundle(path_, kProgram);
  ASSERT_TRUE(check) << check.error().message();
  EXPECT_TRUE(check->ok());
  for (const auto& file : check->files) EXPECT_TRUE(file.ok) << file.wrong;
  double error_n = 7;
  EXPECT_EQ(library(&error_n), TACTUS_OK) << message_;
  EXPECT_EQ(error_n, 0);
}

/// The rules never ask for more force with more lubrication; the centroid gives more all the same.
TEST_F(BundleTest, TheLibraryFindsAContractThatTheModelBreaks) {
  for (const auto& [sentence, kept] : {std::pair{"the force is never above 1.1 N", true},
                                       std::pair{"more lubrication never raises the force", false}}) {
    fuzzy::ForceModel model = support::s4FiveRegions();
    const auto contract = contracts::parseContract(model, sentence);
    ASSERT_TRUE(contract) << contract.error().message();
    model.contracts = {*contract};
    model.contracts.front().id = "c1";
    const auto made = makeBundle(model, {{}, "2026-11-22T08:00:00Z", std::string(kProgram), kCoarse});
    ASSERT_TRUE(made) << made.error().message();
    ASSERT_TRUE(writeBundle(*made, path_));
    EXPECT_EQ(library(), kept ? TACTUS_OK : TACTUS_NOT_VERIFIED) << message_;
    EXPECT_EQ(std::string(message_).find(sentence) == std::string::npos, kept) << message_;
  }
}

TEST_F(BundleTest, ItsChecksAreManyAndExact) {
  const auto table = base::CsvTable::read(path_ + "/checks.csv");
  ASSERT_TRUE(table);
  EXPECT_GE(table->rowCount(), analysis::kLeastChecks);
  const auto compiled = fuzzy::compile(made_->model);
  std::set<bool> outside;
  for (std::size_t r = 0; r < table->rowCount(); ++r) {
    std::vector<double> point;
    bool any_outside = false;
    for (std::size_t i = 0; i < 4; ++i) {
      point.push_back(table->number(r, i).value());
      any_outside = any_outside || point[i] < made_->model.inputs[i].min || point[i] > made_->model.inputs[i].max;
    }
    outside.insert(any_outside);
    EXPECT_EQ(table->number(r, 4).value(), compiled->evaluate(point).force_n);
  }
  EXPECT_EQ(outside.size(), 2U);
}

TEST_F(BundleTest, ItsReportSaysWhatIsKnownOfHoles) {
  const auto says = [this](const Bundle& bundle, const std::string& sentence) {
    const auto compiled = fuzzy::compile(bundle.model);
    return bundleReport(bundle, *compiled).find(sentence) != std::string::npos;
  };
  Bundle bundle = *made_;
  EXPECT_TRUE(says(bundle, "There is no such place."));
  bundle.every_hole_is_known = false;
  EXPECT_FALSE(says(bundle, "There is no such place."));
  EXPECT_TRUE(says(bundle, "None was found, but the search was cut off"));
  bundle.holes = {"depth 460 to 600 mm"};
  EXPECT_TRUE(says(bundle, "Accepted: depth 460 to 600 mm. No other was found, but the search was cut off"));
  // What one expert alone leaves open is no place without a force.
  bundle.every_hole_is_known = true;
  bundle.holes.clear();
  bundle.model.accepted_holes = {"depth 1 to 2 mm"};
  EXPECT_TRUE(says(bundle, "There is no such place."));
}

TEST_F(BundleTest, TheMakingTellsHowFarItIsAndStops) {
  std::vector<std::size_t> told;
  std::stop_source source;
  BundleSettings settings{{}, "2026-11-22T08:00:00Z", std::string(kProgram), kCoarse, source.get_token()};
  settings.progress = [&](std::size_t done, std::size_t all) {
    EXPECT_LT(done, all);
    told.push_back(done);
  };
  ASSERT_TRUE(makeBundle(support::s4FiveRegions(), settings));
  // The model, the checks, a file of the expert in each dialect, the insertions, four sources, the table and the
  // report.
  std::vector<std::size_t> all(9 + std::size(exchange::kDialects));
  std::iota(all.begin(), all.end(), std::size_t{0});
  EXPECT_EQ(told, all);
  settings.progress = [&](std::size_t done, std::size_t) {
    if (done == 3) source.request_stop();
  };
  const auto stopped = makeBundle(support::s4FiveRegions(), settings);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, base::ErrorCode::kCancelled);
}

TEST_F(BundleTest, AStopWhileWritingLeavesWhatWasThere) {
  std::stop_source source;
  source.request_stop();
  const std::string before = contents("manifest.json");
  Bundle other = *made_;
  other.files.back().second += "\n";
  const auto written = writeBundle(other, path_, source.get_token());
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, base::ErrorCode::kCancelled);
  EXPECT_EQ(contents("manifest.json"), before);
  const auto beside = folder_.file("new");
  ASSERT_FALSE(writeBundle(other, beside, source.get_token()));
  EXPECT_FALSE(fs::exists(beside));
  EXPECT_EQ(std::distance(fs::directory_iterator(fs::path(path_).parent_path()), {}), 1);
}

TEST_F(BundleTest, TheErrorOfTheCSourceIsMeasuredOrCalledABound) {
  const auto promise = [](const Bundle& bundle) {
    const auto file = std::find_if(bundle.manifest.files.begin(), bundle.manifest.files.end(),
                                   [](const model_io::BundleFile& one) { return one.path == "c/force_model.c"; });
    return file->promise.value();
  };
  // A compiler built this test.
  EXPECT_TRUE(promise(*made_).measured);
  EXPECT_LT(promise(*made_).largest_error_n, 1e-15);
  const char* const path = std::getenv("PATH");
  const std::string before = path != nullptr ? path : "";
  setenv("PATH", folder_.file("nothing").c_str(), 1);
  const Bundle without = ngtBundle();
  setenv("PATH", before.c_str(), 1);
  EXPECT_FALSE(promise(without).measured);
  EXPECT_EQ(promise(without).largest_error_n, promise(without).tolerance_n);
  EXPECT_NE(without.files.back().second.find("\"measured\": false"), std::string::npos) << without.files.back().second;
  const auto read = model_io::parseManifest(without.files.back().second, "manifest.json");
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(*read, without.manifest);
}

TEST_F(BundleTest, EveryHarmIsFound) {
  for (const auto& file : made_->manifest.files) {
    SCOPED_TRACE(file.path);
    const std::string before = contents(file.path);
    // One digit or letter is another one.
    std::string after = before;
    const auto at = after.find_last_of("0123456789abcdefghij");
    after[at] = after[at] == '1' ? '2' : '1';
    write(file.path, after);
    const auto altered = verifyBundle(path_, kProgram);
    EXPECT_TRUE(!altered || !altered->ok());
    EXPECT_EQ(library(), TACTUS_NOT_VERIFIED) << message_;
    fs::remove(path_ + "/" + file.path);
    const auto missing = verifyBundle(path_, kProgram);
    EXPECT_TRUE(!missing || !missing->ok());
    EXPECT_EQ(library(), TACTUS_NOT_VERIFIED) << message_;
    write(file.path, before);
  }
  EXPECT_EQ(library(), TACTUS_OK);
}

/// The manifest says again that the file is right.
void forge(const std::string& folder, const Bundle& made, const std::string& path, const std::string& bytes) {
  Bundle forged = made;
  for (auto& file : forged.manifest.files) {
    if (file.path != path) continue;
    const std::string name = folder + "/" + path;
    std::ofstream(name, std::ios::binary) << bytes;
    file.sha256 = base::fileSha256(name).value();
  }
  std::ofstream(folder + "/manifest.json", std::ios::binary) << model_io::formatManifest(forged.manifest);
}

TEST_F(BundleTest, WhatTheManifestDoesNotNameIsFound) {
  write("experts/S5.fis", "what somebody put there");
  fs::create_symlink(path_ + "/checks.csv", path_ + "/more.csv");
  const auto found = verifyBundle(path_, kProgram);
  ASSERT_TRUE(found) << found.error().message();
  EXPECT_FALSE(found->ok());
  std::vector<std::string> wrong;
  for (const auto& file : found->files)
    if (!file.ok) wrong.push_back(file.file.kind + " " + file.file.path);
  EXPECT_EQ(wrong, (std::vector<std::string>{"unnamed experts/S5.fis", "unnamed more.csv"}));
  EXPECT_EQ(library(), TACTUS_NOT_VERIFIED);
  EXPECT_NE(std::string(message_).find("does not name"), std::string::npos) << message_;
}

TEST_F(BundleTest, ASignatureIsTheOneFileThatTheManifestCannotName) {
  write("manifest.json.sig", "a signature");
  const auto found = verifyBundle(path_, kProgram);
  ASSERT_TRUE(found) << found.error().message();
  EXPECT_TRUE(found->ok());
  EXPECT_EQ(found->signature, "a signature");
  EXPECT_EQ(library(), TACTUS_OK) << message_;
  EXPECT_TRUE(mayHoldBundle(path_));
  fs::remove(path_ + "/manifest.json.sig");
  fs::create_symlink(path_ + "/checks.csv", path_ + "/manifest.json.sig");
  EXPECT_FALSE(verifyBundle(path_, kProgram));
  EXPECT_EQ(library(), TACTUS_NOT_VERIFIED);
  fs::remove(path_ + "/manifest.json.sig");
  fs::create_directory(path_ + "/manifest.json.sig");
  EXPECT_FALSE(verifyBundle(path_, kProgram));
}

TEST_F(BundleTest, ALinkIsNoFileOfABundle) {
  const auto linked = [&](const std::string& name) {
    fs::rename(path_ + "/" + name, folder_.file("moved"));
    fs::create_symlink(folder_.file("moved"), path_ + "/" + name);
    const auto found = verifyBundle(path_, kProgram);
    EXPECT_FALSE(found && found->ok()) << name;
    EXPECT_EQ(library(), TACTUS_NOT_VERIFIED) << name;
    EXPECT_NE(std::string(message_).find("found a link"), std::string::npos) << message_;
    fs::remove(path_ + "/" + name);
    fs::rename(folder_.file("moved"), path_ + "/" + name);
    EXPECT_EQ(library(), TACTUS_OK) << message_;
  };
  for (const char* const name : {"manifest.json", "model.tactus.json", "checks.csv", "c/force_model.c"}) linked(name);
}

TEST_F(BundleTest, AForceThatIsWrongIsFoundBehindARightChecksum) {
  std::string checks = contents("checks.csv");
  const auto row = checks.find('\n', 40);
  const auto comma = checks.rfind(',', checks.find('\n', row + 1));
  checks.replace(checks.rfind(',', comma - 1) + 1, 3, "0.9");
  forge(path_, *made_, "checks.csv", checks);
  double error_n = 0;
  EXPECT_EQ(library(&error_n), TACTUS_NOT_VERIFIED);
  EXPECT_GT(error_n, 0);
  EXPECT_NE(std::string(message_).find("checks.csv: found an error of"), std::string::npos) << message_;

  forge(path_, *made_, "checks.csv", contents("table/force_table.csv"));
  EXPECT_EQ(library(), TACTUS_NOT_VERIFIED);
  EXPECT_NE(std::string(message_).find("fired"), std::string::npos) << message_;
}

TEST_F(BundleTest, ATextOfAnotherModelIsFoundBehindARightChecksum) {
  std::string fll = contents("experts/S4.fll");
  fll.replace(fll.find("Trapezoid"), 9, "Triangle");
  forge(path_, *made_, "experts/S4.fll", fll);
  const auto check = verifyBundle(path_, kProgram);
  ASSERT_TRUE(check);
  EXPECT_FALSE(check->ok());
  // Another version of the program may write the same model in other words.
  const auto later = verifyBundle(path_, "tactus 9.9.9");
  ASSERT_TRUE(later);
  EXPECT_TRUE(later->ok());
}

TEST_F(BundleTest, APathOutOfTheFolderIsRefused) {
  for (const char* const path : {"../secret", "/etc/passwd", "a/../../b", "a//b", "a\\b", "./a"}) {
    Bundle forged = *made_;
    forged.manifest.files[1].path = path;
    write("manifest.json", model_io::formatManifest(forged.manifest));
    EXPECT_EQ(library(), TACTUS_BAD_FILE) << path;
    EXPECT_NE(std::string(message_).find("/files/1/path"), std::string::npos) << message_;
  }
}

TEST_F(BundleTest, ANewOneTakesThePlaceOfAnEarlierOneAndOfNothingElse) {
  EXPECT_TRUE(writeBundle(*made_, path_ + "/"));
  write("notes.txt", "mine");
  const auto refused = writeBundle(*made_, path_);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message().find("notes.txt"), std::string::npos);
  EXPECT_TRUE(fs::exists(path_ + "/notes.txt"));
  fs::create_directory(folder_.file("other"));
  std::ofstream(folder_.file("other") + "/thesis.txt") << "mine";
  EXPECT_FALSE(writeBundle(*made_, folder_.file("other")));
  // Nothing unfinished stays.
  EXPECT_EQ(std::distance(fs::directory_iterator(fs::path(path_).parent_path()), fs::directory_iterator()), 2);
}

TEST(MakeBundle, AHoleIsRefusedByNameAndAcceptedByName) {
  // S4's rules as printed name no force in the oropharynx (facts of the paper).
  const auto model = support::s4AsPrinted();
  const auto refused = makeBundle(model, {});
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message().find("--accept-hole"), std::string::npos) << refused.error().message();
  const std::string wanted = refused.error().wanted;
  const std::string name = wanted.substr(wanted.find('\'') + 1, wanted.rfind('\'') - wanted.find('\'') - 1);
  const auto accepted = makeBundle(model, {{name}, "", "", kCoarse});
  ASSERT_TRUE(accepted) << accepted.error().message();
  EXPECT_EQ(accepted->model.accepted_holes, std::vector<std::string>{name});
  const auto unknown = makeBundle(model, {{"depth 1 to 2 mm"}, "", ""});
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().code, base::ErrorCode::kReference);
}

TEST(BundleReportTest, AnExpertHasTheColorOfItsNumber) {
  fuzzy::ForceModel model = support::s4FiveRegions();
  model.experts.push_back(model.experts.front());
  model.experts.back().id = "S2";
  const auto made = makeBundle(model, {{}, "2026-11-22T08:00:00Z", std::string(kProgram), kCoarse});
  ASSERT_TRUE(made) << made.error().message();
  const auto report = std::find_if(made->files.begin(), made->files.end(),
                                   [](const auto& file) { return file.first == "report.html"; });
  ASSERT_NE(report, made->files.end());
  // S4 is number 3, S2 number 1, wherever they stand in the model.
  for (const std::size_t number : {3, 1}) {
    EXPECT_NE(report->second.find(figures::hex(figures::expertColor(number))), std::string::npos) << number;
  }
  EXPECT_EQ(report->second.find(figures::hex(figures::expertColor(0))), std::string::npos);
}

// Universes as large as a model may have: nothing in a bundle ends the program.
TEST(MakeBundle, OfAnUniverseOfAnySize) {
  for (const double input : {1.0, 6e149, 1e150}) {
    for (const double output : {1.0, 1e100, 1e150, 1e-140}) {
      SCOPED_TRACE(std::to_string(input) + ", " + std::to_string(output));
      fuzzy::ForceModel model;
      model.name = "large";
      model.inputs.push_back(
          {"x", "x", "mm", -input, input, {{"all", "all", fuzzy::Shape::kTrapezoid, {-input, -input, input, input}}}});
      model.output = {"y", "y", "N", 0, output, {{"half", "half", fuzzy::Shape::kTriangle, {0, output / 2, output}}}};
      fuzzy::Expert expert;
      expert.id = "E";
      expert.rules.push_back({{{"x", "all"}}, "half"});
      model.experts.push_back(expert);
      const auto made = makeBundle(model, {{}, "2026-11-22T08:00:00Z", std::string(kProgram)});
      EXPECT_TRUE(made) << made.error().message();
    }
  }
}

}  // namespace
}  // namespace tactus::bundle
