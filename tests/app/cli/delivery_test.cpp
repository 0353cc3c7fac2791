// `bundle`, `verify`, `convert` and `diff` on the command line.
#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/bundle/zip.h"
#include "core/base/files/checksums.h"
#include "core/model_io/model_file.h"
#include "core/store/model_versions.h"
#include "core/store/study_file.h"

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
  EXPECT_TRUE(result["signed_by"].is_null());
  const std::string groups = fingerprint.substr(0, 16) + " " + fingerprint.substr(16, 16) + " " +
                             fingerprint.substr(32, 16) + " " + fingerprint.substr(48);
  EXPECT_NE(made.out.find(groups), std::string::npos) << made.out;
  EXPECT_NE(ProgramRun({"verify", out}).out.find(groups), std::string::npos);
  std::string shouted = groups;
  std::transform(shouted.begin(), shouted.end(), shouted.begin(), ::toupper);
  for (const std::string& said : {fingerprint, groups, shouted})
    EXPECT_EQ(ProgramRun({"verify", out, "--expect", said}).status, 0) << said;
  for (const std::string& said : {std::string(64, '0'), fingerprint.substr(0, 16), fingerprint + "0"}) {
    const ProgramRun other({"verify", out, "--expect", said, "--json"});
    EXPECT_EQ(other.status, 1);
    EXPECT_NE(other.err.find("found the fingerprint " + groups), std::string::npos) << other.err;
    EXPECT_EQ(Json::parse(other.out)["ok"], false);
  }
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

/// A pair of keys of OpenSSH without a passphrase: `path`, `path`.pub.
void makeKey(const std::string& path) {
  ASSERT_EQ(std::system(("ssh-keygen -q -t ed25519 -N '' -C maria@lab -f '" + path + "'").c_str()), 0);
}

TEST_F(DeliveryTest, ABundleIsSignedByAKeyOfOpenSsh) {
  if (std::system("command -v ssh-keygen >/dev/null") != 0) GTEST_SKIP() << "ssh-keygen is not here";
  const std::string model = modelFile("m.json", support::s4FiveRegions());
  const std::string out = folder_.file("bundle");
  const std::string key = folder_.file("key");
  makeKey(key);
  makeKey(folder_.file("other"));
  ASSERT_EQ(ProgramRun({"bundle", model, "--out", out, "--table-error", "0.2"}).status, 0);
  const ProgramRun bare({"verify", out, "--key", key + ".pub"});
  EXPECT_EQ(bare.status, 1);
  EXPECT_NE(bare.err.find("found no signature"), std::string::npos) << bare.err;

  const ProgramRun made({"bundle", model, "--out", out, "--table-error", "0.2", "--sign", key});
  ASSERT_EQ(made.status, 0) << made.err;
  const ProgramRun good({"verify", out, "--key", key + ".pub", "--json"});
  ASSERT_EQ(good.status, 0) << good.err;
  EXPECT_TRUE(Json::parse(good.out)["signed_by"].get<std::string>().starts_with("SHA256:")) << good.out;
  // What OpenSSH itself says of it.
  writeText(folder_.file("signers"), "maria " + readText(key + ".pub"));
  EXPECT_EQ(std::system(("ssh-keygen -q -Y verify -f " + folder_.file("signers") + " -I maria -n tactus-bundle -s " +
                         out + "/manifest.json.sig < " + out + "/manifest.json")
                            .c_str()),
            0);
  const ProgramRun unasked({"verify", out, "--json"});
  EXPECT_EQ(unasked.status, 0) << unasked.err;
  EXPECT_TRUE(Json::parse(unasked.out)["signed_by"].is_null()) << "nobody said whose signature counts";

  const ProgramRun other({"verify", out, "--key", folder_.file("other.pub")});
  EXPECT_EQ(other.status, 1);
  EXPECT_NE(other.err.find("found a signature by another key, SHA256:"), std::string::npos) << other.err;
  for (const std::string& wrong : {key, folder_.file("none.pub"), model}) {
    const ProgramRun refused({"verify", out, "--key", wrong});
    EXPECT_EQ(refused.status, 1) << wrong;
    EXPECT_NE(refused.err.find(wrong), std::string::npos) << refused.err;
  }

  // A manifest that was written anew, with the signature of the old one.
  const std::string zip = folder_.file("b.zip");
  ASSERT_EQ(ProgramRun({"bundle", model, "--out", zip, "--table-error", "0.2", "--sign", key}).status, 0);
  EXPECT_EQ(ProgramRun({"verify", zip, "--key", key + ".pub"}).status, 0);
  std::string manifest = readText(out + "/manifest.json");
  manifest.insert(manifest.find('{') + 1, " ");
  writeText(out + "/manifest.json", manifest);
  EXPECT_EQ(ProgramRun({"verify", out}).status, 0);
  const ProgramRun forged({"verify", out, "--key", key + ".pub"});
  EXPECT_EQ(forged.status, 1);
  EXPECT_NE(forged.err.find("found a signature that does not fit"), std::string::npos) << forged.err;
  writeText(out + "/manifest.json.sig", "nonsense");
  EXPECT_EQ(ProgramRun({"verify", out, "--key", key + ".pub"}).status, 1);
}

