/* A table of points of the NGT model: points COUNT > points.csv. Most are anywhere, up to a tenth outside the universes;
 * some stand on the grid of round numbers, where vertices and ends are. The same table on every machine. */
#include <stdio.h>
#include <stdlib.h>

/* The next of a fixed sequence of numbers in [0, 1): Knuth's 64-bit generator. */
static double next(unsigned long long *state) {
  *state = *state * 6364136223846793005ULL + 1442695040888963407ULL;
  return (double)(*state >> 11) / 9007199254740992.0;
}

int main(int argc, char **argv) {
  static const double kEnds[4] = {1, 90, 600, 400};
  static const double kGrid[4] = {0.1, 5, 5, 5};
  unsigned long long state = 7;
  const long count = argc == 2 ? strtol(argv[1], NULL, 10) : 0;
  long point;
  if (count <= 0) return 2;
  printf("lubrication,neck_flexion,depth,speed\n");
  for (point = 0; point < count; ++point) {
    const int round = point % 4 == 0;
    int i;
    for (i = 0; i < 4; ++i) {
      const double value = kEnds[i] * (1.2 * next(&state) - 0.1);
      const char *const separator = i < 3 ? "," : "\n";
      if (round)
        printf("%.1f%s", kGrid[i] * (double)(long)(value / kGrid[i]), separator);
      else
        printf("%.17g%s", value, separator);
    }
  }
  return 0;
}
