"""The tube in MuJoCo for Python: a tip on a slide joint, pushed by a scripted hand.

    pip install mujoco tactus
    python3 mujoco_tube.py BUNDLE

First each step of BUNDLE/checks_tube.csv with the tip of the engine put where the row says, then two strokes of a free
hand of 0.3 kg. MuJoCo works in m, the tube in mm; both in N.
"""
import sys

import mujoco
import tactus

from traces import prove

SCENE = """<mujoco>
  <option timestep="0.001" gravity="0 0 0" integrator="implicitfast"/>
  <worldbody>
    <body name="tip">
      <joint name="axis" type="slide" axis="1 0 0" damping="2"/>
      <geom type="capsule" fromto="-0.05 0 0 0 0 0" size="0.0025" mass="0.3" contype="0" conaffinity="0"/>
    </body>
  </worldbody>
</mujoco>"""


def main(bundle):
    model = mujoco.MjModel.from_xml_string(SCENE)
    data = mujoco.MjData(model)

    def put(position_mm):
        data.qpos[0] = position_mm / 1000
        mujoco.mj_forward(model, data)
        return data.xpos[1][0] * 1000

    worst = prove(bundle, put)

    mujoco.mj_resetData(model, data)
    force_model = tactus.Model.open(f"{bundle}/model.tactus.json")
    middle = {name: (low + high) / 2
              for name, (low, high) in zip(force_model.input_ids, force_model.input_ranges)
              if name not in ("depth", "speed")}
    tube = tactus.Tube(force_model.scene(middle))
    feel, largest = None, 0.0
    for tick in range(2400):
        along = min(tick % 1200 / 800, 1)
        aim = 0.06 * (tick // 1200 + along ** 3 * (10 + along * (6 * along - 15)))
        feel = tube.step(data.qpos[0] * 1000, tick % 1200 < 900, 0.001)
        data.qfrc_applied[0] = 400 * (aim - data.qpos[0]) - 12 * data.qvel[0] - feel.force_n
        mujoco.mj_step(model, data)
        largest = max(largest, abs(feel.force_n))
    print(f"free hand: {feel.stroke} strokes, depth {feel.depth_mm:.1f} mm, largest force {largest:.2f} N")
    return 0 if worst <= 1e-12 and feel.stroke == 2 else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
