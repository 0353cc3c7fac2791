// The functions of the C source: strengths and centroids of the experts, and the force at one point.
#include <algorithm>
#include <limits>
#include <numeric>

#include "core/exchange/c_writer.h"

namespace tactus::exchange {
namespace {

/// The head of a loop over `count` things of several experts side by side.
std::string forEach(std::size_t count) {
  return "  SIDE_BY_SIDE\n  for (e = 0; e < " + std::to_string(count) + "; ++e) ";
}

}  // namespace

/// The weight of an expert, all weights together being 1.
std::string SourceWriter::share(std::size_t expert) const {
  const double total = std::accumulate(weights_.begin(), weights_.end(), 0.0);
  return number(std::max(weights_[expert] / total, std::numeric_limits<double>::denorm_min()));
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
           "  const int nothing = memberships(inputs, m);\n  if (fired != NULL) *fired = 0;\n"
           "  if (nothing) return not_a_number();\n  if (!expert_" +
           std::to_string(experts.front()) + "(inputs, m, &offset)) return " + number(model_.default_force_n) +
           ";\n  if (fired != NULL) *fired = 1;\n  return " + number(model_.output.min) + " + offset;\n}\n\n";
  }
  std::string out =
      "double force_model(const double *inputs, int *fired) {\n  double m[kMemberships], offset, sum = 0.0, weights = "
      "0.0;\n"
      "  const int nothing = memberships(inputs, m);\n  if (fired != NULL) *fired = 0;\n"
      "  if (nothing) return not_a_number();\n";
  for (const std::size_t e : experts) {
    out += "  if (expert_" + std::to_string(e) + "(inputs, m, &offset)) {\n    sum += " + share(e) +
           " * offset;\n    weights += " + share(e) + ";\n  }\n";
  }
  return out + "  if (!(weights > 0.0)) return " + number(model_.default_force_n) +
         ";\n  if (fired != NULL) *fired = 1;\n  return " + number(model_.output.min) + " + sum / weights;\n}\n\n";
}

/// From the strengths `s` of all experts side by side to the force, so that compilers compute several centroids at
/// once.
std::string SourceWriter::sideBySideCentroids(const std::vector<std::size_t>& experts) const {
  const std::size_t g = ordered_[experts.front()]->group;
  const std::string count = std::to_string(experts.size());
  std::string out = forEach(experts.size()) + "largest[e] = " + largest(groups_[g], " * " + count + " + e]") + ";\n" +
                    forEach(experts.size()) + "{\n    double area, moment;\n    centroid_" + std::to_string(g) +
                    "(s + e, " + count +
                    ", &area, &moment);\n    offset[e] = moment / (largest[e] > 0.0 ? area : 1.0);\n  }\n";
  for (std::size_t i = 0; i < experts.size(); ++i) {
    const std::string at = "[" + std::to_string(i) + "]";
    out +=
        "  sum += share" + at + " * offset" + at + ";\n  weights += largest" + at + " > 0.0 ? share" + at + " : 0.0;\n";
  }
  return out + "  if (!(weights > 0.0)) return " + number(model_.default_force_n) +
         ";\n  if (fired != NULL) *fired = 1;\n  return " + number(model_.output.min) + " + sum / weights;\n}\n\n";
}

/// What the functions that compute centroids side by side begin with.
std::string SourceWriter::sideBySideStart(const std::vector<std::size_t>& experts) const {
  const std::string count = std::to_string(experts.size());
  const std::string terms = std::to_string(groups_[ordered_[experts.front()]->group].live.size());
  std::string out =
      "double force_model(const double *inputs, int *fired) {\n  static const double share[" + count + "] = {";
  for (const std::size_t e : experts) out += (e == experts.front() ? "" : ", ") + share(e);
  return out + "};\n  double m[kMemberships], s[" + terms + " * " + count + "], largest[" + count + "], offset[" +
         count + "];\n  double sum = 0.0, weights = 0.0;\n  int e;\n";
}

std::string SourceWriter::sideBySideText(const std::vector<std::size_t>& experts) const {
  std::string out = sideBySideStart(experts) +
                    "  const int nothing = memberships(inputs, m);\n"
                    "  if (fired != NULL) *fired = 0;\n  if (nothing) return not_a_number();\n";
  for (std::size_t i = 0; i < experts.size(); ++i) {
    out += "  strengths_" + std::to_string(experts[i]) + "(m, s + " + std::to_string(i) + ", " +
           std::to_string(experts.size()) + ");\n";
  }
  return out + sideBySideCentroids(experts);
}

/// The same by the stretches of one input.
std::string SourceWriter::stretchedText(const std::vector<std::size_t>& experts, std::size_t pivot) const {
  const std::size_t g = ordered_[experts.front()]->group;
  const std::size_t count = groups_[g].live.size() * experts.size();
  const std::string places = std::to_string(count);
  // Few strengths are faster written out.
  const std::string each = experts.size() > 1 ? forEach(count) : "  for (e = 0; e < " + places + "; ++e) ";
  const std::string strengths =
      "  const int nothing = other_memberships(inputs, m, &at);\n  if (fired != NULL) *fired = 0;\n"
      "  if (nothing) return not_a_number();\n  strengths_here(at, m, s);\n" +
      each + "s[e] = larger(s[e], 0.0);\n";
  const std::string before = memberships_.functionBut(pivot) + "\n" + stretchesText(experts, pivot);
  if (experts.size() > 1)
    return before + sideBySideStart(experts) + "  double at;\n" + strengths + sideBySideCentroids(experts);
  // The centroid of the only expert is the mean.
  return before + "double force_model(const double *inputs, int *fired) {\n  double m[kMemberships], s[" + places +
         "], largest, area, moment, at;\n  int e;\n" + strengths + "  largest = " + largest(groups_[g], "]") +
         ";\n  if (!(largest > 0.0)) return " + number(model_.default_force_n) + ";\n  centroid_" + std::to_string(g) +
         "(s, 1, &area, &moment);\n  if (fired != NULL) *fired = 1;\n  return " + number(model_.output.min) +
         " + moment / area;\n}\n\n";
}

std::string SourceWriter::meanText() const {
  const std::vector<std::size_t> experts = counting();
  if (const auto pivot = pivotFor(experts)) return stretchedText(experts, *pivot);
  const bool side_by_side = experts.size() > 1 && areOneGroup(experts) && !isLarge() && !memberships_.isOdd();
  return side_by_side ? sideBySideText(experts) : oneByOneText(experts);
}

std::string SourceWriter::expertText() const {
  std::string out =
      "double force_model_expert(size_t expert, const double *inputs, int *fired) {\n"
      "  double m[kMemberships], offset = 0.0;\n  int nothing;\n  int any = 0;\n  if (fired != NULL) *fired = 0;\n"
      "  if (expert >= FORCE_MODEL_EXPERTS) return 0.0;\n  nothing = memberships(inputs, m);\n"
      "  if (nothing) return not_a_number();\n  switch (expert) {\n";
  for (std::size_t e = 0; e < model_.experts.size(); ++e) {
    const std::string index = std::to_string(e);
    out += "    case " + index + ": any = expert_" + index + "(inputs, m, &offset); break;\n";
  }
  return out + "    default: break;\n  }\n  if (!any) return " + number(model_.default_force_n) +
         ";\n  if (fired != NULL) *fired = 1;\n  return " + number(model_.output.min) + " + offset;\n}\n";
}

}  // namespace tactus::exchange
