// libtactus for C++17: header only, a thin layer over tactus.h, which says everything about threads and real time.
//
//   const auto model = tactus::Model::open("model.tactus.json");
//   const double force_n = model.force({1.0, 45.0, 30.0, 30.0});
//   const auto scene = model.scene({{"lubrication", 1.0}, {"neck_flexion", 45.0}});
//   tactus::Tube tube(scene);
//   const tactus::Feel feel = tube.step(position_mm, held, 0.001);
//
// Objects are moved, never copied (a tube has copy()); an object that was moved from is empty and gives forces of 0.
// What cannot be made throws tactus::Error; forces and steps throw only where the number of inputs is wrong.
// Without exceptions (-fno-exceptions) the sentence goes to standard error and the program ends; a program that wants
// something else defines TACTUS_THROW(error), which must not return, before it includes this file.
#ifndef TACTUS_TACTUS_HPP
#define TACTUS_TACTUS_HPP

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tactus.h"

#ifndef TACTUS_THROW
#if defined(__cpp_exceptions) || defined(_CPPUNWIND)
#define TACTUS_THROW(error) throw error
#else
#define TACTUS_THROW(error) ::tactus::detail::endProgram(error)
#endif
#endif

namespace tactus {

// One sentence: what, where, what was found, what was wanted.
class Error : public std::runtime_error {
 public:
  Error(tactus_status status, const std::string& sentence) : std::runtime_error(sentence), status_(status) {}
  tactus_status status() const noexcept { return status_; }

 private:
  tactus_status status_;
};

using Feel = tactus_feel;
using Renderer = tactus_renderer;

namespace detail {

[[noreturn]] inline void endProgram(const Error& error) noexcept {
  std::fprintf(stderr, "tactus: %s\n", error.what());
  std::abort();
}

inline constexpr std::size_t kMessageBytes = 1024;

// Calls `make(message, size)`; throws where it fails, and returns the warning, if any, where it does not.
template <typename Make>
std::string checked(Make&& make) {
  char message[kMessageBytes];
  const tactus_status status = make(message, sizeof message);
  if (status != TACTUS_OK) TACTUS_THROW(Error(status, message));
  return message;
}

struct Free {
  void operator()(tactus_model* model) const noexcept { tactus_model_free(model); }
  void operator()(tactus_scene* scene) const noexcept { tactus_scene_free(scene); }
  void operator()(tactus_tube* tube) const noexcept { tactus_tube_free(tube); }
};

inline void wantInputs(std::size_t found, std::size_t wanted) {
  if (found == wanted) return;
  TACTUS_THROW(Error(TACTUS_BAD_ARGUMENT,
                     "inputs: found " + std::to_string(found) + " values, wanted " + std::to_string(wanted)));
}

// The number of points in `values` numbers.
inline std::size_t pointsIn(std::size_t values, std::size_t inputs) {
  if (inputs == 0 || values % inputs != 0) wantInputs(values, inputs);
  return values / inputs;
}

}  // namespace detail

// Some inputs of a model are fixed; the others stay in the model's order. Any number of threads.
class Scene {
 public:
  std::size_t inputs() const noexcept { return tactus_scene_inputs(handle_.get()); }

  double force(std::initializer_list<double> inputs, bool* fired = nullptr) const {
    return force(inputs.begin(), inputs.size(), fired);
  }
  // Anything with data() and size(): std::vector, std::array, std::span.
  template <typename Inputs>
  double force(const Inputs& inputs, bool* fired = nullptr) const {
    return force(inputs.data(), inputs.size(), fired);
  }
  double force(const double* inputs, std::size_t count, bool* fired = nullptr) const {
    detail::wantInputs(count, this->inputs());
    int any = 0;
    const double force_n = tactus_scene_force(handle_.get(), inputs, &any);
    if (fired != nullptr) *fired = any != 0;
    return force_n;
  }

  // Points one after another.
  template <typename Inputs>
  std::vector<double> batch(const Inputs& inputs) const {
    std::vector<double> force_n(detail::pointsIn(inputs.size(), this->inputs()));
    batch(inputs.data(), force_n.size(), force_n.data());
    return force_n;
  }
  void batch(const double* inputs, std::size_t points, double* force_n, unsigned char* fired = nullptr) const noexcept {
    tactus_scene_force_batch(handle_.get(), inputs, points, force_n, fired);
  }

  // What was worth saying when it was made: a fixed value that was clamped. Mostly empty.
  const std::string& warning() const noexcept { return warning_; }
  const tactus_scene* get() const noexcept { return handle_.get(); }

 private:
  friend class Model;
  Scene() = default;

  std::unique_ptr<tactus_scene, detail::Free> handle_;
  std::string warning_;
};

// A model file in memory. Any number of threads.
class Model {
 public:
  static Model open(const std::string& path) {
    return made([&](tactus_model** model, char* message, std::size_t size) {
      return tactus_model_open(path.c_str(), model, message, size);
    });
  }
  static Model read(std::string_view text) {
    return made([&](tactus_model** model, char* message, std::size_t size) {
      return tactus_model_read(text.data(), text.size(), model, message, size);
    });
  }

