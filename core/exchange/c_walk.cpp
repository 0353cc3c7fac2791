// The centroid in C where the output terms have no order, or some are Gaussians: a walk along the upper envelope, with
// the same steps as core/fuzzy/general_path.h and gaussian_centroid.cpp.
#include <algorithm>

#include "core/exchange/c_parts.h"

namespace tactus::exchange {

std::string walkedCode(const ExpertView& view, std::size_t index, const std::vector<Strength>& strengths,
                       std::string& tables) {
  const auto is_gaussian = [](const NamedTerm& term) { return term.term->shape == fuzzy::Shape::kGaussian; };
  const bool gaussians = std::any_of(view.output.terms.begin(), view.output.terms.end(), is_gaussian);
  const std::string table = "corners_" + std::to_string(index);
  tables += "static const double " + table + (gaussians ? "[][5] = {\n" : "[][4] = {\n");
  std::string values;
  std::vector<std::string> names;
  std::string out = "  (void)inputs;\n  (void)m;\n";
  for (const Strength& strength : strengths) {
    const NamedTerm& term = view.output.terms[strength.term];
    if (is_gaussian(term)) {
      tables += "  {" + number(term.term->points[0]) + ", " + number(term.term->points[1]) + ", 0.0, 0.0, 1.0},\n";
    } else {
      const Corners f = cornersOf(*term.term);
      tables += "  {" + number(f.a) + ", " + number(f.b) + ", " + number(f.c) + ", " + number(f.d) +
                (gaussians ? ", 0.0},\n" : "},\n");
    }
    names.push_back("s" + std::to_string(strength.term));
    out += "  const double " + names.back() + " = " + strength.text + ";  /* " + comment(term.term->id) + " */\n";
    values += (values.empty() ? "" : ", ") + names.back();
  }
  tables += "};\n\n";
  const fuzzy::Variable& force = *view.output.variable;
  const std::string count = std::to_string(strengths.size());
  const std::string scales = view.model->implication == fuzzy::Implication::kScale ? "1" : "0";
  return out + "  const double strengths[" + count + "] = {" + values +
         "};\n  const double largest = " + tree(names, "larger") +
         ";\n  if (!(largest > 0.0)) return 0;\n  *offset = " + (gaussians ? "gaussian" : "general") + "_offset(" +
         table + ", strengths, " + count + ", largest, " + scales + ", " + number(force.min) + ", " +
         number(force.max) + ");\n  return 1;\n";
}

std::string outputSetText(std::size_t most_terms) {
  // GCC takes shorter arrays apart, and then warns of parts that are never read.
  constexpr std::size_t kFewest = 4;
  return "enum { kTerms = " + std::to_string(std::max(most_terms, kFewest)) + R"( };

/* A trapezoid under its rule's strength. */
typedef struct {
  double left, top_left, top_right, right, height;
} output_set;

static double height_at(const output_set *f, double x) {
  if (x < f->top_left) return f->height * ((x - f->left) / (f->top_left - f->left));
  if (x > f->top_right) return f->height * ((f->right - x) / (f->right - f->top_right));
  return f->height;
}

static output_set set_of(const double *c, double strength, double largest, int scales) {
  const double top = scales ? 1.0 : strength;
  output_set f;
  f.left = c[0];
  f.top_left = c[0] + top * (c[1] - c[0]);
  f.top_right = c[3] - top * (c[3] - c[2]);
  f.right = c[3];
  if (f.top_left > f.top_right) f.top_left = f.top_right = (f.top_left + f.top_right) / 2.0;
  f.height = strength / largest;
  return f;
}

static void sort_edges(double *edges, int count) {
  int i, k;
  for (i = 1; i < count; ++i) {
    const double x = edges[i];
    for (k = i; k > 0 && edges[k - 1] > x; --k) edges[k] = edges[k - 1];
    edges[k] = x;
  }
}

)";
}

