// The functions of the C source: strengths and centroids of the experts, and the force at one point.
#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <memory_resource>
#include <numeric>
#include <set>
#include <span>

#include "core/exchange/c_parts.h"
#include "core/fuzzy/closed_form.h"

namespace tactus::exchange {
namespace {

using fuzzy::ClosedForm;
using Polynomial = fuzzy::Polynomial<double>;

std::string strength(std::size_t term) { return "s" + std::to_string(term); }

/// Area and moment of an output set in C: the parts that are added and taken away, each in a variable of its own.
class Parts {
 public:
  /// Declares area and moment of one more part of the sum of `lane`; `sign` is + or -.
  void add(char sign, std::size_t lane, const std::string& area,
           const std::function<std::string(const std::string& area)>& moment) {
    const std::string index = std::to_string(parts_.size());
    text_ += "  const double a" + index + " = " + area + ";\n";
    text_ += "  const double n" + index + " = " + moment("a" + index) + ";\n";
    parts_.push_back({sign, lane});
  }
  void declare(const std::string& name, const std::string& value) {
    text_ += "  const double " + name + " = " + value + ";\n";
  }
  std::size_t count() const { return parts_.size(); }

  /// `alone`: the order of the sums, as MeanOrder::Team says.
  std::string text(bool alone) const {
    const auto sum = [&](char letter) { return alone ? laneByLane(letter) : oneAfterTheOther(letter); };
    return text_ + "  *area = " + sum('a') + ";\n  *moment = " + sum('n') + ";\n";
  }

 private:
  struct Part {
    char sign;
    std::size_t lane;
  };

  std::string oneAfterTheOther(char letter) const {
    std::string out;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      if (i > 0) out += std::string(" ") + parts_[i].sign + " ";
      out += letter + std::to_string(i);
    }
    return out;
  }

  std::string laneByLane(char letter) const {
    std::array<std::string, fuzzy::kLanes> lanes;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      std::string& lane = lanes[parts_[i].lane];
      lane = lane.empty() ? letter + std::to_string(i) : "(" + lane + " - " + letter + std::to_string(i) + ")";
    }
    // A lane that is missing holds 0.
    const auto plus = [](const std::string& x, const std::string& y) {
      return x.empty() || y.empty() ? x + y : "(" + x + " + " + y + ")";
    };
    for (std::size_t k = 0; k < 4; ++k) lanes[k] = plus(lanes[k], lanes[k + 4]);
    return plus(plus(lanes[0], lanes[2]), plus(lanes[1], lanes[3]));
  }

  std::string text_;
  std::vector<Part> parts_;
};

/// Area and moment of a trapezoid that is clipped at `t`. Each number of the kernels (core/fuzzy/kernel_source.h) comes
/// out of the same operations, in the same order.
void addClipped(const std::string& t, const Polynomial& f, char sign, std::size_t lane, Parts& parts) {
  parts.add(sign, lane, t + " * (" + number(f.width) + " - " + t + " * " + number(f.half_taper) + ")",
            [&](const std::string& area) {
              const std::string middle = area + " * " + number(f.middle);
              if (f.linear == 0 && f.cubic == 0) return middle;
              return middle + " + (" + t + " * " + t + ") * (" + number(f.linear) + " - " + t + " * " +
                     number(f.cubic) + ")";
            });
}

void addClippedOverlap(const ClosedForm::Pair& pair, const std::string& left, const std::string& right,
                       const std::vector<std::string>& between, std::size_t lane, Parts& parts) {
  const std::string common = "t" + std::to_string(parts.count());
  std::string least = "lower(" + left + ", " + right + ")";
  // The common part of two trapezoids reaches 1 only where their cores meet.
  if (pair.overlap.peak < 1) least = "lower(" + least + ", " + number(pair.overlap.peak) + ")";
  parts.declare(common, least);
  if (!between.empty()) {
    // Below the strength of the strongest term between, terms between cover the whole overlap.
    const std::string hidden = "hidden" + std::to_string(parts.count());
    parts.declare(hidden, "lower(" + common + ", " + tree(between, "larger") + ")");
    addClipped(hidden, pair.overlap.shape, '+', lane, parts);
  }
  addClipped(common, pair.overlap.shape, '-', lane, parts);
}

void addScaledOverlap(const ClosedForm::Pair& pair, const std::string& left, const std::string& right, std::size_t lane,
                      Parts& parts) {
  const auto& overlap = pair.overlap;
  const double width = overlap.shape.width;
  const std::string index = std::to_string(parts.count());
  const std::string sum = "fall" + index + " + rise" + index;
  parts.declare("fall" + index, left + " * " + number(overlap.inverse_fall));
  parts.declare("rise" + index, right + " * " + number(overlap.inverse_rise));
  parts.declare("t" + index, "fall" + index + " / (" + sum + " > 0.0 ? " + sum + " : 1.0)");
  parts.add(
      '-', lane, "rise" + index + " * t" + index + " * " + number(width * width * 0.5), [&](const std::string& area) {
        return area + " * ((t" + index + " + 1.0) * " + number(width * (1.0 / 3)) + " + " + number(overlap.start) + ")";
      });
}

