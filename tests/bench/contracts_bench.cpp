// What contracts cost on a mean of four experts, and whether the telling stroke beats random strokes.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "core/base/random.h"
#include "core/contracts/contract_check.h"
#include "core/contracts/telling_stroke.h"

#include "tests/support/invented_experts.h"
#include "tests/support/ngt_model.h"

namespace tactus::contracts {
namespace {

constexpr const char* kSentences[] = {"more lubrication never raises the force",
                                      "more speed never lowers the force",
                                      "more neck flexion never raises the force where depth is nasopharynx",
                                      "depth in nasal cavity is never harder than in laryngopharynx",
                                      "the force never changes by more than 1 JND within 1 mm of depth",
                                      "the force never changes by more than 0.1 N within 4 mm/s of speed",
                                      "the force is never above 1 N",
                                      "the force is never below 0.1 N",
                                      "the force is never above 0.93 N where speed is fast",
                                      "the model is never silent"};
constexpr int kStrokes = 10'000;

double msSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

void runContracts() {
  const auto model = support::inventedExperts();
  const auto compiled = *fuzzy::compile(model);
  double total_ms = 0;
  for (const char* const sentence : kSentences) {
    const auto contract = *parseContract(model, sentence);
    const auto start = std::chrono::steady_clock::now();
    const auto result = checkContract(model, compiled, contract);
    const double ms = msSince(start);
    total_ms += ms;
    std::printf("%8.1f ms  %8zu parts  %-9.9s %s\n", ms, result.parts, name(result.verdict).data(), sentence);
  }
  std::printf("%8.1f ms  all\n", total_ms);
}

/// Changes one word of a rule, or moves a ramp of an input or of the force. False where that breaks the order.
bool plant(fuzzy::ForceModel& model, base::Random& random) {
  const auto any = [&](const auto& list) {
    return static_cast<std::size_t>(random.below(static_cast<int>(list.size())));
  };
  const int kind = random.below(3);
  if (kind == 0) {
    auto& expert = model.experts[any(model.experts)];
    auto& rule = expert.rules[any(expert.rules)];
    const std::string before = rule.then;
    rule.then = model.output.terms[any(model.output.terms)].id;
    return rule.then != before;
  }
  auto& variable = kind == 1 ? model.inputs[any(model.inputs)] : model.output;
  const auto left = static_cast<std::size_t>(random.below(static_cast<int>(variable.terms.size()) - 1));
  const double by = (variable.max - variable.min) * (kind == 1 ? 0.02 : 0.05) * random.uniform(-1, 1);
  auto& a = variable.terms[left].points;
  auto& b = variable.terms[left + 1].points;
  a[2] += by, a[3] += by, b[0] += by, b[1] += by;
  return a[1] <= a[2] && b[1] <= b[2];
}

void runTell(int edits) {
  base::Random random(3);
  int beaten = 0;
  double worst = 1e9;
  double tell_ms = 0;
  for (int done = 0; done < edits;) {
    const auto first = done % 2 == 0 ? support::s4FiveRegions() : support::inventedExperts();
    auto second = first;
    if (!plant(second, random)) continue;
    ++done;
    const auto a = *fuzzy::compile(first);
    const auto b = *fuzzy::compile(second);
    const auto start = std::chrono::steady_clock::now();
    const auto found = tell(first, a, second, b, {}, {.bound = false});
    tell_ms += msSince(start);
    const StrokeInputs inputs = *strokeInputs(first);
    double best = 0;
    for (int n = 0; n < kStrokes; ++n) {
      Stroke stroke;
      for (const auto& input : first.inputs) stroke.inputs.push_back(random.uniform(input.min, input.max));
      stroke.from_mm = random.uniform(0, 570);
      stroke.to_mm = random.uniform(stroke.from_mm + 30, 600);
      stroke.peak_mm_s = random.uniform(5, 250);
      best = std::max(best, feelOf(a, b, inputs, stroke).rms_jnd);
    }
    beaten += found->feel.rms_jnd >= best ? 1 : 0;
    if (best > 0) worst = std::min(worst, found->feel.rms_jnd / best);
  }
  std::printf("tell beats the best of %d random strokes in %d of %d edits; worst ratio %.3f; %.0f ms each\n", kStrokes,
              beaten, edits, worst, tell_ms / edits);
}

}  // namespace
}  // namespace tactus::contracts

int main(int count, char** arguments) {
  int edits = 200;
  if (count == 3 && std::string_view(arguments[1]) == "--edits") edits = std::atoi(arguments[2]);
  tactus::contracts::runContracts();
  if (edits > 0) tactus::contracts::runTell(edits);
}
