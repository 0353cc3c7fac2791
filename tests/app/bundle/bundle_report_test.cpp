// The page that a simulator team reads: what it must know of a model, on two printed pages.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <regex>

#include "app/bundle/bundle.h"
#include "app/bundle/report_parts.h"
#include "core/contracts/contract_check.h"
#include "elicitation/model/model_builder.h"

#include "tests/support/chromium.h"
#include "tests/support/french_probe.h"
#include "tests/support/invented_experts.h"
#include "tests/support/temp_folder.h"
#include "tests/support/two_experts.h"
#include "tests/support/well_formed.h"

namespace tactus::bundle {
namespace {

/// Of four experts whose data are simulated, as `build` notes it.
const Bundle& bundleOfFour() {
  static const Bundle bundle = [] {
    fuzzy::ForceModel model = support::inventedExperts();
    model.provenance = fuzzy::Provenance{"a study", {}, {{"simulated", R"(["E1","E2"])"}}, "Simulated: E1, E2."};
    model.renderer.emplace();
    auto made = makeBundle(std::move(model), {{}, "2026-11-22T08:00:00Z", "tactus test", 0.2});
    EXPECT_TRUE(made) << made.error().message();
    return std::move(*made);
  }();
  return bundle;
}

std::string reportOf(const Bundle& bundle) { return bundleReport(bundle, *fuzzy::compile(bundle.model)); }

/// What a reader sees: without scripts, styles and drawings.
std::string readableOf(const std::string& page) {
  std::string out = page;
  for (const auto& [begin, end] :
       {std::pair<std::string, std::string>{"<script", "</script>"}, {"<style", "</style>"}, {"<svg", "</svg>"}}) {
    for (std::size_t at = out.find(begin); at != std::string::npos; at = out.find(begin))
      out.erase(at, out.find(end, at) + end.size() - at);
  }
  return out;
}

TEST(BundleReport, SaysWhichPromisesAreKept) {
  fuzzy::ForceModel model = support::inventedExperts();
  for (const char* const sentence : {"the force is never above 5 N", "the force is never above 0.3 N"}) {
    auto contract = contracts::parseContract(model, sentence);
    ASSERT_TRUE(contract) << contract.error().message();
    contract->id = "c" + std::to_string(model.contracts.size());
    model.contracts.push_back(*contract);
  }
  // A bundle of such a model is refused; its report could not hide it.
  Bundle bundle = bundleOfFour();
  bundle.model = model;
  const std::string text = readableOf(reportOf(bundle));
  EXPECT_NE(text.find("Promises"), std::string::npos);
  EXPECT_NE(text.find("the force is never above 5 N: proved at every place of the inputs."), std::string::npos);
  EXPECT_NE(text.find("the force is never above 0.3 N: NOT kept, by "), std::string::npos);
  EXPECT_EQ(readableOf(reportOf(bundleOfFour())).find("Promises"), std::string::npos);
}

TEST(BundleReport, SaysWhatASimulatorTeamMustKnow) {
  const Bundle& bundle = bundleOfFour();
  const std::string page = reportOf(bundle);
  const std::string text = readableOf(page);
  EXPECT_EQ(support::markupFault(page), "");
  const std::string& sha = bundle.model_sha256;
  for (const std::string& word :
       {std::string("Simulated: E1, E2."), sha.substr(0, 16) + " " + sha.substr(16, 16) + " " + sha.substr(32, 16),
        std::string("Regions along the depth"), std::string("aryngopharynx"), std::string("There is no such place."),
        std::string("step of"), std::string("JND"), std::string("dF/dx"), std::string("dF/dv"),
        std::string("stiffness_n_mm"), std::string("mean distance (N)"), std::string("experts/*.fll"),
        std::string("c/force_model.c"), std::string("checks_tube.csv"), std::string("tactus verify")}) {
    EXPECT_NE(text.find(word), std::string::npos) << word;
  }
  EXPECT_EQ(text.find("[\""), std::string::npos) << "JSON in a sentence";
  EXPECT_EQ(text.find("&quot;"), std::string::npos) << "JSON in a sentence";
  std::smatch digits;
  EXPECT_FALSE(std::regex_search(text, digits, std::regex("[1-9][0-9]*\\.[0-9]{3}|0\\.0*[1-9][0-9]{2}")))
      << digits.str();
  EXPECT_EQ(support::countOf(text, ".fll"), 1U);
  EXPECT_LT(page.size(), 300'000U);
}

TEST(BundleReport, HasTwoPrintedPages) {
  if (!support::hasChromium()) GTEST_SKIP() << "chromium is not installed, so the report was not printed";
  const support::TempFolder folder;
  const std::string file = folder.file("report.html");
  std::ofstream(file) << reportOf(bundleOfFour());
  EXPECT_EQ(support::printedPages(file, folder.file("report.pdf")), 2);
}

// NC and NP cross at 70 mm, NP and LP at 115 mm, LP and ES at 200 mm: the middles of their common slopes.
TEST(BundleReport, FindsTheRegionsAndTheirForces) {
  const auto model = support::inventedExperts();
  const auto compiled = fuzzy::compile(model);
  const auto regions = regionNumbers(model, *compiled);
  ASSERT_EQ(regions.size(), 5U);
  const double limits[] = {0, 70, 115, 200, 440, 600};
  for (std::size_t r = 0; r < regions.size(); ++r) {
    if (r != 3 && r != 4) {
      EXPECT_NEAR(regions[r].from_mm, limits[r], 0.11) << r;
    }
    ASSERT_TRUE(regions[r].lowest_n && regions[r].highest_n);
    EXPECT_LT(*regions[r].lowest_n, *regions[r].highest_n);
    // Every force of the region at other points lies between.
    const std::vector<double> point = {0.37, 41, (regions[r].from_mm + regions[r].to_mm) / 2, 77};
    const double force = compiled->evaluate(point).force_n;
    EXPECT_LE(*regions[r].lowest_n, force + 0.02);
    EXPECT_GE(*regions[r].highest_n, force - 0.02);
  }
}

// Near, A alone fires: 0.25 N and 0.75 N weighted by slow and fast. At 4.5 mm near holds by a half: from 40 to 40.4
// mm/s slow stays a half and fast rises from 0 to 0.02, so the force rises from 1/4 N to 0.14/0.52 N. Far, A says 0.75
// N and B 0.25 N.
TEST(BundleReport, SlopesAndAgreementAreThoseOfAHandCalculation) {
  const auto model = tests::twoExperts();
  const auto compiled = fuzzy::compile(model);
  const auto slope = largestSlope(model, *compiled, *fuzzy::rateOf(model.inputs));
  ASSERT_TRUE(slope);
  EXPECT_NEAR(slope->slope, 1 / 20.8, 1e-9);
  const auto b = agreementOf(model, *compiled, 1);
  ASSERT_TRUE(b);
  EXPECT_NEAR(b->mean_n, 0.25, 1e-9);
  EXPECT_EQ(b->within_jnd, 0);
  const auto a = agreementOf(model, *compiled, 0);
  ASSERT_TRUE(a);
  EXPECT_GT(a->within_jnd, 0.4);
  EXPECT_LT(a->mean_n, 0.15);
}

TEST(BundleReport, OfAnotherProcedureHasItsWords) {
  const study::Study study = support::probeStudy();
  elicitation::BuildSettings settings;
  settings.created_utc = "2026-11-22T08:00:00Z";
  const auto built = elicitation::buildModel(study, study.procedure->forms, settings);
  ASSERT_TRUE(built) << built.error().message();
  const auto made = makeBundle(built->model, {{}, "2026-11-22T08:00:00Z", "tactus test", 0.2});
  ASSERT_TRUE(made) << made.error().message();
  for (const auto& [path, bytes] : made->files) {
    std::string text = bytes;
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    for (const char* word : {"naso", "esoph", "nostril", "neck", "stomach", "lubric"})
      EXPECT_EQ(text.find(word), std::string::npos) << path << " says " << word;
  }
  const std::string page = readableOf(reportOf(*made));
  EXPECT_NE(page.find("at the middle of 2 words of “Etat A”."), std::string::npos);
  EXPECT_NE(page.find("Largest slope over the depth"), std::string::npos);
  EXPECT_EQ(page.find("over the speed"), std::string::npos);
}

TEST(BundleReport, GivesTwoDigits) {
  EXPECT_EQ(shortly(0.47825757575757577), "0.48");
  EXPECT_EQ(shortly(1.1000000000000002e-12), "1.1e-12");
  EXPECT_EQ(shortly(75.49262570548393), "75");
  EXPECT_EQ(shortly(0), "0");
}

}  // namespace
}  // namespace tactus::bundle
