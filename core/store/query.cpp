#include "core/store/query.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/json/json_writer.h"
#include "core/base/text.h"

namespace tactus::store {

std::string pairListText(const PairList& pairs) {
  base::JsonWriter json;
  json.beginArray(base::JsonWriter::Layout::kInline);
  for (const auto& [first, second] : pairs) json.values(std::array{first, second});
  std::string text = json.endArray().text();
  text.pop_back();  // the newline of a whole file
  return text;
}

std::optional<PairList> pairListIn(const std::string& text) {
  const auto json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_array()) return std::nullopt;
  PairList pairs;
  for (const auto& pair : json) {
    if (!pair.is_array() || pair.size() != 2 || !pair[0].is_string() || !pair[1].is_string()) return std::nullopt;
    pairs.emplace_back(pair[0].get<std::string>(), pair[1].get<std::string>());
  }
  return pairs;
}

using base::ErrorCode;
using study::RecordId;

Query& Query::put(std::int64_t value) {
  statement_.bind(in_++, value);
  return *this;
}

Query& Query::put(double value) {
  // SQLite would store NaN as NULL, which says "not given".
  if (!std::isfinite(value)) refuse(ErrorCode::kValue, {}, base::formatNumber(value), "a finite number");
  statement_.bind(in_++, value);
  return *this;
}

Query& Query::put(const std::optional<double>& value) {
  if (value) return put(*value);
  statement_.bind(in_++);
  return *this;
}

Query& Query::put(const std::optional<std::int64_t>& value) {
  if (value) return put(*value);
  statement_.bind(in_++);
  return *this;
}

Query& Query::put(std::string_view text) {
  if (!base::isUtf8(text) || text.find('\0') != std::string_view::npos) {
    refuse(ErrorCode::kSyntax, {}, base::quoted(text), "text in UTF-8");
  }
  statement_.bind(in_++, std::string(text));
  return *this;
}

Query& Query::put(const RecordId& id) {
  if (id.isNil()) refuse(ErrorCode::kValue, {}, "an id of zeros", "a random id");
  statement_.bind(in_++, id.bytes.data(), static_cast<int>(id.bytes.size()));
  return *this;
}

Query& Query::put(const std::optional<RecordId>& id) {
  if (id) return put(*id);
  statement_.bind(in_++);
  return *this;
}

Query& Query::putJson(const std::string& text) {
  if (!text.empty() && !nlohmann::json::accept(text)) {
    refuse(ErrorCode::kSyntax, {}, base::quoted(text), "JSON text, or none");
  }
  return put(text);
}

Query& Query::putBlob(const std::string& bytes) {
  statement_.bind(in_++, bytes.data(), static_cast<int>(bytes.size()));
  return *this;
}

void Query::run() {
  statement_.exec();
  statement_.reset();
  in_ = 1;
}

void Query::reset() {
  statement_.reset();
  in_ = 1;
}

void Query::giveBack() {
  // What went wrong was said when it happened; a reset says it again.
  statement_.tryReset();
  statement_.clearBindings();
}

bool Query::next() {
  out_ = 0;
  return statement_.executeStep();
}

std::optional<double> Query::numberOrNothing() {
  const auto column = statement_.getColumn(out_++);
  return column.isNull() ? std::nullopt : std::optional(column.getDouble());
}

std::optional<std::int64_t> Query::integerOrNothing() {
  const auto column = statement_.getColumn(out_++);
  return column.isNull() ? std::nullopt : std::optional<std::int64_t>(column.getInt64());
}

RecordId Query::id() {
  const auto column = statement_.getColumn(out_++);
  RecordId id;
  if (column.getBytes() != static_cast<int>(id.bytes.size())) {
    refuse(ErrorCode::kMismatch, {}, "an id of " + std::to_string(column.getBytes()) + " bytes", "one of 16");
  }
  const auto* bytes = static_cast<const std::uint8_t*>(column.getBlob());
  std::copy_n(bytes, id.bytes.size(), id.bytes.begin());
  return id;
}

void Query::requireIntact(std::string_view table, const RecordId& id) {
  if (flag()) return;
  refuse(ErrorCode::kMismatch, std::string(table) + " " + study::toText(id), "a record that does not fit its CRC-32",
         "the record as it was written; take it from a backup");
}

std::optional<RecordId> Query::idOrNothing() {
  if (statement_.getColumn(out_).isNull()) {
    ++out_;
    return std::nullopt;
  }
  return id();
}

}  // namespace tactus::store
