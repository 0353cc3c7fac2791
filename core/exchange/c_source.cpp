#include "core/exchange/c_source.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/exchange/c_parts.h"

namespace tactus::exchange {
namespace {

base::Result<FixedInputs> fixedInputs(const fuzzy::ForceModel& model, std::span<const FixedInput> fixed) {
  FixedInputs out(model.inputs.size());
  for (const auto& [input, value] : fixed) {
    const std::string& id = model.inputs[input].id;
    if (!std::isfinite(value)) {
      return base::fail(base::ErrorCode::kValue, "input " + base::quoted(id), base::formatNumber(value),
                        "a finite number to fix it at");
    }
    if (std::exchange(out[input], value)) {
      return base::fail(base::ErrorCode::kValue, "input " + base::quoted(id), "two values to fix it at", "one");
    }
  }
  if (std::all_of(out.begin(), out.end(), [](const auto& value) { return value.has_value(); }))
    return base::fail(base::ErrorCode::kValue, "inputs", "all of them fixed", "one at least that varies");
  return out;
}

/// The helpers that `body` calls: on common processors `lower` and `larger` are one instruction each.
std::string helperText(std::string_view body) {
  constexpr std::pair<std::string_view, std::string_view> kHelpers[] = {
      {"lower(", "HELPER double lower(double a, double b) { return a < b ? a : b; }\n"},
      {"larger(", "HELPER double larger(double a, double b) { return a > b ? a : b; }\n"},
      {"off_zero(",
       "/* Next to 0 a membership would be too small for a double; this far from it nothing changes. */\n"
       "HELPER double off_zero(double x) {\n"
       "  const double above = larger(x, 1e-290), below = lower(x, -1e-290);\n"
       "  const double far = x > 0.0 ? above : below;\n  return x != 0.0 ? far : x;\n}\n"},
      {"kept(",
       "/* A quotient of numbers above 0 stays above 0. */\n"
       "HELPER double kept(double way, double width) {\n"
       "  return way > 0.0 ? larger(way / width, 4.9406564584124654e-324) : 0.0;\n}\n"},
      {"kept_product(",
       "/* So does a product. */\n"
       "HELPER double kept_product(double weight, double held) {\n"
       "  return held > 0.0 ? larger(weight * held, 4.9406564584124654e-324) : 0.0;\n}\n"},
      {"not_a_number(",
       "HELPER double not_a_number(void) {\n"
       "  union {\n    unsigned long long bits;\n    double value;\n  } both;\n  both.bits = 0x7ff8000000000000ULL;\n"
       "  return both.value;\n}\n"},
      {"is_not_finite(",
       "/* By its bits, because compilers may be told that all numbers are finite. */\n"
       "HELPER unsigned long long is_not_finite(double x) {\n"
       "  union {\n    double value;\n    unsigned long long bits;\n  } both;\n  both.value = x;\n"
       "  return (both.bits & 0x7ff0000000000000ULL) == 0x7ff0000000000000ULL;\n}\n"}};
  std::string out;
  for (const auto& [call, text] : kHelpers) {
    // The first two are what the others are made of.
    const bool always = call == "lower(" || call == "larger(";
    if (always || body.find(call) != std::string_view::npos) out += text;
  }
  return out + "\n";
}

}  // namespace

void SourceWriter::addExpert(std::size_t index) {
  const ExpertView view = viewOf(model_, index);
  std::vector<Strength> strengths = strengthsOf(view, memberships_);
  ordered_.emplace_back();
  walked_.emplace_back();
  if (strengths.empty()) {
    walked_.back() = "  (void)inputs;\n  (void)m;\n  (void)offset;\n  return 0;\n";
    return;
  }
  std::vector<fuzzy::MembershipFunction> functions;
  for (const NamedTerm& term : view.output.terms) functions.push_back(fuzzy::MembershipFunction::of(*term.term));
  fuzzy::ClosedForm form{&memory_};
  const fuzzy::Variable& force = *view.output.variable;
  if (fuzzy::makeClosedForm(functions, force.min, force.max, model_.implication, form)) {
    const std::size_t group = groupOf(view, std::move(form), strengths);
    ordered_.back() = Ordered{group, std::move(strengths)};
    return;
  }
  walked_.back() = walkedCode(view, index, strengths, tables_);
  most_walked_ = std::max(most_walked_, strengths.size());
  const bool gaussian = std::any_of(view.output.terms.begin(), view.output.terms.end(),
                                    [](const NamedTerm& term) { return term.term->shape == fuzzy::Shape::kGaussian; });
  (gaussian ? gaussian_ : general_) = true;
}

std::size_t SourceWriter::groupOf(const ExpertView& view, fuzzy::ClosedForm form,
                                  const std::vector<Strength>& strengths) {
  std::vector<fuzzy::Term> terms;
  for (const NamedTerm& term : view.output.terms) terms.push_back(*term.term);
  auto group =
      std::find_if(groups_.begin(), groups_.end(), [&](const CentroidGroup& known) { return known.terms == terms; });
  if (group == groups_.end()) {
    groups_.push_back({std::move(terms), std::move(form), {}});
    group = groups_.end() - 1;
  }
  for (const Strength& strength : strengths) {
    const auto place = std::lower_bound(group->live.begin(), group->live.end(), strength.term);
    if (place == group->live.end() || *place != strength.term) group->live.insert(place, strength.term);
  }
  return static_cast<std::size_t>(group - groups_.begin());
}

/// The parts of a small model go into one stretch of code, a tenth faster; those of a large one stay functions.
bool SourceWriter::isLarge() const {
  constexpr std::size_t kMostRulesInline = 500;
  std::size_t rules = 0;
  for (const fuzzy::Expert& expert : model_.experts) rules += expert.rules.size();
  return rules > kMostRulesInline;
}

std::vector<std::size_t> SourceWriter::counting() const {
  std::vector<std::size_t> out;
  for (std::size_t e = 0; e < model_.experts.size(); ++e) {
    if (model_.experts[e].weight > 0) out.push_back(e);
  }
  return out;
}

bool SourceWriter::areOneGroup(const std::vector<std::size_t>& experts) const {
  return std::all_of(experts.begin(), experts.end(), [&](std::size_t e) {
    return ordered_[e] && ordered_[experts.front()] && ordered_[e]->group == ordered_[experts.front()]->group;
  });
}

std::string SourceWriter::header() const {
  std::string out =
      "/* " + comment(model_.name) + ", written by Tactus. C99, no library" +
      (memberships_.usesExp() || gaussian_ ? " but that of <math.h>" : "") + ". Every number is a double.\n" +
      (origin_.model_sha256.empty() ? "" : " * " + comment(originText(origin_)) + "\n") + " * Inputs, in this order:\n";
  std::string fixed;
  for (std::size_t i = 0; i < model_.inputs.size(); ++i) {
    const fuzzy::Variable& input = model_.inputs[i];
    if (fixed_[i]) {
      fixed += " *   " + comment(input.id) + " " + base::formatNumber(*fixed_[i]) + " " + comment(input.unit) + "\n";
      continue;
    }
    out += " *   " + comment(input.id) + ", " + base::formatNumber(input.min) + " to " + base::formatNumber(input.max) +
           " " + comment(input.unit) + "\n";
  }
  if (!fixed.empty()) out += " * Fixed:\n" + fixed;
  out +=
      " * A value outside is clamped; one that is not finite gives NaN and fired 0. fired: 1 where a rule fires, else "
      "0 and\n"
      " * the force is " +
      base::formatNumber(model_.default_force_n) +
      "; may be null. Any number of threads; no allocation, no lock, bounded time.\n * Experts:";
  for (const fuzzy::Expert& expert : model_.experts) {
    out += " " + comment(expert.id) + " (weight " + base::formatNumber(expert.weight) + ")";
  }
  const auto free = std::count(fixed_.begin(), fixed_.end(), std::nullopt);
  out +=
      " */\n#ifndef FORCE_MODEL_H\n#define FORCE_MODEL_H\n\n#include <stddef.h>\n\n#ifdef __cplusplus\nextern \"C\" "
      "{\n#endif\n\n";
  out += "#define FORCE_MODEL_INPUTS " + std::to_string(free) + "\n#define FORCE_MODEL_EXPERTS " +
         std::to_string(model_.experts.size()) + "\n\n";
  if (!origin_.model_sha256.empty()) {
    out += "/* Of the model file. */\n#define FORCE_MODEL_SHA256 \"" + origin_.model_sha256 + "\"\n\n";
  }
  out += "/* The averaged force, " + comment(model_.output.unit) +
         ". */\ndouble force_model(const double *inputs, int *fired);\n"
         "/* The same at many points: FORCE_MODEL_INPUTS numbers for each, point after point; a force for each; fired\n"
         " * for each, or null. */\n"
         "void force_model_batch(const double *inputs, size_t points, double *force, unsigned char *fired);\n"
         "/* The force of one expert alone; 0 and fired 0 where there is no such expert. */\n"
         "double force_model_expert(size_t expert, const double *inputs, int *fired);\n\n"
         "#ifdef __cplusplus\n}\n#endif\n\n#endif\n";
  return out;
}

std::string SourceWriter::source() const {
  std::string out = "/* " + comment(model_.name) +
                    ": see force_model.h. Written by Tactus; edit the model, not this file." +
                    (origin_.model_sha256.empty() ? "" : "\n * " + comment(originText(origin_))) +
                    " */\n#include \"force_model.h\"\n\n";
  if (memberships_.usesExp() || gaussian_) out += "#include <math.h>\n\n";
  std::string body = "enum { kMemberships = " + std::to_string(std::max<std::size_t>(memberships_.count(), 1)) +
                     " };\n\n" + memberships_.function() + "\n";
  if (general_ || gaussian_) body += outputSetText(most_walked_);
  if (general_) body += generalOffsetText();
  if (gaussian_) body += gaussianOffsetText();
  body += tables_ + expertFunctions() + meanText() + batchText() + expertText();
  // No exception flags are kept, and what is chosen by a comparison stays one instruction. A product and a sum stay two
  // instructions, so that the bits are the evaluator's on every processor.
  out +=
      "#if defined(__GNUC__) && !defined(__clang__)\n#pragma GCC optimize(\"no-trapping-math\", \"no-thread-jumps\", "
      "\"tree-vectorize\", \"vect-cost-model=dynamic\", \"no-tree-pre\", \"peel-loops\", "
      "\"fp-contract=off\")\n#elif defined(__clang__)\n#pragma STDC FP_CONTRACT OFF\n#endif\n";
  const std::string part = isLarge() ? "static" : "static inline __attribute__((always_inline))";
  out += "#ifdef __GNUC__\n#define HELPER static inline __attribute__((always_inline))\n#define PART " + part +
         "\n#define RARE static __attribute__((noinline))\n#else\n#define HELPER static inline\n#define PART static" +
         std::string(isLarge() ? "" : " inline") + "\n#define RARE static\n#endif\n\n";
  if (body.find("SIDE_BY_SIDE") != std::string::npos) {
    out +=
        "/* Clang computes several at once only where it does not write such a loop out first. */\n#ifdef __clang__\n"
        "#define SIDE_BY_SIDE _Pragma(\"clang loop unroll(disable)\")\n#else\n#define SIDE_BY_SIDE\n#endif\n\n";
  }
  return out + helperText(body) + body;
}

base::Result<CSource> cSource(const fuzzy::ForceModel& model, std::span<const FixedInput> fixed, const Origin& origin) {
  TACTUS_TRY(const auto inputs, fixedInputs(model, fixed));
  TACTUS_TRY(const auto compiled, fuzzy::compile(model));
  const SourceWriter writer(model, inputs, origin, fuzzy::meanOrder(compiled));
  return CSource{writer.header(), writer.source()};
}

}  // namespace tactus::exchange
