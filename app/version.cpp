#include "app/version.h"

#include "version_text.h"

namespace tactus {

constinit const std::string_view kVersion = TACTUS_VERSION_TEXT;
constinit const std::string_view kGenerator = "tactus " TACTUS_VERSION_TEXT;

}  // namespace tactus
