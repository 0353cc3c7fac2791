// The form as a web page: what it holds, and that it needs nothing else.
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <regex>

#include "app/webform/pictures.h"
#include "app/webform/web_form.h"

#include "tests/support/default_procedure.h"

namespace tactus::webform {
namespace {

using PageJson = nlohmann::json;

session::StudyProtocol protocolInThree() {
  session::StudyProtocol protocol;
  protocol.languages = {"en", "zh-Hant", "zh-Hans"};
  protocol.consent_version = "2";
  for (const std::string& language : protocol.languages)
    protocol.consent[language] = "The study </script><b> of " + language;
  protocol.contact = "Dr. Lee";
  return protocol;
}

FormContent contentOf(const session::StudyProtocol& protocol, const std::string& wording = {}) {
  const auto id = study::parseRecordId("00112233445566778899aabbccddeeff");
  auto content = formContent(*id, "A & B", protocol, wording);
  EXPECT_TRUE(content.has_value()) << (content ? "" : content.error().message());
  return content.value_or(FormContent{});
}

PageJson dataOf(const std::string& page) {
  const std::string opening = "<script type=\"application/json\" id=\"content\">";
  const auto begin = page.find(opening) + opening.size();
  return PageJson::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

TEST(WebPage, IsOneFileOfAtMost500KilobytesThatAsksForNothing) {
  const std::string page = webPage(contentOf(protocolInThree()));
  EXPECT_LE(page.size(), 500'000U);
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
  EXPECT_EQ(page.find("{{"), std::string::npos);
  // Addresses stand only in the names of SVG.
  std::string rest = std::regex_replace(page, std::regex("http://www\\.w3\\.org/2000/svg"), "");
  EXPECT_EQ(rest.find("http:"), std::string::npos);
  EXPECT_EQ(rest.find("https:"), std::string::npos);
  EXPECT_EQ(std::regex_search(rest, std::regex("<(link|iframe|object|embed|script src)")), false);
}

TEST(WebPage, AsksTheSameAsTheOtherMediaInEachLanguage) {
  const FormContent content = contentOf(protocolInThree());
  const PageJson data = dataOf(webPage(content));
  EXPECT_EQ(data["study"], "00112233445566778899aabbccddeeff");
  EXPECT_EQ(data["form_sha256"], content.sha256);
  ASSERT_EQ(data["languages"].size(), 3U);
  EXPECT_EQ(data["items"].size(), 45U);
  for (const PageJson& language : data["languages"]) {
    const auto asked =
        questionnaires::questionnaire(support::defaultProcedure(), "ngt-force-v1", language["id"].get<std::string>());
    ASSERT_TRUE(asked.has_value());
    for (const auto& question : asked->questions) {
      const std::string situation = language["items"][std::to_string(question.number)];
      const std::string end = language["question"];
      EXPECT_TRUE(question.text == situation + ' ' + end || question.text == situation + end) << question.text;
    }
    for (const auto& choice : asked->choices) EXPECT_EQ(language["terms"][choice.value], choice.label);
    EXPECT_EQ(language["scale"].size(), 6U);
    EXPECT_FALSE(language["words"]["you.hand"].get<std::string>().empty());
    EXPECT_NE(language["consent"].dump().find("The study </script><b> of"), std::string::npos);
  }
  EXPECT_EQ(data["items"][4]["region"], "esophagus");
  EXPECT_EQ(data["items"][4]["input"], "lubrication");
}

TEST(WebPage, TheHashFollowsWhatIsAskedAndAgreedTo) {
  const FormContent one = contentOf(protocolInThree());
  EXPECT_EQ(one.sha256, contentOf(protocolInThree()).sha256);
  auto other = protocolInThree();
  other.contact = "Dr. Wong";
  EXPECT_EQ(contentOf(other).sha256, one.sha256);
  other.consent["en"] = "Another study";
  EXPECT_NE(contentOf(other).sha256, one.sha256);
  auto english = protocolInThree();
  english.languages = {"en"};
  EXPECT_NE(contentOf(english, "published").sha256, contentOf(english).sha256);
  EXPECT_EQ(dataOf(webPage(contentOf(english, "published")))["languages"][0]["question"], "");
}

TEST(WebPage, AWordingThatNoLanguageOfTheStudyHasIsRefused) {
  auto chinese = protocolInThree();
  chinese.languages = {"zh-Hant"};
  const auto refused = formContent({}, "", chinese, "published");
  ASSERT_FALSE(refused.has_value());
  EXPECT_NE(refused.error().message().find("'published' in zh-Hant"), std::string::npos) << refused.error().message();
}

TEST(WebPage, TheFormOfTheSimulatorAloneHasNoRegions) {
  session::StudyProtocol protocol = protocolInThree();
  protocol.settings = session::usabilitySession();
  const PageJson data = dataOf(webPage(contentOf(protocol)));
  EXPECT_EQ(data["items"].size(), 6U);
  EXPECT_FALSE(data["items"][0].contains("region"));
  EXPECT_EQ(data["languages"][0]["terms"].size(), 7U);
}

// Depths of the regions' middles along the tube, mm, by the arc length of the upright drawing: the screens put the tip
// half of the way between the boundaries 0, 70, 115, 150, 200, 440. The outlines end a little before or behind them.
TEST(WebPage, TheTipLiesInTheMiddleOfItsRegion) {
  const auto all = pictures(support::defaultProcedure());
  ASSERT_EQ(all.size(), 3U);
  const Picture& upright = all.front();
  const std::vector<std::pair<std::string, double>> middles = {
      {"nasal_cavity", 35}, {"nasopharynx", 92.5}, {"oropharynx", 132.5}, {"laryngopharynx", 175}, {"esophagus", 320}};
  for (const auto& [id, middle_mm] : middles) {
    double way_mm = 0;
    bool inside = false;
    for (std::size_t i = 1; i < upright.tube.size(); ++i) {
      const Point& a = upright.tube[i - 1];
      const Point& b = upright.tube[i];
      inside = inside || (a.x == 0 && a.y == 0);  // the nostril
      if (inside) way_mm += std::hypot(b.x - a.x, b.y - a.y);
      for (const PictureRegion& region : upright.regions) {
        if (region.id != id || region.end + 1 != i) continue;
        EXPECT_NEAR(way_mm, middle_mm, 8) << id;
      }
    }
  }
}

}  // namespace
}  // namespace tactus::webform
