// A reference under seal: before the elicitation, opened after the sign-off, with its trace in the report.
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/base/files/checksums.h"
#include "core/model_io/model_file.h"
#include "core/store/entries.h"
#include "core/store/model_versions.h"
#include "core/store/sealed_references.h"
#include "core/study/csv_tables.h"

#include "tests/app/cli/run_program.h"
#include "tests/support/default_procedure.h"
#include "tests/support/ngt_model.h"
#include "tests/support/table_study.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

constexpr const char* kCurve = "depth_mm,force_n\n30,0.1\n130,0.42\n170,0.58\n300,0.5\n500,0.2\n";

class StudySeal : public testing::Test {
 protected:
  void SetUp() override {
    writeText(curve_, kCurve);
    writeText(key_, "stones and rivers\n");
    ASSERT_EQ(ProgramRun({"study", "new", study_}).status, 0);
  }

  ProgramRun seal(std::vector<std::string> more = {}) const {
    std::vector<std::string> all = {"study", "seal", study_, curve_, "--passphrase-file", key_};
    all.insert(all.end(), more.begin(), more.end());
    return ProgramRun(all);
  }
  ProgramRun open(std::vector<std::string> more = {}, const std::string& key = {}) const {
    std::vector<std::string> all = {"study", "open", study_, "--passphrase-file", key.empty() ? key_ : key};
    all.insert(all.end(), more.begin(), more.end());
    return ProgramRun(all);
  }
  /// Two participants with strokes, judgements and answers.
  void elicit(bool simulated) const {
    auto study = support::tableStudy(1, {.nurses = 2, .rows_per_s = 60});
    for (auto& one : study.participants) one.simulated = simulated;
    ASSERT_TRUE(study::writeStudyFolder(study, support::ngtInputIds(), folder_.file("tables")));
    const ProgramRun run({"study", "import", study_, folder_.file("tables")});
    ASSERT_EQ(run.status, 0) << run.err;
  }
  void addVersion(const std::string& label) {
    auto file = store::StudyFile::open(study_);
    ASSERT_TRUE(file);
    study::ModelVersion version;
    version.id = ids_.next();
    version.utc_ms = 1'000;  // a clock that was set back hides nothing
    version.author = "Q. Editor";
    version.label = label;
    version.text = model_io::formatModel(support::s4FiveRegions());
    ASSERT_TRUE(store::append(*file, version));
  }
  std::string page() const {
    const ProgramRun run({"report", study_, "--out", folder_.file("R.html"), "--replicates", "20"});
    EXPECT_EQ(run.status, 0) << run.err;
    return readText(folder_.file("R.html"));
  }

  support::TempFolder folder_;
  study::RecordIds ids_;
  std::string study_ = folder_.file("a.tactus");
  std::string curve_ = folder_.file("reference.csv");
  std::string key_ = folder_.file("key.txt");
};

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST_F(StudySeal, FromSealToReport) {
  const auto sealed = seal({"--note", "bench, 2026", "--at", "speed=80", "--json"});
  ASSERT_EQ(sealed.status, 0) << sealed.err;
  const auto json = nlohmann::json::parse(sealed.out);
  EXPECT_EQ(json["sha256"], base::sha256(kCurve));
  EXPECT_EQ(json["points"], 5);
  EXPECT_EQ(json["late"], false);
  EXPECT_FALSE(has(readText(study_), "170,0.58"));  // nothing of the curve is readable

  elicit(false);
  EXPECT_TRUE(has(page(), "Not opened."));
  const auto soon = open();
  EXPECT_EQ(soon.status, 1);
  EXPECT_TRUE(has(unwrapped(soon.err), "no model that is signed off")) << soon.err;

  addVersion("sign-off: feels right, after 1 edit");
  const auto opened = open({"--out", folder_.file("back.csv")});
  ASSERT_EQ(opened.status, 0) << opened.err;
  EXPECT_EQ(readText(folder_.file("back.csv")), kCurve);
  EXPECT_TRUE(has(opened.out, "opened once")) << opened.out;
  EXPECT_TRUE(has(open().out, "opened twice"));

  addVersion("edit: S4: rule 1");
  const std::string text = page();
  EXPECT_TRUE(has(text, "Insertion speed 80 mm/s"));
  EXPECT_TRUE(has(text, "Opening 2 at "));
  EXPECT_FALSE(has(text, "Opening 3 at "));
  EXPECT_TRUE(has(text, "<th scope=\"row\">Signed off before the opening</th>"));
  EXPECT_TRUE(has(text, "Does the reference lie inside the bands?"));
  EXPECT_TRUE(has(text, "1 version of the model came after an opening"));
  EXPECT_TRUE(has(text, "Q. Editor"));
  EXPECT_TRUE(has(text, "edit: S4: rule 1"));
  EXPECT_EQ(ProgramRun({"study", "check", study_}).status, 0);
}