  std::string name() const { return text(tactus_model_name(get())); }
  std::string sha256() const { return text(tactus_model_sha256(get())); }
  std::size_t inputs() const noexcept { return tactus_model_inputs(get()); }
  std::string inputId(std::size_t input) const { return text(tactus_model_input_id(get(), input)); }
  std::string inputLabel(std::size_t input) const { return text(tactus_model_input_label(get(), input)); }
  std::string inputUnit(std::size_t input) const { return text(tactus_model_input_unit(get(), input)); }
  double inputMin(std::size_t input) const noexcept { return tactus_model_input_min(get(), input); }
  double inputMax(std::size_t input) const noexcept { return tactus_model_input_max(get(), input); }
  /// `way`, `rate` or `condition`.
  const char* inputRole(std::size_t input) const noexcept { return tactus_model_input_role(get(), input); }
  std::size_t inputTerms(std::size_t input) const noexcept { return tactus_model_input_terms(get(), input); }
  std::string termId(std::size_t input, std::size_t term) const {
    return text(tactus_model_term_id(get(), input, term));
  }
  std::string termLabel(std::size_t input, std::size_t term) const {
    return text(tactus_model_term_label(get(), input, term));
  }
  double membership(std::size_t expert, std::size_t input, std::size_t term, double x) const noexcept {
    return tactus_model_membership(get(), expert, input, term, x);
  }
  double outputMin() const noexcept { return tactus_model_output_min(get()); }
  double outputMax() const noexcept { return tactus_model_output_max(get()); }
  std::size_t experts() const noexcept { return tactus_model_experts(get()); }
  std::string expertId(std::size_t expert) const { return text(tactus_model_expert_id(get(), expert)); }
  std::string expertLabel(std::size_t expert) const { return text(tactus_model_expert_label(get(), expert)); }
  double expertWeight(std::size_t expert) const noexcept { return tactus_model_expert_weight(get(), expert); }
  // The parameters of the tube.
  Renderer renderer() const noexcept {
    Renderer renderer{};
    renderer.size = sizeof renderer;
    tactus_model_renderer(get(), &renderer);
    return renderer;
  }

  double force(std::initializer_list<double> inputs, bool* fired = nullptr) const {
    return force(inputs.begin(), inputs.size(), fired);
  }
  // Anything with data() and size(): std::vector, std::array, std::span.
  template <typename Inputs>
  double force(const Inputs& inputs, bool* fired = nullptr) const {
    return force(inputs.data(), inputs.size(), fired);
  }
  double force(const double* inputs, std::size_t count, bool* fired = nullptr) const {
    detail::wantInputs(count, this->inputs());
    int any = 0;
    const double force_n = tactus_force(get(), inputs, &any);
    if (fired != nullptr) *fired = any != 0;
    return force_n;
  }

  double expertForce(std::size_t expert, std::initializer_list<double> inputs, bool* fired = nullptr) const {
    return expertForce(expert, inputs.begin(), inputs.size(), fired);
  }
  template <typename Inputs>
  double expertForce(std::size_t expert, const Inputs& inputs, bool* fired = nullptr) const {
    return expertForce(expert, inputs.data(), inputs.size(), fired);
  }
  double expertForce(std::size_t expert, const double* inputs, std::size_t count, bool* fired = nullptr) const {
    detail::wantInputs(count, this->inputs());
    if (expert >= experts())
      TACTUS_THROW(Error(TACTUS_BAD_ARGUMENT, "expert: found " + std::to_string(expert) + ", wanted less than " +
                                                  std::to_string(experts())));
    int any = 0;
    const double force_n = tactus_expert_force(get(), expert, inputs, &any);
    if (fired != nullptr) *fired = any != 0;
    return force_n;
  }

  // Points one after another.
  template <typename Inputs>
  std::vector<double> batch(const Inputs& inputs) const {
    std::vector<double> force_n(detail::pointsIn(inputs.size(), this->inputs()));
    batch(inputs.data(), force_n.size(), force_n.data());
    return force_n;
  }
  void batch(const double* inputs, std::size_t points, double* force_n, unsigned char* fired = nullptr) const noexcept {
    tactus_force_batch(get(), inputs, points, force_n, fired);
  }

  // Whether an input is outside its universe and is clamped. `inputs`: inputs() values.
  bool clamped(const double* inputs) const noexcept { return tactus_clamped(get(), inputs) != 0; }
  // Bit i: input i is.
  unsigned clampedInputs(const double* inputs) const noexcept { return tactus_clamped_inputs(get(), inputs); }

  // Values of the inputs that stay fixed, by id.
  Scene scene(std::initializer_list<std::pair<std::string_view, double>> fixed) const { return sceneOf(fixed); }
  // The same from a map or a vector of pairs.
  template <typename Fixed>
  Scene scene(const Fixed& fixed) const {
    return sceneOf(fixed);
  }

  // A key that the reader did not know, for example. Mostly empty.
  const std::string& warning() const noexcept { return warning_; }
  const tactus_model* get() const noexcept { return handle_.get(); }

