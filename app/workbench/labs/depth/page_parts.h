// What the pages beside the image have in common: a field with its name and the plot's menu, and words below.
#pragma once

#include <QString>

class QHBoxLayout;
class QLabel;
class QWidget;

namespace tactus::workbench {

/// `name` and `field` at the left, `menu` at the right. The name's mnemonic leads to the field.
QHBoxLayout* pageHead(const QString& name, QWidget* field, QWidget* menu);

/// Muted words on as many lines as they need.
QLabel* mutedWords(const QString& words, QWidget* parent);

}  // namespace tactus::workbench
