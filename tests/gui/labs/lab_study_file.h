// The demo's study, made once for all tests of the labs.
#pragma once

#include <QFile>
#include <QTemporaryDir>

#include "app/session/simulated_study.h"
#include "core/base/check.h"

namespace tactus::tests {

/// A copy of the demo's study in `folder`.
inline QString demoStudyIn(const QTemporaryDir& folder) {
  static const QTemporaryDir kept;
  static const QString made = [] {
    const QString path = kept.filePath(QStringLiteral("demo.tactus"));
    auto study = session::makeSimulatedNgtStudy(path.toStdString());
    TACTUS_CHECK(study.has_value());
    TACTUS_CHECK(study->close().has_value());
    return path;
  }();
  const QString path = folder.filePath(QStringLiteral("study.tactus"));
  TACTUS_CHECK(QFile::copy(made, path));
  return path;
}

}  // namespace tactus::tests
