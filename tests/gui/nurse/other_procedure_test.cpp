// The nurse's screens of another procedure: a small pack of two inputs and four words of force, in English and French,
// without a picture; and one with a picture for each pose.
#include <QApplication>
#include <QDir>
#include <QLocale>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/workbench/anatomy/body_view.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/participant/kit/choices.h"
#include "app/workbench/participant/screens/device_screens.h"
#include "app/workbench/participant/screens/question_screens.h"
#include "app/workbench/participant/screens/review_screen.h"
#include "app/workbench/participant/screens/sample_screens.h"

#include "tests/gui/text_recorder.h"

namespace tactus::workbench::nurse {
namespace {

using Json = nlohmann::ordered_json;
using ProcedurePtr = std::shared_ptr<const procedure::Procedure>;

Json term(const char* id, std::vector<double> points) { return {{"id", id}, {"label", id}, {"points", points}}; }

Json both(const char* english, const char* french) { return {{"en", english}, {"fr", french}}; }

/// A dilator along a duct: three parts, two words of cream, four of force, one text in English alone.
ProcedurePtr duct() {
  const Json manifest = {
      {"format", "tactus-procedure"},
      {"version", 1},
      {"id", "duct-dilator"},
      {"pack_version", 1},
      {"title", both("Duct dilator", "Dilatateur")},
      {"languages", {"en", "fr"}},
      {"about", "A dilator in a duct."},
      {"inputs",
       {{{"id", "cream"},
         {"label", "Cream"},
         {"unit", "1"},
         {"min", 0},
         {"max", 1},
         {"role", "condition"},
         {"terms", {term("none", {0, 0, 0.4, 0.6}), term("plenty", {0.4, 0.6, 1, 1})}}},
        {{"id", "place"},
         {"label", "Place"},
         {"unit", "mm"},
         {"min", 0},
         {"max", 60},
         {"role", "way"},
         {"terms", {term("mouth", {0, 0, 8, 12}), term("trunk", {8, 12, 38, 42}), term("end", {38, 42, 60, 60})}}}}},
      {"output",
       {{"id", "force"},
        {"label", "Force"},
        {"unit", "N"},
        {"min", 0},
        {"max", 2},
        {"terms",
         {term("tiny", {0, 0, 0.3, 0.5}), term("little", {0.3, 0.5, 0.9, 1.1}), term("much", {0.9, 1.1, 1.4, 1.6}),
          term("most", {1.4, 1.6, 2, 2})}}}},
      {"forms", {"form.json"}},
      {"wordings", {"form.en.json", "form.fr.json"}},
      {"words", "words.json"}};
  Json items = Json::array();
  int number = 100;
  for (const char* cream : {"none", "plenty"}) {
    for (const char* place : {"mouth", "trunk", "end"})
      items.push_back({{"number", ++number}, {"if", {{"place", place}, {"cream", cream}}}});
  }
  const Json answers = {{{"term", "tiny"}, {"word", "Tiny"}},
                        {{"term", "little"}, {"word", "Little"}},
                        {{"term", "much"}, {"word", "Much"}},
                        {{"term", "most"}, {"word", "Most"}}};
  const Json form = {{"format", "tactus-form"}, {"id", "duct-v1"},    {"version", 1},  {"title", "Duct"},
                     {"source", "own"},         {"answers", answers}, {"items", items}};
  const auto wording = [](const char* language, const Json& phrases, const Json& words, const char* question) {
    return Json{{"format", "tactus-form-wording"},
                {"form", "duct-v1"},
                {"form_version", 1},
                {"wording", "plain"},
                {"language", language},
                {"title", "Duct"},
                {"instructions", question},
                {"order", {"cream", "place"}},
                {"question", question},
                {"phrases", phrases},
                {"answers", words}};
  };
  const Json english = {
      {"cream", {{"none", "There is no cream."}, {"plenty", "There is plenty of cream."}}},
      {"place",
       {{"mouth", "It is in the mouth of the duct."}, {"trunk", "It is in the trunk."}, {"end", "It is at the end."}}}};
  const Json french = {
      {"cream", {{"none", "Sans crème."}, {"plenty", "Avec beaucoup de crème."}}},
      {"place", {{"mouth", "Il est à l'entrée."}, {"trunk", "Il est dans le tronc."}, {"end", "Il est au bout."}}}};
  const Json words = {{"format", "tactus-words"},
                      {"texts",
                       {{"tool", both("the dilator", "le dilatateur")},
                        {"con.purpose", both("We want to learn how a dilator feels.",
                                             "Nous voulons savoir comment on sent un dilatateur.")},
                        {"you.years", both("For how many years have you used dilators?",
                                           "Depuis combien d'années utilisez-vous des dilatateurs ?")},
                        {"a.mouth", both("Mouth", "Entrée")},
                        {"a.trunk", both("Trunk", "Tronc")},
                        {"a.end", both("End", "Bout")},
                        {"s.cream", both("Cream", "Crème")},
                        {"s.cream.none", both("None", "Aucune")},
                        {"s.cream.plenty", both("Plenty", "Beaucoup")},
                        {"glo.cream", both("Cream: how much of it there is.", "Crème : sa quantité.")},
                        {"glo.way", {{"en", "The dilator passes three parts."}}},
                        {"nav.next", both("Next", "Suivant")},
                        {"w.tiny", both("Tiny", "Infime")},
                        {"w.little", both("Little", "Peu")},
                        {"w.much", both("Much", "Fort")},
                        {"w.most", both("Most", "Très fort")}}}};
  procedure::PackFiles files;
  files["procedure.json"] = manifest.dump();
  files["form.json"] = form.dump();
  files["form.en.json"] =
      wording("en", english, {{"tiny", "Tiny"}, {"little", "Little"}, {"much", "Much"}, {"most", "Most"}},
              "How large is the force?")
          .dump();
  files["form.fr.json"] =
      wording("fr", french, {{"tiny", "Infime"}, {"little", "Peu"}, {"much", "Fort"}, {"most", "Très fort"}},
              "Quelle est la force ?")
          .dump();
  files["words.json"] = words.dump();
  auto read = procedure::readProcedure(files, "duct");
  if (!read) throw std::runtime_error(read.error().message());
  return std::make_shared<const procedure::Procedure>(*std::move(read));
}

class OtherProcedure : public testing::Test {
 protected:
  OtherProcedure() {
    look.setAbout(duct());
    look.setScreen(96, {1280, 720});
  }

