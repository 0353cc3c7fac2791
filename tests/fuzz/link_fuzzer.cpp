#include "tests/fuzz/link_fuzzer.h"

#include "tests/app/link/session_drive.h"

namespace tactus::fuzz {

void fuzzLink(std::string_view bytes) { link::driveSession(bytes); }

}  // namespace tactus::fuzz
