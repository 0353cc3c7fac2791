/* What a force costs on this machine: latency MODEL. Times 200,000 points of the model, each five times: the fastest of
 * five is the cost of the point, the slowest also holds what else the machine did meanwhile. */
#define _POSIX_C_SOURCE 199309L
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include <tactus/tactus.h>

enum { kPoints = 200000, kRounds = 5 };

static double now_us(void) {
  struct timespec time;
  clock_gettime(CLOCK_MONOTONIC, &time);
  return (double)time.tv_sec * 1e6 + (double)time.tv_nsec * 1e-3;
}

static int ascending(const void *a, const void *b) {
  const double left = *(const double *)a;
  const double right = *(const double *)b;
  return (left > right) - (left < right);
}

/* The next of a fixed sequence of numbers in [0, 1): Knuth's 64-bit generator. */
static double next(unsigned long long *state) {
  *state = *state * 6364136223846793005ULL + 1442695040888963407ULL;
  return (double)(*state >> 11) / 9007199254740992.0;
}

int main(int argc, char **argv) {
  static double cost_us[kPoints];
  tactus_model *model = NULL;
  char message[512];
  unsigned long long state = 1;
  volatile double sum = 0;
  double slowest_us = 0;
  double start_us;
  size_t inputs, i;
  int p, round;

  if (argc != 2) {
    fprintf(stderr, "usage: latency MODEL\n");
    return 2;
  }
  start_us = now_us();
  if (tactus_model_open(argv[1], &model, message, sizeof message) != TACTUS_OK) {
    fprintf(stderr, "%s\n", message);
    return 1;
  }
  printf("reading the model        %10.1f us\n", now_us() - start_us);
  inputs = tactus_model_inputs(model);
  for (p = 0; p < kPoints; ++p) {
    double point[8];
    for (i = 0; i < inputs; ++i) {
      const double min = tactus_model_input_min(model, i);
      point[i] = min + (tactus_model_input_max(model, i) - min) * next(&state);
    }
    for (round = 0; round < kRounds; ++round) {
      double once_us;
      start_us = now_us();
      sum = sum + tactus_force(model, point, NULL);
      once_us = now_us() - start_us;
      if (round == 0 || once_us < cost_us[p]) cost_us[p] = once_us;
      if (once_us > slowest_us) slowest_us = once_us;
    }
  }
  qsort(cost_us, kPoints, sizeof cost_us[0], ascending);
  printf("force, median point      %10.3f us\n", cost_us[kPoints / 2]);
  printf("force, costliest point   %10.3f us\n", cost_us[kPoints - 1]);
  printf("force, slowest of all    %10.3f us   (with everything else that ran)\n", slowest_us);
  tactus_model_free(model);
  return 0;
}
