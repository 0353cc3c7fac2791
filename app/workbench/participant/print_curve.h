// Prints the force–depth curve of one participant on the default printer, without a dialog.
#pragma once

namespace tactus::workbench {

namespace nurse {
class ForceCurve;
}

bool canPrint();
/// A page with the curve; nothing without a printer.
void printCurve(const nurse::ForceCurve& curve);

}  // namespace tactus::workbench
