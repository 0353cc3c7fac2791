#include "core/haptics/openhaptics/hd_library.h"

#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>

#include "core/base/text.h"

namespace tactus::haptics {
namespace {

constexpr const char* kPlace = "OpenHaptics library";

/// Looks up one function; notes the name of a missing one.
template <class Function>
void find(void* library, const char* name, Function& function, std::vector<std::string>& missing) {
  void* const symbol = dlsym(library, name);
  if (symbol == nullptr) missing.emplace_back(name);
  function = reinterpret_cast<Function>(symbol);
}

std::vector<std::string> findAll(void* library, HdApi& api) {
  std::vector<std::string> missing;
  find(library, "hdInitDevice", api.init_device, missing);
  find(library, "hdDisableDevice", api.disable_device, missing);
  find(library, "hdMakeCurrentDevice", api.make_current_device, missing);
  find(library, "hdBeginFrame", api.begin_frame, missing);
  find(library, "hdEndFrame", api.end_frame, missing);
  find(library, "hdGetError", api.get_error, missing);
  find(library, "hdGetErrorString", api.get_error_string, missing);
  find(library, "hdEnable", api.enable, missing);
  find(library, "hdDisable", api.disable, missing);
  find(library, "hdIsEnabled", api.is_enabled, missing);
  find(library, "hdGetString", api.get_string, missing);
  find(library, "hdGetIntegerv", api.get_integerv, missing);
  find(library, "hdGetDoublev", api.get_doublev, missing);
  find(library, "hdSetDoublev", api.set_doublev, missing);
  find(library, "hdCheckCalibration", api.check_calibration, missing);
  find(library, "hdUpdateCalibration", api.update_calibration, missing);
  find(library, "hdStartScheduler", api.start_scheduler, missing);
  find(library, "hdStopScheduler", api.stop_scheduler, missing);
  find(library, "hdSetSchedulerRate", api.set_scheduler_rate, missing);
  find(library, "hdScheduleAsynchronous", api.schedule_asynchronous, missing);
  find(library, "hdUnschedule", api.unschedule, missing);
  return missing;
}

std::string lastLoaderError() {
  const char* const text = dlerror();
  return base::oneLine(text == nullptr ? "no reason given" : text);
}

}  // namespace

const std::vector<std::string>& HdLibrary::defaultNames() {
  static const std::vector<std::string> names = {"libHD.so", "libHD.so.3.4"};
  return names;
}

base::Result<std::shared_ptr<const HdLibrary>> HdLibrary::load(const std::string& path) {
  const std::vector<std::string> names = path.empty() ? defaultNames() : std::vector<std::string>{path};
  std::vector<std::string> reasons;
  for (const auto& name : names) {
    // Global, because the driver's own libraries look for symbols of one another.
    void* const library = dlopen(name.c_str(), RTLD_NOW | RTLD_GLOBAL);
    if (library == nullptr) {
      reasons.push_back(lastLoaderError());
      continue;
    }
    std::shared_ptr<HdLibrary> loaded(new HdLibrary);
    loaded->path_ = name;
    const auto missing = findAll(library, loaded->api_);
    if (missing.empty()) return loaded;
    return base::fail(base::ErrorCode::kReference, kPlace, name + " without " + base::joined(missing, ", "),
                      "the HD library of OpenHaptics 3.4");
  }
  std::string wanted =
      "the OpenHaptics 3.4 runtime (libHD.so) and the Touch driver (libPhantomIOLib42.so) of 3D Systems";
  const std::string advice = hdEnvironmentAdvice();
  if (!advice.empty()) wanted += ", and " + advice;
  return base::fail(base::ErrorCode::kIo, kPlace,
                    "none that loads, tried " + base::joined(names, ", ") + " (" + base::joined(reasons, "; ") + ")",
                    wanted);
}

std::string hdEnvironmentAdvice() {
  const char* const home = std::getenv("GTDD_HOME");
  if (home == nullptr || *home == '\0')
    return "GTDD_HOME set to the folder of the device's configuration (the driver's default is ~/.3dsystems or "
           "/usr/share/3DSystems)";
  std::error_code ignored;
  if (std::filesystem::is_directory(home, ignored)) return {};
  return "the folder that GTDD_HOME names, " + base::quoted(home) + ", which is not there";
}

}  // namespace tactus::haptics
