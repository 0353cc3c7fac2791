// `study form` on the command line: which files, in which languages.
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/base/files/file.h"
#include "core/base/tables/csv.h"

#include "tests/app/cli/run_program.h"
#include "tests/support/temp_folder.h"
#include "tests/support/well_formed.h"

namespace tactus::cli {
namespace {

using FormJson = nlohmann::json;

class StudyFormTest : public testing::Test {
 protected:
  StudyFormTest() { EXPECT_EQ(ProgramRun({"study", "new", study_}).status, 0); }

  ProgramRun form(const std::string& to) const {
    return ProgramRun({"study", "form", study_, "--to", to, "--out", out_, "--json"});
  }

  support::TempFolder folder_;
  std::string study_ = folder_.file("a.tactus");
  std::string out_ = folder_.file("form");
};

TEST_F(StudyFormTest, InEnglishWithoutAProtocol) {
  const ProgramRun run = form("redcap");
  ASSERT_EQ(run.status, 0) << run.err;
  const FormJson said = FormJson::parse(run.out);
  EXPECT_EQ(said["form"], "ngt-force-v1");
  EXPECT_EQ(said["languages"], FormJson::parse(R"(["en"])"));
  ASSERT_EQ(said["files"].size(), 3U);
  EXPECT_EQ(said["files"][0], out_ + "/ngt_force.en.csv");
  for (const FormJson& file : said["files"]) {
    EXPECT_TRUE(base::CsvTable::read(file.get<std::string>()).has_value()) << file;
  }
  const ProgramRun folder(
      {"study", "form", std::filesystem::path(study_).parent_path().string(), "--to", "print", "--out", out_});
  EXPECT_EQ(folder.status, 0) << folder.err;
  EXPECT_EQ(folder.out, out_ + "/ngt_force.en.html\n");
}

TEST_F(StudyFormTest, ThePublishedWordsHaveFilesOfTheirOwnAndAnswersKeepThem) {
  const auto textOf = [&](const char* wording, const char* name) {
    const ProgramRun run({"study", "form", study_, "--to", "redcap", "--wording", wording, "--out", out_});
    EXPECT_EQ(run.status, 0) << run.err;
    return base::readFile(out_ + "/" + name, 1 << 20).value_or("");
  };
  EXPECT_NE(textOf("plain", "ngt_force.en.csv").find("How large is the force?"), std::string::npos);
  const std::string published = textOf("published", "ngt_force_published.en.csv");
  EXPECT_NE(published.find("THEN Force Change IS"), std::string::npos);
  EXPECT_EQ(published.find("How large is the force?"), std::string::npos);

  std::string head = "record_id";
  std::string row = "velvet-otter";
  for (int item = 1; item <= 45; ++item) {
    head += (item < 10 ? ",q0" : ",q") + std::to_string(item);
    row += ",3";
  }
  writeText(folder_.file("responses.csv"), head + '\n' + row + '\n');
  for (const std::string wording : {"", "published"}) {
    const std::string answers = folder_.file("answers" + wording);
    std::vector<std::string> words = {"study", "form", study_, "--responses", folder_.file("responses.csv"),
                                      "--out", answers};
    if (!wording.empty()) words.insert(words.end(), {"--wording", wording});
    const ProgramRun run(words);
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.err.find("in which words the items were asked is not known") == std::string::npos, !wording.empty());
    const auto table = base::CsvTable::read(answers + "/answers.csv");
    ASSERT_TRUE(table.has_value());
    EXPECT_EQ(table->find("wording").has_value(), !wording.empty());
    if (wording.empty()) continue;
    EXPECT_EQ(table->cell(0, *table->find("wording")), "published");
  }
}

TEST_F(StudyFormTest, InTheLanguagesOfTheProtocol) {
  const std::string consent = folder_.file("consent.txt");
  writeText(consent, "I agree.");
  const ProgramRun set({"study", "protocol", study_, "--set", "languages=en,zh-Hant", "--set", "consent_version=1",
                        "--consent", "en=" + consent, "--consent", "zh-Hant=" + consent, "--author", "Test"});
  ASSERT_EQ(set.status, 0) << set.err;
  const FormJson redcap = FormJson::parse(form("redcap").out);
  EXPECT_EQ(redcap["files"].size(), 4U);
  const ProgramRun lime = form("limesurvey");
  EXPECT_NE(lime.err.find("was never imported into a LimeSurvey server"), std::string::npos);
  EXPECT_EQ(FormJson::parse(lime.out)["files"][0], out_ + "/ngt_force.txt");
  const FormJson print = FormJson::parse(form("print").out);
  ASSERT_EQ(print["files"].size(), 2U);
  for (const FormJson& file : print["files"]) {
    const std::string html = readText(file);
    EXPECT_EQ(support::markupFault(html), "") << file;
    EXPECT_EQ(support::countOf(html, "☐"), 45U * 6U);
  }
}

TEST_F(StudyFormTest, EachMediumHasConsentProfileAndPicture) {
  const std::string consent = folder_.file("consent.txt");
  writeText(consent, "The study of a test.");
  const ProgramRun set({"study", "protocol", study_, "--set", "consent_version=4", "--set", "contact=Dr. Lee",
                        "--consent", "en=" + consent, "--author", "Test"});
  ASSERT_EQ(set.status, 0) << set.err;
  for (const std::string to : {"redcap", "limesurvey", "print", "web"}) {
    const FormJson said = FormJson::parse(form(to).out);
    const std::string text = readText(said["files"][0]);
    for (const char* const words : {"The study of a test.", "Dr. Lee", "I have read this and want to take part",
                                    "For how many years have you placed nasogastric tubes?",
                                    "Which hand guides the tube?", "Neck flexion: how far the chin is lowered"})
      EXPECT_NE(text.find(words), std::string::npos) << to << ": " << words;
    const std::string picture = to == "redcap" || to == "limesurvey" ? readText(said["pictures"][0]) : text;
    EXPECT_NE(picture.find("<svg") == std::string::npos ? picture.find("\\u003csvg") : 0, std::string::npos) << to;
    EXPECT_EQ(to == "print" ? support::markupFault(text) : "", "");
  }
  EXPECT_NE(readText(out_ + "/ngt_force.en.csv").find("\"years_1, Under 5 | years_2"), std::string::npos);
  const ProgramRun tables(
      {"study", "form", std::filesystem::path(study_).parent_path().string(), "--to", "web", "--out", out_});
  EXPECT_EQ(tables.status, 1);
  EXPECT_NE(unwrapped(tables.err).find("a study file, whose id the answers name"), std::string::npos) << tables.err;
}

TEST_F(StudyFormTest, TheProfileOfASurveySystemComesBack) {
  std::string head = "record_id,years,handedness";
  std::string codes = "velvet-otter,years_2,left";
  std::string labels = "amber-fox,15 or more,2";
  for (int item = 1; item <= 45; ++item) {
    head += (item < 10 ? ",q0" : ",q") + std::to_string(item);
    codes += ",3";
    labels += ",4";
  }
  writeText(folder_.file("responses.csv"), head + '\n' + codes + '\n' + labels + '\n');
  const std::string answers = folder_.file("answers");
  const ProgramRun run({"study", "form", study_, "--responses", folder_.file("responses.csv"), "--out", answers});
  ASSERT_EQ(run.status, 0) << run.err;
  const auto table = base::CsvTable::read(answers + "/participants.csv");
  ASSERT_TRUE(table.has_value());
  const auto years = *table->find("years_experience");
  const auto hand = *table->find("handedness");
  EXPECT_EQ(table->cell(0, years), "7.5");  // the middle of 5 to 10
  EXPECT_EQ(table->cell(0, hand), "left");
  EXPECT_EQ(table->cell(1, years), "20");
  EXPECT_EQ(table->cell(1, hand), "right");
}

TEST_F(StudyFormTest, AFormForTheWebWithoutAProtocolIsForTryingOnly) {
  const ProgramRun run({"study", "form", study_, "--to", "web", "--out", out_});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out, out_ + "/form.html\n" + out_ + "/README.txt\n");
  EXPECT_NE(run.err.find("for trying only"), std::string::npos);
}

TEST_F(StudyFormTest, WrongRequestsAreRefused) {
  const ProgramRun to({"study", "form", study_, "--to", "paper", "--out", out_});
  EXPECT_EQ(to.status, 2);
  const ProgramRun missing({"study", "form", folder_.file("none.tactus"), "--to", "print", "--out", out_});
  EXPECT_EQ(missing.status, 1);
  EXPECT_NE(missing.err.find("none.tactus"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(out_));
  writeText(out_, "a file");
  EXPECT_EQ(form("print").status, 1);
}

}  // namespace
}  // namespace tactus::cli
