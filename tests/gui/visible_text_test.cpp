// Whatever the window shows was translated, or is data: the names in the model here have no Latin letters, and a
// language for tests marks what went through tr().
#include <QComboBox>
#include <QRegularExpression>
#include <QSettings>
#include <algorithm>
#include <gtest/gtest.h>
#include <set>

#include "app/editing/membership_edits.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/shell/menus.h"
#include "app/workbench/workbench.h"
#include "core/procedure/procedure.h"

#include "tests/gui/marking_translator.h"
#include "tests/gui/sample_models.h"
#include "tests/gui/sample_study.h"
#include "tests/gui/shown_bench.h"
#include "tests/gui/shown_texts.h"
#include "tests/support/ngt_model.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;
using tests::shownTexts;

/// Text that is no text of the program.
struct Untranslated {
  const char* pattern;
  const char* reason;
};

constexpr Untranslated kUntranslated[] = {
    {"\\b(mm/s|mm|cm|deg|ms|px)\\b", "units"},
    {"\\b(Lubrication|Neck flexion|Depth|Speed)\\b", "the short name of an input is its id"},
    {"\\b(nasal_cavity|nasopharynx|oropharynx|laryngopharynx|esophagus|stomach)\\b", "ids of terms"},
    {"名\\d+ \\(S4, S2\\) / .*", "names of edits come from app/editing"},
    {"\\b([Ll]eft|[Rr]ight) (foot|shoulder)\\b", "names of vertices come from app/editing"},
    {"\\b1\\.ta[a-z.]*", "names of the files, also cut to the width of a label"},
    {"^(\\d+\\.\\d{3} N( because |, the centroid of |\\. No input ).*|No rule fires here: .*)",
     "the sentence comes from core/analysis, as `tactus why` says it"},
    {"Virtual device \\(simulated\\)", "names of devices come from core/haptics"},
    {"\\b(Insertion depth|Nasal cavity|Nasopharynx|Oropharynx|Laryngopharynx|Esophagus|Stomach)\\b",
     "labels come from the pack of the procedure"},
    {"\\bPrep(a|ar)?…", "the title of the first step comes from the pack, cut to its room"},
    {"\\bTactus demo\\b", "the name of a folder, found again in every language"},
    {"^(Exploring and tuning a model|Running sessions with nurses|The labs: from recordings to depth and speed "
     "terms|From words to an agreed model|From an empty study to an agreed model|Taking part as a "
     "nurse|Ten minutes to a force|A procedure of your own in an hour)$",
     "headings of the guide, which is written in English"},
    {"\\([^()]+ (19|20)\\d\\d[^()]*\\)", "sources of landmarks"},
    {"no consent text|the text that participants agree to", "sentences of errors come from app/session"},
    {"\\bEnglish\\b", "a language by its own name"},
    {"^Graph \\d+$", "what QCustomPlot calls a line without a name, never shown"},
};

void nameWithoutLetters(fuzzy::ForceModel& model) {
  int number = 0;
  const auto name = [&number](std::string& label) { label = "名" + std::to_string(++number); };
  const auto nameTerms = [&](std::vector<fuzzy::Term>& terms) {
    for (fuzzy::Term& term : terms) name(term.label);
  };
  name(model.name);
  for (fuzzy::Variable& input : model.inputs) {
    name(input.label);
    nameTerms(input.terms);
  }
  name(model.output.label);
  nameTerms(model.output.terms);
  for (fuzzy::Expert& expert : model.experts) {
    name(expert.label);
    for (auto& own : expert.overrides) nameTerms(own.terms);
  }
}

fuzzy::ForceModel namelessModel() {
  fuzzy::ForceModel model = support::s4AsPrinted();
  // A second opinion, with a rule less, so that there are findings.
  fuzzy::Expert other = model.experts.front();
  other.id = "S2";
  other.rules.pop_back();
  other.rules.front().then = "large";
  model.experts.push_back(other);
  nameWithoutLetters(model);
  return model;
}

// What a pack says is in the languages of the pack.
const QStringList& textsOfPacks() {
  static const QStringList texts = [] {
    QStringList out;
    const procedure::Procedure& about = *procedure::defaultProcedure();
    const auto add = [&out](const procedure::Texts& said) { out << text(procedure::textIn(said, "en")); };
    add(about.title);
    for (const procedure::Step& step : about.steps) {
      add(step.title);
      add(step.text);
    }
    for (const procedure::Landmark& landmark : about.landmarks) {
      add(landmark.name);
      add(landmark.what);
      out << text(landmark.source);
    }
    for (const procedure::Figure& figure : about.figures) {
      add(figure.name);
      add(figure.shows);
    }
    for (const auto& [id, said] : about.words) {
      if (id.starts_with("pose.")) add(said);
    }
    // A name may be a part of a longer text.
    std::stable_sort(out.begin(), out.end(),
                     [](const auto& one, const auto& other) { return one.size() > other.size(); });
    return out;
  }();
  return texts;
}

