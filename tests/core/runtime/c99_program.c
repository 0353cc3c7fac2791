#include "c99_program.h"

#include <string.h>
#include <tactus/tactus.h>

#define WANT(condition) \
  if (!(condition)) return __LINE__

int runC99Program(const char *text, size_t size, double *force_n, double *feel_n) {
  tactus_model *model = NULL;
  tactus_scene *scene = NULL;
  tactus_tube *tube = NULL;
  tactus_tube *copy = NULL;
  tactus_feel feel = {sizeof(tactus_feel), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  tactus_renderer renderer = {sizeof(tactus_renderer), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  const tactus_limits limits = {sizeof(tactus_limits), 0.2, 1.5};
  unsigned char state[4096];
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
  WANT(fired == 1 && tactus_clamped(model, point) == 0 && tactus_clamped_inputs(model, point) == 0);
  WANT(strlen(tactus_model_sha256(model)) == 64);
  WANT(tactus_model_input_label(model, 0) && tactus_model_expert_label(model, 0));
  WANT(tactus_model_input_terms(model, 1) > 0 && tactus_model_term_id(model, 1, 0) && tactus_model_term_label(model, 1, 0));
  WANT(tactus_model_membership(model, 0, 1, 0, 0) >= 0);
  tactus_model_renderer(model, &renderer);
  WANT(renderer.stiffness_n_mm > 0.2);
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
  WANT(feel.limited == 0 && feel.region >= 0);
  WANT(tactus_tube_limits(tube, &limits) == TACTUS_OK);
  WANT(tactus_tube_save(tube, state, sizeof state) <= sizeof state);
  WANT(tactus_tube_copy(tube, &copy) == TACTUS_OK);
  WANT(tactus_tube_load(copy, state, tactus_tube_save(tube, NULL, 0)) == TACTUS_OK);
  WANT(tactus_tube_step(copy, 50, 1, 0.001, &feel) == TACTUS_OK && feel.limited == 1);
  tactus_tube_free(copy);
  tactus_tube_free(tube);
  return 0;
}
