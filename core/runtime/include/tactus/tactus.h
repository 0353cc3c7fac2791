/* libtactus: the force of a Tactus model in a simulator. C99 and C++. Examples and measurements: docs/libtactus.md.
 *
 *   tactus_model *model;
 *   char message[256];
 *   if (tactus_model_open("model.tactus.json", &model, message, sizeof message) != TACTUS_OK) puts(message);
 *   double inputs[4] = {1.0, 45.0, 30.0, 30.0};    in the order and the units of the model
 *   int fired;
 *   double force_n = tactus_force(model, inputs, &fired);
 *
 * No function throws, aborts or prints, whatever its arguments. A null model, scene or tube gives TACTUS_BAD_ARGUMENT,
 * a force of 0 with `fired` 0, or nothing. A pointer must be null or point to what its type says: that cannot be
 * checked. Real-time safe means: no allocation, no lock, no system call, bounded time. Numbers are double; forces are
 * N, lengths mm, speeds mm/s, times s, all other inputs as their unit says. */
#ifndef TACTUS_TACTUS_H
#define TACTUS_TACTUS_H

#include <stddef.h>

/* On Windows a program that links the static library defines TACTUS_STATIC (the CMake target does). */
#if defined(_WIN32) && !defined(TACTUS_STATIC)
#define TACTUS_API __declspec(dllimport)
#elif defined(__GNUC__) && !defined(_WIN32)
#define TACTUS_API __attribute__((visibility("default")))
#else
#define TACTUS_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Version ------------------------------------------------------------------------------------------------- */

/* The interface that this header describes. A higher number adds functions, members at the end of a struct with a
 * `size`, and values at the end of an enum: a program that was compiled against a lower one keeps running with the same
 * libtactus.so.1. Members of interface 1 stand above those that came with a later one. */
#define TACTUS_INTERFACE 2

/* "0.2.0". Thread: any. Real-time safe: yes. */
TACTUS_API const char* tactus_version(void);
/* TACTUS_INTERFACE of the library that runs. Thread: any. Real-time safe: yes. */
TACTUS_API int tactus_interface(void);

typedef enum {
  TACTUS_OK = 0,
  TACTUS_BAD_ARGUMENT = 1, /* the call is wrong */
  TACTUS_BAD_FILE = 2,     /* the file cannot be read, or is no valid model */
  TACTUS_NO_MEMORY = 3,
  TACTUS_NOT_VERIFIED = 4 /* a file of a bundle is missing, altered, or beyond its tolerance */
} tactus_status;

/* ---- Models -------------------------------------------------------------------------------------------------- */

typedef struct tactus_model tactus_model; /* immutable: any number of threads */

/* Reads the model file `path`, checks it and repeats the reference evaluations in it (docs/model-file.md).
 * `model`: receives the model, or null on failure. `message`: receives one sentence in UTF-8 (what, where, found,
 * wanted), always terminated, cut to `message_size` bytes between characters; may be null. Success leaves "" or a
 * warning.
 * Thread: any. Real-time safe: no. */
TACTUS_API tactus_status tactus_model_open(const char* path, tactus_model** model, char* message, size_t message_size);

/* The same for the text of a model file, `size` bytes.
 * Thread: any. Real-time safe: no. */
TACTUS_API tactus_status tactus_model_read(const void* text, size_t size, tactus_model** model, char* message,
                                           size_t message_size);

/* No thread may use the model afterwards. Scenes made from it stay. Null is allowed.
 * Thread: any. Real-time safe: no. */
TACTUS_API void tactus_model_free(tactus_model* model);

/* What a model declares. Texts live as long as the model; null where there is no such input or expert. Numbers are then
 * 0. Thread: any. Real-time safe: yes. */
