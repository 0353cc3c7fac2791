// Programs that are right, and programs that are wrong in one way each.
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "app/certify/certificate.h"
#include "core/base/text.h"
#include "core/exchange/c_source.h"
#include "core/exchange/js_source.h"
#include "core/exchange/tube_source.h"
#include "core/model_io/model_file.h"

#include "tests/support/ngt_model.h"
#include "tests/support/temp_folder.h"

namespace tactus::certify {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kPoints = 40;

/// Everything asked, but few points and short traces, so that a test is quick.
const Questions& questions() {
  static const Questions all = [] {
    auto made = questionsOf(support::s4FiveRegions(), std::string(64, 'a'));
    EXPECT_TRUE(made) << made.error().message();
    made->points.resize(kPoints);
    return std::move(*made);
  }();
  return all;
}

class Certify : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(model_io::writeModel(support::s4FiveRegions(), model_)); }
  /// Each test ends its children.
  void TearDown() override {
    EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1);
    EXPECT_EQ(errno, ECHILD);
  }

  Certificate certified(const Target& target, const Questions& asked = questions()) const {
    Patience patience;
    patience.answer = std::chrono::milliseconds(400);
    auto made = certify(target, asked, {1e-9, "2026-11-28T08:00:00Z", "tactus test"}, patience);
    EXPECT_TRUE(made) << made.error().message();
    return made ? std::move(*made) : Certificate();
  }
  Certificate simulated(const std::string& how, int at = 1) const {
    return certified({TACTUS_SIMULATOR, {model_, how, std::to_string(at)}});
  }
  /// A shared library with the text of a C file.
  std::string library(const std::string& text) const {
    std::ofstream(folder_.file("library.c")) << text;
    const std::string path = folder_.file("library.so");
    EXPECT_EQ(
        std::system(
            (std::string(TACTUS_CC) + " -shared -fPIC -o " + path + " " + folder_.file("library.c") + " -lm").c_str()),
        0);
    return path;
  }

  support::TempFolder folder_;
  const std::string model_ = folder_.file("m.tactus.json");
};

void expectCertified(const Certificate& made) {
  EXPECT_TRUE(made.ok()) << made.failure;
  EXPECT_EQ(made.points.right, kPoints);
  EXPECT_EQ(made.points.largest_error_n, 0) << "libtactus has the same bits";
  EXPECT_EQ(made.points.latency_us.size(), kPoints);
}

TEST_F(Certify, LibtactusIsRightInEachPointAndStep) {
  const Certificate made = simulated("");
  expectCertified(made);
  EXPECT_EQ(made.program, "the simulator of the tests");
  EXPECT_TRUE(made.has_tube);
  EXPECT_GT(made.steps.all, 3000U);
  EXPECT_EQ(made.steps.right, made.steps.all);
  EXPECT_EQ(made.steps.largest_error_n, 0);
  EXPECT_EQ(made.largest_depth_error_mm, 0);
  EXPECT_NE(made.verdict().find("what a hand feels of its tube"), std::string::npos) << made.verdict();
  const Percentiles latency = made.steps.latency();
  EXPECT_GT(latency.half, 0);
  EXPECT_LE(latency.half, latency.p99);
  EXPECT_LE(latency.p99, latency.p999);
  EXPECT_LE(latency.p999, latency.largest);
}

TEST_F(Certify, AProgramThatIsAMicronewtonOffIsFound) {
  const Certificate at_a_point = simulated("off", 17);
  EXPECT_FALSE(at_a_point.ok());
  EXPECT_EQ(at_a_point.points.wrong, 1U);
  EXPECT_EQ(at_a_point.points.right, kPoints - 1);
  EXPECT_NEAR(at_a_point.points.largest_error_n, 1e-6, 1e-15);
  EXPECT_TRUE(at_a_point.points.where.starts_with("point 17 (lubrication ")) << at_a_point.points.where;
  EXPECT_TRUE(at_a_point.failure.starts_with("point 17 (lubrication ")) << at_a_point.failure;
  EXPECT_NE(at_a_point.failure.find(" within 1e-09 N"), std::string::npos) << at_a_point.failure;
  EXPECT_EQ(at_a_point.steps.right, at_a_point.steps.all);

  const Certificate in_a_trace = simulated("off", kPoints + 30);
  EXPECT_EQ(in_a_trace.points.right, kPoints);
  EXPECT_EQ(in_a_trace.steps.wrong, 1U);
  EXPECT_TRUE(in_a_trace.failure.starts_with("insertion 'strokes_with_stops', step 30: found ")) << in_a_trace.failure;
}

