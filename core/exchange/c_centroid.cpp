// The centroid in C: polynomials in the strengths where the output terms have an order (core/fuzzy/closed_form.h), else
// a walk along the upper envelope.
#include <algorithm>
#include <array>
#include <memory_resource>

#include "core/exchange/c_parts.h"
#include "core/fuzzy/closed_form.h"

namespace tactus::exchange {
namespace {

using fuzzy::ClosedForm;
using Polynomial = fuzzy::Polynomial<double>;

std::string strength(std::size_t term) { return "s" + std::to_string(term); }

/// Adds (`sign` is `+`) or subtracts area and moment of a trapezoid that is clipped at `t`.
std::string addClipped(const std::string& t, const Polynomial& f, char sign) {
  const std::string operation = std::string(" ") + sign + "= ";
  std::string out = "  part = " + t + " * (" + number(f.width) + " - " + t + " * " + number(f.half_taper) + ");\n";
  out += "  area" + operation + "part;\n  moment" + operation + "part * " + number(f.middle);
  if (f.linear != 0 || f.cubic != 0) {
    out += " + " + t + " * " + t + " * (" + number(f.linear) + " - " + t + " * " + number(f.cubic) + ")";
  }
  return out + ";\n";
}

std::string clippedOverlap(const ClosedForm::Pair& pair, const std::string& left, const std::string& right,
                           const std::vector<std::string>& between) {
  std::string out = "  common = lower(lower(" + left + ", " + right + "), " + number(pair.overlap.peak) + ");\n";
  out += addClipped("common", pair.overlap.shape, '-');
  if (between.empty()) return out;
  // Below the strength of the strongest term between, terms between cover the whole overlap.
  out += "  hidden = 0.0;\n";
  for (const std::string& one : between) out += "  hidden = larger(hidden, " + one + ");\n";
  out += "  hidden = lower(hidden, common);\n";
  return out + addClipped("hidden", pair.overlap.shape, '+');
}

std::string scaledOverlap(const ClosedForm::Pair& pair, const std::string& left, const std::string& right) {
  const auto& overlap = pair.overlap;
  const double width = overlap.shape.width;
  return "  fall = " + left + " * " + number(overlap.inverse_fall) + ";\n  rise = " + right + " * " +
         number(overlap.inverse_rise) +
         ";\n  common = fall / (fall + rise > 0.0 ? fall + rise : 1.0);\n  part = rise * common * " +
         number(width * width * 0.5) + ";\n  area -= part;\n  moment -= part * ((common + 1.0) * " + number(width / 3) +
         " + " + number(overlap.start) + ");\n";
}

/// The strengths may be so small that their squares vanish. Ratios alone count there.
std::string liftText(const std::vector<std::size_t>& reached) {
  std::string out = "  if (largest < 1e-90) {\n    const double lift = 1e-90 / largest;\n";
  for (const std::size_t term : reached) out += "    " + strength(term) + " *= lift;\n";
  return out + "  }\n";
}

std::string largestText(const std::vector<std::size_t>& reached) {
  std::string out;
  for (const std::size_t term : reached) out += "  largest = larger(largest, " + strength(term) + ");\n";
  return out + "  if (!(largest > 0.0)) return 0;\n";
}

std::string orderedCode(const ExpertView& view, const ClosedForm& form, const std::vector<std::size_t>& reached) {
  const bool clips = view.model->implication == fuzzy::Implication::kClip;
  std::array<std::size_t, fuzzy::kMostTerms> term_of{};  // of each lane
  std::array<bool, fuzzy::kMostTerms> live{};
  for (std::size_t t = 0; t < form.lane_of.size(); ++t) term_of[form.lane_of[t]] = t;
  for (const std::size_t term : reached) live[form.lane_of[term]] = true;

  std::string sums;
  for (std::size_t lane = 0; lane < form.terms.size(); ++lane) {
    if (!live[lane]) continue;
    const std::string own = strength(term_of[lane]);
    if (clips) {
      sums += addClipped(own, form.terms[lane], '+');
    } else {
      sums += "  area += " + own + " * " + number(form.terms[lane].width) + ";\n  moment += " + own + " * " +
              number(form.terms[lane].middle) + ";\n";
    }
    for (std::uint32_t p = form.first_pair[lane]; p < form.first_pair[lane + 1]; ++p) {
      const ClosedForm::Pair& pair = form.pairs[p];
      if (!live[pair.left]) continue;
      const std::string left = strength(term_of[pair.left]);
      std::vector<std::string> between;
      for (std::size_t k = pair.left + 1U; k < lane; ++k) {
        if (live[k]) between.push_back(strength(term_of[k]));
      }
      sums += clips ? clippedOverlap(pair, left, own, between) : scaledOverlap(pair, left, own);
    }
  }
  std::string locals = "  double largest = 0.0, area = 0.0, moment = 0.0;\n";
  for (const char* const local : {"part", "common", "hidden", "fall", "rise"}) {
    if (sums.find(std::string("  ") + local + " = ") != std::string::npos)
      locals += "  double " + std::string(local) + ";\n";
  }
  return locals + largestText(reached) + liftText(reached) + sums + "  *offset = moment / area;\n  return 1;\n";
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
  return "  const double strengths[" + std::to_string(reached.size()) + "] = {" + strengths +
         "};\n  double largest = 0.0;\n" + largestText(reached) + "  *offset = general_offset(" + table +
         ", strengths, " + std::to_string(reached.size()) + ", largest, " + scales + ", " + number(force.min) + ", " +
         number(force.max) + ");\n  return 1;\n";
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
