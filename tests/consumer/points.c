/* A table of points of a model: points COUNT ID:MIN:MAX:GRID ... > points.csv. Most are anywhere, up to a tenth outside the
 * universes; some stand on the grid of round numbers, where vertices and ends are. The same table on every machine. */
#include <stdio.h>
#include <stdlib.h>

enum { kMostInputs = 8 };

typedef struct {
  char id[32];
  double min, max, grid;
} universe;

/* The next of a fixed sequence of numbers in [0, 1): Knuth's 64-bit generator. */
static double next(unsigned long long *state) {
  *state = *state * 6364136223846793005ULL + 1442695040888963407ULL;
  return (double)(*state >> 11) / 9007199254740992.0;
}

int main(int argc, char **argv) {
  universe inputs[kMostInputs];
  unsigned long long state = 7;
  const long count = argc > 2 ? strtol(argv[1], NULL, 10) : 0;
  const int all = argc - 2;
  long point;
  int i;
  if (count <= 0 || all > kMostInputs) return 2;
  for (i = 0; i < all; ++i) {
    universe *u = &inputs[i];
    if (sscanf(argv[i + 2], "%31[^:]:%lf:%lf:%lf", u->id, &u->min, &u->max, &u->grid) != 4) return 2;
    printf("%s%s", u->id, i + 1 < all ? "," : "\n");
  }
  for (point = 0; point < count; ++point) {
    const int round = point % 4 == 0;
    for (i = 0; i < all; ++i) {
      const universe *u = &inputs[i];
      const double value = u->min + (u->max - u->min) * (1.2 * next(&state) - 0.1);
      const char *const separator = i + 1 < all ? "," : "\n";
      if (round)
        printf("%.1f%s", u->grid * (double)(long)(value / u->grid), separator);
      else
        printf("%.17g%s", value, separator);
    }
  }
  return 0;
}
