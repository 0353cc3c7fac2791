// Small models whose forces can be worked out by hand, and files of them.
#pragma once

#include <QString>
#include <QTemporaryDir>

#include "core/fuzzy/force_model.h"

namespace tactus::tests {

/// Inputs speed [0, 100] mm/s (slow, fast; they cross at 50) and depth [0, 10] mm (near until 5, far from 6 on, nothing
/// between). The output terms low and high are rectangles with the centroids 0.25 N and 0.75 N, whatever clips them.
/// Expert A: near and slow -> low, near and fast -> high, far -> high. Expert B: far -> low. B has a list of its own
/// for speed.
fuzzy::ForceModel twoExperts();

/// Writes models into a folder that is removed in the end.
class ModelFolder {
 public:
  /// Path of a file with `model`.
  QString write(const fuzzy::ForceModel& model, const QString& name = QStringLiteral("sample.tactus.json")) const;
  QString writeText(const QByteArray& text, const QString& name) const;
  QString path(const QString& name) const { return folder_.filePath(name); }

 private:
  QTemporaryDir folder_;
};

}  // namespace tactus::tests