TEST_F(StudySeal, LateAndEarlyAreMarkedAndSimulatedDataAreNoEvidence) {
  elicit(true);
  const auto refused = seal();
  EXPECT_EQ(refused.status, 1);
  EXPECT_TRUE(has(unwrapped(refused.err), "whose elicitation has begun")) << refused.err;
  const auto late = seal({"--late"});
  ASSERT_EQ(late.status, 0) << late.err;
  EXPECT_TRUE(has(late.out, "late")) << late.out;
  EXPECT_EQ(seal({"--late"}).status, 1);  // one reference for a study
  const auto early = open({"--early"});
  ASSERT_EQ(early.status, 0) << early.err;
  const std::string text = page();
  EXPECT_TRUE(has(text, "after the elicitation began"));
  EXPECT_TRUE(has(text, "early: no model was signed off"));
  EXPECT_TRUE(has(text, "A sign-off before the opening"));
  EXPECT_TRUE(has(text, "they are no evidence for any model"));
  EXPECT_FALSE(has(text, "<strong>Done</strong>"));
}

TEST_F(StudySeal, AWrongPassphraseIsOneSentenceAndLeavesTheSealClosed) {
  ASSERT_EQ(seal().status, 0);
  const std::string wrong = folder_.file("wrong.txt");
  writeText(wrong, "stones and river\n");
  const auto run = open({"--early"}, wrong);
  EXPECT_EQ(run.status, 1);
  EXPECT_TRUE(has(unwrapped(run.err), "a passphrase that does not open it")) << run.err;
  writeText(wrong, "short\n");
  EXPECT_TRUE(has(unwrapped(open({"--early"}, wrong).err), "8 to 500 bytes"));
  const auto file = store::StudyFile::open(study_, {store::Access::kReadOnly, {}});
  ASSERT_TRUE(file);
  EXPECT_TRUE(store::sealedTrials(*file)->front().openings.empty());
}

// A record of another program can hold anything: each is a finding of the check, and opens nothing.
TEST_F(StudySeal, RecordsThatAreNoneAreFindings) {
  ASSERT_EQ(seal().status, 0);
  {
    auto file = store::StudyFile::open(study_);
    ASSERT_TRUE(file);
    const auto events = store::events(*file);
    ASSERT_EQ(events->size(), 1U);
    auto event = events->front();
    event.entry.id = ids_.next();
    const auto at = event.detail.find("\"cipher\"");
    event.detail = event.detail.substr(0, at) + "\"cipher\": \"AAAA\"}";
    ASSERT_TRUE(store::append(*file, event));
    event.entry.id = ids_.next();
    event.kind = "reference_opened";
    event.detail =
        R"({"reference": "00000000000000000000000000000001", "early": false, "content": "x", "versions": [], "records": {}})";
    ASSERT_TRUE(store::append(*file, event));
  }
  const ProgramRun check({"study", "check", study_});
  EXPECT_TRUE(has(unwrapped(check.out), "base64 of 16 to ")) << check.out;
  EXPECT_TRUE(has(unwrapped(check.out), "of sealed reference 00000000000000000000000000000001, which is missing"))
      << check.out;
  EXPECT_EQ(open({"--early"}).status, 1);
}

TEST_F(StudySeal, ReferencesThatAreRefused) {
  const auto refusal = [&](const std::string& csv) {
    writeText(curve_, csv);
    const auto run = seal();
    EXPECT_EQ(run.status, 1) << csv;
    return unwrapped(run.err);
  };
  EXPECT_TRUE(has(refusal("depth_cm,force_n\n1,0.1\n2,0.2\n"), "one column depth or depth_mm"));
  EXPECT_TRUE(has(refusal("depth_mm,force_mn\n1,100\n2,200\n"), "one column force or force_n"));
  EXPECT_TRUE(has(refusal("depth_mm,force_n\n10,0.1\n6000,0.2\n"), "line 3"));
  EXPECT_TRUE(has(refusal("depth_mm,force_n\n10,0.1\n20,-0.2\n"), "a force of 0 N or more"));
  EXPECT_TRUE(has(refusal("depth_mm,force_n\n10,0.1\n10,0.2\n"), "more than the depth before"));
  EXPECT_TRUE(has(refusal("depth_mm,force_n\n10,0.1\n20,\n"), "1 points"));
  writeText(curve_, kCurve);
  EXPECT_TRUE(has(unwrapped(seal({"--at", "depth=50"}).err), "another input than the depth"));
  EXPECT_TRUE(
      has(unwrapped(ProgramRun({"study", "open", study_, "--passphrase-file", key_}).err), "no sealed reference"));
}

// A full export and its import keep the seal and its openings.
TEST_F(StudySeal, TravelsWithTheExport) {
  ASSERT_EQ(seal().status, 0);
  ASSERT_EQ(open({"--early"}).status, 0);
  ASSERT_EQ(ProgramRun({"study", "export", study_, folder_.file("all")}).status, 0);
  const std::string again = folder_.file("again.tactus");
  const ProgramRun import({"study", "import", again, folder_.file("all")});
  ASSERT_EQ(import.status, 0) << import.err;
  const auto file = store::StudyFile::open(again, {store::Access::kReadOnly, {}});
  ASSERT_TRUE(file);
  const auto trials = store::sealedTrials(*file);
  ASSERT_TRUE(trials) << trials.error().message();
  ASSERT_EQ(trials->size(), 1U);
  EXPECT_EQ(trials->front().openings.size(), 1U);
  EXPECT_EQ(store::openContent(trials->front().reference, "stones and rivers").value(), kCurve);
}

}  // namespace
}  // namespace tactus::cli
