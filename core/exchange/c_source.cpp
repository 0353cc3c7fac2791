#include "core/exchange/c_source.h"

#include <algorithm>
#include <cmath>
#include <memory_resource>
#include <string_view>
#include <utility>

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

/// Writes the source of one model: what each expert needs, and from it the functions of the header.
class SourceWriter {
 public:
  SourceWriter(const fuzzy::ForceModel& model, const FixedInputs& fixed)
      : model_(model), fixed_(fixed), memberships_(model, fixed) {
    for (std::size_t e = 0; e < model.experts.size(); ++e) addExpert(e);
  }

  std::string header() const;
  std::string source() const;

 private:
  /// An expert whose centroid is the function of a group.
  struct Ordered {
    std::size_t group = 0;
    std::vector<Strength> strengths;
  };

  void addExpert(std::size_t index);
  std::size_t groupOf(const ExpertView& view, fuzzy::ClosedForm form, const std::vector<Strength>& strengths);
  bool isLarge() const;
  /// The experts that count, if all of them are of one group.
  std::vector<std::size_t> counting() const;
  bool areOneGroup(const std::vector<std::size_t>& experts) const;
  std::string strengthFunction(std::size_t index, const Ordered& expert) const;
  std::string largest(const CentroidGroup& group, const std::string& at) const;
  std::string orderedFunctions(std::size_t index) const;
  std::string expertFunctions() const;
  std::string meanText() const;
  std::string oneByOneText(const std::vector<std::size_t>& experts) const;
  std::string sideBySideText(const std::vector<std::size_t>& experts) const;
  std::string batchText() const;
  std::string blockText(const std::vector<std::size_t>& experts) const;
  std::string expertText() const;
  std::string share(std::size_t expert) const;

  const fuzzy::ForceModel& model_;
  const FixedInputs& fixed_;
  MembershipCode memberships_;
  std::pmr::monotonic_buffer_resource memory_;
  std::vector<CentroidGroup> groups_;
  std::vector<std::optional<Ordered>> ordered_;  ///< of each expert
  std::vector<std::string> walked_;              ///< the body of each other expert
  std::string tables_;
  bool general_ = false;
  bool gaussian_ = false;
};

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

/// The weight of an expert, all weights together being 1.
std::string SourceWriter::share(std::size_t expert) const {
  double total = 0;
  for (const fuzzy::Expert& one : model_.experts) total += one.weight;
  return number(model_.experts[expert].weight / total);
}

