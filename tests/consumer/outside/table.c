/* Writes the table that `tactus eval` writes: table MODEL POINTS.csv OUT.csv. The shortest digits of each number are
 * found by trying, because C has no such function. With a fourth argument the numbers are written as the hexadecimal
 * digits of their 64 bits, for programs whose language does not read decimal numbers exactly. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <tactus/tactus.h>

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

static void bits(FILE *out, double value) {
  unsigned char bytes[sizeof value];
  int i;
  memcpy(bytes, &value, sizeof value);
  for (i = (int)sizeof value - 1; i >= 0; --i) fprintf(out, "%02x", bytes[i]);
  fputc(',', out);
}

int main(int argc, char **argv) {
  tactus_model *model = NULL;
  char message[256];
  char line[512];
  FILE *in;
  FILE *out;
  if (argc != 4 && argc != 5) return 2;
  if (tactus_model_open(argv[1], &model, message, sizeof message) != TACTUS_OK) {
    fprintf(stderr, "%s\n", message);
    return 1;
  }
  in = fopen(argv[2], "r");
  out = fopen(argv[3], "wb");
  if (in == NULL || out == NULL || fgets(line, sizeof line, in) == NULL) return 1;
  line[strcspn(line, "\n")] = '\0';
  if (argc == 4) fprintf(out, "%s,force,fired\n", line);
  while (fgets(line, sizeof line, in) != NULL) {
    double inputs[8];
    char number[40];
    double force_n;
    char *at = line;
    size_t i;
    int fired;
    line[strcspn(line, "\n")] = '\0';
    for (i = 0; i < tactus_model_inputs(model); ++i) {
      inputs[i] = strtod(at, &at);
      if (*at == ',') ++at;
    }
    force_n = tactus_force(model, inputs, &fired);
    if (argc == 4) {
      shortest(force_n, number);
      fprintf(out, "%s,%s,%d\n", line, number, fired);
      continue;
    }
    for (i = 0; i < tactus_model_inputs(model); ++i) bits(out, inputs[i]);
    bits(out, force_n);
    fprintf(out, "%d\n", fired);
  }
  fclose(in);
  if (fclose(out) != 0) return 1;
  tactus_model_free(model);
  return 0;
}
