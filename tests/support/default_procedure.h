// The procedure of a study that names none, in short, for tests that are about its words.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/procedure/procedure.h"

namespace tactus::support {

inline const procedure::Procedure& defaultProcedure() { return *procedure::defaultProcedure(); }
inline std::vector<fuzzy::Variable> ngtInputs() { return defaultProcedure().inputs; }
inline std::vector<std::string> ngtInputIds() { return defaultProcedure().inputIds(); }
inline fuzzy::Variable ngtOutput() { return defaultProcedure().output; }
inline study::Form ngtForceForm() { return defaultProcedure().forms.front(); }
inline std::optional<procedure::TermSet> findDepthTerms(std::string_view id) {
  const auto* const set = defaultProcedure().wayTerms(id);
  return set == nullptr ? std::nullopt : std::optional(*set);
}

}  // namespace tactus::support
