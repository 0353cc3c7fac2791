// The simulated study as elicitation sees it.
#pragma once

#include <cstdint>
#include <string>

#include "app/session/simulated_study.h"
#include "app/session/study_view.h"
#include "core/base/check.h"

#include "tests/support/temp_folder.h"

namespace tactus::support {

/// What is read from the study file of session::makeSimulatedNgtStudy, made in a temporary folder. Takes seconds.
inline study::Study simulatedNgtStudy(std::uint64_t seed, const std::string& reading = "ngt-a2-five-regions") {
  const TempFolder folder;
  const auto file = session::makeSimulatedNgtStudy(folder.file("study.tactus"), seed, reading);
  TACTUS_CHECK(file.has_value());
  auto view = session::studyForElicitation(*file);
  TACTUS_CHECK(view.has_value());
  return std::move(view->study);
}

}  // namespace tactus::support
