#include "app/cli/data_text.h"

#include "app/cli/wrapped_text.h"

namespace tactus::cli {

std::string dataAsText(const std::vector<study::DataFinding>& findings,
                       std::span<const study::DataFinding::Kind> accepted) {
  if (findings.empty()) return {};
  std::string text = "look at the data first: " + std::to_string(findings.size()) + '\n';
  for (const auto& finding : findings) {
    const bool refused = finding.severity == study::DataFinding::Severity::kRefused;
    const bool is_accepted = study::isAccepted(finding, accepted);
    text += wrapped(study::text(finding), is_accepted ? "  accepted: " : refused ? "  refused: " : "  ", 4);
  }
  return text;
}

void writeData(const std::vector<study::DataFinding>& findings, base::JsonWriter& json) {
  json.key("data").beginArray();
  const auto textOrNull = [&json](std::string_view key, std::string_view value) {
    json.key(key);
    value.empty() ? json.null() : json.value(value);
  };
  for (const auto& finding : findings) {
    const bool in_table = finding.cell.line.number > 0;
    json.beginObject(base::JsonWriter::Layout::kInline).key("kind").value(name(finding.kind));
    json.key("severity").value(name(finding.severity));
    textOrNull("participant", finding.participant);
    textOrNull("table", in_table ? finding.cell.table : std::string_view());
    json.key("line");
    in_table ? json.value(static_cast<long long>(finding.cell.line.number)) : json.null();
    textOrNull("column", in_table ? finding.cell.column : std::string_view());
    json.key("sentence").value(finding.sentence).endObject();
  }
  json.endArray();
}

}  // namespace tactus::cli
