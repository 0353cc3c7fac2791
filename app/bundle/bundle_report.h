// The report of a bundle: what the simulator team must know of the model, on two printed pages.
#pragma once

#include <string>

#include "core/fuzzy/force_model.h"
#include "core/model_io/bundle_manifest.h"

namespace tactus::bundle {

/// The page. `manifest`: with the files so far. `model` must be valid.
std::string bundleReport(const fuzzy::ForceModel& model, const model_io::BundleManifest& manifest);

}  // namespace tactus::bundle
