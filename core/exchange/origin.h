// Where an exported file comes from, as its first lines say.
#pragma once

#include <string>

namespace tactus::exchange {

/// Of the model file that is exported. The same model and the same program give the same text: the time is that of the
/// model, not of the export.
struct Origin {
  std::string model_sha256;  ///< of the bytes of the model file; empty: the exported file says nothing
  std::string model_utc;     ///< when the model was written; may be empty
  std::string program;       ///< that exports, with its version
};

/// `Model SHA-256 5f…, of 2026-11-21T08:00:00Z; exported by tactus 0.2.0`; empty where nothing is known.
inline std::string originText(const Origin& origin) {
  if (origin.model_sha256.empty()) return {};
  return "Model SHA-256 " + origin.model_sha256 + (origin.model_utc.empty() ? "" : ", of " + origin.model_utc) +
         "; exported by " + origin.program;
}

}  // namespace tactus::exchange