  std::unique_ptr<QWidget> shown(const SampleScreen& sample) const {
    std::unique_ptr<QWidget> screen = sample.make(look);
    screen->resize(1280, 720);
    screen->show();
    QCoreApplication::processEvents();
    return screen;
  }
  SampleScreen sampleCalled(const QString& name) const {
    for (SampleScreen& sample : sampleScreens(look)) {
      if (sample.name == name) return std::move(sample);
    }
    ADD_FAILURE() << "no screen " << name.toStdString();
    return {};
  }
  QStringList wordsOn(const QString& name) const {
    QStringList out;
    for (const auto& written : tests::textsOf(*shown(sampleCalled(name)))) out << written.text.trimmed();
    return out;
  }

  Look look;
};

QStringList cardsOf(const QWidget& screen) {
  QStringList out;
  for (const auto* card : screen.findChildren<AnswerCard*>()) out << card->id();
  return out;
}

// The statements for clinical teachers are those of the paper.
bool isOfThePaper(const QString& name) { return name.startsWith(QLatin1String("usability")); }

TEST_F(OtherProcedure, NoScreenSpeaksOfTheDefaultOne) {
  for (const char* language : {"en", "fr"}) {
    look.setLanguage(Language{QString::fromLatin1(language)});
    for (const SampleScreen& sample : sampleScreens(look)) {
      if (isOfThePaper(sample.name)) continue;
      const auto screen = shown(sample);
      if (const QByteArray folder = qgetenv("TACTUS_PICTURES"); !folder.isEmpty()) {
        const QDir dir(QString::fromLocal8Bit(folder) + QLatin1String("/duct_") + QLatin1String(language));
        dir.mkpath(QStringLiteral("."));
        EXPECT_TRUE(screen->grab().save(dir.filePath(sample.name + QStringLiteral(".png"))));
      }
      QStringList texts;
      for (const auto& written : tests::textsOf(*screen)) texts << written.text;
      for (const QWidget* part : screen->findChildren<QWidget*>()) texts << part->accessibleName();
      for (const QString& text : texts) {
        for (const char* word :
             {"naso", "esoph", "neck", "nostril", "stomach", "nose", "throat", "tube", "lubric", "45"})
          EXPECT_FALSE(text.contains(QLatin1String(word), Qt::CaseInsensitive))
              << sample.name.toStdString() << ": " << text.toStdString();
      }
    }
  }
}

TEST_F(OtherProcedure, OffersItsLanguagesByTheirOwnNames) {
  EXPECT_EQ(languagesOf(*look.about()), (std::vector<QString>{QStringLiteral("en"), QStringLiteral("fr")}));
  const QStringList words = wordsOn(QStringLiteral("welcome"));
  EXPECT_TRUE(words.contains(QStringLiteral("English")));
  EXPECT_TRUE(words.contains(QStringLiteral("Français")));
}

TEST_F(OtherProcedure, ATextThatALanguageLacksIsInTheFirstOne) {
  const Language french{QStringLiteral("fr")};
  EXPECT_EQ(look.say(phrase(QStringLiteral("nav.next")), french), "Suivant");
  EXPECT_EQ(look.say(phrase(QStringLiteral("nav.back")), french), "Back") << "the program's own text";
  EXPECT_EQ(look.say(phrase(QStringLiteral("glo.way")), french), "The dilator passes three parts.");
  EXPECT_EQ(look.say(phrase(QStringLiteral("q.item.105")), french),
            QStringLiteral("Avec beaucoup de crème. Il est dans le tronc."));
  EXPECT_EQ(look.say(phrase(QStringLiteral("q.ask.105")), french), "Quelle est la force ?");
  EXPECT_EQ(look.say(phrase(QStringLiteral("you.hand")), french), "Which hand guides le dilatateur?");
  EXPECT_EQ(look.say(phrase(QStringLiteral("thx.curve")), Language::kEnglish),
            "Your force along the way of the dilator");
}

TEST_F(OtherProcedure, TheForceHasFourWordsAndTheirKeys) {
  ForceScreen screen(look);
  ParticipantState state;
  state.force.phase = ForceState::Phase::kAnswer;
  screen.setState(state);
  screen.show();
  EXPECT_EQ(cardsOf(screen), (QStringList{"tiny", "little", "much", "most", "not_felt", "beyond_practice"}));
  QSignalSpy picks(&screen, &ScreenFrame::picked);
  for (const Qt::Key key : {Qt::Key_1, Qt::Key_4, Qt::Key_5, Qt::Key_0}) QTest::keyClick(&screen, key);
  ASSERT_EQ(picks.count(), 3) << "there is no fifth word";
  EXPECT_EQ(picks[0][0], "tiny");
  EXPECT_EQ(picks[1][0], "most");
  EXPECT_EQ(picks[2][0], "not_felt");
}

TEST_F(OtherProcedure, AQuestionSaysItsConditionsAndTheRegion) {
  const QString sentence = wordsOn(QStringLiteral("question_cream")).join(QLatin1Char(' '));
  EXPECT_TRUE(sentence.contains(QStringLiteral("There is plenty of cream. It is at the end.")))
      << sentence.toStdString();
  EXPECT_TRUE(sentence.contains(QStringLiteral("How large is the force?")));
  EXPECT_TRUE(sentence.contains(QStringLiteral("of 6")));
  for (const char* region : {"Mouth", "Trunk", "End"}) EXPECT_TRUE(sentence.contains(QLatin1String(region))) << region;
}

TEST_F(OtherProcedure, TheReviewHasTheWordsBesideAndTheRegionsBelow) {
  ParticipantState state;
  for (const study::FormItem& item : look.form().items) {
    state.review.answers.push_back(
        {item.number, {item.conditions[1]}, QString::fromStdString(item.conditions[0].term), QStringLiteral("much")});
  }
  const auto pages = reviewPages(*look.about(), look.form(), state.review.answers);
  ASSERT_EQ(pages.size(), 1U);
  EXPECT_EQ(pages[0].input, "cream");
  EXPECT_EQ(pages[0].terms, (std::vector<std::string>{"none", "plenty"}));
  EXPECT_EQ(pages[0].regions, (std::vector<QString>{"mouth", "trunk", "end"}));
  ASSERT_NE(pages[0].answer(state.review.answers, 2, 1), nullptr);
  EXPECT_EQ(pages[0].answer(state.review.answers, 2, 1)->item, 106);

  ReviewScreen screen(look);
  screen.setState(state);
  EXPECT_EQ(screen.findChildren<ReviewCell*>().size(), 6);
  QSignalSpy sealed(&screen, &ScreenFrame::primary);
  screen.show();
  QTest::keyClick(&screen, Qt::Key_Return);
  EXPECT_EQ(sealed.count(), 1) << "the only page is the last one";
}

// Two conditions in one item: a page for each word of the first one.
TEST_F(OtherProcedure, AnswersOfTwoConditionsHaveAPageForEachWordOfTheFirst) {
  const procedure::Procedure& catheter = *procedure::builtIn("male-urethral-catheter");
  std::vector<ReviewAnswer> answers;
  int number = 0;
  for (const char* gel : {"generous", "little"}) {
    for (const char* angle : {"upright", "lying"}) {
      for (const char* region : {"bulb", "fossa"})
        answers.push_back({++number, {{"angle", angle}, {"lubrication", gel}}, QString::fromLatin1(region), {}});
    }
  }
  answers.push_back({++number, {}, QStringLiteral("bulb"), {}});
  answers.push_back({++number, {{"speed", "fast"}}, {}, {}});
  const auto pages = reviewPages(catheter, catheter.forms.front(), answers);
  ASSERT_EQ(pages.size(), 4U);
  EXPECT_EQ(pages[0].fixed, (std::vector<study::ItemCondition>{{"lubrication", "generous"}}));
  EXPECT_EQ(pages[0].terms, (std::vector<std::string>{"lying", "upright"}));
  EXPECT_EQ(pages[0].regions, (std::vector<QString>{"fossa", "bulb"}));
  ASSERT_NE(pages[1].answer(answers, 1, 0), nullptr);
  EXPECT_EQ(pages[1].answer(answers, 1, 0)->item, 7) << "little, lying, bulb";
  EXPECT_EQ(pages[2].input, "");
  ASSERT_NE(pages[3].answer(answers, 0, 0), nullptr);
  EXPECT_EQ(pages[3].answer(answers, 0, 0)->item, 10);
}

TEST_F(OtherProcedure, TheGlossaryExplainsItsOwnConditions) {
  GlossaryScreen screen(look);
  EXPECT_EQ(screen.pages(), 4);  // what to do, force, way, cream
  EXPECT_TRUE(
      wordsOn(QStringLiteral("glossary_4")).join(QLatin1Char(' ')).contains(QStringLiteral("how much of it there is")));
}

TEST_F(OtherProcedure, WithoutARateNoInsertionsAreShown) {
  for (const SampleScreen& sample : sampleScreens(look)) EXPECT_FALSE(sample.name.startsWith(QLatin1String("speed")));
}

QImage pictureOf(anatomy::BodyView& view) { return view.grab().toImage().convertToFormat(QImage::Format_RGB32); }

TEST(BodyView, ShowsThePictureOfThePoseAndTheUsualOneOtherwise) {
  const auto catheter = procedure::builtIn("male-urethral-catheter");
  EXPECT_TRUE(anatomy::showsPose(*catheter, "angle"));
  EXPECT_FALSE(anatomy::showsPose(*catheter, "lubrication"));
  const std::unique_ptr<anatomy::BodyView> view(anatomy::makeBodyView(catheter, nullptr));
  view->resize(500, 400);
  const QImage usual = pictureOf(*view);
  view->setPose({"angle", "upright"});
  const QImage upright = pictureOf(*view);
  EXPECT_NE(upright, usual);
  view->setPose({"angle", "half_raised"});
  EXPECT_NE(pictureOf(*view), upright);
  view->setPose({"lubrication", "little"});
  EXPECT_EQ(pictureOf(*view), usual);
}

/// How many pixels have lost most of their blue to the color of the lit region, which leaves the lines of the drawing.
int litPixels(const QImage& picture, const QImage& unlit) {
  int count = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x)
      count += picture.pixelColor(x, y).blue() < 0.6 * unlit.pixelColor(x, y).blue() ? 1 : 0;
  }
  return count;
}

