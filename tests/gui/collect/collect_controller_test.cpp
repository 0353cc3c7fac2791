#include "app/workbench/collect/collect_controller.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/session/study_protocol.h"
#include "app/webform/answers.h"
#include "app/workbench/collect/participant_table.h"
#include "core/base/files/file.h"
#include "core/store/entries.h"
#include "core/store/persons.h"

#include "tests/gui/sample_study.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;

class CollectControllerTest : public testing::Test {
 protected:
  void open() {
    study.open(path);
    ASSERT_TRUE(comesTrue([this] { return study.isOpen() && collect.isCurrent() && isRead(); }));
  }
  bool isRead() const { return collect.overview().rows.size() == people; }

  QTemporaryDir folder;
  QString path = folder.filePath(QStringLiteral("study.tactus"));
  std::size_t people = 0;
  StudyConnection study;
  CollectController collect{study};
};

TEST_F(CollectControllerTest, ANewParticipantHasACodeOfTwoWordsAndIsInTheList) {
  tests::makeStudyFile(path);
  open();
  ParticipantTable table(collect);
  QSignalSpy added(&collect, &CollectController::added);
  collect.addParticipant();
  ASSERT_TRUE(comesTrue([&] { return table.rowCount() == 1; }));
  ASSERT_EQ(added.size(), 1);
  const QString code = added.front()[1].toString();
  EXPECT_EQ(code.count(QLatin1Char('-')), 1) << code.toStdString();
  EXPECT_EQ(table.index(0, ParticipantTable::kCode).data().toString(), code);
  EXPECT_EQ(table.index(0, ParticipantTable::kNext).data().toString(), QStringLiteral("Consent"));
  EXPECT_EQ(table.index(0, ParticipantTable::kLastSeen).data().toString(), QStringLiteral("never"));
  study.close();
  ASSERT_TRUE(comesTrue([&] { return !study.isOpen(); }));
  EXPECT_EQ(table.rowCount(), 0);
  EXPECT_EQ(store::persons(tests::lookInto(path))->size(), 1U);
}

TEST_F(CollectControllerTest, TheOverviewWaitsForTheEndOfASession) {
  tests::makeStudyFile(path);
  open();
  collect.setSessionRunning(true);
  collect.addParticipant();
  QSignalSpy added(&collect, &CollectController::added);
  ASSERT_TRUE(comesTrue([&] { return added.size() == 1; }));
  QSignalSpy read(&study, &StudyConnection::contentsChanged);
  ASSERT_TRUE(comesTrue([&] { return !read.isEmpty(); }));
  EXPECT_TRUE(collect.overview().rows.empty());
  EXPECT_FALSE(collect.isCurrent());
  collect.setSessionRunning(false);
  EXPECT_TRUE(comesTrue([&] { return collect.overview().rows.size() == 1; }));
}

TEST_F(CollectControllerTest, AWithdrawalIsCountedBeforeAndDeletesThatParticipantAlone) {
  tests::makeStudyFile(path, [](store::StudyFile& file, study::RecordIds& ids) {
    tests::addVisit(file, ids, "amber-crow", false);
    tests::addVisit(file, ids, "blue-fox", false);
  });
  people = 2;
  open();
  const study::RecordId person = collect.overview().rows.front().person;
  store::WithdrawalPreview counted;
  QObject::connect(&collect, &CollectController::previewed,
                   [&](const study::RecordId&, const store::WithdrawalPreview& preview) { counted = preview; });
  collect.previewWithdrawal(person);
  ASSERT_TRUE(comesTrue([&] { return counted.records > 0; }));
  EXPECT_EQ(counted.sessions, 1);

  QString gone;
  QObject::connect(&collect, &CollectController::withdrawn, [&](const QString& code) { gone = code; });
  collect.withdraw(person);
  EXPECT_TRUE(collect.isWithdrawing());
  ASSERT_TRUE(comesTrue([&] { return !gone.isEmpty() && collect.overview().rows.size() == 1; }));
  EXPECT_EQ(gone, QStringLiteral("amber-crow"));
  EXPECT_FALSE(collect.isWithdrawing());
  EXPECT_EQ(collect.overview().rows.front().code, QStringLiteral("blue-fox"));
}

