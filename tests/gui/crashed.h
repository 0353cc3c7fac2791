// What a process leaves behind that is killed while it edits.
#pragma once

#include <QString>

namespace tactus::tests {

/// A copy of the autosave folder `folder` beside it, as if its process had died: its lock names a process that is gone.
QString crashedCopy(const QString& folder);

}  // namespace tactus::tests
