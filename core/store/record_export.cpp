#include "core/store/record_export.h"

#include <filesystem>
#include <set>
#include <utility>

#include "core/base/files/file.h"
#include "core/base/files/checksums.h"
#include "core/base/tables/csv.h"
#include "core/base/text.h"
#include "core/store/pair_list.h"
#include "core/store/query.h"
#include "core/store/record_checksum.h"
#include "core/store/record_tables.h"
#include "core/store/recording_codec.h"
#include "core/store/schema.h"

namespace tactus::store {
namespace {

namespace fs = std::filesystem;
using base::ErrorCode;
using base::Result;
using study::RecordId;

std::string channelList(const study::Recording& recording) {
  PairList pairs;
  for (const auto& channel : recording.channels) pairs.emplace_back(channel.name, channel.unit);
  return pairListText(pairs);
}

/// `depth_mm`, `speed_mm_s`: what people and programs can use as the name of a column, each once.
std::vector<std::string> sampleColumns(const study::Recording& recording) {
  std::vector<std::string> columns = {"sample"};
  std::set<std::string> taken = {"sample"};
  for (const auto& channel : recording.channels) {
    std::string column = base::lowered(channel.name + '_' + channel.unit);
    for (char& c : column) {
      const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80;
      if (!plain) c = '_';
    }
    if (!taken.insert(column).second) {
      column += "_channel_" + std::to_string(columns.size());
      taken.insert(column);
    }
    columns.push_back(column);
  }
  return columns;
}

std::string samplesText(const study::Recording& recording) {
  const auto columns = sampleColumns(recording);
  base::CsvWriter csv{std::span<const std::string>(columns)};
  for (std::size_t i = 0; i < recording.size(); ++i) {
    csv.cell(i);
    for (const auto& channel : recording.channels) csv.cell(channel.values[i]);
    csv.endRow();
  }
  return csv.text();
}

/// Writes one table after the other; throws as Query does.
class Writer {
 public:
  Writer(Connection& connection, const std::string& folder, ByteOrderMark mark)
      : connection_(connection), folder_(folder), mark_(mark) {}

  void write(const RecordTable& table) {
    std::vector<std::string> names;
    for (const auto& column : table.columns) names.emplace_back(column.name);
    base::CsvWriter csv{std::span<const std::string>(names)};
    Query query(connection_, selection(table));
    while (query.next()) {
      key_.reset();
      for (const auto& column : table.columns) csv.cell(std::string_view(cell(column, query)));
      query.requireIntact(table.name, *key_);
      csv.endRow();
    }
    writeTable(fs::path(table.file), csv.text());
  }

 private:
  std::string selection(const RecordTable& table) const {
    std::string sql;
    for (const auto& column : table.columns) {
      std::string what(column.name);
      if (column.kind == ColumnKind::kChannels) what = "data";
      if (column.kind == ColumnKind::kRecording) what = "NULL";  // the channels brought it along
      if (column.kind == ColumnKind::kModel) what = "sha256, text";
      if (column.name == "schema_version") what = std::to_string(schemaSteps().back().version);
      if (column.kind == ColumnKind::kBytes) what = "lower(hex(" + what + "))";
      sql += (sql.empty() ? "SELECT " : ", ") + what;
    }
    sql += ", " + fitsChecksum(connection_, table.name, table.name);
    return sql + " FROM " + std::string(table.name) + " ORDER BY " + std::string(table.order);
  }

  std::string cell(const RecordColumn& column, Query& query) {
    switch (column.kind) {
      case ColumnKind::kId: {
        const auto id = query.idOrNothing();
        if (!key_) key_ = id;
        return id ? study::toText(*id) : std::string();
      }
      case ColumnKind::kBytes:
      case ColumnKind::kText:
        return mark_ == ByteOrderMark::kWrite ? base::guarded(query.text()) : query.text();
      case ColumnKind::kJson:
        return query.text();
      case ColumnKind::kInteger:
      case ColumnKind::kFlag: {
        const auto integer = query.integerOrNothing();
        return integer ? std::to_string(*integer) : std::string();
      }
      case ColumnKind::kNumber: {
        const auto number = query.numberOrNothing();
        return number ? base::formatNumber(*number) : std::string();
      }
      case ColumnKind::kChannels: {
        auto recording = decodeRecording(query.text());
        if (!recording) {
          recording.error().place = "recording of stroke " + study::toText(*key_);
          throw Refusal{recording.error()};
        }
        recording_ = std::move(*recording);
        return channelList(recording_);
      }
      case ColumnKind::kRecording: {
        query.idOrNothing();
        const fs::path path = fs::path(kRecordingsFolder) / (study::toText(*key_) + ".csv");
        writeTable(path, samplesText(recording_));
        return path.generic_string();
      }
      case ColumnKind::kModel: {
        const std::string hash = query.text();
        const std::string text = query.text();
        if (base::sha256(text) != hash) {
          refuse(ErrorCode::kMismatch, "model version " + study::toText(*key_), "a text that does not fit its SHA-256",
                 "the text that was saved");
        }
        const fs::path path = fs::path(kModelsFolder) / (study::toText(*key_) + ".json");
        writeFile(path, text);
        return path.generic_string();
      }
    }
    return {};
  }

  void writeTable(const fs::path& path, const std::string& text) {
    writeFile(path, (mark_ == ByteOrderMark::kWrite ? std::string(kByteOrderMark) : std::string()) + text);
  }

  void writeFile(const fs::path& path, const std::string& text) {
    const fs::path whole = folder_ / path;
    if (auto made = base::makeFolder(whole.parent_path().string()); !made) throw Refusal{made.error()};
    if (auto written = base::writeFileAtomically(whole.string(), text); !written) throw Refusal{written.error()};
  }

  Connection& connection_;
  fs::path folder_;
  ByteOrderMark mark_;
  std::optional<RecordId> key_;  // of the row; its files are named after it
  study::Recording recording_;
};

}  // namespace

Result<void> writeRecords(const StudyFile& file, const std::string& folder, ByteOrderMark mark) {
  Connection& connection = file.connection();
  return guarded(connection, [&] {
    Writer writer(connection, folder, mark);
    for (const auto& table : recordTables()) writer.write(table);
  });
}

}  // namespace tactus::store
