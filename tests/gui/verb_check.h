// Whether what can be pressed, chosen or typed into says what it does: its words begin with a verb.
#pragma once

#include <QStringList>

class QMenu;
class QWidget;

namespace tactus::tests {

/// The entries of `menu` and of the menus in it that begin with no verb, one line each. What is one of several choices,
/// or on or off, is named by what it is and left out.
QStringList entriesWithoutVerb(const QMenu& menu);

/// The same for the words of the buttons in `part` that are on the screen.
QStringList buttonsWithoutVerb(const QWidget& part);

/// The same for the hints (tool tips and placeholders) in `part` of what can be pressed, chosen or typed into.
QStringList hintsWithoutVerb(const QWidget& part);

}  // namespace tactus::tests
