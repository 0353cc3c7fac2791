// The program itself, killed or with a full disk at each screen of a session: what a screen acknowledged is in the
// file, and the session continues at the right place. TACTUS_KILLS=1 kills a program of its own at each screen, and
// fills the disk at each.
#include <QFile>
#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "app/session/study_protocol.h"
#include "app/workbench/participant/check_in.h"
#include "core/store/persons.h"
#include "core/store/study_info.h"
#include "experiments/force_series.h"

#include "tests/gui/participant/course_test.h"
#include "tests/gui/rehearsal/watched_program.h"

namespace tactus::workbench {
namespace {

using Screen = ParticipantScreen;
using tests::RehearsalLine;
using tests::WatchedProgram;

const bool kEach = std::getenv("TACTUS_KILLS") != nullptr;

// What came before, in each part once more.
QString momentOf(const RehearsalLine& line) {
  return QStringLiteral("%1 after %2 %3 %4")
      .arg(line.screen)
      .arg(line.insertions > 0 ? 1 : 0)
      .arg(line.judgements > 0 ? 1 : 0)
      .arg(line.answers / 16);
}

/// What the file holds, counted as the program counts.
struct Counted {
  int insertions = 0;
  int judgements = 0;
  int answers = 0;
  int ratings = 0;
};

Counted countedIn(const store::StudyFile& file) {
  Counted out;
  const store::Selection all{{}, {}, true};
  const auto strokes = *store::strokes(file, all, store::Recordings::kLeaveOut);
  const auto judgements = *store::judgements(file, all);
  const auto answers = *store::answers(file);
  for (const auto& one : strokes) out.insertions += !one.practice && one.verdict == "accepted" ? 1 : 0;
  for (const auto& one : judgements) out.judgements += one.series != experiments::kFamiliarisation ? 1 : 0;
  for (const auto& one : answers) out.answers += one.status != study::Answer::Status::kCleared ? 1 : 0;
  out.ratings = static_cast<int>(store::ratings(file, all)->size());
  return out;
}

class SessionKilledTest : public CourseTest {
 protected:
  void SetUp() override {
    tests::makeStudyFile(path, [](store::StudyFile& file, study::RecordIds& ids) {
      session::StudyProtocol protocol;
      protocol.settings = shortPlan().settings;
      protocol.consent_version = "1";
      protocol.consent = {{"en", "A rehearsal."}};
      session::SessionTools tools{session::systemTools().now, ids};
      ASSERT_TRUE(session::setProtocol(file, protocol, "", {}, tools));
    });
  }

  QString copyOf(const QString& moment) {
    const QString copy =
        folder.filePath(QString(moment).replace(QLatin1Char(' '), QLatin1Char('_')) + QStringLiteral(".tactus"));
    EXPECT_TRUE(QFile::copy(path, copy));
    const QString journal = QStringLiteral("-wal");
    EXPECT_TRUE(!QFile::exists(path + journal) || QFile::copy(path + journal, copy + journal));
    return copy;
  }

  // Nothing acknowledged is missing, and at most one record more is there, whose acknowledgement was not seen.
  void expectAll(const RehearsalLine& told) {
    const auto file = store::StudyFile::open(path.toStdString());
    ASSERT_TRUE(file) << file.error().message();
    EXPECT_TRUE(store::checkStudy(*file)->empty());
    const Counted held = countedIn(*file);
    const auto holds = [](const char* what, int in_file, int known) {
      EXPECT_GE(in_file, known) << what;
      EXPECT_LE(in_file, known + 1) << what;
    };
    holds("insertions", held.insertions, told.insertions);
    holds("judgements", held.judgements, told.judgements);
    holds("answers", held.answers, told.answers);
    holds("ratings", held.ratings, told.ratings);
    const auto persons = *store::persons(*file);
    code = persons.empty() ? QString() : QString::fromStdString(persons.front().code);
    plan = *participantPlan(*file);
    plan.simulated = true;
  }

