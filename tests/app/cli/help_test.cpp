// What the program says about its commands: the same for a person, a shell and a manual page.
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <set>
#include <sstream>
#include <string>

#include "tests/app/cli/run_program.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

/// The commands of the main help, and the groups that they stand in.
struct Listed {
  std::set<std::string> commands;
  std::set<std::string> groups;
};

Listed listed() {
  Listed out;
  std::istringstream help(ProgramRun({"--help"}).out);
  std::string line;
  std::string group;
  while (std::getline(help, line)) {
    if (line.ends_with(':') && !line.starts_with(' ')) group = line.substr(0, line.size() - 1);
    if (line.starts_with("  ") && line[2] >= 'a' && line[2] <= 'z') {
      out.groups.insert(group);
      out.commands.insert(line.substr(2, line.find(' ', 2) - 2));
    }
  }
  return out;
}

TEST(Help, EachCommandStandsInAGroup) {
  const Listed found = listed();
  EXPECT_EQ(found.groups, (std::set<std::string>{"Study", "Model", "Deliver", "Device", "Help"}));
  EXPECT_GE(found.commands.size(), 20U);
  for (const char* command : {"demo", "eval", "bundle", "devices", "help"})
    EXPECT_TRUE(found.commands.contains(command));
}

TEST(Help, OfACommandIsWhatItsOptionSays) {
  EXPECT_EQ(ProgramRun({"help"}).out, ProgramRun({"--help"}).out);
  for (const auto& command : listed().commands) {
    const ProgramRun run({"help", command});
    EXPECT_EQ(run.status, 0) << command;
    EXPECT_EQ(run.out, ProgramRun({command, "--help"}).out);
  }
  const ProgramRun nested({"help", "study", "new"});
  EXPECT_EQ(nested.status, 0);
  EXPECT_EQ(nested.out, ProgramRun({"study", "new", "--help"}).out);
  const ProgramRun unknown({"help", "evla"});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.err.find("found the word 'evla', wanted a command: "), std::string::npos) << unknown.err;
  EXPECT_NE(unknown.err.find("(eval?)"), std::string::npos) << unknown.err;
}

TEST(Help, TellsOfTablesWhereACommandHasOne) {
  const auto tells = [](const char* command) {
    return ProgramRun({"help", command}).out.find("docs/csv-tables.md") != std::string::npos;
  };
  EXPECT_TRUE(tells("eval"));
  EXPECT_TRUE(tells("cluster"));
  EXPECT_FALSE(tells("verify"));
  EXPECT_FALSE(tells("serve"));
}

TEST(Help, WrongUsageNamesTheCommand) {
  EXPECT_TRUE(ProgramRun({"eval"}).err.starts_with("tactus eval: MODEL is required\n")) << ProgramRun({"eval"}).err;
  EXPECT_TRUE(ProgramRun({"eval", "m"}).err.starts_with("tactus eval: --in is required\n"));
  EXPECT_TRUE(ProgramRun({"study"}).err.starts_with("tactus study: A subcommand is required\n"));
  EXPECT_TRUE(ProgramRun({"study", "new"}).err.starts_with("tactus study new: FILE is required\n"));
  EXPECT_TRUE(ProgramRun({"cluster", "f", "-c", "0"}).err.starts_with("tactus cluster: -c: found '0'"));
}

TEST(Help, TheManualHasEachCommandAndEachOption) {
  const std::string manual = ProgramRun({"help", "--man"}).out;
  for (const auto& command : listed().commands) {
    EXPECT_NE(manual.find(".SS \"tactus " + command), std::string::npos) << command;
  }
  EXPECT_NE(manual.find(".SS \"tactus study new FILE\"\n"), std::string::npos);
  EXPECT_NE(manual.find(".TP\n.B \\-\\-method\n"), std::string::npos);
}

/// What bash offers for `typed`, whose last word is being written.
std::set<std::string> offered(const std::string& typed, const support::TempFolder& folder) {
  std::ofstream(folder.file("tactus.bash")) << ProgramRun({"completion", "bash"}).out;
  const std::string out = folder.file("offered.txt");
  std::ofstream(folder.file("run.bash")) << "source " << folder.file("tactus.bash") << "\nCOMP_WORDS=(" << typed
                                         << ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_tactus\nprintf '%s\\n' "
                                            "\"${COMPREPLY[@]}\" > "
                                         << out << '\n';
  EXPECT_EQ(std::system(("bash " + folder.file("run.bash")).c_str()), 0);
  std::set<std::string> words;
  std::ifstream in(out);
  for (std::string word; std::getline(in, word);) words.insert(word);
  return words;
}

TEST(Completion, BashOffersCommandsAndOptions) {
  if (std::system("bash -c true") != 0) GTEST_SKIP() << "there is no bash here";
  const support::TempFolder folder;
  EXPECT_EQ(offered("tactus ''", folder), listed().commands);
  EXPECT_EQ(offered("tactus eva", folder), std::set<std::string>{"eval"});
  EXPECT_EQ(offered("tactus eval m --me", folder), std::set<std::string>{"--method"});
  EXPECT_TRUE(offered("tactus study ne", folder).contains("new"));
  EXPECT_EQ(offered("tactus study new --na", folder), std::set<std::string>{"--name"});
  EXPECT_EQ(offered("tactus eval ''", folder), std::set<std::string>{""});  // files
}

TEST(Completion, EachShellHasEachCommandWithItsDescription) {
  for (const char* shell : {"zsh", "fish"}) {
    const ProgramRun run({"completion", shell});
    EXPECT_EQ(run.status, 0);
    for (const auto& command : listed().commands) EXPECT_NE(run.out.find("tactus " + command), std::string::npos);
    EXPECT_NE(run.out.find("The force of a model at the points of a CSV file"), std::string::npos) << shell;
    if (std::system((std::string("command -v ") + shell + " >/dev/null").c_str()) != 0) continue;
    const support::TempFolder folder;
    std::ofstream(folder.file("script")) << run.out;
    EXPECT_EQ(std::system((std::string(shell) + " -n " + folder.file("script")).c_str()), 0);
  }
  EXPECT_EQ(ProgramRun({"completion", "tcsh"}).status, 2);
}

}  // namespace
}  // namespace tactus::cli
