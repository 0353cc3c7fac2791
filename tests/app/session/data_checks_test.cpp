// Well-made tables give no finding; sentences say what is wrong, where, and the remedy.
#include "app/session/data_checks.h"

#include "tests/app/session/data_mistakes.h"

namespace tactus::session {
namespace {

TEST(DataChecks, CodesThatAPersonTakesForOne) {
  for (const std::string code : {"n1", "N 1", "N-1", "N01", "N_001",
                                 "N\xE2\x80\x93"
                                 "1",
                                 "N\xC2\xA0"
                                 "1"}) {
    Study study = support::tableStudy(4);
    for (auto* rows : {&study.speeds}) {
      for (auto& row : *rows) row.participant = row.participant == kWho ? code : row.participant;
    }
    for (auto& row : study.judgements) row.participant = row.participant == kWho ? code : row.participant;
    for (auto& row : study.answers) row.participant = row.participant == kWho ? code : row.participant;
    study.participants[2].code = code;
    const auto findings = dataFindings(study);
    ASSERT_EQ(findings.size(), 1U) << code;
    EXPECT_EQ(name(findings[0].kind), "codes_alike");
    EXPECT_EQ(findings[0].participant, code);
    EXPECT_EQ(findings[0].cell.line.number, 4U);
  }
}

TEST(DataChecks, CodesWithOtherNumbersAreNotAlike) {
  Study study = support::tableStudy(4, {.nurses = 12});
  for (const auto& finding : dataFindings(study)) EXPECT_NE(name(finding.kind), "codes_alike") << text(finding);
}

TEST(DataChecks, CodesThatLookLikeNames) {
  Study study;
  for (const char* code : {"Anna Schmidt", "anna.schmidt", "a.s@clinic.example", "S1", "NURSE A", "Nurse 12",
                           "expert-one2", "crisp-ostrich"})
    study.participants.emplace_back().code = code;
  std::vector<std::string> named;
  for (const auto& finding : dataFindings(study)) {
    if (name(finding.kind) == "code_like_name") named.push_back(finding.participant);
  }
  EXPECT_EQ(named, (std::vector<std::string>{"Anna Schmidt", "anna.schmidt", "a.s@clinic.example"}));
}

TEST(DataChecks, LinesBelowTheTableAndDatesOfSpreadsheets) {
  Study study;
  for (const char* code : {"N1", "Mean", "n = 12", "TOTAL", "Mean (SD)", "N4", "Max", "05. Jan", "5-Mar", "2026-01-05",
                           "05.01.26", "JAN05", "1-5", "A-12-3", "SD"})
    study.participants.emplace_back().code = code;
  std::vector<std::string> named;
  for (const auto& finding : dataFindings(study)) {
    named.push_back(std::string(name(finding.kind)) + ' ' + finding.participant);
  }
  EXPECT_EQ(named,
            (std::vector<std::string>{"summary_row Mean", "summary_row n = 12", "summary_row TOTAL",
                                      "summary_row Mean (SD)", "summary_row SD", "code_like_date 05. Jan",
                                      "code_like_date 5-Mar", "code_like_date 2026-01-05", "code_like_date 05.01.26"}));
}

TEST(DataChecks, PercentBesideShares) {
  Study study = support::tableStudy(5);
  for (auto& participant : study.participants) participant.weight = 0.25;
  EXPECT_TRUE(dataFindings(study).empty());
  study.participants[2].weight = 25;
  const auto findings = dataFindings(study);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(text(findings[0]),
            "participants.csv, line 4: The weight of N3 is 25, that of N1 0.25: percent beside shares?");
  for (auto& participant : study.participants) participant.weight = 25;
  study.participants[0].weight = 0;
  EXPECT_TRUE(dataFindings(study).empty());
}

TEST(DataChecks, SimulatedBesideReal) {
  Study study = support::tableStudy(5);
  study.participants[1].simulated = true;
  const auto findings = dataFindings(study);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(text(findings[0]), "participants.csv, line 3: Simulated participants stand beside real ones: N2.");
  for (auto& participant : study.participants) participant.simulated = true;
  EXPECT_TRUE(dataFindings(study).empty());
}

TEST(DataChecks, SentencesSayWhatAndTheRemedy) {
  Study study = support::tableStudy(6);
  eachSample(study, [](SpeedSample& row) { row.speed_mm_s /= 10; });
  const auto findings = dataFindings(study);
  ASSERT_EQ(findings.size(), 1U);
  const auto refused = study::refuseData(findings);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(findings[0].sentence,
            "In all 12 strokes of N3 the speeds look like cm/s: multiply speed_mm_s by 10 there, so that s, mm and "
            "mm/s fit each other.");
  EXPECT_EQ(
      refused.error().message(),
      "speeds.csv: line " + std::to_string(findings[0].cell.line.number) +
          ", column 'speed_mm_s': found that in all 12 strokes of N3 the speeds look like cm/s, wanted multiply "
          "speed_mm_s by 10 there, so that s, mm and mm/s fit each other, or --accept speed_unit if the data are right "
          "as they are");
}

TEST(DataChecks, AStudyFromAFileHasNoLines) {
  Study study = support::tableStudy(6);
  study.participants[2].years_experience = 300;
  for (auto& participant : study.participants) participant.line = {};
  const auto findings = dataFindings(study);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(text(findings[0]), findings[0].sentence);
  EXPECT_EQ(study::refuseData(findings).error().file, "");
}

// Chance gives two participants one series of words in about one of a thousand pairs (15 pairs a study here), and the
// sentence says so; nothing else is ever said of well-made tables.
TEST(DataChecks, WellMadeTablesGiveNoFinding) {
  int copied_by_chance = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    for (const double noise : {0.0, 0.05}) {
      for (const auto& finding : dataFindings(support::tableStudy(seed, {.noise = noise}))) {
        EXPECT_EQ(name(finding.kind), "judgements_copied") << "seed " << seed << ": " << text(finding);
        ++copied_by_chance;
      }
    }
  }
  EXPECT_LE(copied_by_chance, 6);  // of 120 studies with 15 pairs each, 1.8 are expected
  EXPECT_TRUE(dataFindings({}).empty());
}

}  // namespace
}  // namespace tactus::session
