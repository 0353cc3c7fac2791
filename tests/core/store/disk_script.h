// A short session that is written over and over while something breaks, and what must be true afterwards.
#pragma once

#include <string>
#include <vector>

#include "core/study/session_records.h"

#include "tests/core/store/sample_records.h"

namespace tactus::store {

/// Records in the order in which they are written; which kind number n is follows from n.
class DiskScript {
 public:
  explicit DiskScript(study::RecordId session, std::size_t samples = 40) : session_(session), samples_(samples) {}

  /// Writes record number `number` (from 0).
  base::Result<void> write(StudyFile& file, int number) const;

  /// How many of the first records are in the file; every one of them must be there once, in order, as it was written,
  /// with nothing else and nothing damaged. A failure is a sentence in `complaint`.
  int intactRecords(const StudyFile& file, std::string& complaint) const;

 private:
  enum class Kind { kAnswer, kStroke, kJudgement };
  static Kind kindOf(int number);
  SampleRecords sampleFor(int number) const { return SampleRecords(1000U + static_cast<unsigned>(number)); }

  study::RecordId session_;
  std::size_t samples_;
};

}  // namespace tactus::store
