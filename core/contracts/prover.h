// Proves something about a sum of forces in every part of the input space, cell by cell.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/contracts/force_cells.h"

namespace tactus::contracts {

/// What a proof needs of a part: how far it is from being proved.
using Excess = std::function<double(const PartBounds&)>;

enum class Split { kOrders, kRanges };

struct ProofTask {
  std::vector<Copy> copies;
  std::vector<Interval> ranges;
  Excess excess;  ///< <= 0: the part is proved
  Split split = Split::kRanges;
  std::optional<std::size_t> along;  ///< the variable whose slope decides: the force must not jump along it
  /// Called with the middle of a part that is surely bad; true: a case was found there, the search ends.
  std::function<bool(const Box&)> look;
};

struct Proof {
  bool proved = false;
  bool found = false;
  double largest = 0;  ///< of the excess in what is not proved
  bool bounded = true;
  bool complete = true;  ///< all cells were looked at
  bool jumps = false;
  bool too_many = false;  ///< flanks in a cell
  std::size_t parts = 0;
};

/// Divides the cells until every part is proved, `parts` were bounded, or `stop` is requested. Deterministic.
Proof prove(const ProofTask& task, std::size_t parts, const std::stop_token& stop);

/// 0, 1, …: each input of a model as the variable of its number.
std::vector<std::size_t> plainVariables(std::size_t count);

}  // namespace tactus::contracts
