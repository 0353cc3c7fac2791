// `pull` on the command line: its numbers are those of core/analysis/pull, here its words, its JSON, its files and
// refusals.
#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/model_io/model_file.h"
#include "core/store/model_versions.h"
#include "elicitation/model/model_provenance.h"

#include "tests/app/cli/run_program.h"
#include "tests/support/invented_experts.h"
#include "tests/support/ngt_model.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

using PullJson = nlohmann::json;

constexpr const char* kPulled = "lubrication=1,neck_flexion=60,depth=200,speed=50";

class PullCommandTest : public testing::Test {
 protected:
  PullCommandTest() {
    auto s4 = support::s4FiveRegions();
    s4.provenance = fuzzy::Provenance{"A study", {}, {}, "Simulated."};
    EXPECT_TRUE(elicitation::setChecks(s4));
    EXPECT_TRUE(model_io::writeModel(s4, s4_));
    EXPECT_TRUE(model_io::writeModel(support::inventedExperts(), four_));
  }

  PullJson pulled(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "pull");
    arguments.push_back("--json");
    const ProgramRun run(arguments);
    EXPECT_EQ(run.status, 0) << run.err;
    return PullJson::parse(run.out);
  }

  void expectRefused(std::vector<std::string> arguments, int status, const std::string& says) const {
    arguments.insert(arguments.begin(), "pull");
    const ProgramRun run(arguments);
    EXPECT_EQ(run.status, status) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_NE(run.err.find(says), std::string::npos) << run.err;
  }

  support::TempFolder folder_;
  std::string s4_ = folder_.file("s4.tactus.json");
  std::string four_ = folder_.file("four.tactus.json");
  std::string out_ = folder_.file("out.tactus.json");
};

TEST_F(PullCommandTest, TheMembersOfItsJson) {
  const PullJson found = pulled({s4_, "--at", kPulled, "--force", "0.55"});
  EXPECT_NEAR(found["before_n"].get<double>(), .589444, 5e-7);
  EXPECT_EQ(found["target_n"], .55);
  EXPECT_LT(found["reachable"]["min_n"], found["reachable"]["max_n"]);
  EXPECT_TRUE(found["blocker"].is_null());
  const PullJson& best = found["candidates"][0];
  EXPECT_EQ(best["kind"], "place");
  EXPECT_EQ(best["gesture"], "q");
  EXPECT_EQ(best["variable"], "depth");
  EXPECT_EQ(best["gap"], "laryngopharynx/esophagus");
  EXPECT_TRUE(best["rule"].is_null());
  EXPECT_TRUE(best["then"].is_null());
  EXPECT_NEAR(best["delta"].get<double>(), -12.8926, 5.1e-5);
  EXPECT_NEAR(best["force_n"].get<double>(), .55, 1e-9);
  EXPECT_NEAR(best["k"].get<double>(), .0904, 5.1e-5);
  EXPECT_NEAR(best["k_curve"].get<double>(), .0647, 5.1e-5);
  EXPECT_NEAR(best["k_box"].get<double>(), .1102, 5.1e-5);
  EXPECT_GT(best["largest_n"], 0);
  EXPECT_EQ(best["folded"], false);
  EXPECT_EQ(best["text"], "Depth, laryngopharynx/esophagus: the transition ends at 202.107 instead of 215.000 mm");
  bool word = false;
  for (const PullJson& one : found["candidates"]) {
    if (one["gesture"] != "word") continue;
    word = true;
    EXPECT_EQ(one["kind"], "rule");
    EXPECT_TRUE(one["variable"].is_null());
    EXPECT_EQ(one["rule"], 28);
    EXPECT_EQ(one["then"], "very_small");
    EXPECT_EQ(one["folded"], true);
    EXPECT_EQ(one["text"],
              "S4, rule 28 (Neck flexion large, Depth laryngopharynx): very_small instead of large; comes only to "
              "0.519 N; contradicts "
              "S4's answer");
  }
  EXPECT_TRUE(word);
}