TEST_F(Certify, ABrokenProgramIsOneSentenceThatNamesThePoint) {
  for (const auto& [how, says] :
       {std::pair{"hang", "found no answer within 0.4 s, wanted one line"},
        {"die", "found a program that ended with status 7, after the words 'no license', wanted one that answers"},
        {"crash", "found a program that crashed (Segmentation fault), wanted one that answers"},
        {"nan", "found null, wanted a number"},
        {"id", "found an answer to the question 9999, wanted one to 5"},
        {"nonsense", "wanted"},
        {"endless", "found a line of more than 1 MiB, wanted one of at most 1 MiB"},
        {"child", "found no answer within 0.4 s"}}) {
    SCOPED_TRACE(how);
    const fs::path before = fs::current_path();
    fs::current_path(folder_.file("."));
    const Certificate made = simulated(how, 5);
    fs::current_path(before);
    EXPECT_FALSE(made.ok());
    EXPECT_TRUE(made.failure.starts_with("point 5 (lubrication ")) << made.failure;
    EXPECT_NE(made.failure.find(says), std::string::npos) << made.failure;
    EXPECT_EQ(made.failure.find('\n'), std::string::npos);
    EXPECT_FALSE(made.verdict().starts_with("Within"));
    const Answers& points = made.points;
    EXPECT_EQ(points.right + points.wrong + points.late + points.missing + points.unasked(), points.all);
    EXPECT_LT(points.right, points.all);
  }
  // What the program started has ended with it.
  std::string child;
  ASSERT_TRUE(std::ifstream(folder_.file("child.txt")) >> child);
  std::string state;
  for (int ms = 0; ms < 5000 && state != "Z" && state != "X"; ++ms) {
    std::string number, name;
    if (!(std::ifstream("/proc/" + child + "/stat") >> number >> name >> state)) state = "X";
    ::usleep(1000);
  }
  EXPECT_TRUE(state == "Z" || state == "X") << state;
}

TEST_F(Certify, ASilentProgramIsNotAskedForEver) {
  const Certificate silent = simulated("silent");
  EXPECT_TRUE(silent.failure.starts_with("hello: found no answer")) << silent.failure;
  EXPECT_EQ(silent.points.unasked(), kPoints);
  const Certificate hangs = simulated("hang", 3);
  EXPECT_EQ(hangs.points.right, 2U);
  EXPECT_EQ(hangs.points.missing, 3U);
}

TEST_F(Certify, AnAnswerThatComesAfterTheNextQuestionIsLate) {
  const Certificate made = simulated("late", 3);
  EXPECT_EQ(made.points.late, 1U);
  EXPECT_EQ(made.points.missing, 0U);
  EXPECT_EQ(made.points.right, kPoints - 1);
  EXPECT_TRUE(made.failure.starts_with("point 3 ")) << made.failure;
}

TEST_F(Certify, AFloodOfErrorsStopsNothing) { expectCertified(simulated("flood", 3)); }

TEST_F(Certify, AProgramMaySayThatItCannotGoOn) {
  EXPECT_EQ(simulated("error", 3).failure, "the program: found the words 'the motor is off', wanted answers");
}

TEST_F(Certify, AProgramWithoutATubeIsCertifiedForItsForcesAlone) {
  const Certificate made = simulated("notube");
  expectCertified(made);
  EXPECT_FALSE(made.has_tube);
  EXPECT_NE(made.verdict().find("its tube was not asked for"), std::string::npos) << made.verdict();
}

TEST_F(Certify, AProgramOfAnotherModelIsNotCertified) {
  const Certificate made = simulated("other");
  EXPECT_FALSE(made.ok());
  EXPECT_TRUE(made.failure.starts_with("hello: found a program of the model with SHA-256 0000")) << made.failure;
}

TEST_F(Certify, APageSaysItAll) {
  Certificate made = simulated("off", 17);
  made.program = "<script>alert(1)</script>";
  const std::string page = certificatePage(made);
  for (const std::string& text :
       {std::string("Not certified: point 17 (lubrication"), made.model_sha256, made.machine,
        std::string("2026-11-28T08:00:00Z"), std::string("99.9 %"), std::string("&lt;script&gt;")}) {
    EXPECT_NE(page.find(text), std::string::npos) << text;
  }
  EXPECT_EQ(page.find("<script"), std::string::npos);
}

