// libtactus for C++17: header only, a thin layer over tactus.h, which says everything about threads and real time.
//
//   const auto model = tactus::Model::open("model.tactus.json");
//   const double force_n = model.force({1.0, 45.0, 30.0, 30.0});
//   const auto scene = model.scene({{"lubrication", 1.0}, {"neck_flexion", 45.0}});
//   tactus::Tube tube(scene);
//   const tactus::Feel feel = tube.step(position_mm, held, 0.001);
//
// Objects are moved, never copied; an object that was moved from is empty and gives forces of 0. What cannot be made
// throws tactus::Error; forces and steps throw only where the number of inputs is wrong.
#ifndef TACTUS_TACTUS_HPP
#define TACTUS_TACTUS_HPP

#include <cstddef>
#include <initializer_list>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tactus.h"

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

namespace detail {

inline constexpr std::size_t kMessageBytes = 1024;

// Calls `make(message, size)`; throws where it fails, and returns the warning, if any, where it does not.
template <typename Make>
std::string checked(Make&& make) {
  char message[kMessageBytes];
  const tactus_status status = make(message, sizeof message);
  if (status != TACTUS_OK) throw Error(status, message);
  return message;
}

struct Free {
  void operator()(tactus_model* model) const noexcept { tactus_model_free(model); }
  void operator()(tactus_scene* scene) const noexcept { tactus_scene_free(scene); }
  void operator()(tactus_tube* tube) const noexcept { tactus_tube_free(tube); }
};

inline void wantInputs(std::size_t found, std::size_t wanted) {
  if (found == wanted) return;
  throw Error(TACTUS_BAD_ARGUMENT,
              "inputs: found " + std::to_string(found) + " values, wanted " + std::to_string(wanted));
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
  std::size_t inputs() const noexcept { return tactus_model_inputs(get()); }
  std::string inputId(std::size_t input) const { return text(tactus_model_input_id(get(), input)); }
  std::string inputUnit(std::size_t input) const { return text(tactus_model_input_unit(get(), input)); }
  double inputMin(std::size_t input) const noexcept { return tactus_model_input_min(get(), input); }
  double inputMax(std::size_t input) const noexcept { return tactus_model_input_max(get(), input); }
  double outputMin() const noexcept { return tactus_model_output_min(get()); }
  double outputMax() const noexcept { return tactus_model_output_max(get()); }
  std::size_t experts() const noexcept { return tactus_model_experts(get()); }
  std::string expertId(std::size_t expert) const { return text(tactus_model_expert_id(get(), expert)); }
  double expertWeight(std::size_t expert) const noexcept { return tactus_model_expert_weight(get(), expert); }

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
      throw Error(TACTUS_BAD_ARGUMENT,
                  "expert: found " + std::to_string(expert) + ", wanted less than " + std::to_string(experts()));
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

  // Bit i: input i is outside its universe and is clamped. `inputs`: inputs() values.
  unsigned clamped(const double* inputs) const noexcept { return tactus_clamped(get(), inputs); }

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
    throw Error(TACTUS_BAD_ARGUMENT, "scene: found the input '" + std::string(id) + "', wanted one of the model");
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
  // A position or a time out of range lets the tube go (phase 0).
  Feel step(double position_mm, bool held, double dt_s) noexcept {
    Feel feel{};
    feel.size = sizeof feel;
    tactus_tube_step(handle_.get(), position_mm, held ? 1 : 0, dt_s, &feel);
    return feel;
  }

 private:
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