std::string centroidName(std::size_t group, bool alone) {
  return "centroid_" + std::to_string(group) + (alone ? "_alone" : "");
}

/// The function centroidName(s, n, &area, &moment): the strength of the term live[k] is `s[k * n]`.
std::string centroidFunction(const fuzzy::ForceModel& model, const CentroidGroup& group, const std::string& name,
                             bool alone) {
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
      addClipped(own, whole, '+', lane, parts);
    } else {
      parts.add('+', lane, own + " * " + number(whole.width),
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
        addClippedOverlap(pair, left, own, between, pair.left, parts);
      } else {
        addScaledOverlap(pair, left, own, pair.left, parts);
      }
    }
  }
  std::string out = "PART void " + name + "(const double *s, int n, double *area, double *moment) {\n";
  for (std::size_t k = 0; k < group.live.size(); ++k) {
    out += "  const double " + strength(group.live[k]) + " = s[" + std::to_string(k) + " * n];  /* " +
           comment(group.terms[group.live[k]].id) + " */\n";
  }
  return out + parts.text(alone) + "}\n\n";
}

/// The head of a loop over `count` things of several experts side by side.
std::string forEach(std::size_t count) {
  return "  SIDE_BY_SIDE\n  for (e = 0; e < " + std::to_string(count) + "; ++e) ";
}

}  // namespace

/// Which centroid the expert takes: the sums of an expert alone, or of one in a team.
std::string SourceWriter::centroidOf(std::size_t expert) const {
  return centroidName(ordered_[expert]->group, isAlone(expert));
}

bool SourceWriter::isAlone(std::size_t expert) const {
  return std::any_of(order_.teams.begin(), order_.teams.end(), [expert](const fuzzy::MeanOrder::Team& team) {
    return team.alone && team.experts.front() == expert;
  });
}

