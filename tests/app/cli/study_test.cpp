#include <chrono>
#include <csignal>
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/wait.h>
#include <unistd.h>

#include "app/cli/study_text.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/text.h"
#include "core/store/persons.h"
#include "core/store/study_records.h"

#include "tests/app/cli/run_program.h"
#include "tests/core/store/faulty_disk.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

namespace fs = std::filesystem;

/// A folder of tables of two simulated participants, and the commands on study files beside it.
class StudyCommands : public testing::Test {
 protected:
  StudyCommands() {
    fs::create_directory(path("tables"));
    writeText(path("tables/participants.csv"),
              "participant,years_experience,category,handedness,weight,simulated\n"
              "S1,12.25,expert,left,,1\nS2,3,beginner,right,,1\n");
    writeText(
        path("tables/answers.csv"),
        "participant,form,item,term,status\nS1,ngt-force-v1,1,small,answered\nS2,ngt-force-v1,1,large,answered\n");
  }

  std::string path(const std::string& name) const { return folder_.file(name); }
  static ProgramRun fine(const std::vector<std::string>& arguments) {
    const ProgramRun run(arguments);
    EXPECT_EQ(run.status, 0) << run.err;
    return run;
  }
  static nlohmann::json json(std::vector<std::string> arguments) {
    arguments.emplace_back("--json");
    return nlohmann::json::parse(fine(arguments).out);
  }
  nlohmann::json rows(const std::string& file) const { return json({"study", "info", path(file)})["rows"]; }

  support::TempFolder folder_;
};

TEST_F(StudyCommands, NewMakesAnEmptyStudyOnce) {
  fine({"study", "new", path("a.tactus"), "--name", "Tube study"});
  const auto info = json({"study", "info", path("a.tactus")});
  EXPECT_EQ(info["name"], "Tube study");
  EXPECT_EQ(info["rows"]["person"], 0);
  EXPECT_NE(fine({"study", "info", path("a.tactus")}).out.find("Tube study"), std::string::npos);
  EXPECT_EQ(ProgramRun({"study", "new", path("a.tactus")}).status, 1);
  fine({"study", "new", path("b.tactus")});
  EXPECT_EQ(json({"study", "info", path("b.tactus")})["name"], "b");
}

TEST_F(StudyCommands, ImportOfTablesMakesTheStudyAndAddsNothingTwice) {
  const auto first = json({"study", "import", path("a.tactus"), path("tables")});
  EXPECT_EQ(first["persons"], 2);
  EXPECT_EQ(first["records"], 4);  // a profile and an answer each
  const auto again = json({"study", "import", path("a.tactus"), path("tables")});
  EXPECT_EQ(again["persons"], 0);
  EXPECT_EQ(again["records"], 0);
  EXPECT_EQ(rows("a.tactus")["answer"], 2);
  EXPECT_EQ(json({"study", "info", path("a.tactus")})["simulated_persons"], 2);
}

TEST_F(StudyCommands, ImportsAndMergesAreRemembered) {
  const auto before = std::chrono::system_clock::now();
  fine({"study", "import", path("a.tactus"), path("tables")});
  fine({"study", "new", path("b.tactus")});
  const std::string other = base::fileSha256(path("a.tactus")).value();
  fine({"study", "merge", path("b.tactus"), path("a.tactus")});
  fine({"study", "export", path("b.tactus"), path("out")});
  fine({"study", "new", path("c.tactus")});
  fine({"study", "import", path("c.tactus"), path("out")});
  const auto logOf = [&](const std::string& name) {
    const auto file = store::StudyFile::open(path(name), {store::Access::kReadOnly});
    return store::importLog(*file).value();
  };
  const auto tables = base::listingSha256(path("tables"), {"participants.csv", "answers.csv"});
  const auto log = logOf("b.tactus");
  ASSERT_EQ(log.size(), 2U);
  EXPECT_EQ(log[0].kind, "tables");
  EXPECT_EQ(log[0].source, "tables");
  EXPECT_EQ(log[0].sha256, tables);
  EXPECT_NE(log[0].detail.find("\"records\":4"), std::string::npos);
  EXPECT_GE(log[0].utc_ms, std::chrono::duration_cast<std::chrono::milliseconds>(before.time_since_epoch()).count());
  EXPECT_EQ(log[1].kind, "merge");
  EXPECT_EQ(log[1].source, "a.tactus");
  EXPECT_EQ(log[1].sha256, other);
  // A full export is a merge from a folder.
  const auto imported = logOf("c.tactus");
  ASSERT_EQ(imported.size(), 3U);
  EXPECT_EQ(imported[2].source, "out");
  EXPECT_EQ(imported[2].sha256.size(), 64U);
}

