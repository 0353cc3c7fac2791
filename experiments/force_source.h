// What the device does to the hand during a step of an experiment.
#pragma once

#include <string_view>

namespace tactus::experiments {

enum class ForceSource {
  kOff,       ///< no force
  kStimulus,  ///< a constant force against the hand
};

/// `off`, `stimulus`.
constexpr std::string_view name(ForceSource source) noexcept {
  return source == ForceSource::kOff ? "off" : "stimulus";
}

}  // namespace tactus::experiments
