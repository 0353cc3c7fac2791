#include "app/bundle/bounded_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <thread>
#include <utility>
#include <vector>

#include "app/bundle/force_enclosure.h"
#include "core/base/in_parallel.h"

namespace tactus::bundle {
namespace {

using Lines = std::vector<std::vector<double>>;
using Parts = std::vector<std::vector<std::size_t>>;  // of each input, between neighboring vertices
using Factors = std::vector<std::vector<double>>;     // of the same

/// The points sampled must be so many times closer than wanted: the worst lies between them, and its bound beyond.
constexpr double kMargin = 1.3;

/// Where the force jumps, a finer grid than this helps little. It is found out with so many times the wanted error.
constexpr double kNodesBesideJumps = 60'000;
constexpr double kRough = 4;

/// A number with few digits within a thousandth of `step` of `value`.
double shortened(double value, double step) {
  const double unit = std::pow(10, std::floor(std::log10(step)) - 3);
  const double out = unit < 1 ? std::round(value / unit) / std::round(1 / unit) : std::round(value / unit) * unit;
  return std::isfinite(out) ? out : value;
}

Lines divided(const Lines& vertices, const Parts& parts) {
  Lines out;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    auto& line = out.emplace_back();
    for (std::size_t k = 0; k + 1 < vertices[i].size(); ++k) {
      const double lo = vertices[i][k];
      const double step = (vertices[i][k + 1] - lo) / static_cast<double>(parts[i][k]);
      line.push_back(lo);
      for (std::size_t p = 1; p < parts[i][k]; ++p) {
        const double next = shortened(lo + step * static_cast<double>(p), step);
        if (next > line.back() && next < vertices[i][k + 1]) line.push_back(next);
      }
    }
    line.push_back(vertices[i].back());
  }
  return out;
}

/// The lines and the middles between them.
Lines halved(const Lines& lines) {
  Lines out;
  for (const auto& line : lines) {
    auto& half = out.emplace_back();
    for (std::size_t k = 0; k + 1 < line.size(); ++k)
      half.insert(half.end(), {line[k], line[k] + (line[k + 1] - line[k]) / 2});
    half.push_back(line.back());
  }
  return out;
}

/// A table, and the forces at its nodes and half-way between them.
class Sampled {
 public:
  Sampled(const fuzzy::CompiledModel& compiled, Lines lines) {
    table_.lines = std::move(lines);
    halves_ = forceTable(compiled, halved(table_.lines));
    std::size_t node_stride = 1;
    std::size_t half_stride = 1;
    for (std::size_t i = inputs(); i-- > 0;) {
      stride_[i] = node_stride;
      half_stride_[i] = half_stride;
      node_stride *= table_.lines[i].size();
      half_stride *= halves_.lines[i].size();
    }
    table_.force_n.resize(node_stride);
    half_offset_ = {0};
    for (std::size_t i = 0; i < inputs(); ++i) {
      const std::size_t count = half_offset_.size();
      upper_[i] = 2 * count;
      for (std::size_t digit = 1; digit <= 2; ++digit) {
        for (std::size_t k = 0; k < count; ++k) half_offset_.push_back(half_offset_[k] + digit * half_stride_[i]);
      }
    }
    for (std::size_t c = 0; c < corners(); ++c) {
      corner_offset_.push_back(offset(c, stride_));
      upper_offset_.push_back(offset(c, upper_));
    }
    forEachIndex(
        0, [&](const Index& node, std::size_t number) { table_.force_n[number] = halves_.force_n[halfOf(node)]; });
  }

  /// Spreads the errors to both sides: a node moves by the mean of the largest and the smallest error in the cells
  /// around it, at most `most_n` in all.
  void spread(double most_n) {
    constexpr int kRounds = 2;
    const std::vector<double> exact_n = table_.force_n;
    double best_n = kInfinity;
    std::vector<double> best_force_n;
    std::vector<Range> best_errors;
    for (int round = 0; round <= kRounds; ++round) {
      findErrors();
      double worst_n = 0;
      for (const Range& cell : errors_) worst_n = std::max({worst_n, -cell.lo, cell.hi});
      if (worst_n < best_n) {
        best_n = worst_n;
        best_force_n = table_.force_n;
        best_errors = errors_;
      }
      if (round == kRounds) break;
      std::vector<Range> around(table_.force_n.size());  // each node
      forEachIndex(1, [&](const Index& cell, std::size_t number) {
        const Range& error = errors_[number];
        const std::size_t first = nodeOf(cell);
        for (const std::size_t corner : corner_offset_) {
          Range& node = around[first + corner];
          node = {std::min(node.lo, error.lo), std::max(node.hi, error.hi)};
        }
      });
      for (std::size_t node = 0; node < around.size(); ++node) {
        const double moved = table_.force_n[node] + (around[node].hi + around[node].lo) / 2;
        table_.force_n[node] = std::clamp(moved, exact_n[node] - most_n, exact_n[node] + most_n);
      }
    }
    table_.force_n = std::move(best_force_n);
    errors_ = std::move(best_errors);
  }

