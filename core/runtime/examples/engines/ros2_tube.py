"""A node of ROS 2 that feels the tube: the pose of the tool in, the wrench on the hand out.

    ros2 run … or: python3 ros2_tube.py --ros-args -p model:=model.tactus.json -p conditions:="[1.0, 45.0]"

Subscribes `pose` (geometry_msgs/PoseStamped, m; the axis of insertion is z of its frame) and `held` (std_msgs/Bool),
publishes `wrench` (geometry_msgs/WrenchStamped, N). At the rate of the poses: a node in Python has no firm 1 kHz; where
that matters, call libtactus in the driver's own loop.
"""
import rclpy
import tactus
from geometry_msgs.msg import PoseStamped, WrenchStamped
from rclpy.node import Node
from std_msgs.msg import Bool


class TubeNode(Node):
    def __init__(self):
        super().__init__("tactus_tube")
        path = self.declare_parameter("model", "model.tactus.json").value
        values = self.declare_parameter("conditions", [1.0, 45.0]).value
        model = tactus.Model.open(path)
        free = [name for name in model.input_ids if name not in ("depth", "speed")]
        self.tube = tactus.Tube(model.scene(dict(zip(free, values))))
        self.held = False
        self.before_ns = None
        self.wrench = self.create_publisher(WrenchStamped, "wrench", 1)
        self.create_subscription(Bool, "held", lambda message: setattr(self, "held", message.data), 1)
        self.create_subscription(PoseStamped, "pose", self.feel, 1)

    def feel(self, pose):
        now_ns = pose.header.stamp.sec * 1_000_000_000 + pose.header.stamp.nanosec
        if self.before_ns is None or now_ns <= self.before_ns:
            self.before_ns = now_ns
            return
        dt_s, self.before_ns = (now_ns - self.before_ns) / 1e9, now_ns
        feel = self.tube.step(pose.pose.position.z * 1000, self.held, dt_s)
        message = WrenchStamped()
        message.header = pose.header
        message.wrench.force.z = -feel.force_n
        self.wrench.publish(message)


def main():
    rclpy.init()
    rclpy.spin(TubeNode())


if __name__ == "__main__":
    main()