std::string SourceWriter::header() const {
  std::string out = "/* " + comment(model_.name) + ", written by Tactus. C99, no library" +
                    (memberships_.usesExp() || gaussian_ ? " but that of <math.h>" : "") +
                    ". Every number is a double.\n * Inputs, in this order:\n";
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

/// The helpers that `body` calls: on common processors `lower` and `larger` are one instruction each.
std::string helperText(std::string_view body) {
  constexpr std::pair<std::string_view, std::string_view> kHelpers[] = {
      {"lower(", "static inline double lower(double a, double b) { return a < b ? a : b; }\n"},
      {"larger(", "static inline double larger(double a, double b) { return a > b ? a : b; }\n"},
      {"off_zero(",
       "/* Next to 0 a membership would be too small for a double; this far from it nothing changes. */\n"
       "static inline double off_zero(double x) {\n"
       "  const double above = larger(x, 1e-290), below = lower(x, -1e-290);\n"
       "  const double far = x > 0.0 ? above : below;\n  return x != 0.0 ? far : x;\n}\n"},
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

std::string SourceWriter::strengthFunction(std::size_t index, const Ordered& expert) const {
  const CentroidGroup& group = groups_[expert.group];
  std::string out = "/* " + comment(model_.experts[index].id) + " */\nPART void strengths_" + std::to_string(index) +
                    "(const double *m, double *s, int n) {\n";
  auto next = expert.strengths.begin();
  for (std::size_t k = 0; k < group.live.size(); ++k) {
    const bool own = next != expert.strengths.end() && next->term == group.live[k];
    out += "  s[" + std::to_string(k) + " * n] = " + (own ? next->text : "0.0") + ";  /* " +
           comment(group.terms[group.live[k]].id) + " */\n";
    if (own) ++next;
  }
  return out + "  (void)m;\n}\n\n";
}

/// The largest strength of those at `s[k * stride + place]`, for an `at` of ` * stride + place]`.
std::string SourceWriter::largest(const CentroidGroup& group, const std::string& at) const {
  std::vector<std::string> all;
  for (std::size_t k = 0; k < group.live.size(); ++k) all.push_back("s[" + std::to_string(k) + at);
  return tree(all, "larger");
}

std::string SourceWriter::orderedFunctions(std::size_t index) const {
  const Ordered& expert = *ordered_[index];
  const CentroidGroup& group = groups_[expert.group];
  const std::string name = std::to_string(index);
  const std::string count = std::to_string(group.live.size());
  const std::string centroid = "centroid_" + std::to_string(expert.group) + "(s, 1, &area, &moment);\n";
  const std::string start = "strengths_" + name + "(m, s, 1);\n  largest = " + largest(group, "]") + ";\n";
  return strengthFunction(index, expert) +
         "/* Strengths may be so small that their squares vanish. Ratios alone count there. */\nRARE double tiny_" +
         name + "(const double *inputs) {\n  double m[kMemberships], s[" + count +
         "], largest, area, moment;\n  int i;\n  (void)memberships(inputs, m);\n  " + start + "  for (i = 0; i < " +
         count + "; ++i) s[i] *= 1e-90 / largest;\n  " + centroid + "  return moment / area;\n}\n\n" +
         "PART int expert_" + name + "(const double *inputs, const double *m, double *offset) {\n  double s[" + count +
         "], largest, area, moment;\n  " + start +
         "  if (largest < 1e-90) {\n    if (!(largest > 0.0)) return 0;\n    *offset = tiny_" + name +
         "(inputs);\n    return 1;\n  }\n  " + centroid + "  *offset = moment / area;\n  return 1;\n}\n\n";
}

std::string SourceWriter::expertFunctions() const {
  std::string out;
  for (std::size_t g = 0; g < groups_.size(); ++g) out += centroidFunction(model_, groups_[g], g);
  for (std::size_t e = 0; e < model_.experts.size(); ++e) {
    if (ordered_[e]) {
      out += orderedFunctions(e);
      continue;
    }
    out += "/* " + comment(model_.experts[e].id) + " */\nPART int expert_" + std::to_string(e) +
           "(const double *inputs, const double *m, double *offset) {\n" + walked_[e] + "}\n\n";
  }
  return out;
}

std::string SourceWriter::oneByOneText(const std::vector<std::size_t>& experts) const {
  // The centroid of the only expert is the mean.
  if (experts.size() == 1) {
    return "double force_model(const double *inputs, int *fired) {\n  double m[kMemberships], offset;\n"
           "  const double nothing = memberships(inputs, m);\n  if (fired != NULL) *fired = 0;\n"
           "  if (nothing != 0.0) return nothing;\n  if (!expert_" +
           std::to_string(experts.front()) + "(inputs, m, &offset)) return " + number(model_.default_force_n) +
           ";\n  if (fired != NULL) *fired = 1;\n  return " + number(model_.output.min) + " + offset;\n}\n\n";
  }
  std::string out =
      "double force_model(const double *inputs, int *fired) {\n  double m[kMemberships], offset, sum = 0.0, weights = "
      "0.0;\n"
      "  const double nothing = memberships(inputs, m);\n  if (fired != NULL) *fired = 0;\n"
      "  if (nothing != 0.0) return nothing;\n";
  for (const std::size_t e : experts) {
    out += "  if (expert_" + std::to_string(e) + "(inputs, m, &offset)) {\n    sum += " + share(e) +
           " * offset;\n    weights += " + share(e) + ";\n  }\n";
  }
  return out + "  if (!(weights > 0.0)) return " + number(model_.default_force_n) +
         ";\n  if (fired != NULL) *fired = 1;\n  return " + number(model_.output.min) + " + sum / weights;\n}\n\n";
}

/// The strengths of all experts side by side, so that compilers compute several centroids at once.
std::string SourceWriter::sideBySideText(const std::vector<std::size_t>& experts) const {
  const std::size_t g = ordered_[experts.front()]->group;
  const std::string count = std::to_string(experts.size());
  const std::string terms = std::to_string(groups_[g].live.size());
  std::string out =
      "double force_model(const double *inputs, int *fired) {\n  static const double share[" + count + "] = {";
  for (const std::size_t e : experts) out += (e == experts.front() ? "" : ", ") + share(e);
  out += "};\n  double m[kMemberships], s[" + terms + " * " + count + "], largest[" + count + "], offset[" + count +
         "];\n  double sum = 0.0, weights = 0.0;\n  int e;\n  const double nothing = memberships(inputs, m);\n"
         "  if (fired != NULL) *fired = 0;\n  if (nothing != 0.0) return nothing;\n";
  for (std::size_t i = 0; i < experts.size(); ++i) {
    out += "  strengths_" + std::to_string(experts[i]) + "(m, s + " + std::to_string(i) + ", " + count + ");\n";
  }
  out += "  for (e = 0; e < " + count + "; ++e) largest[e] = " + largest(groups_[g], " * " + count + " + e]") +
         ";\n  for (e = 0; e < " + count + "; ++e) {\n    double area, moment;\n    centroid_" + std::to_string(g) +
         "(s + e, " + count + ", &area, &moment);\n    offset[e] = moment / (largest[e] > 0.0 ? area : 1.0);\n  }\n";
  for (std::size_t i = 0; i < experts.size(); ++i) {
    const std::string at = "[" + std::to_string(i) + "]";
    out +=
        "  sum += share" + at + " * offset" + at + ";\n  weights += largest" + at + " > 0.0 ? share" + at + " : 0.0;\n";
  }
  return out + "  if (!(weights > 0.0)) return " + number(model_.default_force_n) +
         ";\n  if (fired != NULL) *fired = 1;\n  return " + number(model_.output.min) + " + sum / weights;\n}\n\n";
}

std::string SourceWriter::meanText() const {
  const std::vector<std::size_t> experts = counting();
  const bool side_by_side = experts.size() > 1 && areOneGroup(experts) && !isLarge();
  return side_by_side ? sideBySideText(experts) : oneByOneText(experts);
}

/// A block of points without a branch, so that compilers compute several points at once.
std::string SourceWriter::blockText(const std::vector<std::size_t>& experts) const {
  std::string copies;
  std::string arrays;
  std::string point;
  std::size_t free = 0;
  for (const auto& fixed : fixed_) {
    if (fixed) continue;
    const std::string index = std::to_string(free++);
    arrays += ", x" + index + "[kBlock]";
    copies += "    x" + index + "[j] = inputs[j * FORCE_MODEL_INPUTS + " + index + "];\n";
    point += "    at[" + index + "] = x" + index + "[j];\n";
  }
  std::string forces;
  for (const std::size_t e : experts) {
    const std::size_t g = ordered_[e]->group;
    forces += "    strengths_" + std::to_string(e) + "(m, s, 1);\n    largest = " + largest(groups_[g], "]") +
              ";\n    centroid_" + std::to_string(g) + "(s, 1, &area, &moment);\n";
    forces += "    tiny += largest < 1e-90 ? largest : 0.0;\n";
    forces += "    offset = moment / (largest > 0.0 ? area : 1.0);\n";
    forces += experts.size() == 1
                  ? "    sum = offset;\n    weights = largest > 0.0 ? 1.0 : 0.0;\n"
                  : "    sum += " + share(e) + " * offset;\n    weights += largest > 0.0 ? " + share(e) + " : 0.0;\n";
  }
  std::size_t terms = 0;
  for (const std::size_t e : experts) terms = std::max(terms, groups_[ordered_[e]->group].live.size());
  const std::string quotient = experts.size() == 1 ? "sum" : "sum / (weights > 0.0 ? weights : 1.0)";
  return "enum { kBlock = 32 };\n\nstatic void force_block(const double *inputs, double *force, unsigned char *fired) "
         "{\n  double on[kBlock], odd[kBlock], out[kBlock]" +
         arrays + ";\n  int j;\n  for (j = 0; j < kBlock; ++j) {\n" + copies +
         "  }\n  for (j = 0; j < kBlock; ++j) {\n    double m[kMemberships], s[" + std::to_string(terms) + "], at[" +
         std::to_string(free) +
         "];\n    double largest, area, moment, offset, nothing, sum = 0.0, weights = 0.0, tiny = 0.0;\n" + point +
         "    nothing = memberships(at, m);\n" + forces + "    sum = " + number(model_.output.min) + " + " + quotient +
         ";\n    out[j] = weights > 0.0 ? sum : " + number(model_.default_force_n) +
         ";\n    odd[j] = tiny + (nothing == 0.0 ? 0.0 : 1.0);\n    on[j] = weights;\n  }\n"
         "  for (j = 0; j < kBlock; ++j) {\n    int one = on[j] > 0.0;\n    force[j] = odd[j] > 0.0 ? "
         "force_model(inputs + j * FORCE_MODEL_INPUTS, &one) : out[j];\n    if (fired != NULL) fired[j] = (unsigned "
         "char)one;\n  }\n}\n\n";
}

std::string SourceWriter::batchText() const {
  const std::vector<std::size_t> experts = counting();
  const bool in_blocks =
      !isLarge() && !memberships_.isOdd() && !memberships_.usesExp() && !experts.empty() &&
      std::all_of(experts.begin(), experts.end(), [&](std::size_t e) { return ordered_[e].has_value(); });
  std::string out = in_blocks ? blockText(experts) : std::string();
  out +=
      "void force_model_batch(const double *inputs, size_t points, double *force, unsigned char *fired) {\n"
      "  size_t p = 0;\n";
  if (in_blocks) {
    out +=
        "  for (; p + kBlock <= points; p += kBlock)\n"
        "    force_block(inputs + p * FORCE_MODEL_INPUTS, force + p, fired != NULL ? fired + p : NULL);\n";
  }
  return out +
         "  for (; p < points; ++p) {\n    int one;\n    force[p] = force_model(inputs + p * FORCE_MODEL_INPUTS, "
         "&one);\n    if (fired != NULL) fired[p] = (unsigned char)one;\n  }\n}\n\n";
}

std::string SourceWriter::expertText() const {
  std::string out =
      "double force_model_expert(size_t expert, const double *inputs, int *fired) {\n"
      "  double m[kMemberships], offset = 0.0;\n  double nothing;\n  int any = 0;\n  if (fired != NULL) *fired = 0;\n"
      "  if (expert >= FORCE_MODEL_EXPERTS) return 0.0;\n  nothing = memberships(inputs, m);\n"
      "  if (nothing != 0.0) return nothing;\n  switch (expert) {\n";
  for (std::size_t e = 0; e < model_.experts.size(); ++e) {
    const std::string index = std::to_string(e);
    out += "    case " + index + ": any = expert_" + index + "(inputs, m, &offset); break;\n";
  }
  return out + "    default: break;\n  }\n  if (!any) return " + number(model_.default_force_n) +
         ";\n  if (fired != NULL) *fired = 1;\n  return " + number(model_.output.min) + " + offset;\n}\n";
}

std::string SourceWriter::source() const {
  std::string out =
      "/* " + comment(model_.name) +
      ": see force_model.h. Written by Tactus; edit the model, not this file. */\n#include \"force_model.h\"\n\n";
  if (memberships_.usesExp() || gaussian_) out += "#include <math.h>\n\n";
  std::string body = "enum { kMemberships = " + std::to_string(std::max<std::size_t>(memberships_.count(), 1)) +
                     " };\n\n" + memberships_.function() + "\n";
  if (general_ || gaussian_) body += outputSetText();
  if (general_) body += generalOffsetText();
  if (gaussian_) body += gaussianOffsetText();
  body += tables_ + expertFunctions() + meanText() + batchText() + expertText();
  // Both change no number: no exception flags are kept, and what is chosen by a comparison stays one instruction.
  out +=
      "#if defined(__GNUC__) && !defined(__clang__)\n#pragma GCC optimize(\"no-trapping-math\", \"no-thread-jumps\", "
      "\"tree-vectorize\", \"vect-cost-model=dynamic\")\n#endif\n";
  const std::string part = isLarge() ? "static" : "static inline __attribute__((always_inline))";
  out += "#ifdef __GNUC__\n#define PART " + part +
         "\n#define RARE static __attribute__((noinline))\n#else\n#define PART static" +
         std::string(isLarge() ? "" : " inline") + "\n#define RARE static\n#endif\n\n";
  return out + helperText(body) + body;
}

}  // namespace

base::Result<CSource> cSource(const fuzzy::ForceModel& model, std::span<const FixedInput> fixed) {
  const auto inputs = fixedInputs(model, fixed);
  if (!inputs) return tl::unexpected(inputs.error());
  const SourceWriter writer(model, *inputs);
  return CSource{writer.header(), writer.source()};
}

}  // namespace tactus::exchange
