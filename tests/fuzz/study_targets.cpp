#include "tests/fuzz/study_targets.h"

#include <cmath>
#include <string>
#include <vector>

#include "core/base/check.h"
#include "core/base/files/checksums.h"
#include "core/base/tables/csv.h"
#include "core/store/recording_codec.h"
#include "core/study/csv_tables.h"

namespace tactus::fuzz {
namespace {

constexpr std::size_t kChecksumBytes = 4;

void holds(const study::Participant& one) {
  TACTUS_CHECK(!one.code.empty());
  TACTUS_CHECK(!one.weight || (std::isfinite(*one.weight) && *one.weight >= 0));
}
void holds(const study::SpeedSample& one) {
  TACTUS_CHECK(one.stroke > 0 && std::isfinite(one.time_s) && std::isfinite(one.depth_mm) &&
               std::isfinite(one.speed_mm_s));
}
void holds(const study::ForceJudgement& one) {
  TACTUS_CHECK(one.step > 0 && std::isfinite(one.force_n) && one.force_n >= 0);
}
void holds(const study::Answer& one) {
  TACTUS_CHECK((one.status == study::Answer::Status::kAnswered) == !one.term.empty());
}
void holds(const study::GivenRule& one) { TACTUS_CHECK(!one.then.empty() && one.weight >= 0 && one.weight <= 1); }

template <class Record>
void checkRecords(const base::CsvTable& table, const base::Result<std::vector<Record>>& records) {
  if (!records) {
    TACTUS_CHECK(!records.error().wanted.empty());
    return;
  }
  TACTUS_CHECK(records->size() <= table.rowCount());
  for (const Record& one : *records) holds(one);
}

}  // namespace

void fuzzTables(std::string_view bytes) {
  const auto table = base::CsvTable::parse(std::string(bytes), "fuzzed");
  if (!table) return;
  checkRecords(*table, study::readParticipants(*table));
  checkRecords(*table, study::readSpeeds(*table));
  checkRecords(*table, study::readJudgements(*table));
  checkRecords(*table, study::readAnswers(*table));
  checkRecords(*table, study::readRules(*table, {"lubrication", "neck_flexion", "depth", "speed"}));
}

void fuzzRecording(std::string_view bytes) {
  TACTUS_CHECK(!store::decodeRecording(bytes) || bytes.size() > kChecksumBytes);
  // With a checksum that fits, so that more than the first check is reached.
  std::string sealed(bytes);
  std::uint32_t checksum = base::crc32(sealed);
  for (std::size_t i = 0; i < kChecksumBytes; ++i, checksum >>= 8U) sealed += static_cast<char>(checksum & 0xFFU);
  const auto recording = store::decodeRecording(sealed);
  if (!recording) return;
  const auto again = store::encodeRecording(*recording);
  TACTUS_CHECK(!again || *again == sealed);
}

}  // namespace tactus::fuzz
