// "Why here" and `tactus why` show the same numbers; here also what a click and the keys do.
#include <QComboBox>
#include <QLabel>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/workbench/base/theme.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/model/selection.h"
#include "app/workbench/understand/here/rule_panel.h"
#include "core/base/text.h"
#include "core/fuzzy/membership.h"

#include "tests/app/cli/run_program.h"
#include "tests/gui/patience.h"
#include "tests/gui/sample_models.h"
#include "tests/support/invented_experts.h"
#include "tests/support/ngt_model.h"

namespace tactus::workbench {
namespace {

using Json = nlohmann::json;
using Kind = WhyView::Kind;
using tests::kPatience;

class WhyViewTest : public testing::Test {
 protected:
  WhyViewTest() {
    panel.resize(700, 500);
    panel.show();
  }

  void open(const fuzzy::ForceModel& model, int row = 0) {
    path = folder.write(model, QStringLiteral("model-%1.tactus.json").arg(++files));
    models.open(path);
    auto& who = *panel.findChild<QComboBox*>();
    if (who.currentIndex() == row) return;
    who.setCurrentIndex(row);
    emit who.activated(row);
  }

  Json command(const std::vector<double>& point, const std::string& expert = {}) const {
    std::string at;
    for (std::size_t i = 0; i < point.size(); ++i) {
      at += (i > 0 ? "," : "") + scene.model()->model.inputs[i].id + "=" + base::formatNumber(point[i]);
    }
    std::vector<std::string> arguments = {"why", path.toStdString(), "--at", at, "--json"};
    if (!expert.empty()) arguments.insert(arguments.end(), {"--expert", expert});
    const cli::ProgramRun run(arguments);
    EXPECT_EQ(run.status, 0) << run.err;
    return Json::parse(run.out);
  }

  /// Whether the panel says what the command does.
  bool says(const Json& why) const {
    for (const QLabel* label : panel.findChildren<QLabel*>()) {
      if (label->text().toStdString() == why["sentence"].get<std::string>()) return true;
    }
    return false;
  }

  std::vector<WhyView::Line> of(Kind kind) const {
    std::vector<WhyView::Line> out;
    for (const auto* lines : {&view().words(), &view().others()}) {
      for (const WhyView::Line& line : *lines) {
        if (line.kind == kind) out.push_back(line);
      }
    }
    return out;
  }

  static QString newtons(double n) { return (n < 0 ? "" : "+") + QString::number(n, 'f', 3) + " N"; }

  void expectSame(const Json& why) const {
    const auto words = of(Kind::kWord);
    ASSERT_EQ(words.size(), why["words"].size());
    double sum = 0;
    for (std::size_t i = 0; i < words.size(); ++i) {
      const Json& word = why["words"][i];
      EXPECT_EQ(words[i].term, word["term"]);
      EXPECT_EQ(words[i].pull_n, word["pull_n"].get<double>());
      EXPECT_EQ(words[i].cells[1], QString::number(100 * word["share"].get<double>(), 'f', 1) + " %");
      EXPECT_EQ(words[i].cells[2], newtons(word["pull_n"]));
      sum += *words[i].pull_n;
    }
    EXPECT_NEAR(sum, 0, 1e-12);
    const auto experts = of(Kind::kExpert);
    ASSERT_EQ(experts.size(), why["experts"].size() > 1 ? why["experts"].size() : 0);
    for (std::size_t i = 0; i < experts.size(); ++i) {
      const Json& expert = why["experts"][i];
      EXPECT_EQ(scene.model()->model.experts[experts[i].expert].id, expert["id"]);
      EXPECT_EQ(experts[i].cells[1], QString::number(expert["force_n"].get<double>(), 'f', 3) + " N");
      EXPECT_EQ(experts[i].cells[2], newtons(-expert["leave_one_out_n"].get<double>()));
    }
    std::size_t next = 0;
    const auto moves = of(Kind::kMove);
    for (const Json& move : why["counterfactuals"]) {
      if (move["what"] != "one just-noticeable difference") continue;
      ASSERT_LT(next, moves.size());
      EXPECT_TRUE(moves[next].cells[1].startsWith(QString::number(move["value"].get<double>(), 'f', 3)));
      EXPECT_TRUE(moves[next].cells[2].endsWith(QString::number(move["delta"].get<double>(), 'f', 3)));
      EXPECT_EQ(moves[next].cells[3], newtons(move["force_n"].get<double>() - why["force_n"].get<double>()));
      ++next;
    }
    EXPECT_EQ(next, moves.size());
  }