// Each edit is written and evaluated by another command; the file differs in the edit and in what says so.
TEST_F(PullCommandTest, EachEditCanBeWritten) {
  const PullJson found = pulled({s4_, "--at", kPulled, "--force", "0.55"});
  const std::string points = folder_.file("points.csv");
  writeText(points, "lubrication,neck_flexion,depth,speed\n1,60,200,50\n");
  const PullJson before = PullJson::parse(readText(s4_));
  for (std::size_t k = 0; k < found["candidates"].size(); ++k) {
    const ProgramRun run(
        {"pull", s4_, "--at", kPulled, "--force", "0.55", "--apply", std::to_string(k + 1), "--out", out_});
    ASSERT_EQ(run.status, 0) << run.err;
    const std::string text = found["candidates"][k]["text"];
    EXPECT_NE(run.out.find(text), std::string::npos) << run.out;
    const ProgramRun eval({"eval", out_, "--in", points});
    ASSERT_EQ(eval.status, 0) << eval.err;
    const auto last = eval.out.substr(0, eval.out.rfind(','));
    EXPECT_NEAR(std::stod(last.substr(last.rfind(',') + 1)), found["candidates"][k]["force_n"].get<double>(), 1e-14);
    PullJson after = PullJson::parse(readText(out_));
    EXPECT_EQ(after["provenance"]["notes"], "Simulated. " + text + ".");
    PullJson same = before;
    for (const char* key : {"inputs", "output", "experts", "created_utc", "generator", "checks"}) {
      same.erase(key);
      after.erase(key);
    }
    same["provenance"].erase("notes");
    after["provenance"].erase("notes");
    EXPECT_EQ(after, same);
  }
}

// Rule 3 to Large: more force well lubricated than at medium lubrication (rule 8, small), against nearly all other
// steps.
TEST_F(PullCommandTest, NewFindingsOfTheLintAreSaid) {
  const PullJson found = pulled({s4_, "--at", kPulled, "--force", "0.62"});
  std::size_t checked = 0;
  for (std::size_t k = 0; k < found["candidates"].size(); ++k) {
    const PullJson& one = found["candidates"][k];
    const bool rule = one["gesture"] == "word" && one["rule"] == 3;
    if (!rule && one["gesture"] != "p") continue;
    ++checked;
    const ProgramRun run(
        {"pull", s4_, "--at", kPulled, "--force", "0.62", "--apply", std::to_string(k + 1), "--out", out_});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.err.find("new finding: S4: ") != std::string::npos, rule) << run.err;
  }
  EXPECT_GE(checked, 2U);
}

TEST_F(PullCommandTest, EachCandidateSaysWhatItContradictsAndNewlyFinds) {
  const PullJson found = pulled({s4_, "--at", kPulled, "--force", "0.62"});
  std::size_t words = 0;
  for (const PullJson& one : found["candidates"]) {
    const bool says_otherwise = one["gesture"] == "word" || one["gesture"] == "off";
    words += says_otherwise ? 1 : 0;
    EXPECT_EQ(one["contradicts"], says_otherwise ? PullJson::array({"S4"}) : PullJson::array());
    EXPECT_EQ(one["text"].get<std::string>().find("contradicts S4's answer") != std::string::npos, says_otherwise);
    const bool is_checked = one["gesture"] == "p" || (one["gesture"] == "word" && one["rule"] == 3);
    EXPECT_TRUE(!is_checked || one["new_findings"].empty() == (one["gesture"] == "p")) << one;
  }
  EXPECT_GE(words, 4U);  // rules 3, 4, 23 and 24 to Large (oracle 2)
}

