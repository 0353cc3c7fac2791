#include "app/report/study_report.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <regex>

#include "app/session/data_checks.h"
#include "app/session/study_source.h"

#include "tests/support/default_procedure.h"
#include "tests/support/table_study.h"
#include "tests/support/well_formed.h"

namespace tactus::report {
namespace {

using support::countOf;

elicitation::BuildSettings studySettings() {
  elicitation::BuildSettings out;
  out.created_utc = "2026-11-23T02:00:00Z";
  out.generator = "tactus test";
  return out;
}

study::Study recorded(int nurses = 3) {
  auto study = support::tableStudy(1, {.nurses = nurses, .rows_per_s = 30});
  for (auto& one : study.participants) one.simulated = false;
  return study;
}

/// The report of a study, as the command makes it.
std::string pageOf(const study::Study& study, elicitation::BuildSettings build = studySettings()) {
  const auto built = elicitation::hasRules(study)
                         ? elicitation::buildModel(study, session::knownForms(support::defaultProcedure()), build)
                         : elicitation::buildTerms(study, build);
  EXPECT_TRUE(built) << built.error().message();
  const auto page = studyReport({.study = study,
                                 .built = *built,
                                 .build_settings = build,
                                 .forms = session::knownForms(support::defaultProcedure()),
                                 .data = session::dataFindings(study),
                                 .settings = {{"Study", "a & b"}},
                                 .replicates = 20});
  EXPECT_TRUE(page) << page.error().message();
  EXPECT_EQ(support::markupFault(*page), "");
  // Scripts are those of the averaged model alone.
  const std::size_t living = page->find("<div id=\"living\"");
  EXPECT_EQ(page->find("<script") == std::string::npos, living == std::string::npos);
  EXPECT_GE(page->find("<script"), living);
  return *page;
}

bool has(const std::string& page, const std::string& text) { return page.find(text) != std::string::npos; }

/// The drawings of a page, outermost `<svg>` elements.
std::vector<std::string> drawings(const std::string& page) {
  std::vector<std::string> out;
  for (std::size_t at = page.find("<div class=\"panel\">"); at != std::string::npos;
       at = page.find("<div class=\"panel\">", at + 1)) {
    out.push_back(page.substr(at, page.find("</svg></div>", at) - at));
  }
  return out;
}

/// Words of the paper's own data and verdicts.
void expectNothingOfTheDemo(const std::string& page) {
  for (const char* text :
       {"recomputed", "S4", "Table A2", "Fig. 6", "published rules", "Claims", "Contradictions in"}) {
    EXPECT_FALSE(has(page, text)) << text;
  }
}

TEST(StudyReport, OfAWholeStudyHasEverySectionAndNumbersItsCaptions) {
  const std::string page = pageOf(recorded());
  for (const char* title :
       {"At a glance", "Participants", "Insertion speed", "Speed clusters and terms", "Insertion force",
        "Membership functions", "Rules", "The experts and their mean", "Force over depth and speed",
        "Influence of tube lubrication, neck flexion angle and insertion speed", "What the hand feels",
        "How far the experts agree", "Findings in the rules", "Reachable range",
        "Does a choice of the method matter here?", "Method", "Notes and settings of this build", "References"}) {
    EXPECT_TRUE(has(page, std::string(">") + title + "</h2>")) << title;
  }
  EXPECT_TRUE(has(page, "<strong>Vertices of the membership functions.</strong>"));
  EXPECT_TRUE(has(page, "<strong>Rules of N1.</strong>"));
  EXPECT_TRUE(has(page, "<strong>Conflicts in newtons.</strong>"));
  EXPECT_TRUE(has(page, "a &amp; b"));
  EXPECT_FALSE(has(page, "What is missing"));
  expectNothingOfTheDemo(page);
  // The numbers run through: as many as there are captions, each once, in order.
  for (const auto& [kind, tag] : {std::pair<const char*, const char*>("Table", "<caption>"),
                                  std::pair<const char*, const char*>("Figure", "<figcaption>")}) {
    const std::string begin = std::string(tag) + "<span class=\"caption-number\">" + kind + ' ';
    int number = 0;
    for (std::size_t at = page.find(begin); at != std::string::npos; at = page.find(begin, at + 1)) {
      EXPECT_EQ(page.compare(at + begin.size(), 3, std::to_string(++number) + ".<", 0, 3), 0) << kind << number;
    }
    EXPECT_EQ(static_cast<std::size_t>(number), countOf(page, tag));
    EXPECT_GT(number, 5) << kind;
  }
}

TEST(StudyReport, StatesHowTheModelWasMade) {
  auto build = studySettings();
  build.speed.alpha = 0.9;
  build.force_terms = elicitation::ForceTermsFrom::kThresholds;
  build.weights.policy = elicitation::WeightPolicy::kYears;
  auto study = recorded();
  for (std::size_t i = 0; i < study.participants.size(); ++i) study.participants[i].years_experience = 5.0 + i;
  const std::string page = pageOf(study, build);
  for (const char* cells :
       {"<td>Clusters c</td><td>3</td>", "<td>Fuzziness m</td><td>2</td>",
        "<td>Core ends at membership α</td><td>0.9</td>", "<td>From</td><td>thresholds</td>",
        "<td>Weights</td><td>years: N1 5, N2 6, N3 7</td>", "<td>Implication</td><td>clip (minimum)</td>",
        "<td>Draws of strokes for intervals</td><td>20</td>"}) {
    EXPECT_TRUE(has(page, cells)) << cells;
  }
}

TEST(StudyReport, HasTheMethodStudyAndMeasuredDepths) {
  const auto study = recorded(2);
  auto build = studySettings();
  const auto inputs = support::ngtInputs();
  build.measured_depths = elicitation::emptyMeasurement(inputs[2]);
  build.measured_depths->image = "scan.png";
  build.depths = elicitation::DepthsFrom::kMeasured;
  const std::string page = pageOf(study, build);
  EXPECT_TRUE(has(page, "<strong>Choices, the largest effect first.</strong>"));
  EXPECT_TRUE(has(page, "atter here: "));
  // The same boundaries as the template's.
  EXPECT_TRUE(has(page,
                  "<th scope=\"row\">Depths of the regions</th><td>measured</td><td>Does not matter here: no other "
                  "choice moves the force.</td>"));
  EXPECT_TRUE(has(page, "<td>Boundaries</td><td>measured on scan.png</td>"));
  EXPECT_FALSE(has(page, "Usability of the simulator"));
}

// Two answers, 5 and 6: mean 5.5, deviation with n - 1 the root of one half.
TEST(StudyReport, HasTheUsabilityScaleWhereItWasAnswered) {
  const auto study = recorded(1);
  const auto built =
      elicitation::buildModel(study, session::knownForms(support::defaultProcedure()), studySettings()).value();
  const auto page = studyReport({.study = study,
                                 .built = built,
                                 .settings = {},
                                 .replicates = 0,
                                 .usability = {{1, 2, 5.5, 0.70710678, 5, 6}, {2, 0, 0, 0, 0, 0}}});
  ASSERT_TRUE(page);
  EXPECT_TRUE(has(*page,
                  "1. The procedure of the simulator is clear.</td><td class=\"number group\">2</td><td "
                  "class=\"number\">5.50</td><td class=\"number\">0.71</td><td class=\"number\">5</td><td "
                  "class=\"number\">6</td>"));
  EXPECT_TRUE(has(*page, "is realistic.</td><td class=\"number group\">0</td><td class=\"number\">–</td>"));
}

TEST(StudyReport, SaysSimulatedInsideEachPictureWithSuchData) {
  auto study = recorded();
  const std::string real = pageOf(study);
  // Only the simulated hand is left: one stroke, force and depth of a placement.
  EXPECT_EQ(countOf(real, ">SIMULATED</text>"), 3U);
  EXPECT_FALSE(has(real, "no person was measured"));

  study.participants[0].simulated = true;
  const std::string mixed = pageOf(study);
  EXPECT_TRUE(has(mixed, "The data of 1 of 3 participants are simulated."));
  for (const auto& drawing : drawings(mixed)) {
    const bool marked = has(drawing, ">SIMULATED</text>");
    const bool of_n1 = has(drawing, "<title>Fast strokes of N1<") || has(drawing, "<title>Speed clusters of N1<");
    const bool of_others = has(drawing, " of N2<") || has(drawing, " of N3<");
    const bool defaults = has(drawing, "functions of tube lubrication<") || has(drawing, "functions of neck flexion") ||
                          has(drawing, "functions of insertion depth<");
    EXPECT_TRUE(marked || !of_n1);
    EXPECT_EQ(marked, !of_others && !defaults) << drawing.substr(0, 300);
  }
}

TEST(StudyReport, SaysWhatIsMissing) {
  const auto whole = recorded();

  auto study = whole;
  study.speeds.clear();
  std::string page = pageOf(study);
  EXPECT_TRUE(has(page, "There are no insertion strokes."));
  EXPECT_FALSE(has(page, ">Insertion speed</h2>"));
  EXPECT_FALSE(has(page, ">Speed clusters and terms</h2>"));
  EXPECT_TRUE(has(page, ">The experts and their mean</h2>"));

  study = whole;
  study.judgements.clear();
  page = pageOf(study);
  EXPECT_TRUE(has(page, "There are no force judgements."));
  EXPECT_FALSE(has(page, ">Insertion force</h2>"));

  study = whole;
  study.answers.clear();
  page = pageOf(study);
  EXPECT_TRUE(has(page, "There are no answers and no rules."));
  EXPECT_TRUE(has(page, ">Insertion force</h2>"));
  EXPECT_TRUE(has(page, ">Speed clusters and terms</h2>"));
  EXPECT_FALSE(has(page, ">The experts and their mean</h2>"));
  EXPECT_TRUE(has(page, ">no force yet<"));

  study = whole;
  std::erase_if(study.speeds, [](const auto& one) { return one.participant == "N2"; });
  EXPECT_TRUE(has(pageOf(study), "Without strokes: N2."));

  study::Study empty;
  EXPECT_TRUE(has(pageOf(empty), "There are no participants."));
}

TEST(StudyReport, OfOneParticipantSaysThatNobodyCanAgree) {
  const std::string page = pageOf(recorded(1));
  EXPECT_TRUE(has(page, "There is one participant only"));
  EXPECT_TRUE(has(page, "There is one expert only"));
  EXPECT_FALSE(has(page, "<strong>Conflicts in newtons.</strong>"));
  EXPECT_TRUE(has(page, "<strong>Rules of N1.</strong>"));
}

TEST(StudyReport, OfManyParticipantsDrawsSomeAndListsAll) {
  const std::string page = pageOf(recorded(14));
  EXPECT_EQ(countOf(page, "<title>Fast strokes of N"), 12U);
  EXPECT_TRUE(has(page, "The first 12 of 14 participants are drawn."));
  EXPECT_TRUE(has(page, "All 14 experts"));
  EXPECT_TRUE(has(page, "<strong>Rules of all experts.</strong>"));
  EXPECT_TRUE(has(page, "The 12 of 14 experts who move the mean most."));
  EXPECT_TRUE(has(page, "<th scope=\"row\">N14</th>"));
}

// A finished comparison and one that was interrupted, of which nothing is said.
TEST(StudyReport, BlindComparisons) {
  const auto study = recorded();
  const auto built = elicitation::buildModel(study, session::knownForms(support::defaultProcedure()), studySettings());
  ASSERT_TRUE(built);
  StudyReportInputs inputs{
      .study = study, .built = *built, .build_settings = studySettings(), .settings = {}, .replicates = 0};
  const auto without = studyReport(inputs);
  ASSERT_TRUE(without);
  EXPECT_FALSE(has(*without, "Blind comparisons"));

  experiments::JudgedDuel duel;
  duel.participant = "N<1>";
  duel.start.a.name = "before";
  duel.start.b.name = "after";
  duel.start.to_mm = 60;
  duel.start.speed_mm_s = 60;
  duel.start.trials = 18;
  auto answers = experiments::simulatedAnswers(duel.start, {4}, 1);
  duel.verdict = experiments::verdictOf(duel.start, answers);
  inputs.duels.push_back(duel);
  answers.pop_back();
  duel.start.setting.simulated = true;
  duel.verdict = experiments::verdictOf(duel.start, answers);
  inputs.duels.push_back(duel);
  const auto page = studyReport(inputs);
  ASSERT_TRUE(page);
  EXPECT_EQ(support::markupFault(*page), "");
  EXPECT_TRUE(has(*page, "Blind comparisons by hand"));
  EXPECT_TRUE(has(*page, "is felt as heavier"));
  EXPECT_TRUE(has(*page, "N&lt;1&gt; (simulated)"));
  EXPECT_TRUE(has(*page, "Not finished"));
}

}  // namespace
}  // namespace tactus::report
