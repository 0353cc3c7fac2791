// `tactus verify`: a bundle read back as far as this program can.
#pragma once

#include <string>
#include <string_view>

#include "core/model_io/bundle_check.h"

namespace tactus::bundle {

/// model_io::checkBundle, and further: the look-up table is read and compared with the model, the errors of the files
/// for other programs are measured again, and their texts and the C source must be those that this program writes for
/// the model, if `generator` (this program and version) wrote the bundle. Texts of another version are compared by
/// their checksums alone.
base::Result<model_io::BundleCheck> verifyBundle(const std::string& folder, std::string_view generator);

}  // namespace tactus::bundle
