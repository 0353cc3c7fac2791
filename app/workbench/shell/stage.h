// The stages of the research mode, in the order in which a study goes through them.
#pragma once

#include <QString>
#include <array>

namespace tactus::workbench {

enum class Stage { kCollect, kBuild, kUnderstand, kTune, kDeliver };

inline constexpr std::array<Stage, 5> kStages = {Stage::kCollect, Stage::kBuild, Stage::kUnderstand, Stage::kTune,
                                                 Stage::kDeliver};

/// The name in settings; never translated.
QString stageId(Stage stage);
QString stageName(Stage stage);
/// The task of the stage in a few words.
QString stageHint(Stage stage);

}  // namespace tactus::workbench
