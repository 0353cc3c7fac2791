// Answer files of the web page: read, checked, and brought into a study by the public command.
#include <algorithm>
#include <functional>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/webform/answers.h"
#include "core/base/files/checksums.h"
#include "core/store/entries.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"

#include "tests/app/cli/run_program.h"
#include "tests/support/temp_folder.h"

namespace tactus::webform {
namespace {

using cli::ProgramRun;
using AnswersJson = nlohmann::ordered_json;

constexpr const char* kRun = "0123456789abcdef0123456789abcdef";

class AnswerFileTest : public testing::Test {
 protected:
  AnswerFileTest() {
    EXPECT_EQ(ProgramRun({"study", "new", study_}).status, 0);
    cli::writeText(folder_.file("consent.txt"), "The study of a test.");
    const ProgramRun set({"study", "protocol", study_, "--set", "languages=en,zh-Hant", "--set", "consent_version=2",
                          "--set", "contact=Dr. Lee", "--consent", "en=" + folder_.file("consent.txt"), "--consent",
                          "zh-Hant=" + folder_.file("consent.txt"), "--author", "Test"});
    EXPECT_EQ(set.status, 0) << set.err;
  }

  FormContent form() const {
    const auto file = store::StudyFile::open(study_, {store::Access::kReadOnly});
    return currentForm(*file, "").value_or(FormContent{});
  }

  /// What the page would save: items 1 to 44 are medium, 45 cannot be told.
  AnswersJson answers(const std::string& code = "velvet-otter", const std::string& given = "page") const {
    const FormContent content = form();
    AnswersJson json = {{"format", "tactus-answers"},     {"version", 1},
                        {"study", toText(content.study)}, {"form", content.form},
                        {"wording", content.wording},     {"form_sha256", content.sha256},
                        {"language", "zh-Hant"}};
    json["participant"] = {{"code", code}, {"given", given}, {"run", kRun}};
    json["consent"] = {{"version", "2"}, {"time", "2026-11-28T10:14:32.000Z"}, {"language", "en"}, {"text", "Read."}};
    json["profile"] = {{"years", "years_2"}, {"handedness", "left"}, {"gloves", "none"}, {"haptic_experience", ""}};
    json["answers"] = AnswersJson::array();
    for (int item = 1; item <= 45; ++item) {
      json["answers"].push_back({{"item", item},
                                 {"term", "medium"},
                                 {"status", "answered"},
                                 {"utc_ms", 1'795'860'900'000 + item},
                                 {"changes", item == 7 ? 2 : 0}});
    }
    json["answers"][44]["term"] = nullptr;
    json["answers"][44]["status"] = "cant_tell";
    json["usability"] = AnswersJson::array();
    json["check_code"] = "0000-0000";
    return json;
  }

  /// Writes the file with the check code that fits; its path.
  std::string saved(AnswersJson json, const std::string& name = "a") const {
    const auto read = parseAnswerFile(json.dump(), name);
    if (read) json["check_code"] = checkCodeOf(*read);
    return plainlySaved(json, name);
  }
  std::string plainlySaved(const AnswersJson& json, const std::string& name = "a") const {
    const std::string path = folder_.file(name + ".tactus-answers.json");
    cli::writeText(path, json.dump(2));
    return path;
  }

  ProgramRun import(std::vector<std::string> paths) const {
    std::vector<std::string> words = {"study", "import", study_, "--json"};
    words.insert(words.end(), paths.begin(), paths.end());
    return ProgramRun(words);
  }

  std::string information() const { return ProgramRun({"study", "info", study_, "--json"}).out; }