TEST_F(StudyCommands, AnImportThatIsStoppedBlocksNothing) {
  // Enough rows that the signal falls into the middle.
  std::string speeds = "participant,level,stroke,time_s,depth_mm,speed_mm_s\n";
  for (int i = 0; i < 20'000; ++i) {
    // A sample each 0.1 ms: a stroke of 999 s would be refused as one of milliseconds.
    speeds += "S1,slow," + std::to_string(1 + i / 1000) + ",0." + std::to_string(1000 + i % 1000) + ",1,1\n";
  }
  writeText(path("tables/speeds.csv"), speeds);
  for (const int wait_ms : {0, 2, 5, 10, 20, 40, 80}) {
    for (const bool is_there : {false, true}) {
      const std::string study = path(std::to_string(wait_ms) + (is_there ? "there.tactus" : "new.tactus"));
      if (is_there) fine({"study", "new", study});
      const pid_t child = ::fork();
      if (child == 0) {
        const ProgramRun run({"study", "import", study, path("tables")});
        ::_exit(run.status);
      }
      ::usleep(static_cast<unsigned>(wait_ms) * 1000);
      ::kill(child, SIGINT);
      int status = 0;
      ASSERT_EQ(::waitpid(child, &status, 0), child);
      fine({"study", "import", study, path("tables")});
      EXPECT_EQ(json({"study", "info", study})["rows"]["stroke"], 20);
      const auto check = json({"study", "check", study});
      EXPECT_TRUE(check["findings"].empty()) << check;
      for (const auto& entry : fs::directory_iterator(path(""))) {
        const std::string name = entry.path().filename().string();
        EXPECT_EQ(name.find(".import-"), std::string::npos) << name;
        EXPECT_EQ(name.find(".tactus-"), std::string::npos) << name;
      }
    }
  }
}

TEST_F(StudyCommands, AStudyThatIsSavedIsNotSaidToHaveFailed) {
  store::FaultyDisk disk("full after the commit");
  auto made = store::StudyFile::create(path("a.tactus"), {study::RecordIds(1).next(), "a", 1, "test"});
  ASSERT_TRUE(made && made->close());
  auto file = store::StudyFile::open(path("a.tactus"), {store::Access::kReadWrite, disk.name()});
  ASSERT_TRUE(file);
  const study::Person person{study::RecordIds(2).next(), "amber-otter", true};
  ASSERT_TRUE(store::append(*file, person));
  disk.failAt(1, store::FaultyDisk::Fault::kDiskFull, true);
  const auto warnings = closeSaved(*file);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("everything is saved, but"), std::string::npos);
  disk.heal();
  const auto again = store::StudyFile::open(path("a.tactus"));
  ASSERT_TRUE(again) << again.error().message();
  EXPECT_EQ(store::findPerson(*again, "amber-otter").value(), person);
}

TEST_F(StudyCommands, AMistakeInTheTablesLeavesNoStudy) {
  writeText(path("tables/answers.csv"), "participant,form,item,term,status\nS9,f,1,small,answered\n");
  const ProgramRun run({"study", "import", path("a.tactus"), path("tables")});
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.err.find("answers.csv: line 2, column 'participant': found 'S9'"), std::string::npos) << run.err;
  EXPECT_FALSE(fs::exists(path("a.tactus")));
}

TEST_F(StudyCommands, CheckTellsFindingsFromDamage) {
  fine({"study", "import", path("a.tactus"), path("tables")});
  EXPECT_TRUE(json({"study", "check", path("a.tactus")})["findings"].empty());
  EXPECT_NE(fine({"study", "check", path("a.tactus")}).out.find("findings 0"), std::string::npos);
  writeText(path("text.tactus"), "participant,years\n");
  EXPECT_EQ(ProgramRun({"study", "check", path("text.tactus")}).status, 1);
  std::string bytes = readText(path("a.tactus"));
  for (std::size_t at = 5000; at < bytes.size(); ++at) bytes[at] = '\x5A';
  writeText(path("damaged.tactus"), bytes);
  const ProgramRun damaged({"study", "check", path("damaged.tactus")});
  EXPECT_EQ(damaged.status, 1);
  EXPECT_NE(damaged.err.find("damaged"), std::string::npos) << damaged.err;
  EXPECT_EQ(ProgramRun({"study", "check", path("none.tactus")}).status, 1);
}

