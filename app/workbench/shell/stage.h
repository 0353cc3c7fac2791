// The stages of the research mode, in the order in which a study goes through them.
#pragma once

#include <QString>
#include <array>

namespace tactus::workbench {

enum class Stage { kCollect, kUnderstand, kTune, kAgree, kDeliver };

inline constexpr std::array<Stage, 5> kStages = {Stage::kCollect, Stage::kUnderstand, Stage::kTune, Stage::kAgree,
                                                 Stage::kDeliver};

/// The name in settings; never translated.
QString stageId(Stage stage);
QString stageName(Stage stage);
/// The task of the stage in a few words.
QString stageHint(Stage stage);

}  // namespace tactus::workbench
