#include "core/store/sealed_references.h"

#include <gtest/gtest.h>

#include "core/store/entries.h"
#include "core/store/merge.h"
#include "core/store/model_versions.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"
#include "core/store/study_info.h"
#include "core/store/withdrawal.h"

#include "tests/core/store/naming_model.h"
#include "tests/core/store/sample_records.h"
#include "tests/support/temp_folder.h"

namespace tactus::store {
namespace {

constexpr const char* kContent = "depth_mm,force_n\n30,0.1\n170,0.58\n";
constexpr const char* kPassphrase = "stones and rivers";

class SealedReferences : public testing::Test {
 protected:
  void SetUp() override {
    // Of `makeStudy` there is a participant without records of the elicitation.
    seal_person_ = records_.person("quiet-seal");
    seal_session_ = records_.session(seal_person_.id);
    seal_session_.kind = study::SessionKind::kUsability;
    ASSERT_TRUE(append(study_.file, seal_person_));
    ASSERT_TRUE(append(study_.file, seal_session_));
  }

  SealedReference sealedNow() {
    SealedReference out;
    out.entry = records_.entry(seal_session_.id);
    out.note = "access sheath, bench";
    out.conditions = {{"lubrication", 1}, {"neck_flexion", 60}, {"speed", 50}};
    EXPECT_TRUE(sealContent(out, kContent, kPassphrase));
    return out;
  }
  SealOpening opening(const SealedReference& reference, bool early = false) {
    return {records_.entry(seal_session_.id), reference.entry.id, early, kContent, {}, {}};
  }
  void addVersion(const std::string& label) {
    auto version = records_.model(namingModel({"E1"}));
    version.label = label;
    ASSERT_TRUE(append(study_.file, version));
  }
  SealedTrial trial() {
    const auto all = sealedTrials(study_.file);
    EXPECT_TRUE(all) << all.error().message();
    return all->at(0);
  }
  template <class Record>
  std::string refusal(const Record& record) {
    const auto written = append(study_.file, record);
    return written ? "" : written.error().message();
  }

