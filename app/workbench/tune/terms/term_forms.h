// Small forms for a whole term: split it, or remove it together with its rules.
#pragma once

#include <string>

class QWidget;

namespace tactus::workbench {

class TermController;

/// Asks below `anchor` for the cuts, then splits the term. `terms` outlives `parent`.
void askSplit(TermController& terms, const std::string& term, const QWidget& anchor, QWidget* parent);
/// Removes the term. Asks first if rules name it.
void askRemove(TermController& terms, const std::string& term, const QWidget& anchor, QWidget* parent);

}  // namespace tactus::workbench
