// The demo: the paper's study with simulated nurses, from sessions to the exported model, as files in a folder.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace tactus::demo {

/// The study file, below the demo's folder.
inline constexpr std::string_view kStudyFile = "study/ngt-demo.tactus";

struct DemoSettings {
  std::string folder;
  std::optional<std::uint64_t> seed = {};  ///< of the simulated data; nothing: session::kDefaultSeed
  std::string reading = {};                ///< reading of Table A2; empty: the default
};

struct DemoFile {
  std::string path;  ///< below the demo's folder
  std::string holds;
};

struct DemoFolder {
  std::vector<DemoFile> files;
  std::vector<std::string> notes;  ///< of the build of the averaged model
};

/// The parts of the work, in their order.
enum class DemoPart { kSessions, kModel, kReport, kFiles };

/// Runs the whole elicitation on the published data and writes study, tables, models, scenarios, export and report into
/// `settings.folder`, each file whole or not at all. `begins` is called before each part.
/// Refused: an unknown reading, and a folder that holds other files than those of a demo. A demo's folder is written
/// again; the study in it keeps its mode.
base::Result<DemoFolder> writeDemo(const DemoSettings& settings, const std::function<void(DemoPart)>& begins = {});

}  // namespace tactus::demo
