// What a message offers to do about it, for controllers and views alike.
#pragma once

#include <QString>
#include <functional>

namespace tactus::workbench {

/// The button of a message; without text there is none.
struct MessageAct {
  QString text;  ///< a verb, as in "Save elsewhere…"
  std::function<void()> run;
};

}  // namespace tactus::workbench
