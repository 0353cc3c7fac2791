#include "core/procedure/procedure.h"

#include <algorithm>

#include "core/base/files/checksums.h"

namespace tactus::procedure {

std::string textIn(const Texts& texts, std::string_view language) {
  for (const std::string_view wanted : {language, std::string_view("en")}) {
    const auto found = texts.find(std::string(wanted));
    if (found != texts.end()) return found->second;
  }
  return texts.empty() ? std::string() : texts.begin()->second;
}

std::size_t Procedure::way() const { return fuzzy::wayOf(inputs).value_or(0); }
std::optional<std::size_t> Procedure::rate() const { return fuzzy::rateOf(inputs); }

const fuzzy::Variable* Procedure::rateInput() const {
  const auto found = rate();
  return found ? &inputs[*found] : nullptr;
}

std::vector<std::string> Procedure::inputIds() const {
  std::vector<std::string> out;
  for (const auto& input : inputs) out.push_back(input.id);
  return out;
}

const TermSet* Procedure::wayTerms(std::string_view set) const {
  const auto found =
      std::find_if(way_terms.begin(), way_terms.end(), [&](const TermSet& one) { return one.id == set; });
  return found == way_terms.end() ? nullptr : &*found;
}

const study::Form* Procedure::form(std::string_view form_id) const {
  const auto found =
      std::find_if(forms.begin(), forms.end(), [&](const study::Form& one) { return one.id == form_id; });
  return found == forms.end() ? nullptr : &*found;
}

std::string Procedure::titleIn(std::string_view language) const { return textIn(title, language); }

std::string packSha256(const PackFiles& files) {
  std::string list;
  for (const auto& [path, bytes] : files) list += base::sha256(bytes) + "  " + path + "\n";
  return base::sha256(list);
}

}  // namespace tactus::procedure
