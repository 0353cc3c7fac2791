#include <algorithm>

#include "core/base/json/json_members.h"
#include "core/base/text.h"
#include "core/procedure/procedure.h"

namespace tactus::procedure {
namespace {

using base::ErrorCode;
using base::JsonMembers;
using base::JsonValue;
using base::required;
using base::Result;
using Problem = std::optional<base::Error>;

Result<std::map<std::string, Texts>> readTexts(std::string_view text, const std::string& file,
                                               const std::vector<std::string>& languages) {
  return base::readJson(text, file, [&](JsonMembers& json, Problem& error) {
    std::map<std::string, Texts> out;
    json.format("tactus-words");
    if (const auto all = json.object(required("texts"))) {
      JsonMembers members(*all, error);
      for (const JsonValue one : *all) {
        std::vector<JsonMembers::NamedText> texts;
        members.texts(required(one.key()), texts);
        for (const auto& [language, words] : texts) {
          if (std::find(languages.begin(), languages.end(), language) == languages.end())
            members.refuse(one.key(), "words in " + base::quoted(language), "words in the pack's languages");
        }
        out.emplace(one.key(), Texts(texts.begin(), texts.end()));
      }
    }
    json.refuseOthers();
    return out;
  });
}

/// The ids of the words that a pack must give.
std::vector<std::string> wantedWords(const Procedure& procedure) {
  std::vector<std::string> out = {"tool", "con.purpose", "you.years", "glo.way"};
  for (const TermSet& set : procedure.way_terms) {
    for (const auto& region : set.terms) out.push_back("a." + region.id);
  }
  for (std::size_t i = 0; i < procedure.inputs.size(); ++i) {
    const fuzzy::Variable& input = procedure.inputs[i];
    if (i == procedure.way()) continue;
    out.push_back("s." + input.id);
    out.push_back("glo." + input.id);
    for (const auto& term : input.terms) out.push_back("s." + input.id + "." + term.id);
    if (procedure.rate() == i) {
      for (const auto& term : input.terms) out.push_back("spd." + term.id);
    }
  }
  for (const auto& term : procedure.output.terms) out.push_back("w." + term.id);
  const bool way_out = std::any_of(procedure.forms.begin(), procedure.forms.end(), [](const study::Form& form) {
    return std::any_of(form.items.begin(), form.items.end(), study::isWayOut);
  });
  if (way_out) {
    const std::string input = "s." + study::kWayOut.input;
    out.push_back(input);
    out.push_back(input + "." + study::kWayOut.term);
  }
  return out;
}

Result<void> checkWords(const Procedure& procedure, const std::string& file) {
  const std::string& first = procedure.languages.front();
  std::vector<std::string> missing;
  for (const std::string& id : wantedWords(procedure)) {
    const auto found = procedure.words.find(id);
    if (found == procedure.words.end() || !found->second.contains(first)) missing.push_back(id);
  }
  if (missing.empty()) return {};
  return base::inFile({ErrorCode::kSchema,
                       {},
                       "texts",
                       "no words in " + base::quoted(first) + " for " + base::listed(missing),
                       "words for each"},
                      file);
}

}  // namespace

Result<void> readWords(Procedure& procedure, const PackFiles& files, const std::string& path, const std::string& name) {
  const std::string file = name + "/" + (path.empty() ? std::string(kManifest) : path);
  if (!path.empty()) {
    TACTUS_TRY(procedure.words, readTexts(files.at(path), file, procedure.languages));
  }
  return checkWords(procedure, file);
}

}  // namespace tactus::procedure