TEST_F(PullCommandTest, RulesAndPointsCanBeHeld) {
  const PullJson locked = pulled({s4_, "--at", kPulled, "--force", "0.62", "--lock", "rules"});
  for (const PullJson& one : locked["candidates"]) EXPECT_TRUE(one["rule"].is_null());
  EXPECT_FALSE(locked["candidates"].empty());
  const char* const throat = "lubrication=1,neck_flexion=60,depth=150,speed=50";
  const PullJson held = pulled({s4_, "--at", throat, "--force", "0.6", "--lock", "lubrication", "neck_flexion", "depth",
                                "speed", "force", "rules"});
  EXPECT_EQ(held["blocker"], "the rules are locked, and without the lock one edit is enough");
  const PullJson pinned = pulled({s4_, "--at", kPulled, "--force", "0.5", "--pin", "depth=200.5"});
  EXPECT_EQ(pinned["blocker"], "the pinned points stay, and without the pins one edit is enough");
  expectRefused({s4_, "--at", kPulled, "--force", "0.5", "--pin", "dpth=1"}, 1,
                "--pin: found 'dpth', wanted an input of the model");
  expectRefused({s4_, "--at", kPulled, "--force", "0.5", "--pin", "depth=700"}, 1,
                "--pin depth: found 700, wanted a value from 0 to 600");
}

