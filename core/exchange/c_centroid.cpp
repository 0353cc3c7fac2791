// The centroid in C: polynomials in the strengths where the output terms have an order (core/fuzzy/closed_form.h), else
// a walk along the upper envelope.
#include <algorithm>
#include <array>
#include <functional>
#include <memory_resource>
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
    return text_ + "  *offset = (" + sum(plus_, "n") + rest("n") + ") / (" + sum(plus_, "a") + rest("a") + ");\n";
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
              std::string moment = area + " * " + number(f.middle);
              if (f.linear == 0 && f.cubic == 0) return moment;
              return moment + " + " + t + " * " + t + " * (" + number(f.linear) + " - " + t + " * " + number(f.cubic) +
                     ")";
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

/// The strengths may be so small that their squares vanish. Ratios alone count there.
std::string liftText(const std::vector<std::size_t>& reached) {
  std::string out = "  if (largest < 1e-90) {\n    const double lift = 1e-90 / largest;\n";
  for (const std::size_t term : reached) out += "    " + strength(term) + " *= lift;\n";
  return out + "  }\n";
}

std::string largestText(const std::vector<std::size_t>& reached) {
  std::vector<std::string> strengths;
  for (const std::size_t term : reached) strengths.push_back(strength(term));
  return "  const double largest = " + tree(strengths, "larger") + ";\n  if (!(largest > 0.0)) return 0;\n";
}

std::string orderedCode(const ExpertView& view, const ClosedForm& form, const std::vector<std::size_t>& reached) {
  const bool clips = view.model->implication == fuzzy::Implication::kClip;
  std::array<std::size_t, fuzzy::kMostTerms> term_of{};  // of each lane
  std::array<bool, fuzzy::kMostTerms> live{};
  for (std::size_t t = 0; t < form.lane_of.size(); ++t) term_of[form.lane_of[t]] = t;
  for (const std::size_t term : reached) live[form.lane_of[term]] = true;

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
  // Declarations stand after a statement, as C99 allows.
  return largestText(reached) + liftText(reached) + parts.text() + "  return 1;\n";
}

std::string unorderedCode(const ExpertView& view, std::size_t index, const std::vector<std::size_t>& reached,
                          std::string& tables) {
  const std::string table = "corners_" + std::to_string(index);
  tables += "static const double " + table + "[][4] = {\n";
  std::string strengths;
  for (const std::size_t term : reached) {
    const Corners f = cornersOf(*view.output.terms[term].term);
    tables += "  {" + number(f.a) + ", " + number(f.b) + ", " + number(f.c) + ", " + number(f.d) + "},\n";
    strengths += (strengths.empty() ? "" : ", ") + strength(term);
  }
  tables += "};\n\n";
  const fuzzy::Variable& force = *view.output.variable;
  const std::string scales = view.model->implication == fuzzy::Implication::kScale ? "1" : "0";
  return "  const double strengths[" + std::to_string(reached.size()) + "] = {" + strengths + "};\n" +
         largestText(reached) + "  *offset = general_offset(" + table + ", strengths, " +
         std::to_string(reached.size()) + ", largest, " + scales + ", " + number(force.min) + ", " + number(force.max) +
         ");\n  return 1;\n";
}

}  // namespace

std::string centroidCode(const ExpertView& view, std::size_t index, const StrengthCode& strengths, std::string& tables,
                         bool& general) {
  if (strengths.reached.empty()) return "  (void)m;\n  (void)offset;\n  return 0;\n";
  std::vector<fuzzy::MembershipFunction> terms;
  for (const NamedTerm& term : view.output.terms) terms.push_back(fuzzy::MembershipFunction::of(*term.term));
  std::pmr::monotonic_buffer_resource memory;
  ClosedForm form{&memory};
  const fuzzy::Variable& force = *view.output.variable;
  if (fuzzy::makeClosedForm(terms, force.min, force.max, view.model->implication, form))
    return orderedCode(view, form, strengths.reached);
  general = true;
  return unorderedCode(view, index, strengths.reached, tables);
}

std::string generalOffsetText() {
  return R"(/* Trapezoids in any order: the maximum of the sets is piecewise linear, and every piece is integrated exactly. */
typedef struct {
  double left, top_left, top_right, right, height;
} output_set;

static double height_at(const output_set *f, double x) {
  if (x < f->top_left) return f->height * ((x - f->left) / (f->top_left - f->left));
  if (x > f->top_right) return f->height * ((f->right - x) / (f->right - f->top_right));
  return f->height;
}

static double general_offset(const double (*corners)[4], const double *strengths, int count, double largest, int scales,
                             double lo, double hi) {
  output_set sets[64];
  double edges[256], start[64], end[64];
  double area = 0.0, moment = 0.0;
  int used = 0, edge_count = 0, i, k;
  for (i = 0; i < count; ++i) {
    const double top = scales ? 1.0 : strengths[i];
    const double *c = corners[i];
    output_set *f = &sets[used];
    if (!(strengths[i] > 0.0)) continue;
    f->left = c[0];
    f->top_left = c[0] + top * (c[1] - c[0]);
    f->top_right = c[3] - top * (c[3] - c[2]);
    f->right = c[3];
    if (f->top_left > f->top_right) f->top_left = f->top_right = (f->top_left + f->top_right) / 2.0;
    f->height = strengths[i] / largest;
    edges[edge_count++] = lower(larger(f->left, lo), hi);
    edges[edge_count++] = lower(larger(f->top_left, lo), hi);
    edges[edge_count++] = lower(larger(f->top_right, lo), hi);
    edges[edge_count++] = lower(larger(f->right, lo), hi);
    ++used;
  }
  for (i = 1; i < edge_count; ++i) {
    const double x = edges[i];
    for (k = i; k > 0 && edges[k - 1] > x; --k) edges[k] = edges[k - 1];
    edges[k] = x;
  }
  for (i = 1; i < edge_count; ++i) {
    const double from = edges[i - 1], width = edges[i] - edges[i - 1];
    double t = 0.0;
    int lines = 0, best = 0;
    if (!(width > 0.0)) continue;
    for (k = 0; k < used; ++k) {
      if (!(sets[k].left <= from && edges[i] <= sets[k].right)) continue;
      start[lines] = height_at(&sets[k], from);
      end[lines] = height_at(&sets[k], edges[i]);
      if (start[lines] > start[best] || (start[lines] == start[best] && end[lines] > end[best])) best = lines;
      ++lines;
    }
    while (lines > 0 && t < 1.0) {
      const double slope = end[best] - start[best];
      double next = 1.0, steepest = slope, y0, y1, piece, x;
      int follower = -1;
      for (k = 0; k < lines; ++k) {
        const double steeper = (end[k] - start[k]) - slope;
        double at;
        if (!(steeper > 0.0)) continue;
        at = larger(t, (start[best] - start[k]) / steeper);
        if (at < next || (at == next && at < 1.0 && end[k] - start[k] > steepest)) {
          next = at;
          steepest = end[k] - start[k];
          follower = k;
        }
      }
      y0 = start[best] + t * slope;
      y1 = start[best] + next * slope;
      x = (from - edges[0]) + t * width;
      piece = (next - t) * width * (y0 + y1) / 2.0;
      area += piece;
      moment += piece * x + (next - t) * width * ((next - t) * width) * (y0 + 2.0 * y1) / 6.0;
      t = next;
      if (follower < 0) break;
      best = follower;
    }
  }
  return (edges[0] - lo) + (area > 0.0 ? moment / area : 0.0);
}

)";
}

}  // namespace tactus::exchange
