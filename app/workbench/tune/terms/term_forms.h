// Small forms for what is done to a whole term: split it, or remove it together with its rules.
#pragma once

#include <string>

class QWidget;

namespace tactus::workbench {

class TermController;

/// Asks below `anchor` where to cut the term, and splits it. `terms` outlives `parent`.
void askSplit(TermController& terms, const std::string& term, const QWidget& anchor, QWidget* parent);
/// Removes the term; where rules name it, asks before.
void askRemove(TermController& terms, const std::string& term, const QWidget& anchor, QWidget* parent);

}  // namespace tactus::workbench
