/* What the library gives at the points of a table: table MODEL POINTS.csv OUT.csv ALL.
 * OUT is the table that `tactus eval` writes; the shortest digits of each number are found by trying, because C has no such
 * function. ALL has for each point the doubles inputs, force, fired, force of the last expert, force out of a batch, force of
 * a scene, and the same out of a batch; of every thousand points the scene has the first two inputs of the first. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <tactus/tactus.h>

enum { kMostInputs = 8, kGroup = 1000, kFixed = 2 };

static void shortest(double value, char *out) {
  char fewer[40];
  int digits = 17;
  sprintf(out, "%.*g", digits, value);
  while (--digits > 0) {
    sprintf(fewer, "%.*g", digits, value);
    if (strtod(fewer, NULL) != value) return;
    strcpy(out, fewer);
  }
}

/* A batch agrees with its points to 4 units in the last place of 1 N. */
static int agree(double batch, double point) { return fabs(batch - point) <= 4 * 2.220446049250313e-16; }

/* Writes OUT; returns how many points were read into `points`, which the caller frees, and whether they fire. */
static size_t table(const tactus_model *model, FILE *in, FILE *out, double **points, int **fired) {
  const size_t inputs = tactus_model_inputs(model);
  char line[512];
  size_t count = 0, room = 0, i;
  if (fgets(line, sizeof line, in) == NULL) return 0;
  line[strcspn(line, "\r\n")] = '\0';
  fprintf(out, "%s,force,fired\n", line);
  while (fgets(line, sizeof line, in) != NULL) {
    char number[40];
    char *at = line;
    if (count == room) {
      room = 2 * room + kGroup;
      *points = realloc(*points, room * inputs * sizeof **points);
      *fired = realloc(*fired, room * sizeof **fired);
      if (*points == NULL || *fired == NULL) return 0;
    }
    line[strcspn(line, "\r\n")] = '\0';
    for (i = 0; i < inputs; ++i) {
      (*points)[count * inputs + i] = strtod(at, &at);
      if (*at == ',') ++at;
    }
    shortest(tactus_force(model, *points + count * inputs, *fired + count), number);
    fprintf(out, "%s,%s,%d\n", line, number, (*fired)[count]);
    ++count;
  }
  return count;
}

/* The forces of a scene at up to kGroup points, one by one and in a batch. A point of a scene is a point of its model. */
static int scene_forces(const tactus_model *model, const double *points, size_t count, double *one, double *batch) {
  static const size_t fixed[kFixed] = {0, 1};
  static double rest[kGroup * kMostInputs];
  const size_t inputs = tactus_model_inputs(model), left = inputs - kFixed;
  double merged[kMostInputs];
  tactus_scene *scene = NULL;
  size_t i;
  if (tactus_scene_make(model, fixed, points, kFixed, &scene, NULL, 0) != TACTUS_OK) return 0;
  memcpy(merged, points, kFixed * sizeof *merged);
  for (i = 0; i < count; ++i) {
    memcpy(merged + kFixed, points + i * inputs + kFixed, left * sizeof *merged);
    memcpy(rest + i * left, merged + kFixed, left * sizeof *rest);
    one[i] = tactus_scene_force(scene, merged + kFixed, NULL);
    if (one[i] != tactus_force(model, merged, NULL)) return 0;
  }
  tactus_scene_force_batch(scene, rest, count, batch, NULL);
  for (i = 0; i < count; ++i)
    if (!agree(batch[i], one[i])) return 0;
  tactus_scene_free(scene);
  return 1;
}

static int write_all(const tactus_model *model, const double *points, const int *fired, size_t count, FILE *out) {
  const size_t inputs = tactus_model_inputs(model), last = tactus_model_experts(model) - 1;
  double *const batch = malloc(count * sizeof *batch);
  unsigned char *const batch_fired = malloc(count);
  double one[kGroup], many[kGroup];
  size_t i;
  if (batch == NULL || batch_fired == NULL) return 0;
  tactus_force_batch(model, points, count, batch, batch_fired);
  for (i = 0; i < count; ++i) {
    const double *const point = points + i * inputs;
    double row[6];
    if (i % kGroup == 0 && !scene_forces(model, point, count - i < kGroup ? count - i : kGroup, one, many)) return 0;
    row[0] = tactus_force(model, point, NULL);
    row[1] = fired[i];
    row[2] = tactus_expert_force(model, last, point, NULL);
    row[3] = batch[i];
    row[4] = one[i % kGroup];
    row[5] = many[i % kGroup];
    if (!agree(row[3], row[0]) || batch_fired[i] != fired[i]) return 0;
    fwrite(point, sizeof *point, inputs, out);
    fwrite(row, sizeof *row, 6, out);
  }
  free(batch);
  free(batch_fired);
  return 1;
}

int main(int argc, char **argv) {
  tactus_model *model = NULL;
  char message[256];
  double *points = NULL;
  int *fired = NULL;
  FILE *in, *out, *everything;
  size_t count;
  if (argc != 5) return 2;
  if (tactus_model_open(argv[1], &model, message, sizeof message) != TACTUS_OK) {
    fprintf(stderr, "%s\n", message);
    return 1;
  }
  in = fopen(argv[2], "r");
  out = fopen(argv[3], "wb");
  everything = fopen(argv[4], "wb");
  if (in == NULL || out == NULL || everything == NULL) return 1;
  count = table(model, in, out, &points, &fired);
  if (count == 0 || !write_all(model, points, fired, count, everything)) {
    fprintf(stderr, "a batch or a scene differs from its points\n");
    return 1;
  }
  fclose(in);
  if (fclose(out) != 0 || fclose(everything) != 0) return 1;
  free(points);
  free(fired);
  tactus_model_free(model);
  return 0;
}
