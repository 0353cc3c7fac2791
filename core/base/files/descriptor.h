// A file descriptor that closes itself.
#pragma once

#include <unistd.h>
#include <utility>

namespace tactus::base {

class Descriptor {
 public:
  /// Takes ownership of the descriptor `number`; negative: none.
  explicit Descriptor(int number = -1) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    if (this != &other) {
      close();
      number_ = std::exchange(other.number_, -1);
    }
    return *this;
  }

  int number() const { return number_; }
  bool isOpen() const { return number_ >= 0; }
  /// Closes the descriptor. Returns false if the system reports a failed write.
  bool close() {
    const int open_number = std::exchange(number_, -1);
    return open_number < 0 || ::close(open_number) == 0;
  }

 private:
  int number_;
};

}  // namespace tactus::base
