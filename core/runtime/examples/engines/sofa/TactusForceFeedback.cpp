// A force feedback of SOFA that is felt as the tube of a Tactus model: along one axis, nothing across it.
//   <TactusForceFeedback model="model.tactus.json" conditions="1 45" axis="0 0 1" millimetres="1000" activate="true"/>
// Needs the headers of SOFA and libtactus; see CMakeLists.txt beside it. The device's thread calls computeForce.
#include <chrono>
#include <memory>
#include <sofa/component/haptics/ForceFeedback.h>
#include <sofa/core/ObjectFactory.h>
#include <string>
#include <string_view>
#include <tactus/tactus.hpp>
#include <utility>
#include <vector>

namespace tactus_sofa {

class TactusForceFeedback : public sofa::component::haptics::ForceFeedback {
 public:
  SOFA_CLASS(TactusForceFeedback, sofa::component::haptics::ForceFeedback);
  using Solid = sofa::defaulttype::SolidTypes<SReal>;

  sofa::Data<std::string> d_model{initData(&d_model, "model", "path of the model file")};
  sofa::Data<sofa::type::vector<double>> d_conditions{
      initData(&d_conditions, "conditions", "values of the inputs but depth and speed, in the model's order")};
  sofa::Data<sofa::type::Vec3> d_axis{
      initData(&d_axis, sofa::type::Vec3(0, 0, 1), "axis", "axis of insertion, inwards, of length 1")};
  sofa::Data<double> d_millimetres{initData(&d_millimetres, 1.0, "millimetres", "mm of one unit of the scene")};

  void init() override {
    ForceFeedback::init();
    try {
      const tactus::Model model = tactus::Model::open(d_model.getValue());
      std::vector<std::pair<std::string, double>> fixed;
      for (std::size_t i = 0, next = 0; i < model.inputs(); ++i) {
        const std::string id = model.inputId(i);
        if (std::string_view(model.inputRole(i)) == "condition")
          fixed.emplace_back(id, d_conditions.getValue().at(next++));
      }
      tube_ = std::make_unique<tactus::Tube>(model.scene(fixed));
    } catch (const std::exception& wrong) {
      msg_error() << wrong.what();
    }
  }

  void computeForce(SReal x, SReal y, SReal z, SReal, SReal, SReal, SReal, SReal& fx, SReal& fy, SReal& fz) override {
    const auto now = std::chrono::steady_clock::now();
    const double dt_s = std::chrono::duration<double>(now - std::exchange(last_, now)).count();
    const sofa::type::Vec3 axis = d_axis.getValue();
    const double along = x * axis[0] + y * axis[1] + z * axis[2];
    // isEnabled: the button or the scene. The force is the resistance, so it points outwards.
    const double force_n = tube_ ? tube_->step(along * d_millimetres.getValue(), isEnabled(), dt_s).force_n : 0;
    fx = -force_n * axis[0];
    fy = -force_n * axis[1];
    fz = -force_n * axis[2];
  }

  void computeWrench(const Solid::Transform& tool, const Solid::SpatialVector&, Solid::SpatialVector& wrench) override {
    const auto& at = tool.getOrigin();
    SReal fx = 0, fy = 0, fz = 0;
    computeForce(at[0], at[1], at[2], 0, 0, 0, 1, fx, fy, fz);
    wrench.clear();
    wrench.setForce({fx, fy, fz});
  }

 private:
  std::unique_ptr<tactus::Tube> tube_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace tactus_sofa

extern "C" {
SOFA_EXPORT_DYNAMIC_LIBRARY void initExternalModule() {}
SOFA_EXPORT_DYNAMIC_LIBRARY const char* getModuleName() { return MODULE_NAME; }
SOFA_EXPORT_DYNAMIC_LIBRARY const char* getModuleVersion() { return MODULE_VERSION; }
SOFA_EXPORT_DYNAMIC_LIBRARY void registerObjects(sofa::core::ObjectFactory* factory) {
  factory->registerObjects(
      sofa::core::ObjectRegistrationData("Feels the tube of a Tactus model").add<tactus_sofa::TactusForceFeedback>());
}
}