TEST_F(PullCommandTest, SignOffsOnTheModelAreSaid) {
  const std::string study = folder_.file("a.tactus");
  ASSERT_EQ(ProgramRun({"study", "new", study}).status, 0);
  {
    auto file = store::StudyFile::open(study);
    ASSERT_TRUE(file);
    study::RecordIds ids;
    const auto add = [&](const std::string& label, fuzzy::ForceModel model) {
      study::ModelVersion version;
      version.id = ids.next();
      version.utc_ms = 1'770'000'000'000;
      version.author = "S4";
      version.label = label;
      version.text = model_io::formatModel(model);
      EXPECT_TRUE(store::append(*file, version));
    };
    auto same = support::s4FiveRegions();  // the model of the test has checks and a provenance besides
    add("edit: S4: rule 1", same);
    add("sign-off: feels right, after 1 edit: 4 strokes on Touch", same);
    same.experts[0].rules[0].weight = 0.5;
    add("sign-off: approved without feeling, after 2 edits", same);
  }
  const ProgramRun run({"pull", s4_, "--at", kPulled, "--force", "0.55", "--study", study, "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const PullJson found = PullJson::parse(run.out);
  ASSERT_EQ(found["sign_offs"].size(), 1U);
  EXPECT_EQ(found["sign_offs"][0]["author"], "S4");
  EXPECT_EQ(found["sign_offs"][0]["text"], "feels right, after 1 edit: 4 strokes on Touch");
  EXPECT_EQ(
      unwrapped(run.err),
      "tactus: warning: every edit contradicts a sign-off: S4, 2026-02-02T02:40:00Z: feels right, after 1 edit: 4 "
      "strokes on Touch\n");
  expectRefused({s4_, "--at", kPulled, "--force", "0.55", "--study", s4_}, 1, "wanted a Tactus study file");
}

TEST_F(PullCommandTest, InWords) {
  const ProgramRun one({"pull", s4_, "--at", kPulled, "--force", "0.55"});
  EXPECT_EQ(one.status, 0);
  EXPECT_TRUE(one.out.starts_with("0.589 N here, wanted 0.550 N. Within reach: ")) << one.out;
  EXPECT_NE(
      one.out.find("\n1   Depth, laryngopharynx/esophagus: the transition ends at 202.107 instead of 215.000 mm\n"),
      std::string::npos)
      << one.out;
  EXPECT_NE(one.out.find(" more with --json"), std::string::npos);
  const ProgramRun mean({"pull", four_, "--at", kPulled, "--force", "0.56"});
  EXPECT_NE(mean.out.find("A rule belongs to one expert"), std::string::npos) << mean.out;
  const ProgramRun shared({"pull", four_, "--at", kPulled, "--force", "0.56", "--expert", "S4"});
  EXPECT_NE(shared.err.find("an edit of them changes the forces of others than S4"), std::string::npos) << shared.err;
}

TEST_F(PullCommandTest, WhatCannotBeReachedSaysWhy) {
  const char* const nose = "lubrication=1,neck_flexion=60,depth=30,speed=50";
  const PullJson found = pulled({s4_, "--at", nose, "--force", "0.1", "--lock", "force"});
  EXPECT_EQ(found["blocker"], "the centroid of very_small: no word alone goes below 0.127 N");
  EXPECT_TRUE(found["candidates"].empty());
  const PullJson far = pulled({s4_, "--at", "lubrication=1,neck_flexion=60,depth=300,speed=50", "--force", "1"});
  EXPECT_EQ(far["blocker"], "one rule is not enough, the words of the other rules hold the force");
  EXPECT_EQ(far["candidates"].size(), 2U);
  auto model = support::s4FiveRegions();
  model.experts[0].rules = {{{{"speed", "fast"}}, "large"}};
  ASSERT_TRUE(model_io::writeModel(model, s4_));
  const PullJson hole = pulled({s4_, "--at", kPulled, "--force", "0.3"});
  EXPECT_EQ(hole["blocker"], "no rule fires here");
  EXPECT_TRUE(hole["before_n"].is_null());
  EXPECT_TRUE(hole["reachable"].is_null());
}

// Terms that do not sum to one have no ramps; their vertices move alone.
TEST_F(PullCommandTest, SingleVertices) {
  auto model = support::s4FiveRegions();
  model.inputs[2].terms[2].points[3] += 5;
  ASSERT_TRUE(model_io::writeModel(model, s4_));
  const PullJson found = pulled({s4_, "--at", kPulled, "--force", "0.55"});
  bool vertex = false;
  for (const PullJson& one : found["candidates"]) {
    if (one["variable"] != "depth") continue;
    vertex = true;
    EXPECT_EQ(one["gesture"], "vertex");
    EXPECT_EQ(std::string(one["gap"]).find('/'), std::string::npos);
    EXPECT_NE(std::string(one["text"]).find(": vertex "), std::string::npos) << one["text"];
  }
  EXPECT_TRUE(vertex);
}

TEST_F(PullCommandTest, ToAReferenceCurve) {
  auto planted = support::s4FiveRegions();
  for (const std::size_t vertex : {2U, 3U}) planted.inputs[2].terms[2].points[vertex] += 8;
  for (const std::size_t vertex : {0U, 1U}) planted.inputs[2].terms[3].points[vertex] += 8;
  const std::string other = folder_.file("planted.tactus.json");
  ASSERT_TRUE(model_io::writeModel(planted, other));
  std::string points = "lubrication,neck_flexion,depth,speed\n";
  for (int depth_mm = 0; depth_mm <= 600; depth_mm += 2) points += "1,60," + std::to_string(depth_mm) + ",50\n";
  const std::string in = folder_.file("in.csv");
  const std::string reference = folder_.file("reference.csv");
  writeText(in, points);
  ASSERT_EQ(ProgramRun({"eval", other, "--in", in, "--out", reference}).status, 0);

  const PullJson found = pulled({s4_, "--at", kPulled, "--curve", reference});
  EXPECT_TRUE(found["target_n"].is_null());
  EXPECT_TRUE(found["blocker"].is_null());
  EXPECT_GT(found["residual_n"], .005);
  EXPECT_EQ(found["candidates"][0]["gesture"], "shift");
  EXPECT_NEAR(found["candidates"][0]["delta"].get<double>(), 8, 1e-9);
  EXPECT_LT(found["candidates"][0]["residual_n"], 1e-12);
  EXPECT_EQ(
      found["candidates"][0]["text"],
      "Depth, laryngopharynx/esophagus: the transition runs from 193.000 to 223.000 instead of 185.000 to 215.000 mm; "
      "leaves 0.000 N");
  const ProgramRun written({"pull", s4_, "--at", kPulled, "--curve", reference, "--apply", "1", "--out", out_});
  ASSERT_EQ(written.status, 0) << written.err;
  const ProgramRun difference({"diff", out_, other, "--json"});
  EXPECT_LT(PullJson::parse(difference.out)["force"]["largest_n"].get<double>(), 1e-12) << difference.out;

  // The same curve by depths alone, and a band.
  writeText(reference, "depth,force_min\n125,0.5\n150,0.5\n185,0.5\n");
  const ProgramRun band({"pull", s4_, "--at", kPulled, "--curve", reference});
  EXPECT_EQ(band.status, 0) << band.err;
  EXPECT_NE(band.out.find("N (root mean square) from the reference."), std::string::npos) << band.out;

  // As the workbench writes its curves: units in the names, gaps.
  writeText(reference, "depth_mm,force_n\n200,0.6\n210,\n");
  const PullJson one = pulled({s4_, "--at", kPulled, "--curve", reference});
  EXPECT_NEAR(one["residual_n"].get<double>(), .6 - .589444, 5.1e-7) << "the point that is no gap";
}

TEST_F(PullCommandTest, WrongReferencesAreRefused) {
  const std::string reference = folder_.file("reference.csv");
  const auto refused = [&](const std::string& text, const std::string& says) {
    writeText(reference, text);
    expectRefused({s4_, "--at", kPulled, "--curve", reference}, 1, says);
  };
  refused("mm,force\n1,0.5\n", "header: found mm, force, wanted a column of an input: lubrication, ");
  refused("depth\n1\n", "header: found depth, wanted a column force, or force_min, force_max or both");
  refused("depth,force,force_min\n1,0.5,0.5\n", "wanted either force, or force_min and force_max");
  refused("depth,force\n", "found 0 rows, wanted 1 to 10000");
  refused("depth,force\n700,0.5\n", "line 2, column 'depth': found '700', wanted a value from 0 to 600");
  refused("depth,force\n70,much\n", "line 2, column 'force': found 'much'");
  refused("depth,force_min,force_max\n70,0.5,0.4\n", "found '0.4', wanted at least force_min, which is 0.5");
  expectRefused({s4_, "--at", kPulled, "--curve", folder_.file("none.csv")}, 1, "none.csv");
  expectRefused({s4_, "--at", kPulled}, 2, "--force or --curve is required");
}

TEST_F(PullCommandTest, WrongQuestionsAreRefused) {
  expectRefused(
      {s4_, "--at", "lubrication=0,5", "--force", "0.5"}, 1,
      "--at: found '5' after a comma, wanted INPUT=VALUE; a comma separates entries and the decimal sign is a point, "
      "as in lubrication=0.5");
  expectRefused({s4_, "--at", "wetness=1", "--force", "0.5"}, 1, "--at: found 'wetness', wanted an input of the model");
  expectRefused({s4_, "--at", "lubrication=1,neck_flexion=60,depth=700,speed=50", "--force", "0.5"}, 1,
                "--at depth: found 700, wanted a value from 0 to 600");
  expectRefused({s4_, "--at", kPulled, "--force", "0.5", "--expert", "S9"}, 1, "found 'S9', wanted one of S4");
  expectRefused({s4_, "--at", kPulled, "--force", "much"}, 2, "--force: found 'much', wanted a finite force");
  expectRefused({s4_, "--at", kPulled, "--force", "0.5", "--lock", "dpth"}, 1,
                "--lock: found 'dpth', wanted a variable of the model: ");
  expectRefused({s4_, "--at", kPulled, "--force", "0.5", "--apply", "1"}, 2, "--apply requires --out");
  expectRefused({s4_, "--at", kPulled, "--force", "0.5", "--apply", "700", "--out", out_}, 1,
                "--apply: found 700, wanted a number from 1 to ");
  expectRefused({s4_, "--at", kPulled, "--force", "0.5", "--apply", "1", "--out", s4_}, 1,
                "--out: found a file that the command reads, wanted another file");
  EXPECT_FALSE(std::filesystem::exists(out_));
}

}  // namespace
}  // namespace tactus::cli
