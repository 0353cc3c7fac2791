// The schema of study files, version by version: core/store/schema.
#pragma once

#include <span>
#include <string_view>

#include "core/store/migrations.h"

namespace tactus::store {

/// The steps to the newest version that this program knows.
std::span<const Migration> schemaSteps();

/// SQL that lets a connection read version 1 as if it were the newest one, and the views of the newest version for this
/// connection alone: nothing in the file is changed.
std::string_view readingVersion1();
std::string viewsForReading();

}  // namespace tactus::store
