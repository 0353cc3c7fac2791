// The averaged model of the open study with the labs' settings, and everything that led to it.
#pragma once

#include <memory>
#include <stop_token>

#include "app/workbench/base/computed.h"
#include "app/workbench/labs/data/lab_data.h"

namespace tactus::workbench {

/// `settings`, with which a clustering ends early if `stop` asks for it.
elicitation::BuildSettings stoppable(elicitation::BuildSettings settings, const std::stop_token& stop);

/// Keeps `cell` at the study and the settings of `data`.
void followLabData(Computation& cell, LabData& data);

/// What computations that compare forces begin with.
struct BuiltStudy {
  std::shared_ptr<const elicitation::BuiltModel> model;
  std::shared_ptr<const LabStudy> study;  ///< that the model was made from
  elicitation::BuildSettings settings;    ///< that made it
};

/// The newest build stays while another one runs. Thread: gui.
class LabModel : public Computed<LabInputs, BuiltStudy> {
 public:
  /// `data` outlives this.
  explicit LabModel(LabData& data, QObject* parent = nullptr);

  /// Null if there is no model, or it cannot be built.
  std::shared_ptr<const elicitation::BuiltModel> built() const { return value() ? value()->model : nullptr; }
  /// The model with what made it; nothing: none.
  std::optional<BuiltStudy> inputs() const { return value() ? std::optional(*value()) : std::nullopt; }
};

}  // namespace tactus::workbench
