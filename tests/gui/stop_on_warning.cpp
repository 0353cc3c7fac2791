#include "tests/gui/stop_on_warning.h"

#include <QString>
#include <QtGlobal>
#include <cstdio>
#include <cstdlib>

namespace tactus::tests {
namespace {

// The offscreen platform says this of every window with a size limit, and of every popup.
constexpr const char* kExpected[] = {"This plugin does not support propagateSizeHints()",
                                     "This plugin does not support raise()",
                                     "This plugin does not support grabbing the keyboard"};

void stopOnWarning(QtMsgType type, const QMessageLogContext& /*context*/, const QString& message) {
  for (const char* expected : kExpected) {
    if (message == QLatin1String(expected)) return;
  }
  std::fprintf(stderr, "Qt: %s\n", qPrintable(message));
  if (type != QtDebugMsg && type != QtInfoMsg) std::abort();
}

}  // namespace

void stopOnWarnings() { qInstallMessageHandler(stopOnWarning); }

}  // namespace tactus::tests