/// What the page of the study at `path` would save; its file in `folder`.
QString savedAnswers(const QString& path, const QTemporaryDir& folder) {
  const auto content = *webform::currentForm(tests::lookInto(path), "");
  nlohmann::ordered_json json = {{"format", "tactus-answers"},
                                 {"version", 1},
                                 {"study", toText(content.study)},
                                 {"form", content.form},
                                 {"wording", content.wording},
                                 {"form_sha256", content.sha256},
                                 {"language", "en"}};
  json["participant"] = {{"code", "velvet-otter"}, {"given", "page"}, {"run", std::string(32, 'a')}};
  json["consent"] = {{"version", "1"}, {"time", "2026-11-28T10:14:32.000Z"}, {"language", "en"}, {"text", "Read."}};
  json["profile"] = {{"years", "years_2"}, {"handedness", "left"}, {"gloves", "none"}, {"haptic_experience", ""}};
  json["answers"] = nlohmann::ordered_json::array();
  for (int item = 1; item <= 45; ++item) {
    json["answers"].push_back({{"item", item},
                               {"term", "medium"},
                               {"status", "answered"},
                               {"utc_ms", 1'795'860'900'000 + item},
                               {"changes", 0}});
  }
  json["usability"] = nlohmann::ordered_json::array();
  json["check_code"] = "0000-0000";
  json["check_code"] = webform::checkCodeOf(*webform::parseAnswerFile(json.dump(), "a"));
  const QString file = folder.filePath(QStringLiteral("a.tactus-answers.json"));
  EXPECT_TRUE(base::writeFileAtomically(file.toStdString(), json.dump()));
  return file;
}

TEST_F(CollectControllerTest, AnswerFilesComeInOnceAndABadOneChangesNothing) {
  tests::makeStudyFile(path, [](store::StudyFile& file, study::RecordIds& ids) {
    session::StudyProtocol protocol;
    protocol.consent_version = "1";
    protocol.consent = {{"en", "A study of the tests."}};
    protocol.contact = "the tests";
    session::SessionTools tools{session::systemTools().now, ids};
    ASSERT_TRUE(session::setProtocol(file, protocol, "", {}, tools));
  });
  const QString good = savedAnswers(path, folder);
  open();
  const QString bad = folder.filePath(QStringLiteral("b.tactus-answers.json"));
  ASSERT_TRUE(base::writeFileAtomically(bad.toStdString(), "{}"));
  QSignalSpy refused(&collect, &CollectController::refused);
  QSignalSpy imported(&collect, &CollectController::answersImported);
  collect.importAnswers({good, bad});
  ASSERT_TRUE(comesTrue([&] { return refused.size() == 1; }));
  EXPECT_NE(refused.front()[0].toString().indexOf(QStringLiteral("b.tactus-answers.json")), -1)
      << refused.front()[0].toString().toStdString();
  EXPECT_TRUE(collect.overview().rows.empty());
  for (const int added : {1, 0}) {
    collect.importAnswers({good});
    ASSERT_TRUE(comesTrue([&] { return imported.size() == 1; }));
    EXPECT_EQ(imported.front()[0].toInt(), 1);
    EXPECT_EQ(imported.takeFirst()[1].toInt(), added);
  }
  ASSERT_TRUE(comesTrue([&] { return collect.overview().rows.size() == 1; }));
  EXPECT_EQ(collect.overview().rows.front().code, QStringLiteral("velvet-otter"));

  const study::RecordId person = collect.overview().rows.front().person;
  study.close();
  ASSERT_TRUE(comesTrue([&] { return !study.isOpen(); }));
  const auto lines = *readParticipantRecord(tests::lookInto(path), person);
  const auto of = [&lines](const char* part) {
    return std::count_if(lines.begin(), lines.end(),
                         [part](const RecordLine& one) { return one.part == QLatin1String(part); });
  };
  EXPECT_EQ(of("Person"), 1);
  ASSERT_EQ(of("Questions"), 45);
  const auto answer = std::find_if(lines.begin(), lines.end(),
                                   [](const RecordLine& one) { return one.part == QLatin1String("Questions"); });
  EXPECT_EQ(answer->asked, QStringLiteral("item 1 of ngt-force-v1"));
  EXPECT_EQ(answer->said, QStringLiteral("medium"));
  EXPECT_EQ(answer->remark, QString());
}

// Everything of a whole session, in the order in which it was stored, with what does not count.
TEST_F(CollectControllerTest, TheRecordHasEachLineOfASession) {
  tests::makeStudyFile(path);
  open();
  session::SimulatedGroup group;
  group.count = 1;
  group.seed = 3;
  collect.fillWithSimulated(group);
  ASSERT_TRUE(comesTrue([&] { return collect.overview().rows.size() == 1; }));
  const study::RecordId person = collect.overview().rows.front().person;
  study.close();
  ASSERT_TRUE(comesTrue([&] { return !study.isOpen(); }));
  const auto file = tests::lookInto(path);
  const auto lines = *readParticipantRecord(file, person);
  const store::Selection all{person, {}, true};
  const std::size_t records = store::strokes(file, all, store::Recordings::kLeaveOut)->size() +
                              store::judgements(file, all)->size() + store::answers(file, all)->size() +
                              store::ratings(file, all)->size() + store::profiles(file, all)->size() +
                              store::events(file, all)->size();
  EXPECT_EQ(lines.size(), records);
  EXPECT_TRUE(std::is_sorted(lines.begin(), lines.end(),
                             [](const auto& one, const auto& other) { return one.sequence < other.sequence; }));
  const auto practice = std::count_if(lines.begin(), lines.end(),
                                      [](const RecordLine& one) { return one.remark == QLatin1String("practice"); });
  EXPECT_EQ(practice, 1);
}

}  // namespace
}  // namespace tactus::workbench
