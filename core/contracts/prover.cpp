#include "core/contracts/prover.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace tactus::contracts {
namespace {

constexpr std::size_t kPartsOfACell = 20'000;
constexpr double kSmallestFlank = 1e-9;  // of a membership: parts are not divided below

class Prover {
 public:
  Prover(const ProofTask& task, std::size_t parts, const std::stop_token& stop)
      : task_(task), sum_(task.copies, task.ranges), most_parts_(parts), stop_(stop) {}

  Proof run() {
    const bool all_fire = sum_.allFireEverywhere();
    std::vector<std::vector<Stretch>> stretches;
    for (std::size_t v = 0; v < sum_.variableCount(); ++v) {
      stretches.push_back(sum_.stretches(v));
      // A vertex between two open stretches adds nothing where the force is continuous there.
      std::erase_if(stretches.back(), [&](const Stretch& one) {
        return one.low == one.high && task_.ranges[v].low < task_.ranges[v].high && all_fire &&
               !sum_.jumpsAt(v, one.low);
      });
      if (task_.along == v) {
        const auto is_jump = [&](const Stretch& one) { return one.low == one.high && sum_.jumpsAt(v, one.low); };
        out_.jumps = std::any_of(stretches.back().begin(), stretches.back().end(), is_jump);
      }
    }
    std::vector<std::size_t> at(stretches.size(), 0);
    std::vector<Stretch> cell(stretches.size());
    while (!out_.found) {
      if (out_.parts >= most_parts_ || stop_.stop_requested()) {
        out_.complete = false;
        break;
      }
      for (std::size_t v = 0; v < cell.size(); ++v) cell[v] = stretches[v][at[v]];
      if (!sum_.enter(cell)) {
        out_.too_many = true;
        break;
      }
      if (task_.along && !all_fire) noteFiring(at);
      takeCell();
      std::size_t v = 0;
      while (v < at.size() && ++at[v] == stretches[v].size()) at[v++] = 0;
      if (v == at.size()) break;
    }
    if (!task_.along) out_.bounded = true;  // values always have bounds, slopes may have none
    out_.proved = !out_.found && !out_.too_many && !out_.jumps && out_.complete && out_.bounded && out_.largest <= 0;
    return out_;
  }

 private:
  /// Along the variable of the slopes the same experts must fire.
  void noteFiring(std::vector<std::size_t> at) {
    at[*task_.along] = 0;
    const auto [known, is_new] = firing_.emplace(std::move(at), sum_.firing());
    if (!is_new && known->second != sum_.firing()) out_.jumps = true;
  }

  void leaveOpen(const PartBounds& bounds, double excess) {
    out_.largest = std::max(out_.largest, excess);
    out_.bounded = out_.bounded && bounds.bounded;
  }

  void takeCell() {
    std::vector<Part> parts = {sum_.whole()};
    std::size_t used = 0;
    while (!parts.empty()) {
      Part part = std::move(parts.back());
      parts.pop_back();
      const auto bounds = sum_.bounds(part);
      ++out_.parts;
      ++used;
      if (!bounds) continue;
      const double excess = task_.excess(*bounds);
      if (excess <= 0) continue;
      const bool may_look = bounds->widest_by < 0.25 || bounds->widest_by < kSmallestFlank;
      if (task_.look && may_look && (looks_ < 64 || used % 256 == 0) && !bounds->undecided) {
        ++looks_;
        if (task_.look(part.box)) {
          out_.found = true;
          return;
        }
      }
      const bool stop = used >= kPartsOfACell || out_.parts >= most_parts_ || stop_.stop_requested();
      if (stop || (!bounds->undecided && bounds->widest_by < kSmallestFlank)) {
        leaveOpen(*bounds, excess);
        continue;
      }
      divide(part, *bounds, parts);
    }
  }

  void divide(Part& part, const PartBounds& bounds, std::vector<Part>& parts) const {
    const bool by_order = bounds.undecided && (task_.split == Split::kOrders || bounds.widest_by < 0.05);
    Part other = part;
    if (by_order || (bounds.undecided && bounds.widest_by < kSmallestFlank)) {
      const auto [a, b] = *bounds.undecided;
      part.orders.emplace_back(a, b);
      other.orders.emplace_back(b, a);
    } else {
      std::size_t along = bounds.widest;
      if (task_.split == Split::kRanges && bounds.bounded) {
        double most = 0;
        for (std::size_t v = 0; v < sum_.variableCount(); ++v) {
          const double by =
              std::max(std::abs(bounds.slope[v].low), std::abs(bounds.slope[v].high)) * part.box[v].width();
          if (by > most) most = by, along = v;
        }
      }
      const double middle = part.box[along].middle();
      part.box[along].high = middle;
      other.box[along].low = middle;
    }
    parts.push_back(std::move(part));
    parts.push_back(std::move(other));
  }

  const ProofTask& task_;
  ForceSum sum_;
  std::size_t most_parts_;
  const std::stop_token& stop_;
  Proof out_;
  std::size_t looks_ = 0;
  std::map<std::vector<std::size_t>, std::vector<bool>> firing_;
};

}  // namespace

Proof prove(const ProofTask& task, std::size_t parts, const std::stop_token& stop) {
  return Prover(task, parts, stop).run();
}

std::vector<std::size_t> plainVariables(std::size_t count) {
  std::vector<std::size_t> out(count);
  std::iota(out.begin(), out.end(), std::size_t{0});
  return out;
}

}  // namespace tactus::contracts
