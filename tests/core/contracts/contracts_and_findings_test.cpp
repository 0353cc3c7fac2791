// What the lint finds against a declared direction, a contract finds again.
#include <gtest/gtest.h>

#include "core/contracts/contract_check.h"
#include "elicitation/rules/rule_lint.h"

#include "tests/support/invented_experts.h"
#include "tests/support/ngt_model.h"

namespace tactus::contracts {
namespace {

TEST(ContractsAndFindings, EveryStepAgainstADeclarationViolatesAContract) {
  int steps = 0;
  auto model = support::inventedExperts();
  const auto experts = model.experts;
  for (const auto& expert : experts) {
    model.experts = {expert};
    const auto compiled = *fuzzy::compile(model);
    for (const auto& finding : elicitation::ruleLint(model, compiled).findings) {
      if (finding.kind != analysis::Finding::Kind::kAgainstDeclaration || !(finding.newtons.value_or(0) > 1e-6))
        continue;
      std::size_t input = 0;
      while (finding.from[input] == finding.to[input]) ++input;
      const double up = (compiled.evaluate(finding.to).force_n - compiled.evaluate(finding.from).force_n) *
                        (finding.to[input] > finding.from[input] ? 1 : -1);
      fuzzy::Contract contract;
      contract.kind = up > 0 ? fuzzy::Contract::Kind::kNeverRaises : fuzzy::Contract::Kind::kNeverLowers;
      contract.input = model.inputs[input].id;
      const auto result = checkContract(model, compiled, contract);
      EXPECT_EQ(result.verdict, Verdict::kViolated) << finding.text;
      EXPECT_GE(result.excess_n, *finding.newtons - 1e-9) << finding.text;
      ++steps;
    }
  }
  EXPECT_GT(steps, 3) << "too few to say anything";
}

}  // namespace
}  // namespace tactus::contracts
