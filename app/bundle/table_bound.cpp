#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <thread>

#include "app/bundle/bounded_table.h"
#include "app/bundle/force_enclosure.h"
#include "core/base/in_parallel.h"

namespace tactus::bundle {
namespace {

using fuzzy::MembershipFunction;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kInside = 1e-9;  // of a cell's width: from an edge on which the force may jump into the cell
constexpr std::size_t kMostLooksOfCell = 8'000;
constexpr std::size_t kMostLooks = 200'000'000;  // of all cells and experts
constexpr double kSharp = 1.02;                  // how close a bound comes to the error that was found

/// A part of a cell. Corner c lies at the upper end of input i where bit i of c is set.
struct Box {
  std::array<double, fuzzy::kMostInputs> lo{};
  std::array<double, fuzzy::kMostInputs> hi{};
  std::vector<double> force_n;
  std::vector<double> table_n;
  ForceRange range;        ///< of it, or of the box of which it is a part
  bool looked_at = false;  ///< `range` is its own
  double bound_n = 0;      ///< on the error in it
  bool jumps = false;
  std::size_t longest = 0;  ///< the input along which to split it
  double longest_share = 0;
};

/// Looks at the cells of one slab of the table.
class CellSearch {
 public:
  CellSearch(const fuzzy::CompiledModel& compiled, const ForceTable& table, const ForceEnclosure& enclosure,
             double wanted_n, std::size_t most_looks)
      : compiled_(compiled),
        table_(table),
        enclosure_(enclosure),
        wanted_n_(wanted_n),
        enough_n_(wanted_n),
        most_looks_(most_looks) {
    for (const auto& line : table.lines) out_.finer.emplace_back(line.size() - 1, 1.0);
  }

  /// `cell`: the number of the lower line of each input. `inside`: its corners are taken within it, because the force
  /// may jump at its edge.
  void look(const std::vector<std::size_t>& cell, bool inside) {
    open_.clear();
    Box root = rootOf(cell, inside);
    findMemberships(root, cell.size());
    enclosure_.cellOf(memberships_, rules_);
    lookAt(root, cell);
    keep(std::move(root));
    // Once the work for all is spent, a cell gets a bound from one look. The worst box comes first.
    const std::size_t last = looks_ + (looks_ < most_looks_ ? kMostLooksOfCell : 0);
    while (!open_.empty()) {
      const Box& worst = open_.front();
      const bool splits = worst.longest_share > (worst.jumps ? kThin : 0);
      if (worst.bound_n <= enough_n_ || looks_ >= last || (worst.looked_at && !splits)) {
        out_.bound_n = std::max(out_.bound_n, worst.bound_n);
        out_.jumps = out_.jumps || worst.jumps;
        if (worst.bound_n > wanted_n_ && !worst.jumps) wantFiner(worst, cell);
        return;
      }
      std::pop_heap(open_.begin(), open_.end(), isBetter);
      Box box = std::move(open_.back());
      open_.pop_back();
      if (box.looked_at) {
        split(std::move(box), cell);
      } else {
        lookAt(box, cell);
        keep(std::move(box));
      }
    }
  }

  TableBound result() && { return std::move(out_); }

 private:
  static constexpr double kThin = 1.0 / 64;  ///< of a cell: a box beside a jump is not made thinner

  static bool isBetter(const Box& a, const Box& b) { return a.bound_n < b.bound_n; }

  void findMemberships(const Box& box, std::size_t inputs) {
    enclosure_.lookAt({box.lo.data(), inputs}, {box.hi.data(), inputs}, memberships_);
  }

  void wantFiner(const Box& worst, const std::vector<std::size_t>& cell) {
    for (std::size_t i = 0; i < cell.size(); ++i) {
      if (worst.range.slopes[i].lo == worst.range.slopes[i].hi) continue;
      double& finer = out_.finer[i][cell[i]];
      finer = std::max(finer, worst.bound_n / wanted_n_);
    }
  }

  /// Encloses the force in the box.
  void lookAt(Box& box, const std::vector<std::size_t>& cell) {
    ++looks_;
    findMemberships(box, cell.size());
    box.range = enclosure_.enclose(rules_, memberships_);
    box.looked_at = true;
    box.jumps = box.range.fires && !box.range.smooth;
    bound(box, cell);
  }

