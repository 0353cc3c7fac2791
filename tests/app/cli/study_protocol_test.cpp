// `tactus study protocol` and `tactus study key`.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/store/research_key.h"
#include "core/store/study_file.h"

#include "tests/app/cli/run_program.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

class StudyProtocolCommands : public testing::Test {
 protected:
  StudyProtocolCommands() {
    EXPECT_EQ(ProgramRun({"study", "new", file_}).status, 0);
    writeText(consent_, "Please read.\n");
  }
  ProgramRun protocol(std::vector<std::string> more) const {
    more.insert(more.begin(), {"study", "protocol", file_});
    return ProgramRun(more);
  }
  nlohmann::json json() const { return nlohmann::json::parse(protocol({"--json"}).out); }

  support::TempFolder folder_;
  std::string file_ = folder_.file("a.tactus");
  std::string consent_ = folder_.file("consent.txt");
};

TEST_F(StudyProtocolCommands, ShowsTheDefaultsBeforeOneIsSet) {
  const ProgramRun run = protocol({});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("no protocol is set"), std::string::npos);
  EXPECT_NE(run.out.find("force.ladder.highest_n = 1.7"), std::string::npos);
  EXPECT_EQ(json()["version"], 0);
}

TEST_F(StudyProtocolCommands, SetsValuesAndConsentTexts) {
  const ProgramRun run = protocol({"--set", "force.ladder.highest_n=1.5", "--set", "speed.strokes=6", "--set",
                                   "consent_version=2026-1", "--consent", "en=" + consent_, "--author", "A. Lee"});
  ASSERT_EQ(run.status, 0) << run.err;
  const auto stored = json();
  EXPECT_EQ(stored["version"], 1);
  EXPECT_EQ(stored["locked"], false);
  EXPECT_EQ(stored["protocol"]["settings"]["force"]["ladder"]["highest_n"], 1.5);
  EXPECT_EQ(stored["protocol"]["settings"]["speed"]["strokes"], 6);
  EXPECT_EQ(stored["protocol"]["consent"]["en"], "Please read.\n");
  EXPECT_EQ(stored["records"][0]["author"], "A. Lee");
}

TEST_F(StudyProtocolCommands, RefusesWhatTheDeviceCannotHoldAndStoresNothing) {
  const ProgramRun run =
      protocol({"--set", "force.ladder.highest_n=2.5", "--set", "consent_version=1", "--consent", "en=" + consent_});
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.err.find("the force cap of the device"), std::string::npos) << run.err;
  EXPECT_EQ(json()["version"], 0);
  EXPECT_EQ(protocol({"--set", "force.ladder.highest=1"}).status, 1);
  EXPECT_EQ(protocol({"--set", "speed.strokes"}).status, 1);
  EXPECT_EQ(protocol({"--consent", "en=" + folder_.file("missing.txt")}).status, 1);
}

TEST_F(StudyProtocolCommands, TheKeyComesFromAFileAndIsNeverPrinted) {
  const std::string key = folder_.file("key.txt");
  writeText(key, "open sesame\r\nmore\n");
  const ProgramRun run({"study", "key", file_, "--from", key});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ((run.out + run.err).find("sesame"), std::string::npos);
  const auto opens = [this](const char* passphrase) {
    const auto file = store::StudyFile::open(file_, {store::Access::kReadOnly});
    return file && store::opensResearch(*file, passphrase).value_or(false);
  };
  EXPECT_TRUE(opens("open sesame"));
  EXPECT_FALSE(opens("anything"));

  writeText(key, "short\n");
  EXPECT_EQ(ProgramRun({"study", "key", file_, "--from", key}).status, 1);
  writeText(key, "\n");
  EXPECT_EQ(ProgramRun({"study", "key", file_, "--from", key}).status, 1);
  EXPECT_TRUE(opens("open sesame"));
  ASSERT_EQ(ProgramRun({"study", "key", file_, "--remove"}).status, 0);
  EXPECT_TRUE(opens("anything"));
}

}  // namespace
}  // namespace tactus::cli
