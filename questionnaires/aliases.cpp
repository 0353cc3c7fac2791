#include "questionnaires/aliases.h"

#include <algorithm>
#include <set>

#include "core/base/check.h"
#include "core/base/text.h"
#include "questionnaires/embedded_data.h"
#include "questionnaires/json_reading.h"

namespace tactus::questionnaires {
namespace {

using base::ErrorCode;
using base::Result;

/// Lower case, runs of spaces as one space.
std::string normalised(std::string_view text) {
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

/// The words for `id`, which must not mean anything else that is in `taken`.
Result<NamedId> namedId(std::string id, const JsonPlace& words, std::set<std::string>& taken) {
  auto texts = words.strings();
  if (!texts) return tl::unexpected(texts.error());
  texts->push_back(id);
  NamedId named{std::move(id), {}};
  for (const auto& text : *texts) {
    const std::string word = normalised(text);
    if (isCalled(named, word)) continue;
    if (!taken.insert(word).second) {
      return base::fail(ErrorCode::kValue, words.pointer, base::quoted(text) + " for two ids", "one id for each word");
    }
    named.words.push_back(word);
  }
  return named;
}

Result<VariableWords> variableWords(const JsonPlace& json, std::set<std::string>& names) {
  auto id = json.string("id");
  if (!id) return tl::unexpected(id.error());
  const auto words = json.member("names");
  if (!words) return tl::unexpected(words.error());
  const auto terms = json.member("terms").and_then([](const JsonPlace& place) { return place.object(); });
  if (!terms) return tl::unexpected(terms.error());

  VariableWords variable;
  auto name = namedId(std::move(*id), *words, names);
  if (!name) return tl::unexpected(name.error());
  variable.name = std::move(*name);
  std::set<std::string> taken;
  for (const auto& [term_id, term_words] : *terms) {
    auto term = namedId(term_id, term_words, taken);
    if (!term) return tl::unexpected(term.error());
    variable.terms.push_back(std::move(*term));
  }
  return variable;
}

Result<AliasTable> aliasTable(const JsonPlace& json) {
  const auto inputs = json.member("inputs").and_then([](const JsonPlace& place) { return place.array(); });
  if (!inputs) return tl::unexpected(inputs.error());
  const auto output = json.member("output");
  if (!output) return tl::unexpected(output.error());

  AliasTable table;
  std::set<std::string> names;
  for (const auto& input : *inputs) {
    auto variable = variableWords(input, names);
    if (!variable) return tl::unexpected(variable.error());
    table.inputs.push_back(std::move(*variable));
  }
  auto variable = variableWords(*output, names);
  if (!variable) return tl::unexpected(variable.error());
  table.output = std::move(*variable);
  return table;
}

}  // namespace

std::optional<std::string> VariableWords::term(std::string_view word) const {
  const std::string wanted = normalised(word);
  for (const auto& named : terms) {
    if (isCalled(named, wanted)) return named.id;
  }
  return std::nullopt;
}

std::optional<std::size_t> AliasTable::input(std::string_view word) const {
  const std::string wanted = normalised(word);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (isCalled(inputs[i].name, wanted)) return i;
  }
  return std::nullopt;
}

Result<AliasTable> parseAliases(std::string_view text, const std::string& file) {
  const auto json = parseJson(text, "tactus-aliases");
  if (!json) return base::inFile(json.error(), file);
  auto table = aliasTable({&*json, {}});
  if (!table) return base::inFile(table.error(), file);
  return table;
}

AliasTable ngtAliases() {
  auto table = parseAliases(aliasesJson(), "aliases.json");
  TACTUS_CHECK(table.has_value());
  return std::move(*table);
}

}  // namespace tactus::questionnaires
