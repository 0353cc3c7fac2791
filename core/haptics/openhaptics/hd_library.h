// The OpenHaptics HD library, loaded at run time: Tactus is built without it and works without it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/haptics/openhaptics/hd_api.h"

namespace tactus::haptics {

/// A loaded library. It stays in the process for ever: libHD cannot be loaded a second time after it was closed.
/// Thread: any.
class HdLibrary {
 public:
  /// Loads `path`, or without one the first of `defaultNames` that the loader of the system finds. Refused, with what
  /// was tried and what to install or set: no such library, one of its own libraries missing, functions missing.
  static base::Result<std::shared_ptr<const HdLibrary>> load(const std::string& path = {});

  /// The names that are tried, in this order.
  static const std::vector<std::string>& defaultNames();

  const HdApi& api() const noexcept { return api_; }
  /// The name or path it was loaded by.
  const std::string& path() const noexcept { return path_; }

 private:
  HdLibrary() = default;

  HdApi api_;
  std::string path_;
};

/// What the driver's environment lacks, as far as it can be seen from outside: the sentence names GTDD_HOME, the folder
/// of the device's configuration. Empty when the folder that GTDD_HOME names is there.
std::string hdEnvironmentAdvice();

}  // namespace tactus::haptics
