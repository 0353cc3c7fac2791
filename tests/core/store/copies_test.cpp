#include "core/store/copies.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

#include "core/store/persons.h"

#include "tests/core/store/sample_records.h"
#include "tests/support/temp_folder.h"

namespace tactus::store {
namespace {

namespace fs = std::filesystem;

class Copies : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& bytes) const {
    fs::create_directories(fs::path(folder_.file(name)).parent_path());
    std::ofstream(folder_.file(name), std::ios::binary) << bytes;
  }
  /// `name: what`, a line each.
  std::string found(const std::vector<std::string>& codes, const std::vector<std::string>& also = {}) const {
    std::string lines;
    auto copies = findCopies(folder_.file("study.tactus"), study_.person.id, codes, also);
    std::sort(copies.begin(), copies.end(),
              [](const Copy& a, const Copy& b) { return fs::path(a.path).filename() < fs::path(b.path).filename(); });
    for (const auto& copy : copies) {
      lines += fs::path(copy.path).filename().string() + ": " + copy.what + "\n";
    }
    return lines;
  }

  support::TempFolder folder_;
  SampleRecords records_;
  OpenStudy study_ = makeStudy(folder_.file("study.tactus"), records_);
};

TEST_F(Copies, WhatIsNamedAfterTheStudyIsNamed) {
  EXPECT_EQ(found({"velvet-otter"}), "");  // the study and its own journal are none
  write("study.tactus.before-v2", "");
  write("study.tactus.a1B2c3", "");
  write("study.tactus-wal.damaged-1", "");
  write("study.tactus.import-a1B2c3/x.csv", "");
  EXPECT_EQ(found({}),
            "study.tactus-wal.damaged-1: a journal that was kept aside\n"
            "study.tactus.a1B2c3: left over by a program that was interrupted, or a copy\n"
            "study.tactus.before-v2: a copy made before an upgrade\n"
            "study.tactus.import-a1B2c3: left over by a program that was interrupted, or a copy\n");
}

TEST_F(Copies, FilesAndFoldersAreNamedWhereThePersonStandsInThem) {
  ASSERT_TRUE(backUp(study_.file, folder_.file("yesterday.tactus")));
  SampleRecords others(9);
  ASSERT_TRUE(StudyFile::create(folder_.file("other.tactus"), others.study()));
  write("export/codebook.json", "{}");
  write("export/records/persons.csv", "id,code,simulated\n" + study::toText(study_.person.id) + ",x,1\n");
  write("tables/answers.csv", "participant\nvelvet-otter\n");
  write("tables_of_others/answers.csv", "participant\ncalm-fox\n");
  write("mean.tactus.json", "{\"experts\": [{\"id\": \"velvet-otter\"}]}");
  write("photo.png", "velvet-otter");
  const std::string everything =
      "export: an export in which the participant stands\n"
      "mean.tactus.json: a file in which the participant stands\n"
      "tables: a folder in which the participant stands\n"
      "yesterday.tactus: another study file or backup in which the participant stands\n";
  EXPECT_EQ(found({"velvet-otter"}), everything);
  write("elsewhere/autosave/1/edits-1.json", "{\"label\": \"velvet-otter\"}");
  EXPECT_NE(found({"velvet-otter"}).find("elsewhere"), std::string::npos);
  const support::TempFolder home;
  fs::rename(folder_.file("elsewhere"), home.file("elsewhere"));
  EXPECT_EQ(found({"velvet-otter"}), everything);
  EXPECT_EQ(found({"velvet-otter"}, {home.file("elsewhere")}),
            "autosave: a folder in which the participant stands\n" + everything);
}

TEST_F(Copies, ATextAcrossTwoPiecesIsFound) {
  for (const std::size_t before : {(1U << 20U) - 5, (2U << 20U) - 11, 3U << 20U}) {
    write("big.csv", std::string(before, '.') + "velvet-otter" + std::string(99, '.'));
    EXPECT_EQ(found({"velvet-otter"}), "big.csv: a file in which the participant stands\n") << before;
    EXPECT_EQ(found({"velvet-otters"}), "") << before;
  }
}

}  // namespace
}  // namespace tactus::store
