// What a process leaves behind that is killed while it edits.
#pragma once

#include <QString>

namespace tactus::tests {

/// A copy of the autosave folder `root` beside it, as if the process that writes there had died: history files with
/// their journals.
QString crashedCopy(const QString& root);

}  // namespace tactus::tests