TEST_F(DeliveryTest, ABundleThatCannotBeSignedIsNotWritten) {
  const std::string model = modelFile("m.json", support::s4FiveRegions());
  const std::string out = folder_.file("bundle");
  writeText(folder_.file("key"), "no key\n");
  const auto refused = [&](const std::string& key, const std::string& says) {
    for (const std::string& place : {out, out + ".zip"}) {
      const ProgramRun made({"bundle", model, "--out", place, "--table-error", "0.2", "--sign", key});
      EXPECT_EQ(made.status, 1);
      EXPECT_NE(made.err.find(says), std::string::npos) << made.err;
      EXPECT_FALSE(std::filesystem::exists(place));
    }
  };
  refused(folder_.file("none"), "none: found");
  const char* const path = std::getenv("PATH");
  const std::string before = path != nullptr ? path : "";
  if (std::system("command -v ssh-keygen >/dev/null") == 0)
    refused(folder_.file("key"), "found a key that ssh-keygen does not sign with");
  setenv("PATH", folder_.file("nothing").c_str(), 1);
  refused(folder_.file("key"), "ssh-keygen: found no program of this name, wanted that of OpenSSH");
  setenv("PATH", before.c_str(), 1);
}

TEST_F(DeliveryTest, AnExportedFileNamesTheModelThatItIsOf) {
  auto model = support::s4FiveRegions();
  model.created_utc = "2026-11-21T08:00:00Z";
  const std::string out = folder_.file("bundle");
  ASSERT_EQ(ProgramRun({"bundle", modelFile("m.json", model), "--out", out, "--table-error", "0.2"}).status, 0);
  const std::string own = out + "/model.tactus.json";
  const std::string sha256 = base::sha256(readText(own));
  for (const char* const name :
       {"experts/S4.fll", "experts/S4.iec.fcl", "experts/S4.fuzzylite.fcl", "experts/S4.fis", "experts/S4.fml",
        "c/force_model.h", "c/force_model.c", "table/README.txt", "report.html"}) {
    const std::string text = readText(out + "/" + name);
    EXPECT_NE(text.find("SHA-256 " + sha256), std::string::npos) << name;
    EXPECT_NE(text.find("tactus "), std::string::npos) << name;
    if (std::string(name) != "report.html") {
      EXPECT_NE(text.find("2026-11-21T08:00:00Z"), std::string::npos) << name;
    }
  }
  // The same model, exported alone, gives the same bytes.
  for (const auto& [to, name] :
       {std::pair{"fll", "experts/S4.fll"}, {"fis", "experts/S4.fis"}, {"c", "c/force_model.h"}}) {
    ASSERT_EQ(ProgramRun({"convert", own, "--to", to, "--out", folder_.file("out")}).status, 0);
    const std::string alone = folder_.file("out") + "/" + std::filesystem::path(name).filename().string();
    EXPECT_EQ(readText(alone), readText(out + "/" + name)) << name;
  }
}

TEST_F(DeliveryTest, VerifyTakesTheManifestTooAndThePresentFolder) {
  const std::string out = folder_.file("bundle");
  ASSERT_EQ(ProgramRun({"bundle", modelFile("m.json", support::s4FiveRegions()), "--out", out, "--table-error", "0.2"})
                .status,
            0);
  EXPECT_EQ(ProgramRun({"verify", out + "/manifest.json"}).status, 0);
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(out);
  EXPECT_EQ(ProgramRun({"verify"}).status, 0);
  EXPECT_EQ(ProgramRun({"verify", "."}).status, 0);
  EXPECT_EQ(ProgramRun({"verify", "manifest.json"}).status, 0);
  std::filesystem::current_path(folder_.file("."));
  const ProgramRun none({"verify"});
  EXPECT_EQ(none.status, 1);
  EXPECT_NE(none.err.find("the present folder: found no bundle"), std::string::npos) << none.err;
  std::filesystem::current_path(before);
}

TEST_F(DeliveryTest, TheApprovalsOfAModelGoAlongWithTheirEvidence) {
  const auto approved = support::s4FiveRegions();
  const std::string study = folder_.file("a.tactus");
  ASSERT_EQ(ProgramRun({"study", "new", study}).status, 0);
  {
    auto file = store::StudyFile::open(study);
    ASSERT_TRUE(file);
    study::ModelVersion version;
    version.id = study::RecordIds().next();
    version.utc_ms = 1'770'000'000'000;
    version.author = "S4";
    version.label = "sign-off: feels right, after 1 edit: 4 strokes on Touch, Nasal cavity to Oropharynx";
    version.text = model_io::formatModel(approved);
    ASSERT_TRUE(store::append(*file, version));
  }
  const std::string out = folder_.file("bundle");
  const ProgramRun made(
      {"bundle", modelFile("m.json", approved), "--out", out, "--table-error", "0.2", "--study", study});
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_EQ(made.err, "");
  const std::string evidence = "feels right, after 1 edit: 4 strokes on Touch, Nasal cavity to Oropharynx";
  EXPECT_NE(readText(out + "/report.html").find("Approved by S4, 2026-02-02T02:40:00Z: " + evidence),
            std::string::npos);
  EXPECT_NE(ProgramRun({"verify", out}).out.find("approved by S4, 2026-02-02T02:40:00Z: " + evidence),
            std::string::npos);
  const Json said = Json::parse(ProgramRun({"verify", out, "--json"}).out);
  ASSERT_EQ(said["sign_offs"].size(), 1U);
  EXPECT_EQ(said["sign_offs"][0]["text"], evidence);

  // Of another model there is none.
  auto other = approved;
  other.experts[0].rules[0].weight = 0.5;
  const ProgramRun unapproved(
      {"bundle", modelFile("o.json", other), "--out", out, "--table-error", "0.2", "--study", study});
  EXPECT_EQ(unapproved.status, 0);
  EXPECT_NE(unapproved.err.find("has no sign-off on this state of the model"), std::string::npos) << unapproved.err;
  EXPECT_FALSE(std::filesystem::exists(out + "/approvals.json"));
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
