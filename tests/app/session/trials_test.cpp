#include "app/session/trials.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <iomanip>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include "app/session/simulated_study.h"
#include "app/session/study_export.h"
#include "core/base/tables/csv.h"
#include "core/store/entries.h"
#include "elicitation/speed/participant_speeds.h"

#include "tests/app/session/session_fixture.h"
#include "tests/support/temp_folder.h"

namespace tactus::session {
namespace {

/// What `command` prints; nothing if it ends with an error.
std::optional<std::string> printed(const std::string& command) {
  std::FILE* pipe = popen((command + " 2>/dev/null").c_str(), "r");
  if (pipe == nullptr) return std::nullopt;
  std::string out;
  std::array<char, 4096> buffer{};
  while (const std::size_t got = std::fread(buffer.data(), 1, buffer.size(), pipe)) out.append(buffer.data(), got);
  return pclose(pipe) == 0 ? std::optional(out) : std::nullopt;
}

/// The block of the guide that begins with ```language.
std::string example(const std::string& language) {
  std::ifstream file(TACTUS_SOURCE_DIR "/docs/study-export.md");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::size_t begin = text.find("```" + language + "\n");
  EXPECT_NE(begin, std::string::npos);
  const std::size_t first = text.find('\n', begin) + 1;
  return text.substr(first, text.find("```", first) - first);
}

/// The study of one seed and its export, made once for all tests.
class TrialsOfSimulatedNurses : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new support::TempFolder;
    auto made = makeSimulatedNgtStudy(folder_->file("study.tactus"), 3, "ngt-a2-shifted", "test");
    ASSERT_TRUE(made) << made.error().message();
    file_ = new store::StudyFile(*std::move(made));
    ASSERT_TRUE(exportStudy(*file_, folder_->file("out")));
  }
  static void TearDownTestSuite() {
    delete file_;
    delete folder_;
  }

  /// Tables 1 and 2 by the program's own calculation, as the examples print them; without the order of the lines.
  std::multiset<std::string> expected() const {
    std::multiset<std::string> lines;
    const auto view = *studyForElicitation(*file_);
    for (const auto& participant : view.study.participants) {
      std::vector<study::SpeedSample> samples;
      for (const auto& sample : view.study.speeds) {
        if (sample.participant == participant.code) samples.push_back(sample);
      }
      const std::vector<std::string> levels = {"slow", "medium", "fast"};
      for (const auto& level : elicitation::levelSpeeds(samples, levels)) {
        std::ostringstream line;
        line << participant.code << ' ' << level.level << std::fixed << std::setprecision(4) << ' ' << level.mean_mm_s
             << ' ' << level.sd_mm_s;
        lines.insert(line.str());
      }
    }
    std::map<double, std::map<std::string, int>> votes;
    for (const auto& judgement : view.study.judgements) {
      if (judgement.series == "ascending" && judgement.kind == study::ForceJudgement::Kind::kTerm)
        ++votes[judgement.force_n][judgement.term];
    }
    for (const auto& [force, words] : votes) {
      std::ostringstream line;
      line << force;
      for (const auto& [word, count] : words) line << ' ' << word << '=' << count;
      lines.insert(line.str());
    }
    return lines;
  }

  std::multiset<std::string> linesOf(const std::string& text) const {
    std::multiset<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
      while (!line.empty() && line.back() == ' ') line.pop_back();
      lines.insert(line);
    }
    return lines;
  }

  void expectTablesFrom(const std::string& language, const std::string& program) {
    const std::string script = folder_->file("tables." + language);
    std::ofstream(script) << example(language);
    const auto out = printed(program + " " + script + " " + folder_->file("out/trials.csv"));
    ASSERT_TRUE(out.has_value());
    EXPECT_EQ(linesOf(*out), expected());
  }

  static support::TempFolder* folder_;
  static store::StudyFile* file_;
};

support::TempFolder* TrialsOfSimulatedNurses::folder_ = nullptr;
store::StudyFile* TrialsOfSimulatedNurses::file_ = nullptr;

TEST_F(TrialsOfSimulatedNurses, GiveTables1And2InPython) {
  if (!printed("python3 --version")) GTEST_SKIP() << "no python3";
  expectTablesFrom("python", "python3");
}

TEST_F(TrialsOfSimulatedNurses, GiveTables1And2InR) {
  if (!printed("Rscript --version")) GTEST_SKIP() << "no Rscript";
  expectTablesFrom("r", "Rscript");
}