TEST(BodyView, LightsTheRegionAndAPartOfIt) {
  for (const ProcedurePtr& about : {ProcedurePtr(procedure::builtIn("male-urethral-catheter")), duct()}) {
    const std::unique_ptr<anatomy::BodyView> view(anatomy::makeBodyView(about, nullptr));
    view->resize(500, 400);
    const QImage unlit = pictureOf(*view);
    const std::string region = about->wayInput().terms.back().id;
    const auto range = anatomy::rangeOf(*about, region);
    ASSERT_TRUE(range.has_value());
    view->lightRegion(QString::fromStdString(region));
    const int whole = litPixels(pictureOf(*view), unlit);
    EXPECT_GT(whole, 300) << about->id;
    view->light(anatomy::LitRange{range->from_mm, range->middleMm(), {}});
    const int half = litPixels(pictureOf(*view), unlit);
    EXPECT_GT(half, 50) << about->id;
    EXPECT_LT(half, whole) << about->id;
    view->lightRegion({});
    EXPECT_EQ(litPixels(pictureOf(*view), unlit), 0);
  }
}

TEST(BodyView, TheToolFollowsTheDepthAndIsMirrored) {
  for (const ProcedurePtr& about : {ProcedurePtr(procedure::builtIn("male-urethral-catheter")), duct()}) {
    const std::unique_ptr<anatomy::BodyView> view(anatomy::makeBodyView(about, nullptr));
    view->resize(500, 400);
    // A bar looks the same both ways but for its names.
    view->setRegionNames({{QString::fromStdString(about->wayInput().terms.front().id), QStringLiteral("First")}});
    const QImage without = pictureOf(*view);
    view->setDepth(20);
    const QImage near = pictureOf(*view);
    EXPECT_NE(near, without);
    view->setDepth(50);
    EXPECT_NE(pictureOf(*view), near);
    view->setMirrored(true);
    view->setDepth(20);
    EXPECT_NE(pictureOf(*view), near);
    view->setDepth({});
    view->setMirrored(false);
    EXPECT_EQ(pictureOf(*view), without);
  }
}

TEST(BodyView, RegionsReachFromTheMiddleOfOneOverlapToTheNext) {
  const auto about = duct();
  EXPECT_EQ(anatomy::rangeOf(*about, "mouth"), (anatomy::WayRange{0, 10}));
  EXPECT_EQ(anatomy::rangeOf(*about, "trunk"), (anatomy::WayRange{10, 40}));
  EXPECT_EQ(anatomy::rangeOf(*about, "end"), (anatomy::WayRange{40, 60}));
  EXPECT_FALSE(anatomy::rangeOf(*about, "elsewhere").has_value());
}

}  // namespace
}  // namespace tactus::workbench::nurse
