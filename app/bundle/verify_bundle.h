// The work of `tactus verify`: reads a bundle back and compares each of its files with its model.
#pragma once

#include <string>
#include <string_view>

#include "core/model_io/bundle_check.h"

namespace tactus::bundle {

/// Calls model_io::checkBundle. Then reads the look-up table and compares it with the model, and measures the errors of
/// the files for other programs again. If `generator` (this program and version) wrote the bundle, their texts and the
/// C source must be equal to the ones that this program writes for the model. Texts of another version are compared by
/// their checksums alone. A zip file (zip.h) is unpacked beside the other temporary files first.
base::Result<model_io::BundleCheck> verifyBundle(const std::string& path, std::string_view generator);

}  // namespace tactus::bundle