  /// After `spread`: how much finer the cells of each line must be for the error `most_n` at the points sampled; 1:
  /// they are fine.
  Factors finer(double most_n) const {
    Factors out;
    for (const auto& line : table_.lines) out.emplace_back(line.size() - 1, 1.0);
    forEachIndex(1, [&](const Index& cell, std::size_t number) {
      const double off_n = std::max(-errors_[number].lo, errors_[number].hi);
      if (off_n <= most_n) return;
      std::array<double, fuzzy::kMostInputs> bend{};
      for (std::size_t i = 0; i < inputs(); ++i) bend[i] = bendAlong(cell, i);
      const double most = *std::max_element(bend.begin(), bend.end());
      for (std::size_t i = 0; i < inputs(); ++i) {
        double& one = out[i][cell[i]];
        if (bend[i] > 0 && bend[i] >= kAsMuch * most) one = std::max(one, off_n / most_n);
      }
    });
    return out;
  }

  const ForceTable& table() const { return table_; }

 private:
  static constexpr double kInfinity = HUGE_VAL;
  static constexpr double kAsMuch = 0.6;  ///< an input is refined if the force bends along it so much as along any
  using Index = std::array<std::size_t, fuzzy::kMostInputs>;

  std::size_t inputs() const { return table_.lines.size(); }
  std::size_t corners() const { return std::size_t{1} << inputs(); }

  std::size_t nodeOf(const Index& index) const {
    std::size_t node = 0;
    for (std::size_t i = 0; i < inputs(); ++i) node += index[i] * stride_[i];
    return node;
  }
  std::size_t halfOf(const Index& index) const {
    std::size_t half = 0;
    for (std::size_t i = 0; i < inputs(); ++i) half += 2 * index[i] * half_stride_[i];
    return half;
  }
  std::size_t offset(std::size_t corner, const Index& stride) const {
    std::size_t out = 0;
    for (std::size_t i = 0; i < inputs(); ++i) out += (corner >> i & 1U) != 0 ? stride[i] : 0;
    return out;
  }

  /// `less`: 0 for the nodes, 1 for the cells. `visit(index, number)`: in order, the number counts from 0.
  template <class Visit>
  void forEachIndex(std::size_t less, Visit&& visit) const {
    std::size_t count = 1;
    for (const auto& line : table_.lines) count *= line.size() - less;
    forEachIndex(less, 0, count, visit);
  }
  /// Those with the numbers from `first` up to `last`, without the last.
  template <class Visit>
  void forEachIndex(std::size_t less, std::size_t first, std::size_t last, Visit&& visit) const {
    Index index{};
    std::size_t rest = first;
    for (std::size_t i = inputs(); i-- > 0; rest /= table_.lines[i].size() - less)
      index[i] = rest % (table_.lines[i].size() - less);
    for (std::size_t number = first; number < last; ++number) {
      visit(index, number);
      for (std::size_t i = inputs(); i-- > 0;) {
        if (++index[i] < table_.lines[i].size() - less) break;
        index[i] = 0;
      }
    }
  }

  /// Of each cell the smallest and the largest of force minus table at the corners, the middle, and half-way between
  /// corners.
  void findErrors() {
    constexpr std::size_t kAtOnce = 8192;
    std::size_t cells = 1;
    for (const auto& line : table_.lines) cells *= line.size() - 1;
    errors_.resize(cells);
    base::inParallel((cells + kAtOnce - 1) / kAtOnce, std::thread::hardware_concurrency(), [&](std::size_t part) {
      std::vector<double> table_at(half_offset_.size());
      const std::size_t first = part * kAtOnce;
      forEachIndex(1, first, std::min(first + kAtOnce, cells),
                   [&](const Index& cell, std::size_t number) { errors_[number] = errorsOf(cell, table_at); });
    });
  }

  /// `table_at`: room for the table at each of the 3^inputs points.
  Range errorsOf(const Index& cell, std::vector<double>& table_at) const {
    const std::size_t node = nodeOf(cell);
    const std::size_t half = halfOf(cell);
    // The table at the corners and half-way: digits 0, 1, 2 of each input are the lower end, the middle, the upper end.
    for (std::size_t c = 0; c < corners(); ++c) table_at[upper_offset_[c]] = table_.force_n[node + corner_offset_[c]];
    std::size_t done = 1;  // 3^i
    for (std::size_t i = 0; i < inputs(); ++i, done *= 3) {
      // The digits of later inputs are 0 or 2 so far.
      for (std::size_t c = 0; c < corners() >> (i + 1); ++c) {
        double* const start = table_at.data() + upper_offset_[c << (i + 1)];
        for (std::size_t k = 0; k < done; ++k) start[done + k] = (start[k] + start[2 * done + k]) / 2;
      }
    }
    Range out{kInfinity, -kInfinity};
    for (std::size_t p = 0; p < done; ++p) include(out, halves_.force_n[half + half_offset_[p]] - table_at[p]);
    return out;
  }

