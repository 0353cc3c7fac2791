// One piece of work for each of many subjects, on two processors.
#pragma once

#include <cstddef>
#include <functional>

namespace tactus::workbench {

/// Calls `work` for 0 to count - 1, in this thread and one more if there is a second processor: the window waits for
/// the result, so one is free. `keep_going` is called in this thread, between two pieces, with the share that is done;
/// false stops. Returns whether it came to the end.
bool sideBySide(std::size_t count, const std::function<void(std::size_t)>& work,
                const std::function<bool(double share)>& keep_going);

}  // namespace tactus::workbench
