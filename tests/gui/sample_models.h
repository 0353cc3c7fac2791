// Files of small models whose forces can be worked out by hand.
#pragma once

#include <QString>
#include <QTemporaryDir>

#include "app/editing/membership_edits.h"
#include "core/fuzzy/force_model.h"

#include "tests/support/two_experts.h"

namespace tactus::tests {

/// The inputs of these models, in their order.
inline constexpr std::size_t kSpeed = 0;
inline constexpr std::size_t kDepth = 1;

/// The vertex where "near" begins to fall.
inline const editing::VertexPlace kNearShoulder{{"depth", ""}, "near", 2};

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