  support::TempFolder folder_;
  std::string study_ = folder_.file("a.tactus");
};

TEST_F(AnswerFileTest, ComesInWithConsentProfileWordingLanguageAndTimes) {
  const ProgramRun run = import({saved(answers())});
  ASSERT_EQ(run.status, 0) << run.err;
  const AnswersJson said = AnswersJson::parse(run.out);
  EXPECT_EQ(said["persons"], 1);
  EXPECT_EQ(said["sessions"], 1);
  EXPECT_EQ(said["answers"][0]["participant"], "velvet-otter");
  EXPECT_EQ(said["answers"][0]["answered"], 44);

  const auto file = store::StudyFile::open(study_, {store::Access::kReadOnly});
  const auto sessions = store::sessions(*file);
  ASSERT_EQ(sessions->size(), 1U);
  EXPECT_EQ(sessions->front().kind, study::SessionKind::kImport);
  EXPECT_EQ(sessions->front().program, "web form");
  EXPECT_EQ(sessions->front().consent_version, "2");
  EXPECT_EQ(sessions->front().language, "zh-Hant");
  EXPECT_EQ(sessions->front().started.utc_ms, 1'795'860'872'000);  // date -d 2026-11-28T10:14:32Z +%s
  const auto profiles = store::profiles(*file);
  ASSERT_EQ(profiles->size(), 1U);
  EXPECT_EQ(profiles->front().years_experience, 7.5);
  EXPECT_EQ(profiles->front().handedness, "left");
  EXPECT_EQ(profiles->front().gloves, "none");
  const auto stored = store::answers(*file);
  ASSERT_EQ(stored->size(), 45U);
  EXPECT_EQ(stored->at(6).value, "medium");
  EXPECT_EQ(stored->at(6).wording, "plain");
  EXPECT_EQ(stored->at(6).entry.when.utc_ms, 1'795'860'900'007);
  EXPECT_EQ(stored->at(6).entry.entered_by, study::EnteredBy::kParticipant);
  EXPECT_EQ(stored->at(44).status, study::Answer::Status::kCantTell);
  std::string origin;
  const auto events = store::events(*file);
  for (const auto& event : *events) {
    if (event.kind == "answer_file") origin = event.detail;
  }
  EXPECT_NE(origin.find(base::sha256(cli::readText(folder_.file("a.tactus-answers.json")))), std::string::npos)
      << origin;
  EXPECT_NE(origin.find(R"("changes": { "7": 2 })"), std::string::npos) << origin;
}

TEST_F(AnswerFileTest, TwiceOrUnderAnotherNameChangesNothing) {
  const std::string path = saved(answers());
  ASSERT_EQ(import({path}).status, 0);
  const std::string before = information();
  const ProgramRun again = import({path, saved(answers(), "copy")});
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(AnswersJson::parse(again.out)["records"], 0);
  EXPECT_EQ(AnswersJson::parse(again.out)["answers"][1]["added"], false);
  EXPECT_EQ(information(), before);
}

TEST_F(AnswerFileTest, ManyAtOnceAllOrNone) {
  std::vector<std::string> paths;
  for (int person = 0; person < 12; ++person) {
    AnswersJson json = answers("person-" + std::to_string(person));
    json["participant"]["run"] = std::string(30, 'a') + (person < 10 ? "0" : "") + std::to_string(person);
    paths.push_back(saved(json, "p" + std::to_string(person)));
  }
  AnswersJson wrong = answers("wrong-one");
  wrong["answers"][3]["term"] = "enormous";
  const std::string before = information();
  auto with_wrong = paths;
  with_wrong.push_back(plainlySaved(wrong, "wrong"));
  EXPECT_EQ(import(with_wrong).status, 1);
  EXPECT_EQ(information(), before);
  const ProgramRun run = import(paths);
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(AnswersJson::parse(run.out)["persons"], 12);
}

TEST_F(AnswerFileTest, SavedAgainAfterAChangeIsALaterSessionOfTheSamePerson) {
  ASSERT_EQ(import({saved(answers())}).status, 0);
  AnswersJson later = answers();
  later["answers"][0]["term"] = "very_large";
  const ProgramRun run = import({saved(later)});
  ASSERT_EQ(run.status, 0) << run.err;
  const AnswersJson said = AnswersJson::parse(run.out);
  EXPECT_EQ(said["persons"], 0);
  EXPECT_EQ(said["sessions"], 1);
}

TEST_F(AnswerFileTest, AWithdrawalLeavesNothingOfThem) {
  ASSERT_EQ(import({saved(answers(), "velvet-otter")}).status, 0);
  const ProgramRun run({"study", "withdraw", study_, "velvet-otter", "--yes"});
  ASSERT_EQ(run.status, 0) << run.err;
  const std::string bytes = cli::readText(study_);
  EXPECT_EQ(bytes.find("velvet-otter"), std::string::npos);
  EXPECT_EQ(bytes.find(kRun), std::string::npos);
  // The same file does not bring them back.
  EXPECT_EQ(import({saved(answers(), "again")}).status, 1);
}

TEST_F(AnswerFileTest, TheSimulatorHasASessionOfItsOwn) {
  AnswersJson json = answers();
  for (int item = 1; item <= 6; ++item)
    json["usability"].push_back(
        {{"item", item}, {"term", "6"}, {"status", "answered"}, {"utc_ms", 1'795'861'900'000}, {"changes", 0}});
  const ProgramRun run = import({saved(json)});
  ASSERT_EQ(run.status, 0) << run.err;
  const auto file = store::StudyFile::open(study_, {store::Access::kReadOnly});
  const auto sessions = store::sessions(*file);
  ASSERT_EQ(sessions->size(), 2U);
  // Both began with the consent, so their order is that of their random ids.
  const auto is_scale = [](const study::SessionRecord& one) { return one.kind == study::SessionKind::kUsability; };
  const auto scale = std::find_if(sessions->begin(), sessions->end(), is_scale);
  ASSERT_NE(scale, sessions->end());
  EXPECT_EQ(store::answers(*file, {{}, scale->id, false})->size(), 6U);
}

TEST_F(AnswerFileTest, ACodeThatThePageDrewTwiceIsTwoPersons) {
  ASSERT_EQ(import({saved(answers())}).status, 0);
  AnswersJson other = answers();
  other["participant"]["run"] = std::string(32, 'b');
  const ProgramRun refused = import({saved(other, "other")});
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(cli::unwrapped(refused.err).find("tactus study recode"), std::string::npos) << refused.err;
  other["participant"]["given"] = "typed";  // the researcher gave it: the same person
  const ProgramRun same = import({saved(other, "other")});
  ASSERT_EQ(same.status, 0) << same.err;
  EXPECT_EQ(AnswersJson::parse(same.out)["persons"], 0);
}

TEST_F(AnswerFileTest, WhatDoesNotFitIsRefusedWithOneSentence) {
  const std::string before = information();
  const std::vector<std::pair<std::function<void(AnswersJson&)>, std::string>> wrongs = {
      {[](AnswersJson& json) { json["format"] = "other"; }, "format"},
      {[](AnswersJson& json) { json["version"] = 2; }, "version"},
      {[](AnswersJson& json) { json["study"] = std::string(32, 'c'); }, "study: found the form of the study cccc"},
      {[](AnswersJson& json) { json["form_sha256"] = "abc"; }, "form_sha256: found 'abc'"},
      {[](AnswersJson& json) { json["wording"] = "published"; }, "wording: found 'published', wanted 'plain'"},
      {[](AnswersJson& json) { json["language"] = "de"; }, "language: found 'de', wanted one of en, zh-Hant"},
      {[](AnswersJson& json) { json["consent"]["version"] = "1"; }, "consent: found version '1', wanted version '2'"},
      {[](AnswersJson& json) { json.erase("consent"); }, "consent"},
      {[](AnswersJson& json) { json["consent"]["time"] = "today"; }, "found 'today', wanted a time such as"},
      {[](AnswersJson& json) { json["profile"]["handedness"] = "third"; }, "profile, handedness: found 'third'"},
      {[](AnswersJson& json) { json["answers"][2]["item"] = 99; },
       "answers: found the item 99, wanted the items 1 to 45"},
      {[](AnswersJson& json) { json["answers"][2]["item"] = 1; }, "answers, item 1: found a second answer"},
      {[](AnswersJson& json) { json["answers"].erase(4); }, "answers: found no item 5"},
      {[](AnswersJson& json) { json["answers"][2]["term"] = "huge"; }, "answers, item 3: found the term 'huge'"},
      {[](AnswersJson& json) { json["answers"][2]["term"] = nullptr; }, "no term with the status answered"},
      {[](AnswersJson& json) { json["answers"][2]["status"] = "maybe"; }, "/answers/2/status"},
      {[](AnswersJson& json) { json["participant"]["code"] = "=1+1"; }, "a participant's code"},
  };
  for (const auto& [change, sentence] : wrongs) {
    AnswersJson json = answers();
    change(json);
    const ProgramRun run = import({saved(json)});
    EXPECT_EQ(run.status, 1) << sentence;
    const std::string said = cli::unwrapped(run.err);
    EXPECT_NE(said.find(sentence), std::string::npos) << said;
    EXPECT_NE(said.find("a.tactus-answers.json"), std::string::npos) << said;
  }
  AnswersJson touched = answers();
  const ProgramRun code = import({plainlySaved(touched)});
  EXPECT_NE(cli::unwrapped(code.err).find("check_code: found '0000-0000'"), std::string::npos) << code.err;
  EXPECT_EQ(information(), before);
}

TEST_F(AnswerFileTest, AFormOfAnEarlierProtocolIsStillKnown) {
  const std::string path = saved(answers());
  const ProgramRun set({"study", "protocol", study_, "--set", "languages=en", "--author", "Test"});
  ASSERT_EQ(set.status, 0) << set.err;
  const ProgramRun run = import({path});
  EXPECT_EQ(run.status, 0) << run.err;
}

}  // namespace
}  // namespace tactus::webform
