#include "app/cli/findings_text.h"

#include <map>

#include "app/cli/terminal.h"
#include "core/base/text.h"

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

namespace {

using elicitation::RuleFinding;

// Of one kind; with all kinds at once it still fits on a screen.
constexpr std::size_t kMostLines = 4;

void writeSources(const RuleFinding& finding, base::JsonWriter& json) {
  json.key("sources").beginArray(base::JsonWriter::Layout::kInline);
  for (const auto& [rule, origin] : finding.sources) {
    json.beginObject(base::JsonWriter::Layout::kInline);
    if (rule) json.key("rule").value(*rule + 1);
    if (!origin.form.empty()) json.key("form").value(origin.form);
    if (origin.item > 0) json.key("item").value(origin.item);
    if (origin.line.number > 0) json.key("line").value(static_cast<std::size_t>(origin.line.number));
    json.endObject();
  }
  json.endArray();
}

}  // namespace

std::string findingsAsText(std::span<const RuleFinding> findings, const std::string& unit) {
  std::map<RuleFinding::Kind, std::size_t> of_kind;
  for (const auto& finding : findings) ++of_kind[finding.kind];
  std::map<RuleFinding::Kind, std::size_t> printed;
  std::string text;
  for (const auto& finding : findings) {
    auto& lines = printed[finding.kind];
    if (lines == 0)
      text += "  " + std::string(name(finding.kind)) + ": " + std::to_string(of_kind[finding.kind]) + '\n';
    if (++lines <= kMostLines) {
      // Of experts who are apart the sentence itself says who.
      const bool named = finding.kind == RuleFinding::Kind::kExpertsApart;
      std::string sentence;
      if (!named) sentence = (finding.experts.empty() ? "mean" : base::joined(finding.experts, " and ")) + ": ";
      sentence += finding.text;
      if (finding.newtons) {
        sentence += " (" + base::formatFixed(*finding.newtons, 3) + ' ' + unit + (finding.at_least ? " or more)" : ")");
      }
      text += wrapped(sentence, "    ", 6);
    } else if (lines == of_kind[finding.kind]) {
      text += "    and " + std::to_string(lines - kMostLines) + " more, see --json\n";
    }
  }
  return text;
}

void writeFindings(std::span<const RuleFinding> findings, base::JsonWriter& json) {
  json.key("findings").beginArray();
  for (const auto& finding : findings) {
    json.beginObject(base::JsonWriter::Layout::kInline).key("kind").value(name(finding.kind)).key("expert");
    finding.experts.empty() ? json.null() : json.value(finding.experts.front());
    json.key("experts").values(finding.experts);
    json.key("place").value(finding.place).key("text").value(finding.text);
    json.key("newtons").value(finding.newtons).key("at_least").value(finding.at_least);
    if (!finding.from.empty()) json.key("from").values(finding.from).key("to").values(finding.to);
    writeSources(finding, json);
    json.endObject();
  }
  json.endArray();
}

}  // namespace tactus::cli
