/* The averaged force of a model at one point: force MODEL VALUE..., one value for each input. */
#include <stdio.h>
#include <stdlib.h>

#include <tactus/tactus.h>

int main(int argc, char **argv) {
  tactus_model *model = NULL;
  char message[512];
  double inputs[8];
  double force_n;
  size_t count, i;
  int fired;

  if (argc < 2) {
    fprintf(stderr, "usage: force MODEL VALUE...\n");
    return 2;
  }
  if (tactus_model_open(argv[1], &model, message, sizeof message) != TACTUS_OK) {
    fprintf(stderr, "%s\n", message);
    return 1;
  }
  count = tactus_model_inputs(model);
  if ((size_t)argc - 2 != count) {
    fprintf(stderr, "wanted %lu values:", (unsigned long)count);
    for (i = 0; i < count; ++i) fprintf(stderr, " %s", tactus_model_input_id(model, i));
    fprintf(stderr, "\n");
    tactus_model_free(model);
    return 2;
  }
  for (i = 0; i < count; ++i) {
    char *end;
    inputs[i] = strtod(argv[i + 2], &end);
    if (end == argv[i + 2] || *end != '\0') {
      fprintf(stderr, "%s: found '%s', wanted a number with a decimal point\n", tactus_model_input_id(model, i), argv[i + 2]);
      tactus_model_free(model);
      return 2;
    }
  }
  force_n = tactus_force(model, inputs, &fired);
  printf("%.17g N%s\n", force_n, fired ? "" : " (no rule fires: the model's default)");
  tactus_model_free(model);
  return 0;
}
