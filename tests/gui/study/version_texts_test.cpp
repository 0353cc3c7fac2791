#include <QSignalSpy>
#include <gtest/gtest.h>

#include "app/workbench/study/study_models.h"
#include "core/store/model_versions.h"

#include "tests/gui/patience.h"
#include "tests/gui/sample_models.h"
#include "tests/gui/sample_study.h"

namespace tactus::workbench {
namespace {

using tests::kPatience;

class VersionTextsTest : public testing::Test {
 protected:
  // 100 versions of 1,000 bytes each.
  void SetUp() override {
    const QString path = folder.path(QStringLiteral("long.tactus"));
    tests::makeStudyFile(path, [this](store::StudyFile& file, study::RecordIds& ids) {
      for (int i = 0; i < 100; ++i) {
        study::ModelVersion version;
        version.id = ids.next();
        version.label = "edit: " + std::to_string(i);
        version.text = std::to_string(i) + std::string(1000 - std::to_string(i).size(), ' ');
        ASSERT_TRUE(store::append(file, version));
      }
      versions = *store::modelVersions(file);
    });
    study.open(path);
    ASSERT_TRUE(tests::comesTrue([this] { return study.isOpen(); }));
  }

  tests::ModelFolder folder;
  std::vector<study::ModelVersion> versions;
  StudyConnection study;
  VersionTexts texts{study};
};

TEST_F(VersionTextsTest, ReadsTheNewestAheadAndTheOthersWhenAskedFor) {
  texts.begin(versions, 30'000);
  const auto read = texts.reader();
  // Nobody asked for the newest, so nobody is told; 20 come at once.
  QSignalSpy arrived(&texts, &VersionTexts::arrived);
  ASSERT_TRUE(tests::comesTrue([&] { return read(versions[60].id).has_value(); }));
  EXPECT_EQ(read(versions[99].id)->text.substr(0, 3), "99 ");
  EXPECT_FALSE(read(versions[3].id));
  EXPECT_FALSE(read(versions[3].id));
  arrived.clear();
  ASSERT_TRUE(arrived.wait(kPatience));
  ASSERT_TRUE(read(versions[3].id));
  EXPECT_EQ(read(versions[3].id)->text.substr(0, 2), "3 ");
}

TEST_F(VersionTextsTest, WhatCannotBeReadSaysWhy) {
  texts.begin({});
  const auto read = texts.reader();
  const study::RecordId nowhere = study::RecordIds(99).next();
  QSignalSpy arrived(&texts, &VersionTexts::arrived);
  EXPECT_FALSE(read(nowhere));
  ASSERT_TRUE(arrived.wait(kPatience));
  const auto found = read(nowhere);
  ASSERT_FALSE(found);
  EXPECT_NE(found.error().message().find("no model version"), std::string::npos) << found.error().message();
}

TEST_F(VersionTextsTest, AnotherStudyForgetsWhatWasRead) {
  texts.begin(versions);
  const auto before = texts.reader();
  ASSERT_TRUE(tests::comesTrue([&] { return before(versions[0].id).has_value(); }));
  texts.begin({});
  EXPECT_TRUE(before(versions[0].id));
  EXPECT_FALSE(texts.reader()(versions[0].id));
}

}  // namespace
}  // namespace tactus::workbench
