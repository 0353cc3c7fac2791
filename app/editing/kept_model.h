// A model in the history. Experts that an edit did not change share their memory with the previous state.
#pragma once

#include <cstddef>
#include <memory>
#include <unordered_set>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::editing {

class KeptModel {
 public:
  /// Keeps `model`. An expert that is bit for bit the same in `like`, at the same index, is shared. `like` may be null.
  KeptModel(const fuzzy::ForceModel& model, const KeptModel* like);

  /// The model, bit for bit.
  fuzzy::ForceModel restored() const;

  /// The approximate bytes of the model without the experts in `counted`; adds its experts to `counted`.
  std::size_t bytes(std::unordered_set<const fuzzy::Expert*>& counted) const;

 private:
  fuzzy::ForceModel rest_;  ///< the model without experts
  std::vector<std::shared_ptr<const fuzzy::Expert>> experts_;
};

}  // namespace tactus::editing
