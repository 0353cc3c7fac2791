// Wrong usage: each unknown word is named, every option says its default, and a kind of mistake has one exit status.
#include <algorithm>
#include <array>
#include <csignal>
#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <thread>
#include <unistd.h>
#include <vector>

#include "tests/app/cli/run_program.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

void expectUsage(const std::vector<std::string>& arguments, const std::string& says) {
  const ProgramRun run(arguments);
  EXPECT_EQ(run.status, 2) << run.err;
  EXPECT_EQ(run.out, "");
  EXPECT_NE(run.err.find(says), std::string::npos) << run.err;
}

TEST(Usage, UnknownCommandsAreNamedWithTheClosest) {
  const ProgramRun run({"biuld", "study", "--out", "m"});
  EXPECT_EQ(run.status, 2);
  EXPECT_TRUE(
      run.err.starts_with("tactus: found the word 'biuld', wanted a command: demo, build, report, vote, cluster, "))
      << run.err;
  EXPECT_NE(run.err.find(" (build?)\n"), std::string::npos) << run.err;
  expectUsage({"study", "chek", "f"}, "tactus study: found the word 'chek', wanted a command: new, info, check,");
  expectUsage({"study", "chek", "f"}, "(check?)");
  expectUsage({"devices", "tset"}, "tactus devices: found the word 'tset', wanted a command: test, calibrate (test?)");
  expectUsage({"frobnicate"}, "found the word 'frobnicate'");
  expectUsage({std::string(5000, 'x')}, "found the word 'xxxxx");
}

TEST(Usage, UnknownOptionsAreNamedWithTheClosest) {
  expectUsage({"build", "s", "--out", "m", "--wieghts", "equal"},
              "tactus build: found the option '--wieghts', wanted ");
  expectUsage({"build", "s", "--out", "m", "--wieghts", "equal"}, "(--weights?)");
  expectUsage({"build", "s", "--out", "m", "--wieghts=equal"}, "found the option '--wieghts'");
  expectUsage({"--jsno", "check", "m"}, "tactus: found the option '--jsno'");
  expectUsage({"cluster", "f", "-k", "3"}, "tactus cluster: found the option '-k'");
  expectUsage({"check", "m", "extra"}, "extra");
}

TEST(Usage, ValuesOfOptionsAreNoWords) {
  // Refused for what they are, not because a value looks like a command or an option.
  const support::TempFolder folder;
  const std::string none = folder.file("none.csv");
  EXPECT_EQ(ProgramRun({"cluster", none, "--column", "vote", "-c3", "-m", "2"}).status, 1);
  EXPECT_EQ(ProgramRun({"cluster", none, "--column=--odd"}).status, 1);
  EXPECT_EQ(ProgramRun({"vote", none, "--series", "chek"}).status, 1);
}

TEST(Usage, ValuesOutOfTheirRangeAreWrongUsageEverywhere) {
  expectUsage({"build", "s", "--out", "m", "--alpha", "2"},
              "--alpha: found '2', wanted a number above 0.5 and at most 1");
  expectUsage({"build", "s", "--out", "m", "--alpha", "nan"}, "--alpha: found 'nan'");
  expectUsage({"build", "s", "--out", "m", "--trim", "1"},
              "--trim: found '1', wanted a share of 0 or more and below 1");
  expectUsage({"build", "s", "--out", "m", "--terms", "onw"},
              "--terms: found 'onw', wanted one of averaged, own (own?)");
  expectUsage({"build", "s", "--out", "m", "--weights", "yeers"},
              "--weights: found 'yeers', wanted one of equal, years, category, column or a CSV file (years?)");
  expectUsage({"build", "s", "--out", "m", "--replicates", "1e3"},
              "--replicates: found '1e3', wanted a whole number from 0 to 1000000");
  expectUsage({"cluster", "f", "-c", "0"}, "-c: found '0', wanted a whole number of clusters from 1 to 64");
  expectUsage({"cluster", "f", "-c", "-2"}, "found '-2'");
  expectUsage({"cluster", "f", "-c", "2.5"}, "found '2.5'");
  expectUsage({"cluster", "f", "-m", "1"}, "-m: found '1', wanted a number above 1 and at most 100");
  expectUsage({"eval", "m", "--in", "p", "--method", "guess"}, "--method");
  expectUsage({"demo", "d", "--reading", "guess"}, "--reading: found 'guess', wanted one of ngt-a2-");
}

TEST(Usage, InputThatIsNotThereIsWrongInputEverywhere) {
  const support::TempFolder folder;
  const std::string none = folder.file("none");
  const std::vector<std::vector<std::string>> lines = {
      {"check", none},
      {"build", none, "--out", folder.file("m")},
      {"cluster", none},
      {"vote", none},
      {"agreement", none},
      {"eval", none, "--in", none},
      {"study", "info", none},
      {"study", "check", none},
      {"study", "import", folder.file("s"), none},
      {"simulate", none, "--scenario", none, "--out", folder.file("t")}};
  for (const auto& line : lines) {
    const ProgramRun run(line);
    EXPECT_EQ(run.status, 1) << line.front() << ": " << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  }
  const ProgramRun weights({"build", none, "--out", folder.file("m"), "--weights", none + ".csv"});
  EXPECT_EQ(weights.status, 1);
}

