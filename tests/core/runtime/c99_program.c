#include "c99_program.h"

#include <tactus/tactus.h>

#define WANT(condition) \
  if (!(condition)) return __LINE__

int runC99Program(const char *text, size_t size, double *force_n, double *feel_n) {
  tactus_model *model = NULL;
  tactus_scene *scene = NULL;
  tactus_tube *tube = NULL;
  tactus_feel feel = {sizeof(tactus_feel), 0, 0, 0, 0, 0, 0, 0, 0, 0};
  const double point[2] = {100, 50};
  double forces[1];
  unsigned char told[1];
  char message[200];
  int fired = 0;
  int step;

  WANT(tactus_interface() == TACTUS_INTERFACE);
  WANT(tactus_version()[0] != '\0');
  WANT(tactus_model_read(text, size, &model, message, sizeof message) == TACTUS_OK);
  WANT(message[0] == '\0');
  WANT(tactus_model_inputs(model) == 2);
  WANT(tactus_model_input_max(model, 0) > tactus_model_input_min(model, 0));
  WANT(tactus_model_output_max(model) > tactus_model_output_min(model));
  WANT(tactus_model_experts(model) >= 1 && tactus_model_expert_weight(model, 0) > 0);
  WANT(tactus_model_name(model) && tactus_model_input_id(model, 1) && tactus_model_input_unit(model, 1));
  WANT(tactus_model_expert_id(model, 0));
  *force_n = tactus_force(model, point, &fired);
  WANT(fired == 1 && tactus_clamped(model, point) == 0);
  WANT(tactus_expert_force(model, 0, point, NULL) > 0);
  tactus_force_batch(model, point, 1, forces, told);
  WANT(told[0] == 1 && forces[0] > 0);
  WANT(tactus_scene_make(model, NULL, NULL, 0, &scene, NULL, 0) == TACTUS_OK);
  tactus_model_free(model);
  WANT(tactus_scene_inputs(scene) == 2 && tactus_scene_force(scene, point, NULL) == *force_n);
  tactus_scene_force_batch(scene, point, 1, forces, NULL);
  WANT(forces[0] > 0);
  WANT(tactus_tube_make(scene, &tube, NULL, 0) == TACTUS_OK);
  tactus_tube_place(tube, 10);
  tactus_tube_scene(tube, scene, 0.05);
  tactus_scene_free(scene);
  for (step = 0; step < 500; ++step) {
    WANT(tactus_tube_step(tube, 0.1 * step, 1, 0.001, &feel) == TACTUS_OK);
  }
  WANT(feel.phase == 2 && feel.stroke == 1);
  *feel_n = feel.force_n;
  tactus_tube_free(tube);
  return 0;
}
