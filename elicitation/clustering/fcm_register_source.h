// Registers of the loops, and their logarithms and powers. Only fcm_kernel_source.h includes it, once per instruction
// set.

constexpr int kWidth = TACTUS_FCM_WIDTH;
constexpr int kShares = static_cast<int>(kFcmLanes) / kWidth;
using Register = double __attribute__((vector_size(kWidth * sizeof(double)), may_alias));
using Bits = unsigned long long __attribute__((vector_size(kWidth * sizeof(double))));
using Choice = long long __attribute__((vector_size(kWidth * sizeof(double))));  // of a comparison

#define TACTUS_INLINE [[gnu::always_inline]] inline
#define TACTUS_INLINED __attribute__((always_inline))  // of a lambda

TACTUS_INLINE Register spread(double x) noexcept { return Register{} + x; }
TACTUS_INLINE Register load(const double* from) noexcept {
  Register r;
  __builtin_memcpy(&r, from, sizeof r);
  return r;
}
TACTUS_INLINE void store(double* to, const Register& x) noexcept { __builtin_memcpy(to, &x, sizeof x); }
TACTUS_INLINE Register smaller(const Register& x, const Register& y) noexcept { return x < y ? x : y; }
TACTUS_INLINE Register larger(const Register& x, const Register& y) noexcept { return x > y ? x : y; }

constexpr double kRoundToInteger = 0x1.8p52;

/// c[0] + c[1] x + ... of two chains of half the length, which a processor computes side by side.
template <int count>
TACTUS_INLINE Register polynomial(const double (&c)[count], const Register& x) noexcept {
  const Register square = x * x;
  Register even = spread(c[(count - 1) / 2 * 2]);
  Register odd = spread(c[count / 2 * 2 - 1]);
#pragma GCC unroll 16
  for (int n = (count - 1) / 2 * 2 - 2; n >= 0; n -= 2) even = even * square + c[n];
#pragma GCC unroll 16
  for (int n = count / 2 * 2 - 3; n >= 1; n -= 2) odd = odd * square + c[n];
  return even + x * odd;
}

/// Logarithm to base 2 of a positive normal number: exponent and 2/ln 2 artanh((f - 1)/(f + 1)) of a mantissa f around
/// 1. The polynomial has the smallest largest error (Remez), 2.3e-18 of the result.
TACTUS_INLINE Register logarithm(const Register& x) noexcept {
  constexpr double kSeries[] = {0x1.ec709dc3a0435p-1, 0x1.2776c50eea858p-1, 0x1.a61762cecb807p-2, 0x1.484afd738c535p-2,
                                0x1.0ca125f770604p-2, 0x1.c472ede3fdc95p-3, 0x1.b59894815afc3p-3};
  constexpr unsigned long long kRootOfHalf = 0x3FE6A09E667F3BCDULL;
  constexpr unsigned long long kPositive = 1ULL << 63U;  // keeps what is shifted above 0
  Bits bits;
  __builtin_memcpy(&bits, &x, sizeof bits);
  const Bits shifted = (bits - kRootOfHalf + kPositive) >> 52U;  // the exponent + 2048
  const Bits mantissa = bits - ((shifted << 52U) - kPositive);
  const Bits counted = shifted + 0x4330000000000000ULL;  // as a double: 2^52 + 2048 + the exponent
  Register f, e;
  __builtin_memcpy(&f, &mantissa, sizeof f);
  __builtin_memcpy(&e, &counted, sizeof e);
  e -= 0x1p52 + 2048;
  const Register s = (f - 1.0) / (f + 1.0);
  const Register z = s * s;
  return e + (s * 0x1.71547652b82fep+1 + s * z * polynomial(kSeries, z));
}

/// 2^x for x <= 0; 0 below -1000. The polynomial for -1/2 to 1/2 is Remez's too, with an error of 3.4e-18.
TACTUS_INLINE Register powerOfTwo(const Register& x) noexcept {
  constexpr double kSeries[] = {0x1.62e42fefa39efp-1,  0x1.ebfbdff82c5a4p-3,  0x1.c6b08d7049fe8p-5,
                                0x1.3b2ab6fba011ap-7,  0x1.5d87fe78cd6d1p-10, 0x1.4309130ed8a6dp-13,
                                0x1.ffcbfba97f8afp-17, 0x1.62bfc79daa310p-20, 0x1.b5267ce43d1bbp-24,
                                0x1.e61b4efb4d864p-28, 0x1.e79baed8df3bdp-32};
  const Register safe = larger(x, spread(-1000.0));
  const Register turns = safe + kRoundToInteger;
  const Register t = safe - (turns - kRoundToInteger);
  Register out = t * polynomial(kSeries, t) + 1.0;
  Bits bits, steps;
  __builtin_memcpy(&bits, &out, sizeof bits);
  __builtin_memcpy(&steps, &turns, sizeof steps);
  bits += steps << 52U;  // the low bits of `turns` are the integer
  __builtin_memcpy(&out, &bits, sizeof out);
  return x < -1000.0 ? Register{} : out;
}