TACTUS_API const char* tactus_model_name(const tactus_model* model);
TACTUS_API const char* tactus_model_sha256(const tactus_model* model); /* of the file's text, 64 hexadecimal digits */
TACTUS_API size_t tactus_model_inputs(const tactus_model* model);      /* 1 to 8 */
TACTUS_API const char* tactus_model_input_id(const tactus_model* model, size_t input);
TACTUS_API const char* tactus_model_input_label(const tactus_model* model, size_t input); /* or the id if it has none */
TACTUS_API const char* tactus_model_input_unit(const tactus_model* model, size_t input);
TACTUS_API double tactus_model_input_min(const tactus_model* model, size_t input);
TACTUS_API double tactus_model_input_max(const tactus_model* model, size_t input);
TACTUS_API double tactus_model_output_min(const tactus_model* model);
TACTUS_API double tactus_model_output_max(const tactus_model* model);
TACTUS_API size_t tactus_model_experts(const tactus_model* model);
TACTUS_API const char* tactus_model_expert_id(const tactus_model* model, size_t expert);
TACTUS_API const char* tactus_model_expert_label(const tactus_model* model, size_t expert); /* or the id */
TACTUS_API double tactus_model_expert_weight(const tactus_model* model, size_t expert);

/* The words of an input, such as the regions of `depth`, in the order of the file. A label that the file lacks is the
 * id. Texts live as long as the model; null where there is no such term. Thread: any. Real-time safe: yes. */
/* "way": how deep the tip is, mm; "rate": how fast it moves, mm/s; "condition": any other input. A tube (below) moves
 * the first two. Null for an input that the model has not. */
TACTUS_API const char* tactus_model_input_role(const tactus_model* model, size_t input);
TACTUS_API size_t tactus_model_input_terms(const tactus_model* model, size_t input); /* at most 64 */
TACTUS_API const char* tactus_model_term_id(const tactus_model* model, size_t input, size_t term);
TACTUS_API const char* tactus_model_term_label(const tactus_model* model, size_t input, size_t term);

/* The membership, 0 to 1, of the value `x` in a term, as the rules of `expert` take it: clamped to the universe first.
 * An expert with terms of its own has its own function for this word, or 0 if it does not use it. NaN where `x` is not
 * finite; 0 where there is no such expert, input or term. Thread: any. Real-time safe: yes. */
TACTUS_API double tactus_model_membership(const tactus_model* model, size_t expert, size_t input, size_t term,
                                          double x);

/* The parameters of the tube (docs/renderer.md): those of the model file, or the usual ones if it has none. */
typedef struct {
  size_t size; /* sizeof(tactus_renderer), set by the caller; later versions add members at the end */
  double stiffness_n_mm, damping_n_s_mm, breakaway_ratio, restick_mm, withdrawal_ratio, relaxation_s, ageing_s,
      stick_speed_mm_s, stick_time_s, velocity_filter_hz, slew_n_s, depth_offset_mm;
} tactus_renderer;

/* Fills the members that the caller's `size` covers. Thread: any. Real-time safe: yes. */
TACTUS_API void tactus_model_renderer(const tactus_model* model, tactus_renderer* renderer);

/* ---- Forces -------------------------------------------------------------------------------------------------- */

/* The averaged force at one point. `inputs`: tactus_model_inputs() values in the model's order. A value outside its
 * universe is clamped (tactus_clamped tells). `fired`: 1 where a rule of some expert fires, else 0, and the force is
 * the model's default; may be null. An input that is not finite gives NaN and `fired` 0. The same bits on every x86-64
 * machine. Thread: any. Real-time safe: yes. */
TACTUS_API double tactus_force(const tactus_model* model, const double* inputs, int* fired);

/* The force of one expert alone; its weight does not matter. There is no such expert: 0 and `fired` 0.
 * Thread: any. Real-time safe: yes. */
TACTUS_API double tactus_expert_force(const tactus_model* model, size_t expert, const double* inputs, int* fired);

/* The averaged force at many points, three to ten times as fast. `inputs`: point after point. `force`: `points` values.
 * `fired`: `points` values, 1 or 0; may be null. The forces agree with tactus_force to 4 ulp, `fired` exactly.
 * Needs at most 80 KiB of stack. Thread: any. Real-time safe: yes. */
TACTUS_API void tactus_force_batch(const tactus_model* model, const double* inputs, size_t points, double* force,
                                   unsigned char* fired);

/* 1 where an input of the point is outside of its universe and therefore clamped, else 0. A NaN is not clamped.
 * Thread: any. Real-time safe: yes. */
