// The OpenHaptics HD library, loaded at run time: Tactus is built without it and works without it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/haptics/openhaptics/hd_api.h"

namespace tactus::haptics {

/// A loaded library. It stays in the process forever, because libHD cannot be loaded again after closing. Thread: any.
class HdLibrary {
 public:
  /// Loads `path`, or, if it is empty, the first of `defaultNames` that the system's loader finds. Returns an error if
  /// the library, one of its own libraries, or a function is missing. The error names the attempts and the remedy.
  static base::Result<std::shared_ptr<const HdLibrary>> load(const std::string& path = {});

  /// The names to try, in this order.
  static const std::vector<std::string>& defaultNames();

  const HdApi& api() const noexcept { return api_; }
  /// The name or path from which it was loaded.
  const std::string& path() const noexcept { return path_; }

 private:
  HdLibrary() = default;

  HdApi api_;
  std::string path_;
};

/// Describes missing parts of the driver's environment, as far as visible from outside. The sentence names GTDD_HOME,
/// the folder of the device's configuration. Empty if the folder named by GTDD_HOME exists.
std::string hdEnvironmentAdvice();

}  // namespace tactus::haptics
