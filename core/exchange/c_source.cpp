#include "core/exchange/c_source.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "core/base/text.h"
#include "core/exchange/c_parts.h"

namespace tactus::exchange {
namespace {

base::Result<void> wantTrapezoids(const ExpertView& view) {
  for (const NamedTerm& term : view.output.terms) {
    if (term.term->shape != fuzzy::Shape::kGaussian) continue;
    return base::fail(base::ErrorCode::kValue, "output term " + base::quoted(term.term->id), "a Gaussian",
                      "trapezoids and triangles, whose centroid has a closed form in C");
  }
  return {};
}

std::string headerText(const fuzzy::ForceModel& model) {
  std::string out = "/* " + comment(model.name) +
                    ", written by Tactus. C99, no library. Every number is a double.\n * Inputs, in this order:\n";
  for (const fuzzy::Variable& input : model.inputs) {
    out += " *   " + comment(input.id) + ", " + base::formatNumber(input.min) + " to " + base::formatNumber(input.max) +
           " " + comment(input.unit) + "\n";
  }
  out +=
      " * A value outside is clamped; one that is not finite gives NaN and fired 0. fired: 1 where a rule fires, else "
      "0 and\n"
      " * the force is " +
      base::formatNumber(model.default_force_n) +
      "; may be null. Any number of threads; no allocation, no lock, bounded time.\n * Experts:";
  for (const fuzzy::Expert& expert : model.experts) {
    out += " " + comment(expert.id) + " (weight " + base::formatNumber(expert.weight) + ")";
  }
  out +=
      " */\n#ifndef FORCE_MODEL_H\n#define FORCE_MODEL_H\n\n#include <stddef.h>\n\n#ifdef __cplusplus\nextern \"C\" "
      "{\n#endif\n\n";
  out += "#define FORCE_MODEL_INPUTS " + std::to_string(model.inputs.size()) + "\n#define FORCE_MODEL_EXPERTS " +
         std::to_string(model.experts.size()) + "\n\n";
  out += "/* The averaged force, " + comment(model.output.unit) +
         ". */\ndouble force_model(const double *inputs, int *fired);\n"
         "/* The force of one expert alone; 0 and fired 0 where there is no such expert. */\n"
         "double force_model_expert(size_t expert, const double *inputs, int *fired);\n\n"
         "#ifdef __cplusplus\n}\n#endif\n\n#endif\n";
  return out;
}

/// The parts of a small model go into one stretch of code, a tenth faster; those of a large one stay functions.
std::string partText(const fuzzy::ForceModel& model) {
  constexpr std::size_t kMostRulesInline = 500;
  std::size_t rules = 0;
  for (const fuzzy::Expert& expert : model.experts) rules += expert.rules.size();
  if (rules > kMostRulesInline) return "#define PART static\n\n";
  return "#ifdef __GNUC__\n#define PART static inline __attribute__((always_inline))\n#else\n#define PART static "
         "inline\n"
         "#endif\n\n";
}

/// The helpers that `body` calls: on common processors `lower` and `larger` are one instruction each.
std::string helperText(std::string_view body) {
  constexpr std::pair<std::string_view, std::string_view> kHelpers[] = {
      {"lower(", "static inline double lower(double a, double b) { return a < b ? a : b; }\n"},
      {"larger(", "static inline double larger(double a, double b) { return a > b ? a : b; }\n"},
      {"off_zero(",
       "/* Next to 0 a membership would be too small for a double; this far from it nothing changes. */\n"
       "static inline double off_zero(double x) {\n"
       "  return x > 0.0 ? larger(x, 1e-290) : x < 0.0 ? lower(x, -1e-290) : x;\n}\n"},
      {"kept(",
       "/* A quotient of numbers above 0 stays above 0. */\n"
       "static inline double kept(double way, double width) {\n"
       "  return way > 0.0 ? larger(way / width, 4.9406564584124654e-324) : 0.0;\n}\n"},
      {"kept_product(",
       "/* So does a product. */\n"
       "static inline double kept_product(double weight, double held) {\n"
       "  return held > 0.0 ? larger(weight * held, 4.9406564584124654e-324) : 0.0;\n}\n"}};
  std::string out;
  for (const auto& [call, text] : kHelpers) {
    // The first two are what the others are made of.
    const bool always = call == "lower(" || call == "larger(";
    if (always || body.find(call) != std::string_view::npos) out += text;
  }
  return out + "\n";
}

/// The only expert that counts: its centroid is the mean.
std::string onlyText(const fuzzy::ForceModel& model, std::size_t expert) {
  return "double force_model(const double *inputs, int *fired) {\n  double m[kMemberships], offset;\n"
         "  const double nothing = memberships(inputs, m);\n  if (fired != NULL) *fired = 0;\n"
         "  if (nothing != 0.0) return nothing;\n  if (!expert_" +
         std::to_string(expert) + "(m, &offset)) return " + number(model.default_force_n) +
         ";\n  if (fired != NULL) *fired = 1;\n  return " + number(model.output.min) + " + offset;\n}\n\n";
}

std::string meanText(const fuzzy::ForceModel& model) {
  const auto counts = [](const fuzzy::Expert& expert) { return expert.weight > 0; };
  const auto first = std::find_if(model.experts.begin(), model.experts.end(), counts);
  if (std::count_if(model.experts.begin(), model.experts.end(), counts) == 1)
    return onlyText(model, static_cast<std::size_t>(first - model.experts.begin()));
  double total = 0;
  for (const fuzzy::Expert& expert : model.experts) total += expert.weight;
  std::string out =
      "double force_model(const double *inputs, int *fired) {\n  double m[kMemberships], offset, sum = 0.0, weights = "
      "0.0;\n"
      "  const double nothing = memberships(inputs, m);\n  if (fired != NULL) *fired = 0;\n"
      "  if (nothing != 0.0) return nothing;\n";
  for (std::size_t e = 0; e < model.experts.size(); ++e) {
    if (model.experts[e].weight == 0) continue;
    const std::string weight = number(model.experts[e].weight / total);
    out += "  if (expert_" + std::to_string(e) + "(m, &offset)) {\n    sum += " + weight +
           " * offset;\n    weights += " + weight + ";\n  }\n";
  }
  return out + "  if (!(weights > 0.0)) return " + number(model.default_force_n) +
         ";\n  if (fired != NULL) *fired = 1;\n  return " + number(model.output.min) + " + sum / weights;\n}\n\n";
}

std::string expertText(const fuzzy::ForceModel& model) {
  std::string out =
      "double force_model_expert(size_t expert, const double *inputs, int *fired) {\n"
      "  double m[kMemberships], offset = 0.0;\n  double nothing;\n  int any = 0;\n  if (fired != NULL) *fired = 0;\n"
      "  if (expert >= FORCE_MODEL_EXPERTS) return 0.0;\n  nothing = memberships(inputs, m);\n"
      "  if (nothing != 0.0) return nothing;\n  switch (expert) {\n";
  for (std::size_t e = 0; e < model.experts.size(); ++e) {
    const std::string index = std::to_string(e);
    out += "    case " + index + ": any = expert_" + index + "(m, &offset); break;\n";
  }
  return out + "    default: break;\n  }\n  if (!any) return " + number(model.default_force_n) +
         ";\n  if (fired != NULL) *fired = 1;\n  return " + number(model.output.min) + " + offset;\n}\n";
}

}  // namespace

base::Result<CSource> cSource(const fuzzy::ForceModel& model) {
  MembershipCode memberships(model);
  std::string experts;
  std::string tables;
  bool general = false;
  for (std::size_t e = 0; e < model.experts.size(); ++e) {
    const ExpertView view = viewOf(model, e);
    if (const auto ok = wantTrapezoids(view); !ok) return tl::unexpected(ok.error());
    const StrengthCode strengths = strengthCode(view, memberships);
    experts += "/* " + comment(model.experts[e].id) + " */\nPART int expert_" + std::to_string(e) +
               "(const double *m, double *offset) {\n" + strengths.text +
               centroidCode(view, e, strengths, tables, general) + "}\n\n";
  }
  std::string source =
      "/* " + comment(model.name) +
      ": see force_model.h. Written by Tactus; edit the model, not this file. */\n#include \"force_model.h\"\n\n";
  if (memberships.usesExp()) source += "#include <math.h>\n\n";
  std::string body =
      "enum { kMemberships = " + std::to_string(std::max<std::size_t>(memberships.count(), 1)) + " };\n\n";
  body += memberships.function() + "\n";
  if (general) body += generalOffsetText();
  body += tables + experts + meanText(model) + expertText(model);
  source += partText(model) + helperText(body) + body;
  return CSource{headerText(model), source};
}

}  // namespace tactus::exchange