TEST_F(StudyCommands, CheckAndWithdrawListWhatACrashLeft) {
  fine({"study", "import", path("a.tactus"), path("tables")});
  writeText(path("a.tactus.tactus-k3Xw0a"), "half a copy");
  fs::create_directory(path("a.tactus.import-k3Xw0a"));
  const auto check = fine({"study", "check", path("a.tactus")});
  EXPECT_NE(check.out.find("findings 2\n"), std::string::npos) << check.out;
  for (const char* left : {"a.tactus.tactus-k3Xw0a", "a.tactus.import-k3Xw0a"}) {
    EXPECT_NE(check.out.find(path(left) + ": left by a crash"), std::string::npos) << check.out;
  }
  const auto withdraw = fine({"study", "withdraw", path("a.tactus"), "S1", "--yes"});
  EXPECT_NE(withdraw.err.find(path("a.tactus.tactus-k3Xw0a")), std::string::npos) << withdraw.err;
  const auto exported = fine({"study", "export", path("a.tactus"), path("out")});
  EXPECT_NE(exported.err.find(path("a.tactus.tactus-k3Xw0a") + ": left by a crash; deleted"), std::string::npos);
  EXPECT_FALSE(fs::exists(path("a.tactus.tactus-k3Xw0a")));
  EXPECT_NE(fine({"study", "check", path("a.tactus")}).out.find("findings 0\n"), std::string::npos);
}

/// No byte that a terminal could obey, and no character that turns the text around.
void expectHarmless(const std::string& text) {
  for (const char* const bad : {"\x1b", "\u009b", "\u202e", "\u2066", "\r", "\x9b\x33"}) {
    EXPECT_EQ(text.find(bad), std::string::npos) << "in " << base::oneLine(text);
  }
  EXPECT_TRUE(base::isUtf8(text));
}

TEST_F(StudyCommands, NamesGiveNoOrdersToTheTerminal) {
  const std::string evil = "e\x1b[2J\u009b31m\u202ecod\u2066\r\nforged: line\x9b\x33";
  const std::string folder = path(evil.substr(0, evil.size() - 2));  // a study's name is UTF-8
  fs::create_directory(folder);
  writeText(folder + "/participants.csv",
            "participant,years_experience,category,handedness,weight,simulated\n\"N\x1b[2J\u009b\u202e\n1\",,,,,1\n");
  writeText(folder + "/more\x1b.csv", "");
  const std::string study = folder + "/s.tactus";
  const std::vector<std::vector<std::string>> commands = {
      {"study", "import", study, folder},
      {"study", "info", study},
      {"study", "info", study, "--json"},
      {"study", "check", study},
      {"study", "export", study, folder + "/out"},
      {"study", "merge", study, study},
      {"study", "import", folder + "/t.tactus", folder + "/out"},
      {"study", "import", study, folder + "/out"},
      {"study", "export", study, folder},
      {"study", "withdraw", study, evil, "--yes"},
      {"study", "new", study},
      {"study", "new", folder + "/u.tactus", "--name", evil},
      {"study", "check", folder + "/none"},
      {"build", folder, "--out", folder + "/m.tactus.json"},
      {"build", study, "--out", folder + "/m.tactus.json", "--weights", evil},
      {"check", folder + "/participants.csv"},
      {"eval", folder + "/m", "--in", evil},
      {"cluster", folder + "/participants.csv", "--column", evil},
      {"vote", folder + "/participants.csv", "--series", evil},
      {"agreement", folder + "/participants.csv"},
      {"simulate", folder + "/m", "--scenario", evil, "--out", evil},
      {evil},
      {"study", evil},
      {"cluster", "x", "-c", evil},
      {"eval", "m", "--in", "p", "--method", evil},
      {"devices", "test", evil},
  };
  for (const auto& command : commands) {
    const ProgramRun run(command);
    expectHarmless(run.out);
    expectHarmless(run.err);
    EXPECT_EQ((run.out + run.err).find("\nforged"), std::string::npos) << base::oneLine(run.out + run.err);
  }
  fine({"study", "withdraw", study, "N\x1b[2J\u009b\u202e\n1", "--yes"});
}