std::string generalOffsetText() {
  return R"(/* Trapezoids in any order: the maximum of the sets is piecewise linear, and every piece is integrated exactly. */
static double general_offset(const double (*corners)[4], const double *strengths, int count, double largest, int scales,
                             double lo, double hi) {
  output_set sets[kTerms] = {{0.0, 0.0, 0.0, 0.0, 0.0}};
  double edges[4 * kTerms], start[kTerms], end[kTerms];
  double area = 0.0, moment = 0.0;
  int used = 0, edge_count = 0, i, k;
  for (i = 0; i < count; ++i) {
    output_set *f = &sets[used];
    if (!(strengths[i] > 0.0)) continue;
    *f = set_of(corners[i], strengths[i], largest, scales);
    edges[edge_count++] = lower(larger(f->left, lo), hi);
    edges[edge_count++] = lower(larger(f->top_left, lo), hi);
    edges[edge_count++] = lower(larger(f->top_right, lo), hi);
    edges[edge_count++] = lower(larger(f->right, lo), hi);
    ++used;
  }
  sort_edges(edges, edge_count);
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

std::string gaussianOffsetText() {
  return R"(/* With Gaussians among the terms: between neighboring corners each set is a line or a part of a Gaussian without an
 * inflection. Where two of them meet is found by bisection, and what lies under a Gaussian by quadrature. */
typedef struct {
  int curved;
  double y0, slope;              /* a line from the left end on */
  double mean, sigma, log_scale; /* exp(log_scale - ((x - mean) / sigma)^2 / 2) */
} curve_piece;

static double piece_at(const curve_piece *p, double x) {
  const double u = (x - p->mean) / p->sigma;
  return p->curved ? exp(p->log_scale - 0.5 * u * u) : p->y0 + p->slope * x;
}

static double piece_slope(const curve_piece *p, double x) {
  return p->curved ? -piece_at(p, x) * (x - p->mean) / (p->sigma * p->sigma) : p->slope;
}

/* Has the sign of the difference of two pieces, or of their slopes. */
static double pieces_apart(const curve_piece *p, const curve_piece *q, int of_slopes, double x) {
  const double u = (x - p->mean) / p->sigma, v = (x - q->mean) / q->sigma;
  if (of_slopes) return piece_slope(p, x) - piece_slope(q, x);
  if (!p->curved || !q->curved) return piece_at(p, x) - piece_at(q, x);
  return (p->log_scale - q->log_scale) - 0.5 * (u - v) * (u + v);
}

/* Where the difference changes its sign, to the last bit. */
static double sign_change(const curve_piece *p, const curve_piece *q, int of_slopes, double left, double right) {
  const int rising = pieces_apart(p, q, of_slopes, left) <= 0.0;
  for (;;) {
    const double middle = left + (right - left) / 2.0;
    if (middle <= left || middle >= right) return middle;
    if ((pieces_apart(p, q, of_slopes, middle) <= 0.0) == rising) {
      left = middle;
    } else {
      right = middle;
    }
  }
}

/* Two pieces meet at most twice in (0, length); returns how many cuts are written. */
static int cuts_of(const curve_piece *p, const curve_piece *q, double length, double *cuts) {
  double ends[3];
  int count = 0, i;
  ends[0] = 0.0;
  ends[1] = ends[2] = length;
  if (p->curved && q->curved) {
    const double pp = 1.0 / (p->sigma * p->sigma), qq = 1.0 / (q->sigma * q->sigma);
    if (pp != qq) ends[1] = (p->mean * pp - q->mean * qq) / (pp - qq);
  } else if ((pieces_apart(p, q, 1, 0.0) <= 0.0) != (pieces_apart(p, q, 1, length) <= 0.0)) {
    ends[1] = sign_change(p, q, 1, 0.0, length);
  }
  if (!(ends[1] > 0.0 && ends[1] < length)) ends[1] = length;
  for (i = 0; i < 2; ++i) {
    if (!(ends[i] < ends[i + 1])) continue;
    if ((pieces_apart(p, q, 0, ends[i]) <= 0.0) == (pieces_apart(p, q, 0, ends[i + 1]) <= 0.0)) continue;
    cuts[count++] = sign_change(p, q, 0, ends[i], ends[i + 1]);
  }
  return count;
}

/* Ten points of Gauss and Legendre, on parts so short that the error is below rounding. */
static void add_curve(const curve_piece *p, double from, double to, double start, double *area, double *moment) {
  static const double nodes[5] = {0.14887433898163122, 0.43339539412924719, 0.67940956829902441, 0.86506336668898451,
                                  0.97390652851717172};
  static const double weights[5] = {0.29552422471475287, 0.26926671930999635, 0.21908636251598204, 0.14945134915058059,
                                    0.06667134430868814};
  double left = from;
  while (left < to) {
    const double distance = fabs(left - p->mean) / p->sigma;
    const double right = lower(to, left + p->sigma * 2.0 / (1.0 + distance));
    const double half = (right - left) / 2.0;
    int i;
    if (right <= left) return;
    for (i = 0; i < 10; ++i) {
      const double x = left + half + half * (i % 2 == 0 ? nodes[i / 2] : -nodes[i / 2]);
      const double mass = half * weights[i / 2] * piece_at(p, x);
      *area += mass;
      *moment += mass * (start + x);
    }
    left = right;
  }
}

/* terms: corners of a trapezoid and 0, or mean, sigma, 0, 0 and 1. */
static double gaussian_offset(const double (*terms)[5], const double *strengths, int count, double largest, int scales,
                              double lo, double hi) {
  output_set sets[kTerms] = {{0.0, 0.0, 0.0, 0.0, 0.0}};
  const double *shapes[kTerms];
  double share[kTerms];
  double edges[7 * kTerms], cuts[kTerms * (kTerms - 1) + 2];
  curve_piece pieces[kTerms];
  double area = 0.0, moment = 0.0;
  int used = 0, edge_count = 0, i, j, k;
  for (i = 0; i < count; ++i) {
    const double *c = terms[i];
    if (!(strengths[i] > 0.0)) continue;
    shapes[used] = c;
    share[used] = scales ? 1.0 : strengths[i];
    if (c[4] > 0.0) {
      const double flat = sqrt(-2.0 * log(share[used]));
      const double steps[7] = {-39.0, -flat, -1.0, 0.0, 1.0, flat, 39.0};
      sets[used].height = strengths[i] / largest;
      for (k = 0; k < 7; ++k) edges[edge_count++] = lower(larger(c[0] + steps[k] * c[1], lo), hi);
    } else {
      sets[used] = set_of(c, strengths[i], largest, scales);
      edges[edge_count++] = lower(larger(sets[used].left, lo), hi);
      edges[edge_count++] = lower(larger(sets[used].top_left, lo), hi);
      edges[edge_count++] = lower(larger(sets[used].top_right, lo), hi);
      edges[edge_count++] = lower(larger(sets[used].right, lo), hi);
    }
    ++used;
  }
  sort_edges(edges, edge_count);
  for (i = 1; i < edge_count; ++i) {
    const double from = edges[i - 1], length = edges[i] - edges[i - 1], start = edges[i - 1] - edges[0];
    int piece_count = 0, cut_count = 0;
    if (!(length > 0.0)) continue;
    for (k = 0; k < used; ++k) {
      curve_piece *p = &pieces[piece_count];
      const double *c = shapes[k];
      p->curved = 0;
      p->mean = 0.0;
      p->sigma = 1.0;
      p->log_scale = 0.0;
      if (c[4] > 0.0) {
        /* Height 1 is the largest strength. */
        const double factor = sets[k].height / share[k];
        const double u = (from - c[0] + length / 2.0) / c[1];
        if (fabs(u) > 39.0) continue;
        p->curved = exp(-0.5 * u * u) * factor < sets[k].height;
        p->mean = c[0] - from;
        p->sigma = c[1];
        p->log_scale = log(factor);
        p->y0 = sets[k].height;
        p->slope = 0.0;
      } else {
        if (!(sets[k].left <= from && edges[i] <= sets[k].right)) continue;
        p->y0 = height_at(&sets[k], from);
        p->slope = (height_at(&sets[k], edges[i]) - p->y0) / length;
      }
      ++piece_count;
    }
    if (piece_count == 0) continue;
    cuts[cut_count++] = 0.0;
    for (k = 0; k < piece_count; ++k) {
      for (j = k + 1; j < piece_count; ++j) cut_count += cuts_of(&pieces[k], &pieces[j], length, cuts + cut_count);
    }
    cuts[cut_count++] = length;
    sort_edges(cuts, cut_count);
    for (k = 1; k < cut_count; ++k) {
      const double x0 = cuts[k - 1], x1 = cuts[k], middle = x0 + (x1 - x0) / 2.0;
      const curve_piece *top = pieces;
      if (!(x1 > x0)) continue;
      for (j = 1; j < piece_count; ++j) {
        if (piece_at(&pieces[j], middle) > piece_at(top, middle)) top = &pieces[j];
      }
      if (top->curved) {
        add_curve(top, x0, x1, start, &area, &moment);
      } else {
        const double y0 = piece_at(top, x0), y1 = piece_at(top, x1), width = x1 - x0;
        const double piece = width * (y0 + y1) / 2.0;
        area += piece;
        moment += piece * (start + x0) + width * width * (y0 + 2.0 * y1) / 6.0;
      }
    }
  }
  return (edges[0] - lo) + (area > 0.0 ? moment / area : 0.0);
}

)";
}

}  // namespace tactus::exchange
