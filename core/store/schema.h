// The schema of study files, version by version: core/store/schema.
#pragma once

#include <span>
#include <string_view>

#include "core/store/migrations.h"

namespace tactus::store {

/// The steps to the newest version known to this program.
std::span<const Migration> schemaSteps();

/// SQL that lets a connection read version 1 or 2 like version 3, and version 3 like the newest one, and the views of
/// the newest version for this connection only. Neither changes the file.
std::string_view readingVersion1();
std::string_view readingVersion2();
std::string_view readingVersion3();
std::string_view readingVersion4();
std::string viewsForReading();

}  // namespace tactus::store