TEST_F(Certify, TheCSourceOfAModelAsASharedLibrary) {
  const auto model = support::s4FiveRegions();
  const auto source = exchange::cSource(model);
  const auto tube = exchange::cTube(model);
  ASSERT_TRUE(source && tube);
  std::ofstream(folder_.file("force_model.h")) << source->header;
  std::ofstream(folder_.file("tube.h")) << tube->header;
  const Certificate forces = certified({library(source->source), {}});
  EXPECT_TRUE(forces.ok()) << forces.failure;
  EXPECT_EQ(forces.points.right, kPoints);
  EXPECT_LT(forces.points.largest_error_n, 1.1e-12) << "1e-12 of the range is what the source promises";
  EXPECT_FALSE(forces.has_tube);
  const Certificate felt = certified({library(source->source + tube->source), {}});
  EXPECT_TRUE(felt.ok()) << felt.failure;
  EXPECT_TRUE(felt.has_tube);
  EXPECT_EQ(felt.steps.right, felt.steps.all);
  EXPECT_LT(felt.steps.largest_error_n, 1e-11);
}

TEST_F(Certify, ALibraryThatCrashesPrintsOrLacksTheFunctionIsASentence) {
  const Certificate crashed = certified({library("double force_model(const double *x, int *f) { return *(volatile "
                                                 "int *)0 + *x + *f; }\n"),
                                         {}});
  EXPECT_TRUE(crashed.failure.starts_with("point 1 (")) << crashed.failure;
  EXPECT_NE(crashed.failure.find("found a program that crashed ("), std::string::npos) << crashed.failure;
  const Certificate printed = certified({library("#include <stdio.h>\ndouble force_model(const double *x, int *f) {"
                                                 " puts(\"here\"); fflush(stdout); *f = 1; return *x * 0; }\n"),
                                         {}});
  EXPECT_NE(printed.failure.find("found 0 N, wanted "), std::string::npos) << printed.failure;
  const Certificate lacks = certified({library("int other;\n"), {}});
  EXPECT_NE(lacks.failure.find("undefined symbol: force_model"), std::string::npos) << lacks.failure;
  const Certificate none = certified({folder_.file("none.so"), {}});
  EXPECT_NE(none.failure.find("none.so"), std::string::npos) << none.failure;
}

/// A model whose force is that of the middle of a triangle, 0.5 N, everywhere.
Questions constantForce() {
  fuzzy::ForceModel model;
  model.name = "constant";
  model.inputs.push_back({"x", "x", "mm", 0, 10, {{"all", "all", fuzzy::Shape::kTrapezoid, {0, 0, 10, 10}}}});
  model.output = {"y", "y", "N", 0, 1, {{"half", "half", fuzzy::Shape::kTriangle, {0, 0.5, 1}}}};
  fuzzy::Expert expert;
  expert.id = "E";
  expert.rules.push_back({{{"x", "all"}}, "half"});
  model.experts.push_back(expert);
  auto made = questionsOf(model, std::string(64, 'b'));
  EXPECT_TRUE(made) << made.error().message();
  made->points.resize(kPoints);
  return std::move(*made);
}

TEST_F(Certify, AModuleOfJavaScript) {
  const Questions asked = constantForce();
  EXPECT_TRUE(asked.insertions.traces.empty()) << "a model without depth and speed has no tube";
  const auto module = [&](const std::string& name, const std::string& text) {
    std::ofstream(folder_.file(name)) << text;
    return certified({"node:" + folder_.file(name), {}}, asked);
  };
  if (std::system("command -v node >/dev/null") == 0) {
    for (const auto& [name, text] :
         {std::pair{"common.js", "console.log('here');\nexports.forceModel = (x) => ({force: 0.5, fired: true});\n"},
          {"module.mjs", "export function forceModel(x) { return {force: 0.5, fired: true}; }\n"},
          {"plain.js", "export function forceModel(x) { return {force: 0.5, fired: true}; }\n"},
          {"global.js", "globalThis.forceModel = (x) => ({force: 0.5, fired: true});\n"}}) {
      const Certificate made = module(name, text);
      EXPECT_TRUE(made.ok()) << name << ": " << made.failure;
      EXPECT_EQ(made.points.right, kPoints) << name;
    }
    EXPECT_NE(module("nan.js", "exports.forceModel = () => ({force: NaN, fired: true});\n").failure.find("found null"),
              std::string::npos);
    EXPECT_NE(module("none.js", "exports.force = 1;\n").failure.find("no function forceModel"), std::string::npos);
    EXPECT_NE(module("throws.js", "exports.forceModel = () => { throw new Error('no'); };\n").failure.find("point 1"),
              std::string::npos);
  }
  const char* const path = std::getenv("PATH");
  const std::string before = path != nullptr ? path : "";
  setenv("PATH", folder_.file("nothing").c_str(), 1);
  const auto missing = certify({"node:" + folder_.file("none.js"), {}}, asked, {}, {});
  setenv("PATH", before.c_str(), 1);
  ASSERT_FALSE(missing);
  EXPECT_NE(missing.error().message().find("node: found no program of this name"), std::string::npos)
      << missing.error().message();
}

