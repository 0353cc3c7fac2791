// `bundle`, `verify`, `convert` and `diff` on the command line.
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/bundle/zip.h"
#include "core/base/files/checksums.h"
#include "core/model_io/model_file.h"

#include "tests/app/cli/run_program.h"
#include "tests/support/ngt_model.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

using Json = nlohmann::json;

class DeliveryTest : public testing::Test {
 protected:
  std::string modelFile(const std::string& name, const fuzzy::ForceModel& model) const {
    const std::string path = folder_.file(name);
    EXPECT_TRUE(model_io::writeModel(model, path));
    return path;
  }

  support::TempFolder folder_;
};

TEST_F(DeliveryTest, ABundleIsWrittenAndVerified) {
  const std::string model = modelFile("m.json", support::s4FiveRegions());
  const std::string out = folder_.file("bundle");
  const ProgramRun made({"bundle", model, "--out", out, "--table-error", "0.2"});
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_NE(made.out.find("experts/S4.fis  linspace:101, largest error"), std::string::npos) << made.out;
  const ProgramRun verified({"verify", out, "--json"});
  ASSERT_EQ(verified.status, 0) << verified.err;
  const Json result = Json::parse(verified.out);
  EXPECT_EQ(result["ok"], true);
  // The fingerprint is that of the manifest, and the way to see that somebody wrote another one.
  const std::string fingerprint = result["fingerprint"];
  EXPECT_EQ(fingerprint, base::sha256(readText(out + "/manifest.json")));
  EXPECT_NE(made.out.find(fingerprint), std::string::npos) << made.out;
  EXPECT_EQ(ProgramRun({"verify", out, "--expect", fingerprint}).status, 0);
  const ProgramRun other({"verify", out, "--expect", std::string(64, '0')});
  EXPECT_EQ(other.status, 1);
  EXPECT_NE(other.err.find("found the fingerprint " + fingerprint), std::string::npos) << other.err;
  for (const Json& file : result["files"]) {
    EXPECT_EQ(file["ok"], true) << file;
    EXPECT_TRUE(file.contains("path") && file.contains("largest_error_n") && file.contains("tolerance_n"));
    if (!file["tolerance_n"].is_null()) {
      EXPECT_LE(file["largest_error_n"], file["tolerance_n"]);
    }
  }
}

TEST_F(DeliveryTest, AnAlteredFileIsExitOneWithItsName) {
  const std::string out = folder_.file("bundle");
  ASSERT_EQ(ProgramRun({"bundle", modelFile("m.json", support::s4FiveRegions()), "--out", out, "--table-error", "0.2"})
                .status,
            0);
  writeText(out + "/experts/S4.fll", readText(out + "/experts/S4.fll") + "#\n");
  const ProgramRun verified({"verify", out, "--json"});
  EXPECT_EQ(verified.status, 1);
  EXPECT_NE(verified.err.find("experts/S4.fll"), std::string::npos) << verified.err;
  EXPECT_EQ(Json::parse(verified.out)["ok"], false);
  const ProgramRun none({"verify", folder_.file("nowhere")});
  EXPECT_EQ(none.status, 1);
  EXPECT_NE(none.err.find("nowhere: found nothing of this name"), std::string::npos);
}

TEST_F(DeliveryTest, ABundleIsOneZipFileToo) {
  const std::string model = modelFile("m.json", support::s4FiveRegions());
  const std::string zip = folder_.file("sent/s4.zip");
  ASSERT_EQ(ProgramRun({"bundle", model, "--out", zip, "--table-error", "0.2"}).status, 0);
  const ProgramRun verified({"verify", zip, "--json"});
  ASSERT_EQ(verified.status, 0) << verified.err;

  // Its files are those of a folder, in a folder of its name, and verify there as well.
  const auto files = bundle::unzipped(zip);
  ASSERT_TRUE(files) << files.error().message();
  const std::string unpacked = folder_.file("unpacked");
  for (const auto& [path, bytes] : *files) {
    std::filesystem::create_directories(std::filesystem::path(unpacked + "/" + path).parent_path());
    writeText(unpacked + "/" + path, bytes);
  }
  const ProgramRun folder({"verify", unpacked, "--json"});
  ASSERT_EQ(folder.status, 0) << folder.err;
  EXPECT_EQ(Json::parse(folder.out)["fingerprint"], Json::parse(verified.out)["fingerprint"]);
  EXPECT_EQ(bundle::zipped(*files, "s4"), readText(zip)) << "the same files give the same bytes";

  // One altered byte, and no longer a zip file.
  auto altered = *files;
  for (auto& [path, bytes] : altered) {
    if (path == "checks.csv") bytes.back() = ' ';
  }
  writeText(zip, *bundle::zipped(altered, "s4"));
  const ProgramRun wrong({"verify", zip});
  EXPECT_EQ(wrong.status, 1);
  EXPECT_NE(wrong.err.find("s4.zip/checks.csv"), std::string::npos) << wrong.err;
  writeText(zip, "no zip");
  EXPECT_EQ(ProgramRun({"verify", zip}).status, 1);
}

