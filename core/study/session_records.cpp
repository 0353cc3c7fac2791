#include "core/study/session_records.h"

#include <chrono>

namespace tactus::study {

Moment momentNow() {
  using namespace std::chrono;
  return {duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count(),
          duration_cast<nanoseconds>(steady_clock::now().time_since_epoch()).count()};
}

}  // namespace tactus::study