// English under it, as in every language.
class MarkedLanguage {
 public:
  MarkedLanguage() { QCoreApplication::installTranslator(&marks_); }
  ~MarkedLanguage() { QCoreApplication::removeTranslator(&marks_); }

 private:
  tests::MarkingTranslator marks_;
};

class VisibleText : public testing::Test {
 protected:
  void SetUp() override {
    window.resize(1600, 1000);
    window.show();
  }

  void openModel() {
    bench.files.open(folder.write(namelessModel(), QStringLiteral("1.tactus.json")));
    settle();
  }

  void settle() { tests::settle(window); }

  // Says each text once.
  void expectTranslated(QWidget& shown, const char* when) {
    static const QRegularExpression word(QStringLiteral("[A-Za-z]{2,}"));
    for (const auto& [where, text] : shownTexts(shown)) {
      QString rest = tests::unmarked(text);
      rest.remove(folder.path(QString()));  // in the tool tips of recent files
      for (const QString& of_pack : textsOfPacks()) rest.remove(of_pack);
      for (const Untranslated& allowed : kUntranslated) {
        rest.remove(QRegularExpression(QString::fromUtf8(allowed.pattern)));
      }
      if (!word.match(rest).hasMatch() || !said_.insert(text).second) continue;
      ADD_FAILURE() << when << ": not translated: \"" << text.toStdString() << "\"\n  in " << where.toStdString();
    }
  }

  MarkedLanguage language_;
  tests::ModelFolder folder;
  QSettings settings{folder.path(QStringLiteral("settings.ini")), QSettings::IniFormat};
  Workbench bench{settings, folder.path(QStringLiteral("autosave"))};
  MainWindow& window = bench.window;

 private:
  std::set<QString> said_;
};

TEST(MarkedText, IsLeftOut) {
  const MarkedLanguage language;
  EXPECT_EQ(tests::unmarked(QCoreApplication::translate("tactus::workbench::ModelHeader", "%n rule(s)", nullptr, 3)),
            QStringLiteral("3"));
  EXPECT_EQ(tests::unmarked(QCoreApplication::translate("NoClass", "A text")), QStringLiteral("A text"));
  EXPECT_EQ(tests::unmarked(tests::kOpen + QStringLiteral("a") + tests::kOpen + QStringLiteral("b") + tests::kClose +
                            tests::kClose + QStringLiteral(" c")),
            QStringLiteral("c"));
}

TEST_F(VisibleText, OfTheStartIsTranslated) { expectTranslated(window, "start"); }

TEST_F(VisibleText, OfAllStagesIsTranslated) {
  openModel();
  for (const Stage stage : {Stage::kUnderstand, Stage::kTune}) {
    window.enter(stage);
    settle();
    expectTranslated(window, stage == Stage::kTune ? "tune" : "understand");
  }
}

TEST_F(VisibleText, AfterEditsIsTranslated) {
  openModel();
  const auto& input = bench.edits.model().inputs.front();
  ASSERT_TRUE(
      bench.edits.apply(editing::moveVertex(bench.edits.model(), {{input.id, ""}, input.terms[0].id, 2}, 0.21)));
  bench.edits.snapshot(QStringLiteral("名"));
  settle();
  bench.edits.undo();
  settle();
  expectTranslated(window, "edits");
}

TEST_F(VisibleText, OfFindingsIsTranslated) {
  openModel();
  bench.findings.setWatched(true);
  ASSERT_TRUE(comesTrue([this] { return bench.findings.isCurrent(); }));
  settle();
  expectTranslated(window, "findings");
}

TEST_F(VisibleText, OfAStudyIsTranslated) {
  const QString path = folder.path(QStringLiteral("1.tactus"));
  tests::makeStudyFile(path);
  bench.files.open(path);
  ASSERT_TRUE(comesTrue([this] { return bench.study.isOpen() && !bench.study.isOpening(); }));
  expectTranslated(window, "empty study");
  openModel();
  bench.study_models.putModel();
  settle();
  expectTranslated(window, "study");
}

TEST_F(VisibleText, OfFeelingIsTranslated) {
  openModel();
  window.enter(Stage::kTune);
  bench.feel.start(QStringLiteral("virtual"));
  ASSERT_TRUE(comesTrue([this] { return bench.feel.isRunning(); }));
  expectTranslated(window, "feel");
  bench.feel.stop();
  expectTranslated(window, "stopped");
}

TEST_F(VisibleText, OfTheShortcutsIsTranslated) {
  openModel();
  ShortcutSheet sheet(*window.menuBar(), &window);
  expectTranslated(sheet, "shortcuts");
}

}  // namespace
}  // namespace tactus::workbench