 private:
  Model() = default;

  template <typename Make>
  static Model made(Make&& make) {
    Model model;
    model.warning_ = detail::checked([&](char* message, std::size_t size) {
      tactus_model* handle = nullptr;
      const tactus_status status = make(&handle, message, size);
      model.handle_.reset(handle);
      return status;
    });
    return model;
  }

  static std::string text(const char* text) { return text != nullptr ? text : ""; }

  std::size_t inputOf(std::string_view id) const {
    for (std::size_t i = 0; i < inputs(); ++i) {
      if (id == tactus_model_input_id(get(), i)) return i;
    }
    TACTUS_THROW(
        Error(TACTUS_BAD_ARGUMENT, "scene: found the input '" + std::string(id) + "', wanted one of the model"));
  }

  template <typename Fixed>
  Scene sceneOf(const Fixed& fixed) const {
    std::vector<std::size_t> indices;
    std::vector<double> values;
    for (const auto& [id, value] : fixed) {
      indices.push_back(inputOf(id));
      values.push_back(value);
    }
    Scene scene;
    scene.warning_ = detail::checked([&](char* message, std::size_t size) {
      tactus_scene* handle = nullptr;
      const tactus_status status =
          tactus_scene_make(get(), indices.data(), values.data(), indices.size(), &handle, message, size);
      scene.handle_.reset(handle);
      return status;
    });
    return scene;
  }

  std::unique_ptr<tactus_model, detail::Free> handle_;
  std::string warning_;
};

// One insertion. One thread at a time; the scene may go away.
class Tube {
 public:
  explicit Tube(const Scene& scene) {
    detail::checked([&](char* message, std::size_t size) {
      tactus_tube* handle = nullptr;
      const tactus_status status = tactus_tube_make(scene.get(), &handle, message, size);
      handle_.reset(handle);
      return status;
    });
  }

  // A new placement at this depth.
  void place(double depth_mm) noexcept { tactus_tube_place(handle_.get(), depth_mm); }
  // Feels another scene, without a kick.
  void scene(const Scene& scene, double fade_s = 0.05) noexcept {
    tactus_tube_scene(handle_.get(), scene.get(), fade_s);
  }
  // The largest stiffness and force to render; 0: none but the model's stiffness and the usual cap of 2 N.
  void limits(double stiffness_max_n_mm, double force_cap_n = 0) {
    const tactus_limits limits{sizeof(tactus_limits), stiffness_max_n_mm, force_cap_n};
    wantOk(tactus_tube_limits(handle_.get(), &limits),
           "limits: found one below 0 or not finite, wanted numbers from 0 on");
  }
  // A position or a time out of range lets the tube go (phase 0) and makes `status` TACTUS_BAD_ARGUMENT.
  Feel step(double position_mm, bool held, double dt_s, tactus_status* status = nullptr) noexcept {
    Feel feel{};
    feel.size = sizeof feel;
    feel.region = -1;
    const tactus_status done = tactus_tube_step(handle_.get(), position_mm, held ? 1 : 0, dt_s, &feel);
    if (status != nullptr) *status = done;
    return feel;
  }

  // Another tube in the same state.
  Tube copy() const {
    tactus_tube* handle = nullptr;
    wantOk(tactus_tube_copy(handle_.get(), &handle), "copy: found no tube or no memory, wanted both");
    return Tube(handle);
  }
  // How many bytes `save` writes. Thread and real time: as tactus_tube_save.
  std::size_t savedBytes() const noexcept { return tactus_tube_save(handle_.get(), nullptr, 0); }
  std::vector<unsigned char> save() const {
    std::vector<unsigned char> bytes(savedBytes());
    save(bytes.data(), bytes.size());
    return bytes;
  }
  // False, and nothing is written, where `size` is too small.
  bool save(void* bytes, std::size_t size) const noexcept {
    const std::size_t needed = tactus_tube_save(handle_.get(), bytes, size);
    return needed > 0 && needed <= size;
  }
  // False, and nothing changes, for bytes that are none of a tube of this scene.
  bool load(const void* bytes, std::size_t size) noexcept {
    return tactus_tube_load(handle_.get(), bytes, size) == TACTUS_OK;
  }
  bool load(const std::vector<unsigned char>& bytes) noexcept { return load(bytes.data(), bytes.size()); }

 private:
  explicit Tube(tactus_tube* handle) noexcept : handle_(handle) {}

  static void wantOk(tactus_status status, const char* sentence) {
    if (status != TACTUS_OK) TACTUS_THROW(Error(status, sentence));
  }

  std::unique_ptr<tactus_tube, detail::Free> handle_;
};

// Reads a bundle again; returns the largest error of the forces that it could evaluate, N. Throws where a file is
// missing, altered or beyond its tolerance.
inline double verify(const std::string& bundle_folder) {
  double largest_error_n = 0;
  detail::checked([&](char* message, std::size_t size) {
    return tactus_verify(bundle_folder.c_str(), &largest_error_n, message, size);
  });
  return largest_error_n;
}

inline std::string version() { return tactus_version(); }

}  // namespace tactus

#endif