TEST_F(StudyCommands, MergeAddsSeveralFilesOnce) {
  fine({"study", "import", path("a.tactus"), path("tables")});
  fine({"study", "new", path("b.tactus")});
  fine({"study", "new", path("c.tactus")});
  const auto merged = json({"study", "merge", path("c.tactus"), path("b.tactus"), path("a.tactus")});
  ASSERT_EQ(merged["merged"].size(), 2U);
  EXPECT_TRUE(merged["merged"][0]["added"].empty());
  EXPECT_EQ(merged["merged"][1]["added"]["person"], 2);
  EXPECT_TRUE(merged["merged"][1]["conflicts"].empty());
  EXPECT_NE(fine({"study", "merge", path("c.tactus"), path("a.tactus")}).out.find("nothing new"), std::string::npos);
  EXPECT_EQ(ProgramRun({"study", "merge", path("c.tactus"), path("c.tactus")}).status, 1);
}

TEST_F(StudyCommands, ExportAndImportGiveTheSameStudy) {
  fine({"study", "import", path("a.tactus"), path("tables")});
  EXPECT_EQ(json({"study", "export", path("a.tactus"), path("out")})["participants"], 2);
  EXPECT_EQ(json({"study", "import", path("b.tactus"), path("out")})["added"]["answer"], 2);
  EXPECT_EQ(json({"study", "info", path("a.tactus")})["id"], json({"study", "info", path("b.tactus")})["id"]);
  EXPECT_EQ(rows("a.tactus"), rows("b.tactus"));
  EXPECT_TRUE(json({"study", "import", path("a.tactus"), path("out")})["added"].empty());
  fine({"study", "export", path("b.tactus"), path("out"), "--bom"});
  EXPECT_TRUE(readText(path("out/answers.csv")).starts_with("\xEF\xBB\xBF"));
  fine({"study", "import", path("c.tactus"), path("out")});
  EXPECT_EQ(rows("c.tactus"), rows("a.tactus"));
}

TEST_F(StudyCommands, ShareableLeavesOutCodesAndYears) {
  fine({"study", "import", path("a.tactus"), path("tables")});
  fine({"study", "export", path("a.tactus"), path("out"), "--shareable"});
  const std::string participants = readText(path("out/participants.csv"));
  EXPECT_EQ(participants.find("S1"), std::string::npos);
  EXPECT_EQ(participants.find("12.25"), std::string::npos);
  EXPECT_NE(participants.find("10-14"), std::string::npos);
  EXPECT_FALSE(fs::exists(path("out/records")));
}

TEST_F(StudyCommands, WithdrawWantsAYesAndLastsThroughImports) {
  fine({"study", "import", path("a.tactus"), path("tables")});
  fine({"study", "export", path("a.tactus"), path("out")});
  EXPECT_EQ(ProgramRun({"study", "withdraw", path("a.tactus"), "S1"}).status, 2);
  EXPECT_EQ(rows("a.tactus")["person"], 2);
  EXPECT_EQ(ProgramRun({"study", "withdraw", path("a.tactus"), "S7", "--yes"}).status, 1);
  fine({"study", "withdraw", path("a.tactus"), "S1", "--yes"});
  fine({"study", "import", path("a.tactus"), path("out")});
  EXPECT_EQ(rows("a.tactus")["person"], 1);
  EXPECT_EQ(rows("a.tactus")["tombstone"], 1);
}

TEST_F(StudyCommands, ADryRunSaysWhatAWithdrawalRemovesAndRemovesNothing) {
  fine({"study", "import", path("a.tactus"), path("tables")});
  const auto dry = fine({"study", "withdraw", path("a.tactus"), "S1", "--dry-run"});
  EXPECT_NE(dry.out.find("A withdrawal of S1 from"), std::string::npos) << dry.out;
  EXPECT_NE(dry.out.find("  sessions 1\n"), std::string::npos) << dry.out;
  EXPECT_NE(dry.out.find("What would stay:\n  versions of models as they are 0\n"), std::string::npos) << dry.out;
  EXPECT_EQ(rows("a.tactus")["person"], 2);
  EXPECT_EQ(ProgramRun({"study", "withdraw", path("a.tactus"), "S1", "--dry-run", "--yes"}).status, 2);
  EXPECT_EQ(ProgramRun({"study", "withdraw", path("a.tactus"), "S7", "--dry-run"}).status, 1);
}

