#include "questionnaires/aliases.h"

#include <algorithm>
#include <set>

#include "core/base/check.h"
#include "core/base/json/json_members.h"
#include "core/base/text.h"
#include "questionnaires/form_file.h"

namespace tactus::questionnaires {
namespace {

using base::JsonMembers;
using base::JsonValue;
using base::required;

/// Lower case, runs of spaces as one space.
std::string normalized(std::string_view text) {
  std::string out;
  for (const char c : base::lowered(base::trimmed(text))) {
    const bool space = c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (!space) out += c;
    if (space && !out.empty() && out.back() != ' ') out += ' ';
  }
  return out;
}

bool isCalled(const NamedId& named, const std::string& word) {
  return std::find(named.words.begin(), named.words.end(), word) != named.words.end();
}

/// The words for `id` under `key`, which must not mean anything else that is in `taken`.
NamedId readWords(JsonMembers& json, std::string_view key, std::string id, std::set<std::string>& taken) {
  std::vector<std::string> texts;
  json.texts(required(key), texts);
  texts.push_back(id);
  NamedId named{std::move(id), {}};
  for (const auto& text : texts) {
    const std::string word = normalized(text);
    if (isCalled(named, word)) continue;
    if (!taken.insert(word).second) json.refuse(key, base::quoted(text) + " for two ids", "one id for each word");
    named.words.push_back(word);
  }
  return named;
}

VariableWords readVariable(JsonValue value, std::set<std::string>& names, std::optional<base::Error>& error) {
  JsonMembers json(value, error);
  VariableWords variable;
  std::string id;
  json.text(required("id"), id);
  variable.name = readWords(json, "names", std::move(id), names);
  std::set<std::string> taken;
  if (const auto terms = json.object(required("terms"))) {
    JsonMembers members(*terms, error);
    for (const JsonValue term : *terms)
      variable.terms.push_back(readWords(members, term.key(), std::string(term.key()), taken));
  }
  json.refuseOthers();
  return variable;
}

AliasTable readAliases(JsonMembers& json, std::optional<base::Error>& error) {
  AliasTable table;
  std::set<std::string> names;
  json.format("tactus-aliases");
  json.version("version");
  for (const JsonValue input : json.elements(required("inputs")))
    table.inputs.push_back(readVariable(input, names, error));
  if (const auto output = json.object(required("output"))) table.output = readVariable(*output, names, error);
  json.refuseOthers();
  return table;
}

}  // namespace

std::optional<std::string> VariableWords::term(std::string_view word) const {
  const std::string wanted = normalized(word);
  for (const auto& named : terms) {
    if (isCalled(named, wanted)) return named.id;
  }
  return std::nullopt;
}

std::optional<std::size_t> AliasTable::input(std::string_view word) const {
  const std::string wanted = normalized(word);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (isCalled(inputs[i].name, wanted)) return i;
  }
  return std::nullopt;
}

base::Result<AliasTable> parseAliases(std::string_view text, const std::string& file) {
  return base::readJson(text, file, readAliases);
}

AliasTable ngtAliases() {
  auto table = parseAliases(aliasesJson(), "aliases.json");
  TACTUS_CHECK(table.has_value());
  return std::move(*table);
}

}  // namespace tactus::questionnaires