TEST_F(DeliveryTest, AZipFileWritesNothingOutsideItsFolder) {
  const std::string zip = folder_.file("bad.zip");
  for (const char* path : {"../outside", "/outside", "a/../../outside", "a\\b"}) {
    writeText(zip, *bundle::zipped({{path, "x"}}, ""));
    const auto files = bundle::unzipped(zip);
    ASSERT_FALSE(files) << path;
    EXPECT_NE(files.error().message().find("bad.zip"), std::string::npos) << files.error().message();
  }
}

TEST_F(DeliveryTest, AHoleStopsABundleUntilItIsAccepted) {
  const std::string model = modelFile("m.json", support::s4AsPrinted());
  const ProgramRun refused({"bundle", model, "--out", folder_.file("bundle")});
  EXPECT_EQ(refused.status, 1);
  const auto open = refused.err.find("--accept-hole '");
  ASSERT_NE(open, std::string::npos) << refused.err;
  EXPECT_FALSE(std::filesystem::exists(folder_.file("bundle")));
  const std::string name = refused.err.substr(open + 15, refused.err.rfind('\'') - open - 15);
  const ProgramRun made(
      {"bundle", model, "--out", folder_.file("bundle"), "--accept-hole", name, "--table-error", "0.2"});
  EXPECT_EQ(made.status, 0) << made.err;
}

TEST_F(DeliveryTest, ConvertsToEachFormat) {
  const std::string model = modelFile("m.json", support::s4Shifted());
  for (const auto& [to, file] : {std::pair{"fll", "S4.fll"},
                                 {"fcl", "S4.iec.fcl"},
                                 {"fcl-fuzzylite", "S4.fuzzylite.fcl"},
                                 {"fis", "S4.fis"},
                                 {"fml", "S4.fml"},
                                 {"c", "force_model.c"}}) {
    const ProgramRun made({"convert", model, "--to", to, "--out", folder_.file("out")});
    EXPECT_EQ(made.status, 0) << made.err;
    EXPECT_NE(made.out.find(file), std::string::npos) << made.out;
    EXPECT_FALSE(readText(folder_.file("out") + "/" + file).empty());
  }
  const ProgramRun said({"convert", model, "--to", "fis", "--out", folder_.file("out"), "--json"});
  ASSERT_EQ(said.status, 0) << said.err;
  const auto json = nlohmann::json::parse(said.out);
  ASSERT_FALSE(json["files"].empty());
  for (const auto& file : json["files"]) EXPECT_TRUE(std::filesystem::exists(file.get<std::string>())) << file;
  EXPECT_EQ(ProgramRun({"convert", model, "--to", "xls", "--out", folder_.file("out")}).status, 2);
}

TEST_F(DeliveryTest, FixesInputsInTheCSource) {
  const std::string model = modelFile("m.json", support::s4Shifted());
  const std::string out = folder_.file("out");
  const ProgramRun made(
      {"convert", model, "--to", "c", "--out", out, "--fix", "lubrication=1", "--fix", "neck_flexion=45"});
  ASSERT_EQ(made.status, 0) << made.err;
  const std::string header = readText(out + "/force_model.h");
  EXPECT_NE(header.find("#define FORCE_MODEL_INPUTS 2\n"), std::string::npos) << header;
  EXPECT_NE(header.find(" * Fixed:\n *   lubrication 1 1\n *   neck_flexion 45 deg\n"), std::string::npos) << header;
  for (const auto& [to, fix, says] : {std::tuple{"c", "lubrication", "INPUT=VALUE"},
                                      {"c", "wetness=1", "an input of the model: lubrication, neck_flexion"},
                                      {"fll", "lubrication=1", "--to c"}}) {
    const ProgramRun refused({"convert", model, "--to", to, "--out", out, "--fix", fix});
    EXPECT_EQ(refused.status, 1);
    EXPECT_NE(refused.err.find(says), std::string::npos) << refused.err;
  }
}

TEST_F(DeliveryTest, DiffNamesTermsRulesAndNewtons) {
  const auto first = support::s4Shifted();
  auto second = first;
  second.experts[0].rules[0].then = "very_large";
  second.inputs[0].terms[0].points[3] = 0.5;
  const std::string a = modelFile("a.json", first);
  const std::string b = modelFile("b.json", second);
  const ProgramRun same({"diff", a, a});
  EXPECT_EQ(same.status, 0);
  EXPECT_NE(same.out.find("no term, rule or setting differs"), std::string::npos);
  const ProgramRun differ({"diff", a, b, "--json"});
  EXPECT_EQ(differ.status, 0) << differ.err;  // differences are results, not failures
  const Json result = Json::parse(differ.out);
  EXPECT_EQ(result["changes"].size(), 2U);
  EXPECT_GT(result["force"]["largest_n"], 0.1);
  EXPECT_EQ(result["force"]["at"].size(), 4U);
  const ProgramRun text({"diff", a, b});
  EXPECT_NE(text.out.find("changed  term 'poor' of 'lubrication': trapezoid 0 0 0.2 0.4 -> trapezoid 0 0 0.2 0.5\n"),
            std::string::npos)
      << text.out;
  auto other = first;
  std::swap(other.inputs[0], other.inputs[1]);
  const ProgramRun refused({"diff", a, modelFile("c.json", other)});
  EXPECT_EQ(refused.status, 1);
}

}  // namespace
}  // namespace tactus::cli
