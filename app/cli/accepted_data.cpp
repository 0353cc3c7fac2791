#include "app/cli/accepted_data.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/base/close_match.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"

namespace tactus::cli {
namespace {

using study::DataFinding;
using Kind = DataFinding::Kind;

/// The participants of the refused findings of each kind that was accepted.
std::map<std::string, std::vector<std::string>> byKind(const std::vector<DataFinding>& findings,
                                                       const std::vector<Kind>& accepted) {
  std::map<std::string, std::vector<std::string>> out;
  for (const auto& finding : findings) {
    if (study::isAccepted(finding, accepted)) out[std::string(name(finding.kind))].push_back(finding.participant);
  }
  return out;
}

}  // namespace

std::vector<std::string> acceptableWords() {
  std::vector<std::string> words;
  for (const Kind kind : study::kAcceptable) words.emplace_back(name(kind));
  return words;
}

base::Result<std::vector<Kind>> acceptedKinds(const std::vector<std::string>& words) {
  std::vector<Kind> kinds;
  for (const auto& word : words) {
    const auto kind = study::acceptableKind(word);
    if (!kind) {
      const auto known = acceptableWords();
      return base::fail(base::ErrorCode::kValue, "--accept", base::quoted(word),
                        "one of " + base::joined(known, ", ") + base::suggestion(word, known));
    }
    if (std::find(kinds.begin(), kinds.end(), *kind) == kinds.end()) kinds.push_back(*kind);
  }
  return kinds;
}

std::vector<std::string> acceptedNotes(const std::vector<DataFinding>& findings, const std::vector<Kind>& accepted) {
  const auto found = byKind(findings, accepted);
  std::vector<std::string> notes;
  std::vector<std::string> parts;
  for (const auto& [kind, participants] : found) parts.push_back(kind + " of " + base::joined(participants, ", "));
  if (!parts.empty()) notes.push_back("Accepted as it is: " + base::joined(parts, "; ") + ".");
  for (const Kind kind : accepted) {
    if (found.contains(std::string(name(kind)))) continue;
    notes.push_back("Nothing was refused for " + std::string(name(kind)) + ": --accept has no effect.");
  }
  return notes;
}

std::string acceptedJson(const std::vector<DataFinding>& findings, const std::vector<Kind>& accepted) {
  std::vector<std::string> members;
  for (const auto& [kind, participants] : byKind(findings, accepted)) {
    std::vector<std::string> codes;
    for (const auto& code : participants) codes.push_back(base::jsonString(code));
    members.push_back(base::jsonString(kind) + ": [" + base::joined(codes, ", ") + "]");
  }
  return members.empty() ? std::string() : "{ " + base::joined(members, ", ") + " }";
}

}  // namespace tactus::cli