  /// How far the force is from a line along input `i`, in the middle of it, with the others at either end or their
  /// middle.
  double bendAlong(const Index& cell, std::size_t input) const {
    const std::size_t half = halfOf(cell);
    double out = 0;
    for (std::size_t c = 0; c < corners(); ++c) {
      if ((c >> input & 1U) != 0) continue;
      for (const std::size_t scale : {std::size_t{1}, std::size_t{2}}) {
        const std::size_t at = half + scale * offset(c, half_stride_);
        const double middle = halves_.force_n[at + half_stride_[input]];
        const double ends = (halves_.force_n[at] + halves_.force_n[at + 2 * half_stride_[input]]) / 2;
        out = std::max(out, std::abs(middle - ends));
      }
    }
    return out;
  }

  ForceTable table_;
  ForceTable halves_;
  Index stride_{};
  Index half_stride_{};
  Index upper_{};                           ///< 2 * 3^i
  std::vector<std::size_t> half_offset_;    ///< of each of the 3^inputs points of a cell
  std::vector<std::size_t> corner_offset_;  ///< of each of its corners, in the table
  std::vector<std::size_t> upper_offset_;   ///< likewise, among the 3^inputs points
  std::vector<Range> errors_;               ///< of each cell
};

/// The factors of the stretches between vertices.
Factors ofStretches(const Lines& vertices, const Lines& lines, const Factors& finer) {
  constexpr double kMostAtOnce = 1.5;
  Factors out;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    auto& own = out.emplace_back(vertices[i].size() - 1, 1.0);
    std::size_t stretch = 0;
    for (std::size_t k = 0; k < finer[i].size(); ++k) {
      while (lines[i][k] >= vertices[i][stretch + 1]) ++stretch;
      own[stretch] = std::max(own[stretch], std::min(finer[i][k], kMostAtOnce));
    }
  }
  return out;
}

/// The parts, finer by the factors to the power of `share`.
Parts finerParts(const Parts& parts, const Factors& factors, double share) {
  Parts out = parts;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (std::size_t k = 0; k < parts[i].size(); ++k) {
      const double factor = std::pow(factors[i][k], share);
      if (factor > 1) out[i][k] = static_cast<std::size_t>(std::ceil(static_cast<double>(parts[i][k]) * factor));
    }
  }
  return out;
}

double nodesOf(const Parts& parts) {
  double nodes = 1;
  for (const auto& own : parts) {
    double lines = 1;
    for (const std::size_t one : own) lines += static_cast<double>(one);
    nodes *= lines;
  }
  return nodes;
}

bool isFine(const Factors& factors) {
  return std::all_of(factors.begin(), factors.end(), [](const auto& own) {
    return std::all_of(own.begin(), own.end(), [](double one) { return one <= 1; });
  });
}

}  // namespace

double usualTableErrorN(const fuzzy::ForceModel& model) {
  constexpr double kUsualEndN = 1.25;
  constexpr double kShare = 0.02;
  return model.output.max <= kUsualEndN ? kTableErrorN : kShare * model.output.max;
}

BoundedTable boundedTable(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled, double wanted_n,
                          std::size_t most_nodes, const std::stop_token& stop) {
  const auto most = static_cast<double>(most_nodes);
  const Lines vertices = vertexLines(model, most_nodes);
  Parts parts;
  for (const auto& line : vertices) parts.emplace_back(line.size() - 1, 1);
  BoundedTable out;
  const auto refined = [&](const Factors& finer, const Lines& lines) {
    const Factors factors = ofStretches(vertices, lines, finer);
    for (double share = 1; share > 0.05; share *= 0.7) {
      Parts next = finerParts(parts, factors, share);
      if (nodesOf(next) > most) continue;
      const bool changed = next != parts;
      parts = std::move(next);
      return changed;
    }
    return false;
  };
  bool may_jump = true;
  while (true) {
    if (may_jump && nodesOf(parts) > kNodesBesideJumps) {
      const TableBound rough = tableBound(model, compiled, out.table, kRough * wanted_n, stop);
      may_jump = false;
      if (rough.jumps) {
        out.bound = rough;
        return out;
      }
    }
    Sampled sampled(compiled, divided(vertices, parts));
    sampled.spread(wanted_n);
    out.table = sampled.table();
    const Factors finer = sampled.finer(wanted_n / kMargin);
    if (!isFine(finer) && !stop.stop_requested() && refined(finer, out.table.lines)) continue;
    out.bound = tableBound(model, compiled, out.table, wanted_n, stop);
    if (isFine(out.bound.finer) || stop.stop_requested() || !refined(out.bound.finer, out.table.lines)) return out;
  }
}

}  // namespace tactus::bundle