TACTUS_API int tactus_clamped(const tactus_model* model, const double* inputs);
/* Which inputs these are: bit i for input i. Thread: any. Real-time safe: yes. */
TACTUS_API unsigned tactus_clamped_inputs(const tactus_model* model, const double* inputs);

/* ---- Scenes -------------------------------------------------------------------------------------------------- */

/* A model with some inputs fixed; the others stay in the model's order. Immutable: any number of threads. Lives on its
 * own: the model may be freed before it. */
typedef struct tactus_scene tactus_scene;

/* `fixed`: indices of `fixed_count` inputs, each once, in any order; `values`: their values, finite. None or all may be
 * fixed. A value outside its universe is clamped, and the message says so.
 * Thread: any. Real-time safe: no. */
TACTUS_API tactus_status tactus_scene_make(const tactus_model* model, const size_t* fixed, const double* values,
                                           size_t fixed_count, tactus_scene** scene, char* message,
                                           size_t message_size);

/* No thread may use the scene afterwards. Tubes that feel it keep what they need. Null is allowed.
 * Thread: any. Real-time safe: no. */
TACTUS_API void tactus_scene_free(tactus_scene* scene);

/* How many inputs are not fixed. Thread: any. Real-time safe: yes. */
TACTUS_API size_t tactus_scene_inputs(const tactus_scene* scene);

/* As tactus_force and with its bits; `inputs`: tactus_scene_inputs() values (may be null where that is 0).
 * Thread: any. Real-time safe: yes. */
TACTUS_API double tactus_scene_force(const tactus_scene* scene, const double* inputs, int* fired);

/* As tactus_force_batch; what the fixed inputs decide is computed once, in tactus_scene_make.
 * Thread: any. Real-time safe: yes. */
TACTUS_API void tactus_scene_force_batch(const tactus_scene* scene, const double* inputs, size_t points, double* force,
                                         unsigned char* fired);

/* ---- The tube ------------------------------------------------------------------------------------------------ */

/* The state of one insertion: the renderer of docs/renderer.md with the parameters of the model file, as the servo of
 * the workbench runs it before its safety limits. A tube slips at 2 N at the latest. Lives on its own. */
typedef struct tactus_tube tactus_tube;

typedef struct {
  size_t size;            /* sizeof(tactus_feel), set by the caller; later versions add members at the end */
  double force_n;         /* resistance on the hand, > 0 pushes it out */
  double depth_mm;        /* of the tube: the sum of all slip */
  double speed_mm_s;      /* of the hand, filtered, inwards positive */
  double slip_speed_mm_s; /* of the tube, filtered */
  double stretch_mm;      /* by how much the hand leads the tube */
  double model_force_n;   /* dynamic friction in effect: the model's force, held and faded; 0 while released */
  int phase;              /* 0 released, 1 stuck, 2 sliding */
  int held_last;          /* 1: no rule fired, the last force is held */
  unsigned stroke;        /* number of the stroke, from 1; 0: no stroke yet */
  /* Interface 2; written where `size` covers both. */
  int limited; /* 1: held, and the spring is softer than the model's or the force is at its cap (tactus_tube_limits) */
  int region;  /* where the tip is: index of the strongest term of `depth`, the first of several; -1: none */
} tactus_feel;

/* A tube at depth 0, out of the hand. The scene must leave exactly the inputs `depth` and `speed`, in mm and mm/s, and
 * give N. Thread: any. Real-time safe: no. */
TACTUS_API tactus_status tactus_tube_make(const tactus_scene* scene, tactus_tube** tube, char* message,
                                          size_t message_size);

/* Null is allowed. Thread: any, one at a time. Real-time safe: no. */
TACTUS_API void tactus_tube_free(tactus_tube* tube);

/* A new placement at `depth_mm`, or at the end of the model's depth if that is less: feel.depth_mm of the next step
 * tells. Strokes count from 1 again. A force that is still there fades within 30 ms. Nothing happens if `depth_mm` is
 * not finite or beyond 1e6. Thread: one at a time. Real-time safe: yes. */
TACTUS_API void tactus_tube_place(tactus_tube* tube, double depth_mm);