/// The weight of an expert, all weights together being 1.
std::string SourceWriter::share(std::size_t expert) const {
  return number(std::max(order_.shares[expert], std::numeric_limits<double>::denorm_min()));
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
  const std::string centroid = centroidOf(index) + "(s, 1, &area, &moment);\n";
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

/// The centroids that some expert takes.
std::string SourceWriter::centroidFunctions() const {
  std::set<std::pair<std::size_t, bool>> taken;
  for (std::size_t e = 0; e < ordered_.size(); ++e) {
    if (ordered_[e]) taken.insert({ordered_[e]->group, isAlone(e)});
  }
  std::string out;
  for (const auto& [group, alone] : taken)
    out += centroidFunction(model_, groups_[group], centroidName(group, alone), alone);
  return out;
}

std::string SourceWriter::expertFunctions() const {
  std::string out = centroidFunctions();
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

/// The mean where each expert fires: `offsets` are those of `experts`, in `offset`.
std::string SourceWriter::meanOfAll(const std::vector<std::size_t>& experts) const {
  std::string out;
  for (const fuzzy::MeanOrder::Team& team : order_.teams) {
    std::array<std::string, 4> places;
    for (std::size_t k = 0; k < team.experts.size(); ++k) {
      const auto at = std::find(experts.begin(), experts.end(), team.experts[k]);
      if (at == experts.end()) continue;  // its weight is 0
      const std::string index = std::to_string(at - experts.begin());
      places[k] = "offset[" + index + "] * " + share(team.experts[k]);
    }
    const auto plus = [](const std::string& x, const std::string& y) {
      return x.empty() || y.empty() ? x + y : "(" + x + " + " + y + ")";
    };
    const std::string sum = plus(plus(places[0], places[2]), plus(places[1], places[3]));
    if (!sum.empty()) out += (out.empty() ? "" : " + ") + sum;
  }
  return number(model_.output.min) + " + (" + out + ")";
}

/// The function `mean_of_some`, for where an expert may not fire: `largest` is above 0 where one does.
std::string SourceWriter::meanOfSomeText(const std::vector<std::size_t>& experts) const {
  std::vector<std::size_t> order;
  for (const fuzzy::MeanOrder::Team& team : order_.teams) {
    for (const std::size_t e : team.experts) {
      const auto at = std::find(experts.begin(), experts.end(), e);
      if (at != experts.end()) order.push_back(static_cast<std::size_t>(at - experts.begin()));
    }
  }
  if (order.empty()) {
    order.resize(experts.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
  }
  const std::string count = std::to_string(experts.size());
  std::string places;
  std::string weights;
  for (const std::size_t place : order) {
    places += (places.empty() ? "" : ", ") + std::to_string(place);
    weights += (weights.empty() ? "" : ", ") + number(weights_[experts[place]]);
  }
  return "/* Where some expert does not fire. */\nRARE double mean_of_some(const double *largest, const double "
         "*offset, int "
         "*fired) {\n  static const int place[" +
         count + "] = {" + places + "};\n  static const double weight[" + count + "] = {" + weights +
         "};\n  long double weights = 0.0L;\n  double mean = 0.0;\n  int k;\n  for (k = 0; k < " + count +
         "; ++k) {\n    if (!(largest[place[k]] > 0.0)) continue;\n    weights += weight[k];\n"
         "    mean += (offset[place[k]] - mean) * (double)(weight[k] / weights);\n  }\n  if (!(weights > 0.0L)) "
         "return " +
         number(model_.default_force_n) + ";\n  if (fired != NULL) *fired = 1;\n  return " + number(model_.output.min) +
         " + mean;\n}\n\n";
}

/// From `largest` and `offset` of all experts to the force.
std::string SourceWriter::meanOf(const std::vector<std::size_t>& experts) const {
  // Where the general path evaluates the model, the experts follow each other everywhere.
  if (order_.teams.empty()) return "  return mean_of_some(largest, offset, fired);\n}\n\n";
  std::vector<std::string> all;
  for (std::size_t i = 0; i < experts.size(); ++i) all.push_back("largest[" + std::to_string(i) + "]");
  return "  if (!(" + tree(all, "lower") +
         " > 0.0)) return mean_of_some(largest, offset, fired);\n  if (fired != NULL) *fired = 1;\n  return " +
         meanOfAll(experts) + ";\n}\n\n";
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
  if (experts.empty()) {
    return "double force_model(const double *inputs, int *fired) {\n  double m[kMemberships];\n"
           "  const int nothing = memberships(inputs, m);\n  if (fired != NULL) *fired = 0;\n  return nothing ? "
           "not_a_number() : " +
           number(model_.default_force_n) + ";\n}\n\n";
  }
  const std::string count = std::to_string(experts.size());
  std::string out = meanOfSomeText(experts) +
                    "double force_model(const double *inputs, int *fired) {\n  double m[kMemberships], largest[" +
                    count + "], offset[" + count +
                    "] = {0.0};\n  const int nothing = memberships(inputs, m);\n  if (fired != NULL) *fired = 0;\n"
                    "  if (nothing) return not_a_number();\n";
  for (std::size_t i = 0; i < experts.size(); ++i) {
    const std::string at = "[" + std::to_string(i) + "]";
    out += "  largest" + at + " = expert_" + std::to_string(experts[i]) + "(inputs, m, &offset" + at + ");\n";
  }
  return out + meanOf(experts);
}

/// From the strengths `s` of all experts side by side to the force, so that compilers compute several centroids at
/// once.
std::string SourceWriter::sideBySideCentroids(const std::vector<std::size_t>& experts) const {
  const std::size_t g = ordered_[experts.front()]->group;
  const std::string count = std::to_string(experts.size());
  std::string out = forEach(experts.size()) + "largest[e] = " + largest(groups_[g], " * " + count + " + e]") + ";\n";
  const auto centroid = [&](const std::string& name, const std::string& at) {
    return "{\n    double area, moment;\n    " + name + "(s + " + at + ", " + count +
           ", &area, &moment);\n    offset[" + at + "] = moment / (largest[" + at + "] > 0.0 ? area : 1.0);\n  }\n";
  };
  // Those of teams first, in one loop; the others have sums of their own.
  std::size_t together = 0;
  while (together < experts.size() && !isAlone(experts[together])) ++together;
  if (together > 0) out += forEach(together) + centroid(centroidName(g, false), "e");
  for (std::size_t i = together; i < experts.size(); ++i)
    out += "  " + centroid(centroidOf(experts[i]), std::to_string(i));
  return out + meanOf(experts);
}

/// What the functions that compute centroids side by side begin with.
std::string SourceWriter::sideBySideStart(const std::vector<std::size_t>& experts) const {
  const std::string count = std::to_string(experts.size());
  const std::string terms = std::to_string(groups_[ordered_[experts.front()]->group].live.size());
  return meanOfSomeText(experts) +
         "double force_model(const double *inputs, int *fired) {\n  double m[kMemberships], s[" + terms + " * " +
         count + "], largest[" + count + "], offset[" + count + "];\n  int e;\n";
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
         ";\n  if (!(largest > 0.0)) return " + number(model_.default_force_n) + ";\n  " + centroidOf(experts.front()) +
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