TEST_F(StudyCommands, NewWithdrawAndEraseSayInJsonWhatTheyDid) {
  const auto made = json({"study", "new", path("b.tactus")});
  EXPECT_EQ(made["name"], "b");
  EXPECT_EQ(made["id"], json({"study", "info", path("b.tactus")})["id"]);
  fine({"study", "import", path("a.tactus"), path("tables")});
  const auto dry = json({"study", "withdraw", path("a.tactus"), "S1", "--dry-run"});
  EXPECT_EQ(dry["removed"], false);
  EXPECT_EQ(dry["participant"], "S1");
  EXPECT_EQ(dry["sessions"], 1);
  EXPECT_EQ(dry["answers"], 1);
  const auto removed = json({"study", "withdraw", path("a.tactus"), "S1", "--yes"});
  EXPECT_EQ(removed["removed"], true);
  EXPECT_EQ(removed["records"], dry["records"]);
  EXPECT_EQ(removed["id"], dry["id"]);
  EXPECT_EQ(json({"study", "withdraw", path("a.tactus"), "S1", "--yes"})["records"], 0);
  const auto erased = json({"study", "erase", path("a.tactus")});
  EXPECT_EQ(erased["withdrawn"], 1);
  EXPECT_TRUE(erased["finished"].empty());
}

TEST_F(StudyCommands, WithdrawCanBeDoneAgainAndNamesCopies) {
  fine({"study", "import", path("a.tactus"), path("tables")});
  fine({"study", "export", path("a.tactus"), path("out")});
  const ProgramRun first({"study", "withdraw", path("a.tactus"), "S1", "--yes"});
  EXPECT_EQ(first.status, 0) << first.err;
  EXPECT_NE(first.err.find(path("out") + ": an export in which the participant stands"), std::string::npos)
      << first.err;
  const ProgramRun again({"study", "withdraw", path("a.tactus"), "S1", "--yes"});
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_NE(again.out.find("; there is nothing left to remove"), std::string::npos) << again.out;
  const ProgramRun erased({"study", "erase", path("a.tactus")});
  EXPECT_EQ(erased.status, 0) << erased.err;
  EXPECT_NE(erased.out.find("no erasure was interrupted"), std::string::npos) << erased.out;
  const ProgramRun tables({"study", "import", path("a.tactus"), path("tables")});
  EXPECT_EQ(tables.status, 1);
  EXPECT_NE(tables.err.find("found the code 'S1' of a participant who withdrew on "), std::string::npos) << tables.err;
}

TEST_F(StudyCommands, RecodeGivesAnotherCode) {
  fine({"study", "import", path("a.tactus"), path("tables")});
  fine({"study", "import", path("b.tactus"), path("tables")});
  const ProgramRun merged({"study", "merge", path("a.tactus"), path("b.tactus")});
  ASSERT_EQ(merged.status, 0) << merged.err;
  const auto at = merged.out.find("tactus study recode " + path("a.tactus") + " ");
  ASSERT_NE(at, std::string::npos) << merged.out;
  const std::string id =
      merged.out.substr(at + std::string("tactus study recode ").size() + path("a.tactus").size() + 1, 32);
  const ProgramRun build({"build", path("a.tactus"), "--out", path("m.json")});
  EXPECT_EQ(build.status, 1);
  EXPECT_NE(build.err.find("found 2 persons with the code 'S1' (ids "), std::string::npos) << build.err;
  EXPECT_NE(build.err.find("tactus study recode " + path("a.tactus") + " " + id + " S1-2"), std::string::npos)
      << build.err;
  EXPECT_EQ(ProgramRun({"study", "withdraw", path("a.tactus"), "S1", "--yes"}).status, 1);
  fine({"study", "recode", path("a.tactus"), id, "S1-2"});
  EXPECT_EQ(ProgramRun({"study", "recode", path("a.tactus"), "S1-2", "S1"}).status, 1);
  fine({"study", "withdraw", path("a.tactus"), "S1-2", "--yes"});
  EXPECT_EQ(rows("a.tactus")["tombstone"], 1);
}

TEST_F(StudyCommands, WrongUsage) {
  EXPECT_EQ(ProgramRun({"study"}).status, 2);
  EXPECT_EQ(ProgramRun({"study", "info"}).status, 2);
  EXPECT_EQ(ProgramRun({"study", "new", ""}).status, 2);
  EXPECT_EQ(ProgramRun({"study", "merge", "a.tactus"}).status, 2);
}

}  // namespace
}  // namespace tactus::cli