  WhyView& view() const { return *panel.findChild<WhyView*>(); }

  tests::ModelFolder folder;
  QString path;
  int files = 0;
  ModelController models;
  SceneController scene{models};
  EditController edits{models};
  Selection selection{edits};
  RulePanel panel{scene, selection};
};

TEST_F(WhyViewTest, TheNumbersOfTheCommand) {
  open(support::inventedExperts());
  for (const std::vector<double>& point : {std::vector<double>{1, 60, 200, 50},
                                           {1, 60, 70, 50},
                                           {.3, 45, 170, 80},
                                           {.75, 10, 30, 260},
                                           {.1, 80, 420, 15}}) {
    scene.goTo(point);
    const Json why = command(point);
    ASSERT_TRUE(QTest::qWaitFor([&] { return says(why); }, kPatience)) << why["sentence"];
    expectSame(why);
  }
}

TEST_F(WhyViewTest, OneOfSeveralExperts) {
  open(support::inventedExperts(), 4);
  scene.goTo({1, 60, 200, 50});
  const Json why = command({1, 60, 200, 50}, "S4");
  ASSERT_TRUE(QTest::qWaitFor([&] { return says(why); }, kPatience)) << why["sentence"];
  expectSame(why);
}

TEST_F(WhyViewTest, AModelOfOneExpert) {
  open(support::s4FiveRegions(), 1);
  scene.goTo({1, 60, 200, 50});
  const Json why = command({1, 60, 200, 50});
  ASSERT_TRUE(QTest::qWaitFor([&] { return says(why); }, kPatience)) << why["sentence"];
  expectSame(why);
}

TEST_F(WhyViewTest, WhereNoRuleFiresItSaysSo) {
  auto model = support::s4FiveRegions();
  model.experts[0].rules = {{{{"speed", "fast"}}, "large"}};
  open(model, 1);
  scene.goTo({1, 60, 200, 20});
  const Json why = command({1, 60, 200, 20});
  ASSERT_TRUE(QTest::qWaitFor([&] { return says(why); }, kPatience)) << why["sentence"];
  EXPECT_TRUE(view().words().empty());
  EXPECT_TRUE(view().others().empty());
}

TEST_F(WhyViewTest, EnterOnAWordShowsAndSelectsItsRules) {
  open(support::inventedExperts(), 4);
  scene.goTo({1, 60, 200, 50});
  ASSERT_TRUE(QTest::qWaitFor([&] { return of(Kind::kWord).size() == 4; }, kPatience));
  view().setFocus();
  QTest::keyClick(&view(), Qt::Key_Down);
  QTest::keyClick(&view(), Qt::Key_Return);
  const std::string term = of(Kind::kWord)[0].term;
  EXPECT_EQ(selection.expert(), "S4");
  auto rules = view().rulesOf(3, term);
  std::sort(rules.begin(), rules.end());
  ASSERT_FALSE(rules.empty());
  EXPECT_EQ(selection.rules(), rules);
  double sum = 0;
  for (const auto& rule : of(Kind::kRule)) {
    EXPECT_EQ(edits.model().experts[rule.expert].rules[rule.rule].then, term);
    sum += rule.cells[2].chopped(2).toDouble();
  }
  EXPECT_NEAR(sum, *of(Kind::kWord)[0].pull_n, 5e-3);
  QTest::keyClick(&view(), Qt::Key_Return);
  EXPECT_TRUE(of(Kind::kRule).empty());
}

TEST_F(WhyViewTest, InTheMeanTheRulesOfAllSayTheWord) {
  open(support::inventedExperts());
  scene.goTo({1, 60, 200, 50});
  ASSERT_TRUE(QTest::qWaitFor([&] { return !of(Kind::kWord).empty(); }, kPatience));
  const double line = QFontMetricsF(theme::smallFont()).height() + 5;
  QTest::mouseClick(&view(), Qt::LeftButton, {}, {20, static_cast<int>(1.5 * line)});
  ASSERT_FALSE(of(Kind::kRule).empty());
  QSignalSpy edited(&selection, &Selection::editAsked);
  QTest::mouseDClick(&view(), Qt::LeftButton, {}, {40, static_cast<int>(2.5 * line)});
  EXPECT_EQ(edited.count(), 1);
  EXPECT_TRUE(selection.rule().has_value());
}

// From a move that is felt to the terms and rules by which it acts, to their editors, and to the answer: by keys.
TEST_F(WhyViewTest, AMoveLeadsToItsTermsAndRulesAndARuleToItsAnswer) {
  open(support::inventedExperts());
  const std::vector<double> point = {1, 60, 200, 50};
  scene.goTo(point);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !of(Kind::kMove).empty(); }, kPatience));
  const auto move = of(Kind::kMove).front();
  const auto press = [&](Qt::Key key) { QTest::keyClick(&view(), key); };
  const auto lines = of(Kind::kWord).size() + of(Kind::kExpert).size();
  view().setFocus();
  for (std::size_t i = 0; i <= lines; ++i) press(Qt::Key_Down);
  press(Qt::Key_Return);
  const auto terms = of(Kind::kTerm);
  ASSERT_FALSE(terms.empty());
  const fuzzy::Variable& input = scene.model()->model.inputs[move.input];
  for (const auto& line : terms) {
    EXPECT_EQ(line.input, move.input);
    const auto membership = fuzzy::MembershipFunction::of(*fuzzy::findTerm(input.terms, line.term));
    EXPECT_NE(membership(point[move.input]), membership(move.cells[1].section(QLatin1Char(' '), 0, 0).toDouble()));
  }
  QSignalSpy term_edited(&selection, &Selection::termEditAsked);
  press(Qt::Key_Down);
  press(Qt::Key_Return);
  EXPECT_EQ(term_edited.count(), 1);
  EXPECT_EQ(selection.term(), (editing::TermPlace{{input.id, {}}, terms.front().term}));

  const auto rules = of(Kind::kRule);
  ASSERT_FALSE(rules.empty());
  for (const auto& line : rules) {
    const auto& conditions = scene.model()->model.experts[line.expert].rules[line.rule].conditions;
    EXPECT_TRUE(std::any_of(conditions.begin(), conditions.end(), [&](const auto& one) {
      return one.input == input.id &&
             std::any_of(terms.begin(), terms.end(), [&](const auto& term) { return term.term == one.term; });
    }));
  }
  for (std::size_t i = 0; i < terms.size(); ++i) press(Qt::Key_Down);
  QSignalSpy rule_edited(&selection, &Selection::editAsked);
  press(Qt::Key_Return);
  EXPECT_EQ(selection.rules(), std::vector<std::size_t>{rules.front().rule});
  EXPECT_EQ(rule_edited.count(), 0);
  press(Qt::Key_Return);
  EXPECT_EQ(rule_edited.count(), 1);

  // The answer is there with a study alone.
  EXPECT_TRUE(of(Kind::kAnswer).empty());
  panel.setAnswersKnown(true);
  ASSERT_EQ(of(Kind::kAnswer).size(), 1U);
  std::pair<std::string, fuzzy::Rule> asked;
  QObject::connect(&panel, &RulePanel::answerAsked, [&](const std::string& expert, const fuzzy::Rule& rule) {
    asked = {expert, rule};
  });
  press(Qt::Key_Down);
  press(Qt::Key_Return);
  const fuzzy::Expert& who = scene.model()->model.experts[rules.front().expert];
  EXPECT_EQ(asked, std::pair(who.id, who.rules[rules.front().rule]));
}

TEST_F(WhyViewTest, HiddenItComputesNothing) {
  open(support::inventedExperts());
  scene.goTo({1, 60, 200, 50});
  const Json first = command({1, 60, 200, 50});
  ASSERT_TRUE(QTest::qWaitFor([&] { return says(first); }, kPatience));
  panel.hide();
  scene.goTo({1, 60, 70, 50});
  QTest::qWait(100);
  EXPECT_TRUE(says(first));
  panel.show();
  const Json next = command({1, 60, 70, 50});
  EXPECT_TRUE(QTest::qWaitFor([&] { return says(next); }, kPatience));
}

}  // namespace
}  // namespace tactus::workbench
