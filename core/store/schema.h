// The schema of study files, version by version: core/store/schema.
#pragma once

#include <span>

#include "core/store/migrations.h"

namespace tactus::store {

/// The steps to the newest version that this program knows.
std::span<const Migration> schemaSteps();

}  // namespace tactus::store