TEST(Usage, ASeedThatCannotBeKeptIsRefused) {
  const support::TempFolder folder;
  for (const char* seed : {"-1", "1e3", "1.5", "0x10", "", " 5", "5 ", "+5", "18446744073709551616",
                           "99999999999999999999999", "10000000000000001", "18446744073709551615", "five"}) {
    const ProgramRun run({"demo", folder.file("demo"), "--seed", seed});
    EXPECT_EQ(run.status, 2) << seed;
    EXPECT_NE(run.err.find("found '" + std::string(seed) + "', wanted a whole number from 0 to 10000000000000000"),
              std::string::npos)
        << run.err;
    EXPECT_FALSE(std::filesystem::exists(folder.file("demo")));
  }
}

/// The paragraphs of the options of a help text, one line each.
std::vector<std::string> optionsOf(const std::string& help) {
  std::vector<std::string> options;
  std::size_t at = help.find("\nOptions:\n");
  while (at != std::string::npos && at + 1 < help.size()) {
    const std::size_t begin = help.find_first_not_of('\n', at);
    const std::size_t end = std::min(help.find('\n', begin), help.size());
    const std::string line = help.substr(begin, end - begin);
    if (line.starts_with("  -")) options.push_back(line);
    if (line.starts_with("   ") && !options.empty()) options.back() += line;
    if (!line.starts_with(" ") && !line.starts_with("Options:")) break;
    at = end;
  }
  return options;
}

TEST(Usage, HelpSaysTheDefaultOfEveryOption) {
  const std::vector<std::vector<std::string>> commands = {{"demo"},
                                                          {"build"},
                                                          {"cluster"},
                                                          {"vote"},
                                                          {"agreement"},
                                                          {"eval"},
                                                          {"check"},
                                                          {"simulate"},
                                                          {"study", "new"},
                                                          {"study", "info"},
                                                          {"study", "check"},
                                                          {"study", "merge"},
                                                          {"study", "import"},
                                                          {"study", "export"},
                                                          {"devices"},
                                                          {"devices", "calibrate"}};
  for (auto command : commands) {
    command.emplace_back("--help");
    const ProgramRun run(command);
    EXPECT_EQ(run.status, 0);
    EXPECT_NE(run.out.find("Exit status: 0 fine, 1 the input is wrong"), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("at most 256 MiB are read"), std::string::npos) << run.out;
    EXPECT_FALSE(optionsOf(run.out).empty()) << run.out;
    for (const auto& option : optionsOf(run.out)) {
      const bool takes_value = option.find(" TEXT") != std::string::npos ||
                               option.find(" FLOAT") != std::string::npos || option.find(" INT") != std::string::npos ||
                               option.find(" UINT") != std::string::npos;
      if (!takes_value || option.find("REQUIRED") != std::string::npos) continue;
      const bool said = option.find("=") != std::string::npos || option.find("[") != std::string::npos ||
                        option.find("default") != std::string::npos || option.find("without it") != std::string::npos;
      EXPECT_TRUE(said) << command.front() << ": " << option;
    }
  }
}

TEST(Usage, AnEndlessTableStopsAtItsLimit) {
  const ProgramRun device({"vote", "/dev/zero"});
  EXPECT_EQ(device.status, 1);
  EXPECT_NE(device.err.find("/dev/zero: found a device, wanted a file"), std::string::npos) << device.err;

  // What a shell pipes in is read, and ends at the limit that the help states.
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  const auto before = std::signal(SIGPIPE, SIG_IGN);
  std::thread writer([&ends] {
    const std::string rows(std::size_t{1} << 20U, 'x');
    while (::write(ends[1], rows.data(), rows.size()) > 0) {
    }
    ::close(ends[1]);
  });
  const ProgramRun piped({"vote", "/dev/fd/" + std::to_string(ends[0])});
  ::close(ends[0]);
  writer.join();
  std::signal(SIGPIPE, before);
  EXPECT_EQ(piped.status, 1);
  EXPECT_NE(piped.err.find("wanted at most 268435456 bytes of a pipe or device"), std::string::npos) << piped.err;
}

TEST(Usage, LongNamesAreShortenedInAgreementToo) {
  const support::TempFolder folder;
  const std::string file = folder.file("t.csv");
  std::string header = "a";
  for (int i = 0; i < 300; ++i) header += ",column_" + std::string(50, 'x') + std::to_string(i);
  writeText(file, header + "\n");
  const ProgramRun columns({"agreement", file});
  EXPECT_EQ(columns.status, 1);
  EXPECT_LT(columns.err.size(), 700U) << columns.err;
  writeText(file, "participant,form,item,term,status\nA," + std::string(100000, 'f') + ",1,small,answered\n");
  const ProgramRun form({"agreement", file, "--form", "g"});
  EXPECT_EQ(form.status, 1);
  EXPECT_LT(form.err.size(), 400U) << form.err.substr(0, 1000);
  EXPECT_LT(ProgramRun({"agreement", file}).out.find("Form '" + std::string(60, 'f') + "…'"), std::string::npos);
}

}  // namespace
}  // namespace tactus::cli
