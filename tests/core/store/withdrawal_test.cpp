#include "core/store/withdrawal.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

#include "core/base/files/checksums.h"
#include "core/store/entries.h"
#include "core/store/model_versions.h"
#include "core/store/person_codes.h"
#include "core/store/persons.h"
#include "core/store/recording_codec.h"
#include "core/store/sessions.h"
#include "core/store/study_info.h"

#include "tests/core/store/naming_model.h"
#include "tests/core/store/plain_sql.h"
#include "tests/core/store/sample_records.h"
#include "tests/support/temp_folder.h"

namespace tactus::store {
namespace {

std::string bytesOf(const std::string& path) {
  std::ostringstream out;
  out << std::ifstream(path, std::ios::binary).rdbuf();
  return out.str();
}

class Withdrawals : public testing::Test {
 protected:
  Withdrawals() {
    // A second person whose records lie between those of the first.
    other_ = records_.person("calm-fox");
    other_session_ = records_.session(other_.id);
    EXPECT_TRUE(append(study_.file, other_));
    EXPECT_TRUE(append(study_.file, other_session_));
    for (int item = 1; item <= 30; ++item) {
      auto answer = records_.answer(study_.session.id, item);
      answer.value = "secretopinion";
      if (previous_) answer.entry.supersedes = previous_;
      previous_ = answer.entry.id;
      EXPECT_TRUE(append(study_.file, answer));
      EXPECT_TRUE(append(study_.file, records_.answer(other_session_.id, item)));
    }
    stroke_ = records_.stroke(study_.session.id, 1500);
    EXPECT_TRUE(append(study_.file, stroke_));
    EXPECT_TRUE(append(study_.file, records_.stroke(other_session_.id, 1500)));
  }

  /// The bytes of the file and of what SQLite keeps beside it.
  std::string allBytes() const {
    std::string bytes;
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(path_).parent_path())) {
      bytes += bytesOf(entry.path().string());
    }
    return bytes;
  }
  std::string idBytes(const study::RecordId& id) const { return {id.bytes.begin(), id.bytes.end()}; }

  support::TempFolder folder_;
  SampleRecords records_;
  std::string path_ = folder_.file("study.tactus");
  OpenStudy study_ = makeStudy(path_, records_);
  study::Person other_;
  study::SessionRecord other_session_;
  study::StrokeRecord stroke_;
  std::optional<study::RecordId> previous_;
};

TEST_F(Withdrawals, NothingOfThePersonIsLeft) {
  const std::string samples = encodeRecording(stroke_.recording)->substr(600, 200);
  const std::vector<std::string> traces = {"velvet-otter", "secretopinion", idBytes(study_.session.id),
                                           idBytes(stroke_.entry.id)};
  for (const auto& trace : traces) ASSERT_NE(allBytes().find(trace), std::string::npos);
  const auto before = std::filesystem::file_size(path_);

  const auto withdrawal = withdraw(study_.file, study_.person.id, 1'780'000'000'000);
  ASSERT_TRUE(withdrawal) << withdrawal.error().message();
  EXPECT_EQ(withdrawal->records, 30 + 1 + 1 + 1);  // answers, stroke, session, person

  const auto at_once = allBytes();  // while it is open, its journal included
  ASSERT_TRUE(study_.file.close());
  const auto closed = allBytes();
  for (const auto& trace : traces) {
    EXPECT_EQ(at_once.find(trace), std::string::npos) << trace;
    EXPECT_EQ(closed.find(trace), std::string::npos) << trace;
  }
  // The other person made the same strokes, so only one copy of the samples is left.
  EXPECT_NE(closed.find(samples), std::string::npos);
  EXPECT_EQ(closed.find(samples, closed.find(samples) + 1), std::string::npos);
  EXPECT_GT(before, 0U);
}

TEST_F(Withdrawals, TheOthersKeepEverything) {
  const auto answers_before = *answers(study_.file, {.person = other_.id, .history = true});
  const auto strokes_before = *strokes(study_.file, {.person = other_.id});
  ASSERT_TRUE(withdraw(study_.file, study_.person.id, 5));
  EXPECT_EQ(*answers(study_.file, {.history = true}), answers_before);
  EXPECT_EQ(*strokes(study_.file), strokes_before);
  EXPECT_EQ(*persons(study_.file), std::vector{other_});
  EXPECT_EQ(*sessions(study_.file), std::vector{other_session_});
  EXPECT_TRUE(checkStudy(study_.file)->empty());
  ASSERT_TRUE(append(study_.file, records_.answer(other_session_.id)));
}

