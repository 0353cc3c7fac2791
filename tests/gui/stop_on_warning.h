// Qt's warnings in tests: any of them ends the run.
#pragma once

namespace tactus::tests {

/// Installs the message handler. Call before the application is made.
void stopOnWarnings();

}  // namespace tactus::tests
