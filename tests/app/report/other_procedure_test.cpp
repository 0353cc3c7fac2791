// The report of a study that is not about the procedure of the paper.
#include <cctype>
#include <gtest/gtest.h>

#include "app/report/study_report.h"

#include "tests/support/french_probe.h"
#include "tests/support/well_formed.h"

namespace tactus::report {
namespace {

std::string pageOfProbe(const support::ProbeTraits& traits, int participants = 3) {
  const study::Study study = support::probeStudy(traits, participants);
  elicitation::BuildSettings settings;
  settings.created_utc = "2026-11-23T02:00:00Z";
  settings.generator = "tactus test";
  const auto built = elicitation::buildModel(study, study.procedure->forms, settings);
  EXPECT_TRUE(built) << built.error().message();
  const auto page = studyReport({.study = study,
                                 .built = *built,
                                 .build_settings = settings,
                                 .forms = study.procedure->forms,
                                 .settings = {},
                                 .replicates = 20});
  EXPECT_TRUE(page) << page.error().message();
  EXPECT_EQ(support::markupFault(*page), "");
  return *page;
}

bool says(const std::string& page, const std::string& text) { return page.find(text) != std::string::npos; }

/// Words of the paper's procedure, in any case.
void expectNothingOfThePaper(std::string page) {
  for (char& c : page) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const char* text : {"naso", "esoph", "nostril", "neck", "stomach", "lubric", "fig. 1", "nasal"}) {
    const std::size_t at = page.find(text);
    EXPECT_EQ(at, std::string::npos) << text << " in: " << page.substr(at < 100 ? 0 : at - 100, 200);
  }
}

TEST(OtherProcedure, OfTwoInputsHasEverySectionThatIsNotOfASpeed) {
  const std::string page = pageOfProbe({});
  expectNothingOfThePaper(page);
  for (const char* text : {"At a glance",
                           "Sonde articulaire, pack sonde-articulaire, version 3. Une sonde dans une articulation.",
                           "Try the model",
                           "Insertion force",
                           "Membership functions",
                           "Rules",
                           "The experts and their mean",
                           "Influence of etat a",
                           "What the hand feels",
                           "How far the averaged force can be trusted",
                           "How far the experts agree",
                           "Findings in the rules",
                           "(more etat a more force) follow the procedure",
                           "Reachable range",
                           "Does a choice of the method matter here?",
                           "Method",
                           "those of the procedure",
                           "Of the procedure: Manuel de la sonde",
                           "etat a 0.25",
                           "PE peau, CA capsule, AR articulation"}) {
    EXPECT_TRUE(says(page, text)) << text;
  }
  for (const char* text : {"Speed clusters", "Force over depth and speed", "no insertion strokes", "Speed terms"})
    EXPECT_FALSE(says(page, text)) << text;
}

TEST(OtherProcedure, OfSixInputsHasAllOfThem) {
  const std::string page = pageOfProbe({.conditions = 4, .rate_words = 2});
  expectNothingOfThePaper(page);
  for (const char* text : {"Influence of etat a, etat b, etat c, etat d and allure", "Speed clusters and terms",
                           "Ramp lente, mesuree", "Strokes at the level “mesuree”", "Force over depth and speed",
                           "at etat a 0.25, etat b 0.25, etat c 0.25, etat d 0.25", "(e) Allure"}) {
    EXPECT_TRUE(says(page, text)) << text;
  }
  EXPECT_FALSE(says(page, "Ramp mesuree"));
}

TEST(OtherProcedure, OfTheWayAloneIsShown) {
  const std::string page = pageOfProbe({.conditions = 0, .rate_words = 1});
  EXPECT_TRUE(says(page, "Influence of allure"));
  EXPECT_TRUE(says(page, "Centers"));
}

TEST(OtherProcedure, WithoutAnswersShowsItsTerms) {
  study::Study study = support::probeStudy();
  study.answers.clear();
  const auto built = elicitation::buildTerms(study, {});
  ASSERT_TRUE(built) << built.error().message();
  const auto page = studyReport({.study = study, .built = *built, .settings = {}, .replicates = 0});
  ASSERT_TRUE(page) << page.error().message();
  expectNothingOfThePaper(*page);
  EXPECT_TRUE(says(*page, "There are no answers and no rules."));
}

}  // namespace
}  // namespace tactus::report