TEST_F(Withdrawals, ATombstoneKeepsThePersonOut) {
  ASSERT_TRUE(withdraw(study_.file, study_.person.id, 1'780'000'000'000));
  EXPECT_EQ(*tombstones(study_.file), (std::vector{Tombstone{study_.person.id, 1'780'000'000'000}}));
  const auto back = append(study_.file, study_.person);
  ASSERT_FALSE(back);
  EXPECT_NE(back.error().message().find("found the code 'velvet-otter' of a participant who withdrew on "
                                        "2026-05-28T20:26:40Z, wanted a person who has not taken back their consent"),
            std::string::npos)
      << back.error().message();
  auto renamed = study_.person;
  renamed.code = "misty-lake";
  const auto same_id = append(study_.file, renamed);
  ASSERT_FALSE(same_id);
  EXPECT_NE(same_id.error().message().find("this participant withdrew"), std::string::npos);
  EXPECT_FALSE(append(study_.file, study_.session));
  EXPECT_FALSE(withdraw(study_.file, study_.person.id, 6));
  EXPECT_EQ(tombstones(study_.file)->size(), 1U);
}

TEST_F(Withdrawals, ModelsAndTextsOfOthersAreCleaned) {
  const std::string both = namingModel({"velvet-otter", "calm-fox"});
  auto first = records_.model(both);
  first.label = "opened: mean";
  auto second = records_.model(namingModel({"velvet-otter"}));
  second.parent = first.id;
  second.label = "edit: velvet-otter (simulated): Depth near: small to large";
  second.author = "velvet-otter";
  auto third = records_.model(namingModel({"calm-fox"}));
  third.label = "undo: calm-fox (simulated): 3 rules";
  for (const auto& version : {first, second, third}) ASSERT_TRUE(append(study_.file, version));
  auto felt = records_.event(other_session_.id);
  felt.kind = "placement";
  felt.detail = R"({"model":"NAME: velvet-otter alone","strokes":2})";
  auto slip = records_.judgement(other_session_.id);
  slip.entry.reason = "typed for velvet-otter by mistake";
  ASSERT_TRUE(append(study_.file, felt) && append(study_.file, slip));
  const auto findings_before = *checkStudy(study_.file);  // the placement is made up
  ASSERT_NE(allBytes().find(ruleWeightOf("velvet-otter")), std::string::npos);

  const auto withdrawal = withdraw(study_.file, study_.person.id, 1'780'000'000'000);
  ASSERT_TRUE(withdrawal) << withdrawal.error().message();
  EXPECT_EQ(withdrawal->models, 2);
  EXPECT_TRUE(withdrawal->shared_codes.empty());
  const auto bytes = allBytes();
  EXPECT_EQ(bytes.find("velvet-otter"), std::string::npos);
  EXPECT_EQ(bytes.find(ruleWeightOf("velvet-otter")), std::string::npos);

  const auto now = modelVersion(study_.file, first.id);
  ASSERT_TRUE(now) << now.error().message();
  EXPECT_EQ(now->label, "opened: mean");
  EXPECT_EQ(now->sha256, base::sha256(now->text));
  EXPECT_NE(now->sha256, base::sha256(both));
  EXPECT_NE(now->text.find("\"calm-fox\""), std::string::npos);
  const auto gone = modelVersion(study_.file, second.id);
  ASSERT_TRUE(gone);
  EXPECT_EQ(gone->label, "edit: (withdrawn)");
  EXPECT_EQ(gone->author, "(withdrawn)");
  EXPECT_NE(gone->text.find("The experts of this model withdrew"), std::string::npos);
  const auto untouched = modelVersion(study_.file, third.id);
  EXPECT_EQ(untouched->text, third.text);
  EXPECT_EQ(untouched->label, third.label);
  EXPECT_EQ(events(study_.file)->back().detail, R"({"model":"NAME: (withdrawn) alone","strokes":2})");
  EXPECT_EQ(judgements(study_.file)->back().entry.reason, "typed for (withdrawn) by mistake");
  EXPECT_EQ(*checkStudy(study_.file), findings_before);

  const auto back = append(study_.file, records_.model(both));
  ASSERT_FALSE(back);
  EXPECT_NE(back.error().message().find("an expert with the code 'velvet-otter' of a participant who withdrew"),
            std::string::npos)
      << back.error().message();
}

TEST_F(Withdrawals, EveryCodeThatThePersonHadIsRemovedAndRefused) {
  ASSERT_TRUE(recode(study_.file, study_.person.id, "misty-lake", records_.id(), 9));
  ASSERT_TRUE(append(study_.file, records_.model(namingModel({"velvet-otter", "misty-lake", "calm-fox"}))));
  ASSERT_TRUE(withdraw(study_.file, study_.person.id, 10));
  for (const char* code : {"velvet-otter", "misty-lake"}) {
    EXPECT_EQ(allBytes().find(code), std::string::npos) << code;
    EXPECT_FALSE(append(study_.file, records_.person(code))) << code;
    EXPECT_FALSE(recode(study_.file, other_.id, code, records_.id(), 11)) << code;
    EXPECT_EQ(*withdrawnWithCode(study_.file, code), (Tombstone{study_.person.id, 10})) << code;
  }
  EXPECT_EQ(*withdrawnWithCode(study_.file, "calm-fox"), std::nullopt);
  EXPECT_TRUE(append(study_.file, records_.person("velvet-otter-2")));
}

