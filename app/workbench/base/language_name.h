// The languages of the nurse's screens by their own names.
#pragma once

#include <QString>

namespace tactus::workbench {

/// `English` for `en`, `繁體中文` for `zh-Hant`, `简体中文` for `zh-Hans`; another id as it is.
QString languageName(const QString& id);

}  // namespace tactus::workbench