  /// Bounds the error in the box by what is known of the force there.
  void bound(Box& box, const std::vector<std::size_t>& cell) {
    double off_n = 0;
    for (std::size_t c = 0; c < box.force_n.size(); ++c)
      off_n = std::max(off_n, std::abs(box.force_n[c] - box.table_n[c]));
    const auto [table_lo, table_hi] = std::minmax_element(box.table_n.begin(), box.table_n.end());
    box.bound_n = std::max(box.range.force_n.hi - *table_lo, *table_hi - box.range.force_n.lo);
    box.longest_share = 0;
    double rest_n = 0;
    for (std::size_t i = 0; i < cell.size(); ++i) {
      const double width = box.hi[i] - box.lo[i];
      const double slope = box.range.slopes[i].hi - box.range.slopes[i].lo;
      double share = slope * width;
      if (box.jumps) share = isFlat(i) ? 0 : width / (table_.lines[i][cell[i] + 1] - table_.lines[i][cell[i]]);
      rest_n += slope * width / 4;
      if (share <= box.longest_share) continue;
      box.longest_share = share;
      box.longest = i;
    }
    if (!box.jumps) {
      box.bound_n = std::min(box.bound_n, off_n + rest_n);
      out_.found_n = std::max(out_.found_n, off_n);
      enough_n_ = std::max(enough_n_, kSharp * off_n);
    }
  }

  void keep(Box box) {
    open_.push_back(std::move(box));
    std::push_heap(open_.begin(), open_.end(), isBetter);
  }

  bool isFlat(std::size_t input) const {
    for (std::size_t b = 0; b < enclosure_.banks().size(); ++b) {
      if (enclosure_.banks()[b].input != input) continue;
      for (const Membership& one : memberships_[b]) {
        if (one.slope.lo != 0 || one.slope.hi != 0 || one.jumps) return false;
      }
    }
    return true;
  }

  Box rootOf(const std::vector<std::size_t>& cell, bool inside) const {
    const std::size_t inputs = cell.size();
    Box box;
    for (std::size_t i = 0; i < inputs; ++i) {
      box.lo[i] = table_.lines[i][cell[i]];
      box.hi[i] = table_.lines[i][cell[i] + 1];
    }
    std::array<double, fuzzy::kMostInputs> point{};
    for (std::size_t c = 0; c < (std::size_t{1} << inputs); ++c) {
      std::size_t node = 0;
      for (std::size_t i = 0; i < inputs; ++i) {
        const bool upper = (c >> i & 1U) != 0;
        node = node * table_.lines[i].size() + cell[i] + (upper ? 1 : 0);
        const double step = kInside * (box.hi[i] - box.lo[i]);
        point[i] = upper ? box.hi[i] - step : box.lo[i] + step;
      }
      box.table_n.push_back(table_.force_n[node]);
      if (!inside) {
        for (std::size_t i = 0; i < inputs; ++i) point[i] = (c >> i & 1U) != 0 ? box.hi[i] : box.lo[i];
      }
      box.force_n.push_back(forceAt(point, inputs));
    }
    return box;
  }

  double forceAt(const std::array<double, fuzzy::kMostInputs>& point, std::size_t inputs) const {
    return compiled_.evaluate({point.data(), inputs}).force_n;
  }

  void split(Box box, const std::vector<std::size_t>& cell) {
    const std::size_t input = box.longest;
    const double middle = box.lo[input] + (box.hi[input] - box.lo[input]) / 2;
    Box lower = box;
    lower.hi[input] = middle;
    box.lo[input] = middle;
    std::array<double, fuzzy::kMostInputs> point{};
    const std::size_t bit = std::size_t{1} << input;
    for (std::size_t c = 0; c < box.force_n.size(); ++c) {
      if ((c & bit) != 0) continue;
      for (std::size_t i = 0; i < cell.size(); ++i) point[i] = (c >> i & 1U) != 0 ? box.hi[i] : box.lo[i];
      const double force_n = forceAt(point, cell.size());
      const double table_n = (box.table_n[c] + box.table_n[c | bit]) / 2;
      lower.force_n[c | bit] = box.force_n[c] = force_n;
      lower.table_n[c | bit] = box.table_n[c] = table_n;
    }
    for (Box* const half : {&box, &lower}) {
      half->looked_at = false;
      // Beside a jump nothing is known of a part before it is looked at.
      if (half->jumps) {
        lookAt(*half, cell);
      } else {
        bound(*half, cell);
      }
      keep(std::move(*half));
    }
  }

