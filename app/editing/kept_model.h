// A model kept in the history: experts that an edit left alone are shared with the state before it.
#pragma once

#include <cstddef>
#include <memory>
#include <unordered_set>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::editing {

class KeptModel {
 public:
  /// Keeps `model`. Experts that are the same bit for bit in `like`, at the same place, are shared; `like` may be null.
  KeptModel(const fuzzy::ForceModel& model, const KeptModel* like);

  /// The model as it was, bit for bit.
  fuzzy::ForceModel restored() const;

  /// About the bytes it holds beyond the experts in `counted`, which its own join.
  std::size_t bytes(std::unordered_set<const fuzzy::Expert*>& counted) const;

 private:
  fuzzy::ForceModel rest_;  ///< without experts
  std::vector<std::shared_ptr<const fuzzy::Expert>> experts_;
};

}  // namespace tactus::editing
