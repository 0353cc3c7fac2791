// Copies and pastes rules as a block of text (app/editing/rule_grid.h).
#pragma once

#include <QString>

namespace tactus::workbench {

class EditController;
class Selection;

/// The selected rules as lines of text; empty if none is selected.
QString copiedRules(const EditController& edits, const Selection& selection);

/// Puts the rules of such text among those of the selected expert as one edit, and points at them. One line that is no
/// rule refuses all of them, with a sentence that names it.
void pasteRules(EditController& edits, Selection& selection, const QString& lines);

}  // namespace tactus::workbench