TEST_F(Withdrawals, ACodeThatAnotherPersonHasStaysInTheModels) {
  ASSERT_TRUE(recode(study_.file, study_.person.id, "misty-lake", records_.id(), 9));
  ASSERT_TRUE(study_.file.close());
  // A merge may bring in a second person with the earlier code.
  const auto second = records_.person("velvet-otter");
  EXPECT_EQ(PlainSql(path_).complaintWithoutGuards("INSERT INTO person SELECT randomblob(16), 'velvet-otter', 0, 0;" +
                                                   PlainSql(path_).seal("person")),
            "");
  auto file = StudyFile::open(path_);
  ASSERT_TRUE(file);
  const auto version = records_.model(namingModel({"velvet-otter", "misty-lake"}));
  ASSERT_TRUE(append(*file, version));
  const auto withdrawal = withdraw(*file, study_.person.id, 10);
  ASSERT_TRUE(withdrawal);
  EXPECT_EQ(withdrawal->shared_codes, std::vector<std::string>{"velvet-otter"});
  const auto now = modelVersion(*file, version.id);
  EXPECT_NE(now->text.find("velvet-otter"), std::string::npos);
  EXPECT_EQ(now->text.find("misty-lake"), std::string::npos);
  EXPECT_EQ(*withdrawnWithCode(*file, "velvet-otter"), std::nullopt);
  ASSERT_TRUE(erase(*file));
  EXPECT_EQ(modelVersion(*file, version.id)->text, now->text);
}

TEST_F(Withdrawals, AnErasureThatIsNotFinishedIsKnownAndCanBeFinished) {
  const auto version = records_.model(namingModel({"velvet-otter", "calm-fox"}));
  ASSERT_TRUE(append(study_.file, version));
  ASSERT_TRUE(withdraw(study_.file, study_.person.id, 10));
  EXPECT_TRUE(unfinishedErasures(study_.file)->empty());
  ASSERT_TRUE(study_.file.close());
  // As if the program had ended before the file was rewritten, and as if an older program had let the model in again.
  const std::string id = study::toText(study_.person.id);
  {
    PlainSql sql(path_);
    const std::string text = "text = '" + version.text + "', sha256 = '" + base::sha256(version.text) + "';";
    ASSERT_EQ(sql.complaint("INSERT INTO erasure VALUES (x'" + id + "', 10); UPDATE model_version SET " + text +
                            sql.seal("model_version")),
              "");
  }
  auto file = StudyFile::open(path_);
  ASSERT_TRUE(file);
  EXPECT_EQ(*unfinishedErasures(*file), std::vector{study_.person.id});
  const std::string notice =
      "the erasure of 1 participant who withdrew was interrupted; finish it: tactus study erase " + path_;
  EXPECT_EQ(file->notices(), (std::vector{Notice{Notice::Kind::kErasure, notice}}));
  EXPECT_EQ(*checkStudy(*file), std::vector{"erasure: " + notice});
  const auto erasure = erase(*file);
  ASSERT_TRUE(erasure) << erasure.error().message();
  EXPECT_EQ(erasure->unfinished, std::vector{study_.person.id});
  EXPECT_EQ(erasure->models, 1);
  EXPECT_TRUE(unfinishedErasures(*file)->empty());
  EXPECT_EQ(allBytes().find("velvet-otter"), std::string::npos);
  EXPECT_EQ(erase(*file)->models, 0);
  EXPECT_TRUE(checkStudy(*file)->empty());
  ASSERT_TRUE(file->close());
  EXPECT_TRUE(StudyFile::open(path_)->notices().empty());
}

TEST_F(Withdrawals, WithoutAnErasureNothingIsChanged) {
  ASSERT_TRUE(append(study_.file, records_.model(namingModel({"calm-fox"}))));
  ASSERT_TRUE(withdraw(study_.file, study_.person.id, 10));
  ASSERT_TRUE(study_.file.close());
  PlainSql sql(path_);
  for (const char* change :
       {"UPDATE model_version SET text = ''", "UPDATE answer SET reason = ''", "UPDATE session SET settings = ''",
        "UPDATE study SET name = 'other'", "UPDATE tombstone SET utc_ms = 1"}) {
    EXPECT_NE(sql.complaint(change).find("never changed"), std::string::npos) << change;
  }
}

}  // namespace
}  // namespace tactus::store
