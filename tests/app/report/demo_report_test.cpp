#include <algorithm>
#include <gtest/gtest.h>

#include "app/report/study_report.h"
#include "app/session/study_source.h"
#include "core/base/text.h"
#include "questionnaires/published_rules.h"

#include "tests/support/default_procedure.h"
#include "tests/support/simulated_ngt_study.h"
#include "tests/support/well_formed.h"

namespace tactus::report {
namespace {

elicitation::BuildSettings settings() {
  elicitation::BuildSettings out;
  out.created_utc = "2026-11-21T08:00:00Z";
  out.generator = "tactus test";
  return out;
}

const study::Study& demoStudy() {
  static const study::Study kStudy = support::simulatedNgtStudy(1);
  return kStudy;
}

/// The report of the demo study, made once for all tests.
const std::string& page() {
  static const std::string kPage = [] {
    std::vector<S4Reading> readings;
    const auto& study = demoStudy();
    for (const auto& reading : questionnaires::s4Readings()) {
      auto in_reading = study;
      in_reading.rules = questionnaires::s4Rules(reading.id).value();
      const auto built =
          elicitation::buildModel(in_reading, session::knownForms(support::defaultProcedure()), settings());
      readings.push_back({reading.title, reading.assumes, elicitation::expertModel(built->model, "S4").value()});
    }
    const auto built =
        elicitation::buildModel(study, session::knownForms(support::defaultProcedure()), settings()).value();
    const DemoReportInputs inputs{.study = study,
                                  .built = built,
                                  .readings = readings,
                                  .forms = session::knownForms(support::defaultProcedure()),
                                  .settings = {{"Seed <1>", "1 & only"}}};
    return demoReport(inputs).value();
  }();
  return kPage;
}

bool has(const std::string& text) { return page().find(text) != std::string::npos; }

TEST(DemoReport, IsWellFormedSelfContainedAndSmall) {
  EXPECT_EQ(support::markupFault(page()), "");
  EXPECT_FALSE(has("<script"));
  EXPECT_FALSE(has("src="));
  EXPECT_FALSE(has("url("));
  // The only address in it is the name of the SVG name space.
  EXPECT_EQ(support::countOf(page(), "http:"), support::countOf(page(), "xmlns=\"http://www.w3.org/2000/svg\""));
  EXPECT_LT(page().size(), 3'000'000U);
  EXPECT_TRUE(has("Seed &lt;1&gt;"));
}

TEST(DemoReport, HasEverySection) {
  for (const char* title :
       {"At a glance", "What is published and what is simulated", "Insertion speed", "Speed clusters and terms",
        "Insertion force", "Membership functions", "Force over depth and speed",
        "Influence of tube lubrication, neck flexion angle and insertion speed", "Four experts and their mean",
        "How far the experts agree", "Findings in the rules", "What the paper says, checked",
        "The published rules in three readings", "Reachable range", "Contradictions in the paper",
        "Notes and settings of this build"}) {
    EXPECT_TRUE(has(std::string(">") + title + "</h2>")) << title;
  }
}

TEST(DemoReport, HasEveryTableAndFigureOfThePaper) {
  for (const char* caption : {"Table 1, ", "Table 2 ", "Fig. 3, ", "Fig. 6, ", "Fig. 7, ", "Fig. 8 ", "Fig. 9, ",
                              "Fig. 10, ", "Fig. 11, ", "Table A2 at the setting of Fig. 11", "Claims checklist"}) {
    EXPECT_TRUE(has(std::string("<strong>") + caption)) << caption;
  }
}

/// From `begin` to the next `end`.
std::vector<std::string> pieces(const std::string& begin, const std::string& end) {
  std::vector<std::string> out;
  for (std::size_t at = page().find(begin); at != std::string::npos; at = page().find(begin, at + 1)) {
    out.push_back(page().substr(at, page().find(end, at) - at));
  }
  return out;
}

TEST(DemoReport, EveryFigureSaysThatItIsSimulated) {
  const auto captions = pieces("<figcaption>", "</figcaption>");
  EXPECT_GE(captions.size(), 8U);
  for (const std::string& caption : captions) {
    EXPECT_NE(caption.find("<span class=\"badge simulated\">"), std::string::npos) << caption;
  }
}

TEST(DemoReport, ShowsThePublishedNumbersBesideTheSimulatedOnes) {
  const auto rows = pieces("<tr>", "</tr>");
  const auto row = [&](const std::string& a, const std::string& b) {
    return std::any_of(rows.begin(), rows.end(), [&](const std::string& each) {
      return each.find(a) != std::string::npos && each.find(b) != std::string::npos;
    });
  };
  // Table 1, S1 fast: the simulated strokes promise it to 0.04 mm/s.
  bool near = false;
  for (int hundredths = -4; hundredths <= 4; ++hundredths) {
    near = near || row(">256.7<", '>' + base::formatFixed(256.7 + hundredths / 100.0, 2) + '<');
  }
  EXPECT_TRUE(near);
  EXPECT_TRUE(row(">0.3<", "<strong>Small</strong>"));       // Table 2: the tie at 0.3 N
  EXPECT_TRUE(row(">0.9<", "<strong>Very large</strong>"));  // and the double majority at 0.9 N
  EXPECT_TRUE(has("They are exactly those that the paper prints."));
}

TEST(DemoReport, SaysHowFarTheExpertsAgree) {
  // Table 2 by other programs (tests/golden/agreement); W is of one split of its votes.
  EXPECT_TRUE(has("<strong>0.551</strong>"));
  EXPECT_TRUE(has(">0.093 (1.44)<"));
  EXPECT_TRUE(has(">0.894<"));
  EXPECT_TRUE(has("reconstructed split"));
  EXPECT_TRUE(has("neck flexion large"));
  EXPECT_TRUE(has("Change of the mean (N)"));
  EXPECT_TRUE(has("Frequency curve, least squares"));
}

TEST(DemoReport, ShowsHowFarTheSpeedsCanBeTrusted) {
  EXPECT_TRUE(has("<strong>Levels against clusters.</strong>"));
  EXPECT_TRUE(has("<strong>95 % intervals.</strong>"));
  EXPECT_TRUE(has("2000 draws of whole strokes"));
  EXPECT_TRUE(has(">95 % interval of a center</text>"));
  EXPECT_TRUE(has("read as slow; with speed terms of the participant"));  // S4
  // The best order of 3 times 4 strokes, which the levels of S1 and S3 have: one of 34,650 arrangements.
  EXPECT_TRUE(has(">48 of 48</td>"));
  EXPECT_TRUE(has(">&lt; 0.001</td>"));
}

TEST(DemoReport, LeadsWithTheVerdictsAndLinksToTheirReasons) {
  const auto summary = page().find("Does the model say what the paper says?");
  ASSERT_NE(summary, std::string::npos);
  EXPECT_LT(summary, page().find("<h2 id=\"what-is-published-and-what-is-simulated\">"));
  EXPECT_TRUE(has("href=\"#what-the-paper-says-checked\">What the paper says, checked</a>."));
  EXPECT_TRUE(has("<h2 id=\"what-the-paper-says-checked\">"));
}

TEST(DemoReport, MarksTheHoleOfThePrintedReading) {
  EXPECT_TRUE(has(">hole</text>"));
  EXPECT_TRUE(has("No rule fires at 125 to 138 mm."));
}

TEST(DemoReport, AModelWithoutThePublishedExpertIsRefused) {
  const auto& study = demoStudy();
  auto built = elicitation::buildModel(study, session::knownForms(support::defaultProcedure()), settings()).value();
  std::erase_if(built.model.experts, [](const fuzzy::Expert& expert) { return expert.id == "S4"; });
  const DemoReportInputs inputs{.study = study, .built = built, .readings = {}, .settings = {}};
  EXPECT_FALSE(demoReport(inputs));
}

}  // namespace
}  // namespace tactus::report