  const fuzzy::CompiledModel& compiled_;
  const ForceTable& table_;
  const ForceEnclosure& enclosure_;
  double wanted_n_;
  double enough_n_;
  std::size_t most_looks_;
  std::size_t looks_ = 0;
  TableBound out_;
  std::vector<Box> open_;  ///< a heap, the worst first
  std::vector<std::vector<Membership>> memberships_;
  ForceEnclosure::Cell rules_;
};

/// What is known of the lines of one input.
struct AxisLook {
  std::vector<bool> skipped;  ///< a cell in which no membership changes: it is the edge of a neighbor
  bool jumps = false;         ///< at a line or between two
};

AxisLook lookAlong(const ForceEnclosure& enclosure, std::size_t input, const std::vector<double>& line) {
  AxisLook out;
  std::vector<bool> flat(line.size() - 1, true);
  std::vector<bool> jump_at(line.size(), false);
  for (const Bank& bank : enclosure.banks()) {
    if (bank.input != input) continue;
    for (const MembershipFunction& term : bank.terms) {
      for (std::size_t k = 0; k + 1 < line.size(); ++k) {
        const Membership one = over(term, line[k], line[k + 1]);
        flat[k] = flat[k] && one.slope.lo == 0 && one.slope.hi == 0 && !one.jumps;
        out.jumps = out.jumps || one.jumps;
      }
      for (std::size_t k = 1; k + 1 < line.size() && !term.gaussian; ++k)
        jump_at[k] = jump_at[k] || fromTheLeft(term, line[k]) != fromTheRight(term, line[k]);
    }
  }
  out.jumps = out.jumps || std::find(jump_at.begin(), jump_at.end(), true) != jump_at.end();
  for (std::size_t k = 0; k < flat.size(); ++k) {
    const bool beside = (k > 0 && !flat[k - 1]) || (k + 1 < flat.size() && !flat[k + 1]);
    out.skipped.push_back(flat[k] && beside && !jump_at[k] && !jump_at[k + 1]);
  }
  return out;
}

void merge(TableBound& all, const TableBound& one) {
  all.bound_n = std::max(all.bound_n, one.bound_n);
  all.found_n = std::max(all.found_n, one.found_n);
  all.jumps = all.jumps || one.jumps;
  for (std::size_t i = 0; i < all.finer.size(); ++i) {
    for (std::size_t k = 0; k < all.finer[i].size(); ++k) all.finer[i][k] = std::max(all.finer[i][k], one.finer[i][k]);
  }
}

}  // namespace

TableBound tableBound(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled, const ForceTable& table,
                      double wanted_n, const std::stop_token& stop) {
  const ForceEnclosure enclosure(model);
  std::vector<std::vector<std::size_t>> cells;  // of each input
  bool inside = false;
  std::size_t slabs_along = 0;
  for (std::size_t i = 0; i < table.lines.size(); ++i) {
    const AxisLook axis = lookAlong(enclosure, i, table.lines[i]);
    inside = inside || axis.jumps;
    auto& own = cells.emplace_back();
    for (std::size_t k = 0; k < axis.skipped.size(); ++k) {
      if (!axis.skipped[k]) own.push_back(k);
    }
    if (own.size() > cells[slabs_along].size()) slabs_along = i;
  }
  TableBound out;
  for (const auto& line : table.lines) out.finer.emplace_back(line.size() - 1, 1.0);
  const std::size_t slabs = cells[slabs_along].size();
  const std::size_t most_looks = kMostLooks / std::max<std::size_t>(1, enclosure.experts() * slabs);
  // Each slab for itself, so that the result does not depend on how many are looked at at once.
  const auto slab = [&](std::size_t number) {
    CellSearch search(compiled, table, enclosure, wanted_n, most_looks);
    auto own = cells;
    own[slabs_along] = {cells[slabs_along][number]};
    std::vector<std::size_t> index(own.size(), 0);
    std::vector<std::size_t> cell(own.size());
    for (bool more = true; more && !stop.stop_requested();) {
      for (std::size_t i = 0; i < own.size(); ++i) cell[i] = own[i][index[i]];
      search.look(cell, inside);
      more = false;
      for (std::size_t i = own.size(); i-- > 0 && !more;) {
        more = ++index[i] < own[i].size();
        if (!more) index[i] = 0;
      }
    }
    return std::move(search).result();
  };
  std::vector<TableBound> found(slabs);
  base::inParallel(slabs, std::thread::hardware_concurrency(),
                   [&](std::size_t number) { found[number] = slab(number); });
  for (const TableBound& one : found) merge(out, one);
  return out;
}

}  // namespace tactus::bundle