/* Feels another scene from the next step on, without a kick: the difference to the scene before fades within `fade_s`
 * (0 to 60 s, moved into this range; NaN counts as 0.05 s, the workbench's time for an edit). Nothing happens if the
 * scene has other inputs than `depth` and `speed`, or other units.
 * Thread: one at a time. Real-time safe: yes, as long as the caller has not yet freed the scene felt before. Otherwise
 * this call frees it. */
TACTUS_API void tactus_tube_scene(tactus_tube* tube, const tactus_scene* scene, double fade_s);

/* What the loop and the device can take. */
typedef struct {
  size_t size;               /* sizeof(tactus_limits), set by the caller; later versions add members at the end */
  double stiffness_max_n_mm; /* of the spring between hand and tube; 0: no limit, the model's stiffness is rendered */
  double force_cap_n;        /* the tube slips at this force; 0: no limit of the caller, the usual cap of 2 N stays */
} tactus_limits;

/* Bounds what the tube renders from the next step on, until the next call: the smaller one of the model's stiffness and
 * this one, and of 2 N and this cap. While the tube is held, the spring changes over 50 ms; a lower cap acts at once.
 * How stiff a spring a loop can take: docs/libtactus.md. TACTUS_BAD_ARGUMENT, and nothing changes, if a limit is below
 * 0 or not finite. Thread: one at a time. Real-time safe: yes. */
TACTUS_API tactus_status tactus_tube_limits(tactus_tube* tube, const tactus_limits* limits);

/* One step of the insertion, at any rate; 1 kHz is usual. `position_mm`: of the hand along the axis of insertion,
 * inwards positive, from anywhere. `held`: whether the hand holds the tube; a press begins at force 0, a release fades
 * within 30 ms. `dt_s`: time since the last step, 1e-6 to 1 s.
 * A position that is not finite or beyond 1e6 mm, or a time out of range, lets the tube go and gives
 * TACTUS_BAD_ARGUMENT, with `feel` filled in; it is held again after a step with `held` 0.
 * Thread: one at a time. Real-time safe: yes. */
TACTUS_API tactus_status tactus_tube_step(tactus_tube* tube, double position_mm, int held, double dt_s,
                                          tactus_feel* feel);

/* Another tube in the same state, with the same scene and limits; `copy` receives it, or null on failure. From here on
 * each goes its own way: the same steps give the same bits. Thread: no other thread uses `tube` meanwhile. Real-time
 * safe: no; between two tubes that exist, save and load are. */
TACTUS_API tactus_status tactus_tube_copy(const tactus_tube* tube, tactus_tube** copy);

/* The state as bytes, for replay and rollback. Returns how many there are, the same number for every tube of this
 * library; writes nothing where `size` is smaller or `bytes` is null. They are of this machine's kind and of this
 * version of the library; files of them are no archive.
 * Thread: no other thread uses `tube` meanwhile. Real-time safe: yes. */
TACTUS_API size_t tactus_tube_save(const tactus_tube* tube, void* bytes, size_t size);

/* Takes a saved state: the next steps have the bits of the steps that followed the save. `size`: what tactus_tube_save
 * returned. The tube must feel a scene of the same model text with the same fixed inputs, in this process or another
 * one; call tactus_tube_scene first if it feels another. Of the saved limits and those of the tube the stricter ones
 * stay. Bytes of another scene, model or version, or altered ones, give TACTUS_BAD_ARGUMENT and change nothing.
 * Thread: one at a time. Real-time safe: yes. */
TACTUS_API tactus_status tactus_tube_load(tactus_tube* tube, const void* bytes, size_t size);

/* ---- Bundles ------------------------------------------------------------------------------------------------- */

/* Reads a bundle (docs/bundle.md): every file must be there with its checksum, the model repeats its reference
 * evaluations, the tables of checks and of insertions are evaluated again, and the model's contracts are proved again.
 * TACTUS_NOT_VERIFIED where a file is missing, altered or beyond its tolerance, or a contract is broken, with a
 * sentence about the first of them; TACTUS_BAD_FILE where there is no bundle.
 * `largest_error_n`: receives the largest error of the forces that were evaluated again; may be null.
 * Thread: any. Real-time safe: no. */
TACTUS_API tactus_status tactus_verify(const char* bundle_folder, double* largest_error_n, char* message,
                                       size_t message_size);

#ifdef __cplusplus
}
#endif

#endif