TEST_F(Certify, TheJavaScriptOfAModel) {
  if (std::system("command -v node >/dev/null") != 0) GTEST_SKIP() << "node is not here";
  const auto model = support::s4FiveRegions();
  std::ofstream(folder_.file("force_model.js")) << exchange::jsForce(model);
  const Certificate forces = certified({"node:" + folder_.file("force_model.js"), {}});
  EXPECT_TRUE(forces.ok()) << forces.failure;
  EXPECT_FALSE(forces.has_tube);
  std::ofstream(folder_.file("tube.js")) << exchange::jsTube(model).value();
  for (const char* const named : {"force_model.js", "tube.js"}) {
    const Certificate felt = certified({"node:" + folder_.file(named), {}});
    EXPECT_TRUE(felt.ok()) << felt.failure;
    EXPECT_TRUE(felt.has_tube);
    EXPECT_EQ(felt.steps.right, felt.steps.all);
  }
}

TEST_F(Certify, AProgramThatListens) {
  for (const bool tcp : {false, true}) {
    const std::string place = folder_.file(tcp ? "port" : "socket");
    const pid_t child = ::fork();
    if (child == 0) {
      ::execl(TACTUS_SIMULATOR, "simulator", model_.c_str(), tcp ? "--tcp" : "--unix", place.c_str(),
              static_cast<char*>(nullptr));
      ::_exit(127);
    }
    while (!fs::exists(place) && ::waitpid(child, nullptr, WNOHANG) == 0) ::usleep(1000);
    std::string target = "unix:" + place;
    if (tcp) {
      std::string port;
      std::ifstream(place) >> port;
      target = "tcp:127.0.0.1:" + port;
    }
    expectCertified(certified({target, {}}));
    EXPECT_EQ(::waitpid(child, nullptr, 0), child);
    const auto gone = certify({target, {}}, questions(), {}, {});
    ASSERT_FALSE(gone);
    EXPECT_NE(gone.error().message().find("wanted a program that listens there"), std::string::npos)
        << gone.error().message();
  }
}

TEST_F(Certify, WhatCannotBeStartedIsRefused) {
  const auto none = certify({folder_.file("none"), {}}, questions(), {}, {});
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().message().find("found no program of this name"), std::string::npos) << none.error().message();
  const auto no_program = certify({model_, {}}, questions(), {}, {});
  ASSERT_FALSE(no_program);
  EXPECT_NE(no_program.error().message().find("Permission denied"), std::string::npos) << no_program.error().message();
  for (const char* const name : {"tcp:", "tcp:host", "tcp:host:", "tcp:host:0", "tcp:host:99999", "unix:", "node:", ""})
    EXPECT_FALSE(targetMistake(name).empty()) << name;
  for (const char* const name : {"tcp:host:80", "tcp:[::1]:80", "unix:/x", "node:a.js", "./a", "a.so"})
    EXPECT_TRUE(targetMistake(name).empty()) << name;
}

TEST(CertifyPercentiles, AreNearestRanks) {
  std::vector<double> values;
  for (int i = 1000; i >= 1; --i) values.push_back(i);
  const Percentiles of = percentilesOf(values);
  EXPECT_EQ(of.half, 500);
  EXPECT_EQ(of.p99, 990);
  EXPECT_EQ(of.p999, 999);
  EXPECT_EQ(of.largest, 1000);
  EXPECT_EQ(percentilesOf({}).largest, 0);
  EXPECT_EQ(percentilesOf({7}).half, 7);
}

}  // namespace
}  // namespace tactus::certify
