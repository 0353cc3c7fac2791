// What the commands say of a study whose journal was lost, or whose erasure was interrupted.
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/store/entries.h"
#include "core/store/persons.h"
#include "core/store/withdrawal.h"

#include "tests/app/cli/run_program.h"
#include "tests/core/store/plain_sql.h"
#include "tests/core/store/sample_records.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

namespace fs = std::filesystem;

class StudyNotices : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.file(name); }

  /// `name` as a crash leaves it, without its journal: with the person, without the answer that was saved last. The
  /// study is made anew each time, so that nothing was said of it.
  std::string withoutJournal(const std::string& name) {
    store::SampleRecords records(++seed_);
    auto study = store::makeStudy(path("open.tactus"), records);
    person_ = study.person.code;
    EXPECT_TRUE(study.file.close());  // what is there until now is worked into the file
    auto file = store::StudyFile::open(path("open.tactus"));
    EXPECT_TRUE(file && store::append(*file, records.answer(study.session.id)));
    fs::copy_file(path("open.tactus"), path(name), fs::copy_options::overwrite_existing);
    EXPECT_TRUE(file->close());
    fs::remove(path("open.tactus"));
    return path(name);
  }
  /// With a person, after an erasure of another person that was interrupted.
  std::string withUnfinishedErasure(const std::string& name) {
    store::SampleRecords records(++seed_);
    auto study = store::makeStudy(path(name), records);
    person_ = study.person.code;
    const auto other = records.person("misty-lake");
    EXPECT_TRUE(store::append(study.file, other));
    EXPECT_TRUE(store::withdraw(study.file, other.id, 10));
    EXPECT_TRUE(study.file.close());
    const std::string erasure = "INSERT INTO erasure VALUES (x'" + study::toText(other.id) + "', 10)";
    EXPECT_EQ(store::PlainSql(path(name)).complaint(erasure), "");
    return path(name);
  }
  /// Runs it and expects the notice on standard error, in --json as a member besides.
  void expectNotice(const std::vector<std::string>& arguments, const std::string& file, const std::string& notice) {
    const ProgramRun run(arguments);
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.err.find(file + ": " + notice), std::string::npos) << arguments[1] << ": " << run.err;
    if (arguments.back() != "--json") return;
    const auto notices = nlohmann::json::parse(run.out)["notices"];
    ASSERT_EQ(notices.size(), 1U) << arguments[1] << ": " << run.out;
    EXPECT_EQ(notices[0].get<std::string>().substr(0, file.size() + 2 + notice.size()), file + ": " + notice);
  }

  support::TempFolder folder_;
  std::string person_;
  std::uint64_t seed_ = 0;
};

const std::string kGone = "the journal of a study that was not closed was missing when it was opened";
const std::string kErasure = "the erasure of 1 participant who withdrew was interrupted";

TEST_F(StudyNotices, EachCommandThatOpensAStudySaysThatItsJournalIsGone) {
  const std::string file = path("a.tactus");
  const std::string other = path("b.tactus");
  ASSERT_EQ(ProgramRun({"study", "new", other}).status, 0);
  fs::create_directory(path("tables"));
  writeText(path("tables/participants.csv"),
            "participant,years_experience,category,handedness,weight,simulated\nS7,3,beginner,right,,1\n");
  for (const bool json : {false, true}) {
    const auto expect = [&](std::vector<std::string> arguments) {
      if (json) arguments.emplace_back("--json");
      expectNotice(arguments, file, kGone);
    };
    withoutJournal("a.tactus");
    expect({"study", "info", file});
    expect({"study", "export", file, path("out")});
    expect({"study", "merge", file, other});
    withoutJournal("a.tactus");
    expect({"study", "import", file, path("tables")});
    withoutJournal("a.tactus");
    expect({"study", "import", file, path("out")});
  }
  withoutJournal("a.tactus");
  expectNotice({"study", "recode", file, person_, "calm-fox"}, file, kGone);
  withoutJournal("a.tactus");
  expectNotice({"study", "withdraw", file, person_, "--yes"}, file, kGone);
  withoutJournal("a.tactus");
  expectNotice({"study", "erase", file}, file, kGone);
}

TEST_F(StudyNotices, AnErasureThatACommandFinishesIsNotSaidToBeInterrupted) {
  const std::string file = withUnfinishedErasure("a.tactus");
  expectNotice({"study", "recode", file, person_, "calm-fox"}, file, kErasure);
  const ProgramRun withdraw({"study", "withdraw", file, "calm-fox", "--yes"});
  ASSERT_EQ(withdraw.status, 0) << withdraw.err;
  EXPECT_EQ(withdraw.err.find(kErasure), std::string::npos) << withdraw.err;
  const ProgramRun erase({"study", "erase", file});
  EXPECT_NE(erase.out.find("no erasure was interrupted"), std::string::npos) << erase.out;
}

TEST_F(StudyNotices, BuildSaysThatTheJournalIsGone) {
  // The rules are in the file itself: they were worked in when the study was closed before.
  const std::string file = path("a.tactus");
  fs::create_directory(path("tables"));
  writeText(path("tables/participants.csv"),
            "participant,years_experience,category,handedness,weight,simulated\nS1,3,beginner,right,,1\n");
  writeText(path("tables/rules.csv"),
            "participant,lubrication,neck_flexion,depth,speed,then,weight,form\nS1,,,stomach,slow,small,,\n");
  ASSERT_EQ(ProgramRun({"study", "import", path("open.tactus"), path("tables")}).status, 0);
  auto open = store::StudyFile::open(path("open.tactus"));
  ASSERT_TRUE(open);
  store::SampleRecords records;
  ASSERT_TRUE(store::append(*open, records.person("velvet-otter")));  // an opening that saved nothing needs no journal
  fs::copy_file(path("open.tactus"), file);
  expectNotice({"build", file, "--out", path("m.tactus.json"), "--replicates", "0", "--json"}, file, kGone);
  expectNotice({"build", file, "--out", path("m.tactus.json"), "--replicates", "0"}, file, kGone);
}

}  // namespace
}  // namespace tactus::cli
