// Secondary text: small, in the muted ink of the theme.
#pragma once

class QWidget;

namespace tactus::workbench {

/// Gives `label`, a widget that shows text, the font and color of secondary text.
void setMuted(QWidget& label);

}  // namespace tactus::workbench
