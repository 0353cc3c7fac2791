// The functions of the C source: strengths and centroids of the experts, and the force at one point.
#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <memory_resource>
#include <numeric>
#include <span>

#include "core/exchange/c_parts.h"
#include "core/fuzzy/closed_form.h"

namespace tactus::exchange {
namespace {

using fuzzy::ClosedForm;
using Polynomial = fuzzy::Polynomial<double>;

std::string strength(std::size_t term) { return "s" + std::to_string(term); }

/// The parts of a sum in C, each in a variable of its own, so that the processor can work at them side by side.
class Parts {
 public:
  /// Declares area and moment of one more part; `sign` is + or -.
  void add(char sign, const std::string& area, const std::function<std::string(const std::string& area)>& moment) {
    const std::string index = std::to_string(count_++);
    text_ += "  const double a" + index + " = " + area + ";\n";
    text_ += "  const double n" + index + " = " + moment("a" + index) + ";\n";
    (sign == '+' ? plus_ : minus_).push_back(index);
  }
  void declare(const std::string& name, const std::string& value) {
    text_ += "  const double " + name + " = " + value + ";\n";
  }
  std::size_t count() const { return count_; }

  std::string text() const {
    return text_ + "  *area = " + sum(plus_, "a") + rest("a") + ";\n  *moment = " + sum(plus_, "n") + rest("n") + ";\n";
  }

 private:
  std::string rest(const std::string& letter) const {
    return minus_.empty() ? std::string() : " - " + sum(minus_, letter);
  }

  /// A balanced tree of additions.
  static std::string sum(std::span<const std::string> indices, const std::string& letter) {
    if (indices.size() == 1) return letter + indices.front();
    const std::size_t half = indices.size() / 2;
    return "(" + sum(indices.first(half), letter) + " + " + sum(indices.subspan(half), letter) + ")";
  }

  std::string text_;
  std::size_t count_ = 0;
  std::vector<std::string> plus_;
  std::vector<std::string> minus_;
};

/// Area and moment of a trapezoid that is clipped at `t`.
void addClipped(const std::string& t, const Polynomial& f, char sign, Parts& parts) {
  parts.add(sign, t + " * (" + number(f.width) + " - " + t + " * " + number(f.half_taper) + ")",
            [&](const std::string& area) {
              if (f.linear == 0 && f.cubic == 0) return area + " * " + number(f.middle);
              return t + " * (" + number(f.width * f.middle) + " - " + t + " * (" +
                     number(f.half_taper * f.middle - f.linear) + " + " + t + " * " + number(f.cubic) + "))";
            });
}

void addClippedOverlap(const ClosedForm::Pair& pair, const std::string& left, const std::string& right,
                       const std::vector<std::string>& between, Parts& parts) {
  const std::string common = "t" + std::to_string(parts.count());
  std::string least = "lower(" + left + ", " + right + ")";
  // The common part of two trapezoids reaches 1 only where their cores meet.
  if (pair.overlap.peak < 1) least = "lower(" + least + ", " + number(pair.overlap.peak) + ")";
  parts.declare(common, least);
  addClipped(common, pair.overlap.shape, '-', parts);
  if (between.empty()) return;
  // Below the strength of the strongest term between, terms between cover the whole overlap.
  const std::string hidden = "t" + std::to_string(parts.count());
  parts.declare(hidden, "lower(" + common + ", " + tree(between, "larger") + ")");
  addClipped(hidden, pair.overlap.shape, '+', parts);
}

void addScaledOverlap(const ClosedForm::Pair& pair, const std::string& left, const std::string& right, Parts& parts) {
  const auto& overlap = pair.overlap;
  const double width = overlap.shape.width;
  const std::string index = std::to_string(parts.count());
  const std::string sum = "fall" + index + " + rise" + index;
  parts.declare("fall" + index, left + " * " + number(overlap.inverse_fall));
  parts.declare("rise" + index, right + " * " + number(overlap.inverse_rise));
  parts.declare("t" + index, "fall" + index + " / (" + sum + " > 0.0 ? " + sum + " : 1.0)");
  parts.add('-', "rise" + index + " * t" + index + " * " + number(width * width * 0.5), [&](const std::string& area) {
    return area + " * ((t" + index + " + 1.0) * " + number(width / 3) + " + " + number(overlap.start) + ")";
  });
}

}  // namespace

std::string centroidFunction(const fuzzy::ForceModel& model, const CentroidGroup& group, std::size_t index) {
  const bool clips = model.implication == fuzzy::Implication::kClip;
  const ClosedForm& form = group.form;
  std::array<std::size_t, fuzzy::kMostTerms> term_of{};  // of each lane
  std::array<bool, fuzzy::kMostTerms> live{};
  for (std::size_t t = 0; t < form.lane_of.size(); ++t) term_of[form.lane_of[t]] = t;
  for (const std::size_t term : group.live) live[form.lane_of[term]] = true;

  Parts parts;
  for (std::size_t lane = 0; lane < form.terms.size(); ++lane) {
    if (!live[lane]) continue;
    const std::string own = strength(term_of[lane]);
    const Polynomial& whole = form.terms[lane];
    if (clips) {
      addClipped(own, whole, '+', parts);
    } else {
      parts.add('+', own + " * " + number(whole.width),
                [&](const std::string&) { return own + " * " + number(whole.middle); });
    }
    for (std::uint32_t p = form.first_pair[lane]; p < form.first_pair[lane + 1]; ++p) {
      const ClosedForm::Pair& pair = form.pairs[p];
      if (!live[pair.left]) continue;
      const std::string left = strength(term_of[pair.left]);
      std::vector<std::string> between;
      for (std::size_t k = pair.left + 1U; k < lane; ++k) {
        if (live[k]) between.push_back(strength(term_of[k]));
      }
      if (clips) {
        addClippedOverlap(pair, left, own, between, parts);
      } else {
        addScaledOverlap(pair, left, own, parts);
      }
    }
  }
  std::string out =
      "PART void centroid_" + std::to_string(index) + "(const double *s, int n, double *area, double *moment) {\n";
  for (std::size_t k = 0; k < group.live.size(); ++k) {
    out += "  const double " + strength(group.live[k]) + " = s[" + std::to_string(k) + " * n];  /* " +
           comment(group.terms[group.live[k]].id) + " */\n";
  }
  return out + parts.text() + "}\n\n";
}

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
