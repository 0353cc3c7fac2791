// The folder of a bundle that the user makes in the window.
#pragma once

#include <QString>

namespace tactus::workbench {

/// The folder of the bundle of the model file or study `model_path`, for the folder that the user chose: `chosen`
/// itself if it is empty or holds an earlier bundle, otherwise a folder `NAME-bundle` in it.
QString bundleFolder(const QString& chosen, const QString& model_path);

}  // namespace tactus::workbench