TEST_F(TrialsOfSimulatedNurses, HaveARowForEachRecordAndCountWhatTheTablesHold) {
  const auto view = *studyForElicitation(*file_);
  const auto all = *trials(*file_, view);
  EXPECT_EQ(all.size(), store::strokes(*file_, {}, store::Recordings::kLeaveOut)->size() +
                            store::judgements(*file_)->size() + store::answers(*file_)->size());
  const auto counted = std::count_if(all.begin(), all.end(), [](const Trial& trial) { return trial.counts; });
  EXPECT_EQ(static_cast<std::size_t>(counted),
            view.stroke_ids.size() + view.judgement_ids.size() + view.answer_ids.size());
  const auto table = *base::CsvTable::read(folder_->file("out/trials.csv"));
  EXPECT_EQ(table.rowCount(), all.size());
}

TEST_F(TrialsOfSimulatedNurses, SayWhatTheirRecordsSay) {
  const auto all = *trials(*file_, *studyForElicitation(*file_));
  std::multiset<std::string> found;
  for (const Trial& trial : all) {
    std::ostringstream line;
    line << name(trial.kind) << ' ' << trial.block << ' ' << trial.number << ' ' << trial.attempt << ' '
         << trial.practice << trial.catch_trial << ' ' << trial.answer << ' ' << trial.status << ' ' << trial.wording
         << ' ' << trial.position.value_or(0) << ' ' << trial.response_s.value_or(-1) << ' '
         << trial.force_n.value_or(-1) << ' ' << trial.felt_n.value_or(-1) << ' ' << trial.forward_mm.value_or(-1);
    found.insert(line.str());
  }
  std::multiset<std::string> wanted;
  for (const auto& one : *store::strokes(*file_, {}, store::Recordings::kLeaveOut)) {
    std::ostringstream line;
    line << "stroke " << one.level << ' ' << one.number << ' ' << one.attempt << ' ' << one.practice << "0  "
         << one.verdict << "  0 -1 -1 -1 -1";
    wanted.insert(line.str());
  }
  for (const auto& one : *store::judgements(*file_)) {
    const char* const kinds[] = {"term", "not_felt", "beyond_practice", "no_answer"};
    std::ostringstream line;
    line << "judgement " << one.series << ' ' << one.step << ' ' << one.attempt << ' '
         << (one.series == experiments::kFamiliarisation) << one.catch_trial << ' ' << one.term << ' '
         << kinds[static_cast<std::size_t>(one.kind)] << "  0 " << one.response_s << ' ' << one.commanded_n << ' '
         << one.felt_n.value_or(-1) << ' ' << one.forward_mm;
    wanted.insert(line.str());
  }
  for (const auto& one : *store::answers(*file_)) {
    const char* const kinds[] = {"answered", "skipped", "cant_tell", "cleared"};
    std::ostringstream line;
    line << "answer " << one.form << ' ' << one.item << " 1 00 " << one.value << ' '
         << kinds[static_cast<std::size_t>(one.status)] << ' ' << one.wording << ' ' << one.position << ' '
         << one.response_s << " -1 -1 -1";
    wanted.insert(line.str());
  }
  EXPECT_EQ(found, wanted);
}

TEST_F(TrialsOfSimulatedNurses, AreSharedWithoutWhatTellsAPerson) {
  const auto view = *studyForElicitation(*file_);
  auto all = *trials(*file_, view);
  for (Trial& trial : all) trial.under.device = "hid:1209:ffb0:SN123";
  const auto shared = shareable(all, {{view.study.participants[1].code, "P1"}});
  ASSERT_FALSE(shared.empty());
  const std::string text = trialsText(shared, true);
  EXPECT_EQ(text.find("SN123"), std::string::npos);
  EXPECT_NE(text.find("hid:1209:ffb0,"), std::string::npos);
  for (const char* column : {"utc_ms", "session_id", "station", "calibrated_utc", "protocol_id", "entered_by"}) {
    EXPECT_EQ(text.substr(0, text.find('\n')).find(column), std::string::npos) << column;
  }
  for (const auto& trial : shared) EXPECT_EQ(trial.participant, "P1");
}

class TrialsOfASession : public SessionTest {};

// What was noted last holds: another language on the next day does not change what was answered before.
TEST_F(TrialsOfASession, HaveTheCircumstancesOfTheirMoment) {
  const Circumstances before{"en", 100, "virtual", {}, {}};
  const Circumstances after{"zh-Hant", 150, "virtual", "2026-11-21T08:00:00Z", 0.07};
  begin(start());
  base::Random random(1);
  doNext(random);  // the profile
  ASSERT_TRUE(session_->note(circumstancesNoted(before)));
  doNext(random);
  ASSERT_TRUE(session_->note(circumstancesNoted(after)));
  doNext(random);
  const auto all = trials(*file_, *studyForElicitation(*file_));
  ASSERT_TRUE(all) << all.error().message();
  ASSERT_EQ(all->size(), 2U);
  EXPECT_EQ((*all)[0].under, before);
  EXPECT_EQ((*all)[1].under, after);
  EXPECT_EQ((*all)[0].order, 1);
  EXPECT_EQ((*all)[1].order, 2);
}

}  // namespace
}  // namespace tactus::session
