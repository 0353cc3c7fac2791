"""The tube in Isaac Lab: many environments at once, one tube each. To be called once per physics step.

    tubes = Tubes("model.tactus.json", {"lubrication": 1.0, "neck_flexion": 45.0}, environments, physics_dt)
    forces = tubes.step(tip_z_m.tolist(), held.tolist())     # one number for each environment
    tool.set_external_force_and_torque(...)                  # minus these along the axis of insertion

Physics at 200 Hz is slower than a hand feels: the tube takes sub-steps of about a millisecond between two positions.
"""
import tactus


class Tubes:
    def __init__(self, model_path, conditions, environments, physics_dt_s, tube_dt_s=0.001):
        scene = tactus.Model.open(model_path).scene(conditions)
        self.tubes = [tactus.Tube(scene) for _ in range(environments)]
        self.steps = max(1, round(physics_dt_s / tube_dt_s))
        self.dt_s = physics_dt_s / self.steps
        self.before_mm = None

    def step(self, tip_m, held):
        """The resistance in N of each environment, from the position of its tip (m, inwards) and whether it is held."""
        now_mm = [1000 * along for along in tip_m]
        before_mm, self.before_mm = self.before_mm or now_mm, now_mm
        forces = []
        for tube, before, now, is_held in zip(self.tubes, before_mm, now_mm, held):
            for k in range(1, self.steps + 1):
                feel = tube.step(before + (now - before) * k / self.steps, is_held, self.dt_s)
            forces.append(feel.force_n)
        return forces