  // She types her code, and comes to what was asked; what is shown to each who sits down is passed before.
  void expectItContinues(const RehearsalLine& told) {
    if (code.isEmpty()) return;  // there was no participant yet
    sitDown(time);
    look();
    nurse->enterCode(code);
    ASSERT_TRUE(tests::comesTrue([this] { return at().code == code; }));
    look();
    nurse->next();
    ASSERT_TRUE(stored());
    const bool at_end = told.screen == QLatin1String("own_model") || told.screen == QLatin1String("thanks");
    for (int passed = 0; passed < 3; ++passed) {
      if (screen() == Screen::kDeviceCheck && told.screen != QLatin1String("device_check")) {
        ASSERT_NO_FATAL_FAILURE(checkDevice());
      } else if ((screen() == Screen::kGlossary && told.screen != QLatin1String("glossary")) ||
                 (screen() == Screen::kRest && beginsToCount()) ||
                 (screen() == Screen::kReview && at().review.sealed && at_end)) {
        next();
      }
    }
    // From the others to the same.
    const std::map<QString, std::set<Screen>> places = {
        {"welcome", {Screen::kConsent}},
        {"consent", {Screen::kConsent, Screen::kAboutYou}},
        {"about_you", {Screen::kAboutYou, Screen::kPractice}},
        {"practice", {Screen::kPractice, Screen::kSpeed, Screen::kForce}},
        {"speed", {Screen::kSpeed, Screen::kRating}},
        {"force", {Screen::kForce, Screen::kRating}},
        {"rest", {Screen::kPractice, Screen::kForce, Screen::kQuestion}},
        // The lock is given again with the rating of the questions.
        {"rating", {Screen::kRating, told.answers == 45 ? Screen::kReview : Screen::kPractice, Screen::kQuestion}},
        {"question", {Screen::kQuestion, Screen::kReview}},
        {"thanks", {Screen::kOwnModel}},
    };
    const auto other = places.find(told.screen);
    EXPECT_TRUE(other != places.end() ? other->second.contains(screen())
                                      : told.screen == QLatin1String(factsOf(screen()).id))
        << told.screen.toStdString() << ' ' << factsOf(screen()).id;
    if (screen() == Screen::kQuestion && told.position > 0) {
      EXPECT_GE(at().question.position, told.position);
      EXPECT_LE(at().question.position, told.position + 1);
    }
    EXPECT_TRUE(refused.isEmpty()) << refused.toStdString();
    getUp();
  }

  void expectWhole(const QString& moment, const QString& file, const RehearsalLine& told) {
    SCOPED_TRACE(moment.toStdString());
    path = file;
    ASSERT_NO_FATAL_FAILURE(expectAll(told));
    ASSERT_NO_FATAL_FAILURE(expectItContinues(told));
  }

  QString settings() { return folder.path(); }

  QString code;
};

// What a kill leaves is what the files hold at that moment: they are copied while the program stands still.
TEST_F(SessionKilledTest, AtEachScreenNothingAcknowledgedIsMissingAndItContinuesThere) {
  struct Left {
    QString moment;
    QString file;
    RehearsalLine told;
  };
  std::vector<Left> left;
  std::set<QString> seen;
  {
    WatchedProgram program(path, settings());
    RehearsalLine last;
    while (const auto line = program.next()) {
      last = *line;
      if (!seen.insert(momentOf(last)).second) continue;
      if (const auto newer = program.freeze()) last = *newer;
      left.push_back({momentOf(*line), copyOf(momentOf(*line)), last});
      if (last.screen == QLatin1String("thanks")) break;
      program.thaw();
    }
    // The last one is killed in truth.
    program.kill();
    left.push_back({QStringLiteral("the end"), path, last});
  }
  std::set<QString> screens;
  for (const Left& one : left) screens.insert(one.told.screen);
  EXPECT_EQ(screens.size(), std::count_if(std::begin(kScreenFacts), std::end(kScreenFacts), isOfANurse));
  for (const Left& one : left) ASSERT_NO_FATAL_FAILURE(expectWhole(one.moment, one.file, one.told));
}

TEST_F(SessionKilledTest, KilledInTheMiddleOfTheQuestions) {
  const QString made = path;
  std::vector<QString> moments = {QStringLiteral("question")};
  if (kEach) {
    moments = {"welcome", "consent", "about_you", "device_check", "practice", "speed",     "force",
               "rest",    "rating",  "glossary",  "question",     "review",   "own_model", "thanks"};
  }
  for (const QString& screen : moments) {
    path = made;
    const QString copy = copyOf(screen + QStringLiteral("_killed"));
    RehearsalLine last;
    {
      WatchedProgram program(copy, settings());
      while (const auto line = program.next()) {
        last = *line;
        if (last.screen == screen && (screen != QLatin1String("question") || last.position == 23)) break;
      }
      if (const auto newer = program.kill()) last = *newer;
    }
    ASSERT_NO_FATAL_FAILURE(expectWhole(screen, copy, last));
  }
}

// The nurse waits while the disk refuses, and continues; the rehearsal itself compares the file with what she did.
TEST_F(SessionKilledTest, AFullDiskIsToldAndNothingIsLost) {
  std::set<QString> to_fill = {"speed", "question"};
  if (kEach) to_fill = {"about_you", "practice", "speed", "force", "rating", "question", "review", "own_model"};
  const std::size_t planned = to_fill.size();
  std::size_t told = 0;
  bool full = false;
  WatchedProgram program(path, settings());
  while (const auto line = program.next()) {
    if (full && line->failed) {
      ++told;
      program.fillDisk(full = false);
    } else if (!full && to_fill.erase(line->screen) > 0) {
      program.fillDisk(full = true);
    }
  }
  EXPECT_EQ(program.exitCode(), 0) << program.complaint().toStdString();
  EXPECT_EQ(told, planned);
  EXPECT_TRUE(store::checkStudy(tests::lookInto(path))->empty());
}

}  // namespace
}  // namespace tactus::workbench
