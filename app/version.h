// The version of the programs.
#pragma once

#include <string_view>

namespace tactus {

/// `0.2.0` of a release; `0.2.0+g5f045c3d` of a commit, with `.dirty` where a file differs from it.
extern const std::string_view kVersion;
/// `tactus ` and the version: what a file says about the program that wrote it.
extern const std::string_view kGenerator;

}  // namespace tactus