  support::TempFolder folder_;
  SampleRecords records_;
  std::string path_ = folder_.file("study.tactus");
  OpenStudy study_ = makeStudy(path_, records_);
  study::Person seal_person_;
  study::SessionRecord seal_session_;
};

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST_F(SealedReferences, IsReadAsWrittenAndOpens) {
  const auto reference = sealedNow();
  ASSERT_EQ(refusal(reference), "");
  EXPECT_EQ(trial().reference, reference);
  EXPECT_EQ(openContent(trial().reference, kPassphrase).value(), kContent);
  EXPECT_FALSE(openContent(trial().reference, "stones and river"));
  EXPECT_TRUE(checkStudy(study_.file)->empty());
}

// What stands beside the cipher in the clear is sealed with it.
TEST_F(SealedReferences, AnyChangeBreaksTheSeal) {
  const auto reference = sealedNow();
  const auto breaks = [&](auto change) {
    auto changed = reference;
    change(changed);
    return !openContent(changed, kPassphrase);
  };
  EXPECT_FALSE(breaks([](SealedReference&) {}));
  EXPECT_TRUE(breaks([](auto& one) { one.cipher[5] = static_cast<char>(one.cipher[5] ^ 1); }));
  EXPECT_TRUE(breaks([](auto& one) { one.cipher.pop_back(); }));
  EXPECT_TRUE(breaks([](auto& one) { one.note += '.'; }));
  EXPECT_TRUE(breaks([](auto& one) { one.conditions["speed"] = 51; }));
  EXPECT_TRUE(breaks([](auto& one) { one.conditions.erase("speed"); }));
  EXPECT_TRUE(breaks([](auto& one) { one.late = true; }));
  EXPECT_TRUE(breaks([](auto& one) { --one.entry.when.utc_ms; }));
  EXPECT_TRUE(breaks([](auto& one) { one.sha256[0] = one.sha256[0] == 'a' ? 'b' : 'a'; }));
  EXPECT_TRUE(breaks([](auto& one) { one.salt[0] = static_cast<char>(one.salt[0] ^ 1); }));
  EXPECT_TRUE(breaks([](auto& one) { one.nonce[0] = static_cast<char>(one.nonce[0] ^ 1); }));
  EXPECT_TRUE(breaks([](auto& one) { ++one.operations; }));
}

TEST_F(SealedReferences, AfterTheFirstRecordOnlyAsLate) {
  EXPECT_FALSE(elicitationBegan(study_.file).value());
  ASSERT_TRUE(append(study_.file, records_.answer(study_.session.id)));
  EXPECT_TRUE(elicitationBegan(study_.file).value());
  EXPECT_TRUE(has(refusal(sealedNow()), "before its elicitation"));
  // With the records of the participant gone, nothing proves that the seal came first.
  ASSERT_TRUE(withdraw(study_.file, study_.person.id, 0));
  EXPECT_TRUE(elicitationBegan(study_.file).value());
  EXPECT_TRUE(has(refusal(sealedNow()), "a participant who withdrew"));
}

TEST_F(SealedReferences, OpensAfterASignOffOnly) {
  const auto reference = sealedNow();
  ASSERT_EQ(refusal(reference), "");
  addVersion("edit: S4: rule 1");
  EXPECT_TRUE(has(refusal(opening(reference)), "no version of the model that is signed off"));
  auto other = opening(reference, true);
  other.content += "1";
  EXPECT_TRUE(has(refusal(other), "another SHA-256"));
  EXPECT_TRUE(trial().openings.empty());
  addVersion("sign-off: feels right");
  EXPECT_EQ(refusal(opening(reference)), "");
  EXPECT_EQ(trial().signed_off->label, "sign-off: feels right");
}

// Each opening stays, and what one of them did not find came after it: a clock that is set back, and a further opening,
// hide nothing.
TEST_F(SealedReferences, WhatCameAfterAnOpeningIsVisible) {
  const auto reference = sealedNow();
  ASSERT_EQ(refusal(reference), "");
  ASSERT_TRUE(append(study_.file, records_.answer(study_.session.id, 1)));
  addVersion("sign-off: feels right");
  ASSERT_EQ(refusal(opening(reference)), "");
  EXPECT_TRUE(trial().changed_after.empty());
  EXPECT_EQ(trial().records_after, 0U);

  addVersion("edit: S4: rule 1");
  addVersion("sign-off: feels right, after 1 edit");
  auto answer = records_.answer(study_.session.id, 2);
  answer.entry.when.utc_ms = 1;
  ASSERT_TRUE(append(study_.file, answer));
  ASSERT_TRUE(append(study_.file, records_.rule(study_.session.id)));
  auto again = opening(reference);
  again.entry.when.utc_ms = 1;
  ASSERT_EQ(refusal(again), "");

  const auto found = trial();
  EXPECT_EQ(found.openings.size(), 2U);
  ASSERT_EQ(found.changed_after.size(), 2U);
  EXPECT_EQ(found.changed_after.front().label, "edit: S4: rule 1");
  EXPECT_EQ(found.signed_off->label, "sign-off: feels right");
  EXPECT_EQ(found.records_after, 2U);
  EXPECT_TRUE(checkStudy(study_.file)->empty());
}

TEST_F(SealedReferences, NoWithdrawalTouchesIt) {
  // Codes that also stand in the records of the seal: a depth, a force, a condition, a word of the cipher's text.
  for (const char* code : {"170", "58", "50", "reference"}) {
    ASSERT_TRUE(append(study_.file, records_.person(code)));
  }
  auto reference = sealedNow();
  ASSERT_EQ(refusal(reference), "");
  ASSERT_EQ(refusal(opening(reference, true)), "");
  const auto before = trial();
  const auto all = persons(study_.file);
  ASSERT_TRUE(all);
  for (const auto& person : *all) {
    if (person.id == seal_person_.id) continue;
    const auto withdrawn = withdraw(study_.file, person.id, 0);
    ASSERT_TRUE(withdrawn) << person.code << ": " << withdrawn.error().message();
  }
  EXPECT_EQ(trial().reference, before.reference);
  EXPECT_EQ(trial().openings, before.openings);
  EXPECT_TRUE(checkStudy(study_.file)->empty());
  EXPECT_FALSE(previewWithdrawal(study_.file, seal_person_.id));
  const auto refused = withdraw(study_.file, seal_person_.id, 0);
  ASSERT_FALSE(refused);
  EXPECT_TRUE(has(refused.error().message(), "keeps the sealed reference")) << refused.error().message();
  EXPECT_EQ(trial().reference, before.reference);
}

TEST_F(SealedReferences, ANoteNamesNoPerson) {
  auto reference = sealedNow();
  reference.note = "measured by " + study_.person.code;
  EXPECT_TRUE(has(refusal(reference), "the code of a person"));
}

// A merge takes the seal along, cleaned of nobody, and what the other copy brings was not found by the opening.
TEST_F(SealedReferences, TravelsWithAMerge) {
  const auto reference = sealedNow();
  ASSERT_EQ(refusal(reference), "");
  ASSERT_EQ(refusal(opening(reference, true)), "");
  SampleRecords others(2);
  auto other = makeStudy(folder_.file("other.tactus"), others);
  const auto fifty = others.person("50");
  ASSERT_TRUE(append(other.file, fifty));
  ASSERT_TRUE(withdraw(other.file, fifty.id, 0));
  ASSERT_TRUE(append(other.file, others.answer(other.session.id)));
  ASSERT_TRUE(study_.file.close());
  const auto merged = mergeStudy(other.file, path_, others.id(), 0);
  ASSERT_TRUE(merged) << merged.error().message();
  const auto found = sealedTrials(other.file);
  ASSERT_TRUE(found) << found.error().message();
  ASSERT_EQ(found->size(), 1U);
  EXPECT_EQ(found->front().reference, reference);
  EXPECT_EQ(found->front().records_after, 1U);
  EXPECT_EQ(openContent(found->front().reference, kPassphrase).value(), kContent);
}

}  // namespace
}  // namespace tactus::store
