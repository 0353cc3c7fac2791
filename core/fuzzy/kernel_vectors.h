// Arithmetic on several numbers at once. Part of kernel_source.h.

/// Several numbers side by side, in registers of kWidth doubles.
constexpr int kWidth = TACTUS_KERNEL_WIDTH;
using Register = double __attribute__((vector_size(kWidth * sizeof(double)), may_alias));
using Bits = long long __attribute__((vector_size(kWidth * sizeof(double))));

template <int count>
struct Pack {
  static constexpr int kParts = count / kWidth;
  Register part[kParts];
};

/// Evaluates the expression for each register `i` of the result.
#define TACTUS_EACH_PART(expression)                                                                 \
  Pack<count> out;                                                                                   \
  _Pragma("GCC unroll 16") for (int i = 0; i < Pack<count>::kParts; ++i) out.part[i] = (expression); \
  return out

#define TACTUS_INLINE [[gnu::always_inline]] inline

template <int count>
TACTUS_INLINE Pack<count> spread(double x) noexcept {
  TACTUS_EACH_PART(x - Register{});  // gives x itself; x + 0 would cost an addition, because it turns -0 into 0
}
template <int count>
TACTUS_INLINE Pack<count> load(const double* from) noexcept {
  TACTUS_EACH_PART(([&] {
    Register r;
    __builtin_memcpy(&r, from + i * kWidth, sizeof r);
    return r;
  }()));
}
template <int count>
TACTUS_INLINE void store(double* to, const Pack<count>& x) noexcept {
  _Pragma("GCC unroll 16") for (int i = 0; i < Pack<count>::kParts; ++i) {
    __builtin_memcpy(to + i * kWidth, &x.part[i], sizeof(Register));
  }
}
template <int count>
TACTUS_INLINE Pack<count> operator+(const Pack<count>& x, const Pack<count>& y) noexcept {
  TACTUS_EACH_PART(x.part[i] + y.part[i]);
}
template <int count>
TACTUS_INLINE Pack<count> operator-(const Pack<count>& x, const Pack<count>& y) noexcept {
  TACTUS_EACH_PART(x.part[i] - y.part[i]);
}
template <int count>
TACTUS_INLINE Pack<count> operator*(const Pack<count>& x, const Pack<count>& y) noexcept {
  TACTUS_EACH_PART(x.part[i] * y.part[i]);
}
template <int count>
TACTUS_INLINE Pack<count> operator/(const Pack<count>& x, const Pack<count>& y) noexcept {
  TACTUS_EACH_PART(x.part[i] / y.part[i]);
}
template <int count>
TACTUS_INLINE Pack<count> operator*(const Pack<count>& x, double y) noexcept {
  TACTUS_EACH_PART(x.part[i] * y);
}
template <int count>
TACTUS_INLINE Pack<count> operator+(const Pack<count>& x, double y) noexcept {
  TACTUS_EACH_PART(x.part[i] + y);
}
template <int count>
TACTUS_INLINE Pack<count> operator-(const Pack<count>& x, double y) noexcept {
  TACTUS_EACH_PART(x.part[i] - y);
}
template <int count>
TACTUS_INLINE Pack<count> operator-(double x, const Pack<count>& y) noexcept {
  TACTUS_EACH_PART(x - y.part[i]);
}
/// The larger of x and y; y if x is NaN.
template <int count>
TACTUS_INLINE Pack<count> larger(const Pack<count>& x, const Pack<count>& y) noexcept {
  TACTUS_EACH_PART(x.part[i] > y.part[i] ? x.part[i] : y.part[i]);
}
/// The smaller of x and y; y if x is NaN.
template <int count>
TACTUS_INLINE Pack<count> smaller(const Pack<count>& x, const Pack<count>& y) noexcept {
  TACTUS_EACH_PART(x.part[i] < y.part[i] ? x.part[i] : y.part[i]);
}
TACTUS_INLINE double smaller(double x, double y) noexcept { return x < y ? x : y; }
/// x if it is positive, else 1. Used as a divisor.
template <int count>
TACTUS_INLINE Pack<count> positiveOrOne(const Pack<count>& x) noexcept {
  TACTUS_EACH_PART(x.part[i] > 0 ? x.part[i] : Register{} + 1.0);
}
