#include "core/store/model_versions.h"

#include <gtest/gtest.h>

#include "tests/core/store/plain_sql.h"
#include "tests/core/store/sample_records.h"
#include "tests/support/temp_folder.h"

namespace tactus::store {
namespace {

class ModelVersions : public testing::Test {
 protected:
  study::ModelVersion add(const std::string& text, const std::optional<study::RecordId>& parent = {}) {
    auto version = records_.model(text);
    version.parent = parent;
    const auto added = append(study_.file, version);
    EXPECT_TRUE(added) << added.error().message();
    return version;
  }

  support::TempFolder folder_;
  SampleRecords records_;
  std::string path_ = folder_.file("study.tactus");
  OpenStudy study_ = makeStudy(path_, records_);
};

TEST_F(ModelVersions, AreKeptWithTheirHash) {
  EXPECT_EQ(*latestModelVersion(study_.file), std::nullopt);
  auto version = add("abc");
  version.sha256 = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";  // FIPS 180-4's example
  EXPECT_EQ(*modelVersion(study_.file, version.id), version);
  EXPECT_EQ(*latestModelVersion(study_.file), version);
  version.text.clear();
  EXPECT_EQ(*modelVersions(study_.file), std::vector{version});
}

TEST_F(ModelVersions, TheLatestIsTheOneAddedLastWhateverTheClockSays) {
  add("one");
  auto early = records_.model("two");
  early.utc_ms = 5;
  ASSERT_TRUE(append(study_.file, early));
  EXPECT_EQ((*latestModelVersion(study_.file))->text, "two");
  EXPECT_EQ(modelVersions(study_.file)->back().id, early.id);
}

TEST_F(ModelVersions, UndoIsAStepBackAlongTheParents) {
  const auto first = add("1");
  const auto second = add("2", first.id);
  const auto third = add("3", second.id);
  const auto branch = add("2b", first.id);
  const auto ids = [&](const study::RecordId& of) {
    std::vector<study::RecordId> found;
    const auto ancestors = modelAncestors(study_.file, of);
    for (const auto& version : *ancestors) found.push_back(version.id);
    return found;
  };
  EXPECT_EQ(ids(third.id), (std::vector{second.id, first.id}));
  EXPECT_EQ(ids(branch.id), std::vector{first.id});
  EXPECT_TRUE(ids(first.id).empty());
}

TEST_F(ModelVersions, WhatDoesNotFitIsRefused) {
  auto version = records_.model("text");
  version.parent = records_.id();
  EXPECT_FALSE(append(study_.file, version));
  version.parent.reset();
  version.sha256 = std::string(64, '0');
  EXPECT_FALSE(append(study_.file, version));
  version.sha256.clear();
  EXPECT_TRUE(append(study_.file, version));
  EXPECT_FALSE(append(study_.file, version));
  const auto none = modelVersion(study_.file, records_.id());
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().message().find("found no model version"), std::string::npos);
}

TEST_F(ModelVersions, AChangedTextIsFoundOut) {
  const auto version = add("the model");
  ASSERT_TRUE(study_.file.close());
  {
    PlainSql sql(path_);
    ASSERT_EQ(sql.complaintWithoutGuards("UPDATE model_version SET text = 'another model'"), "");
  }
  const auto file = StudyFile::open(path_);
  ASSERT_TRUE(file);
  const auto read = modelVersion(*file, version.id);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, base::ErrorCode::kMismatch);
}

}  // namespace
}  // namespace tactus::store
