"""Makes the recordings in this folder, with rosbags 0.11.0 and mcap 1.2.2 (PyPI): see README.md.

A robot drives past a post of 5 cm, with one sonar ahead and one to the right. Ranges are those of
the geometry, with a scatter of 3 mm; nothing is hidden in them.
"""

import math
import pathlib
import random
import sys

from mcap.writer import CompressionType
from mcap.writer import Writer as McapWriter
from rosbags.rosbag2 import CompressionFormat, CompressionMode, StoragePlugin, Writer
from rosbags.typesys import Stores, get_typestore

STORE = get_typestore(Stores.ROS2_HUMBLE)
T = STORE.types
POST = (1.5, -0.4)
RADIUS = 0.025
SONARS = {"sonar_front": (0.10, 0.0, 0.0), "sonar_right": (0.0, -0.08, -math.pi / 2)}
HALF_CONE = math.radians(27.5)
LEAST, MOST = 0.03, 4.0
START_NS = 1_700_000_000_000_000_000


def stamp(ns):
    return T["builtin_interfaces/msg/Time"](sec=ns // 10**9, nanosec=ns % 10**9)


def header(ns, frame):
    return T["std_msgs/msg/Header"](stamp=stamp(ns), frame_id=frame)


def transform(ns, parent, child, x, y, z, yaw):
    return T["geometry_msgs/msg/TransformStamped"](
        header=header(ns, parent),
        child_frame_id=child,
        transform=T["geometry_msgs/msg/Transform"](
            translation=T["geometry_msgs/msg/Vector3"](x=x, y=y, z=z),
            rotation=T["geometry_msgs/msg/Quaternion"](
                x=0.0, y=0.0, z=math.sin(yaw / 2), w=math.cos(yaw / 2)
            ),
        ),
    )


def reading(chance, x, y, yaw):
    dx, dy = POST[0] - x, POST[1] - y
    off = math.atan2(dy, dx) - yaw
    off = math.atan2(math.sin(off), math.cos(off))
    distance = math.hypot(dx, dy) - RADIUS
    if abs(off) > HALF_CONE or distance > 1.2:
        return math.inf
    if distance < LEAST:
        return -math.inf
    return distance + chance.gauss(0, 0.003)


def messages():
    """Yields topic, type, time in ns, message."""
    chance = random.Random(5)
    fixed = [
        transform(START_NS, "base_link", name, x, y, 0.15, yaw)
        for name, (x, y, yaw) in SONARS.items()
    ]
    kind = "tf2_msgs/msg/TFMessage"
    yield "/tf_static", kind, START_NS, T[kind](transforms=fixed)
    for i in range(151):
        ns = START_NS + i * 20_000_000
        s = i / 150
        x, y, yaw = 2.5 * s, 0.1 * math.sin(3 * s), 0.1 * math.cos(3 * s)
        moved = transform(ns, "odom", "base_link", x, y, 0.0, yaw)
        yield "/tf", kind, ns, T[kind](transforms=[moved])
        if i % 3 == 1:
            for name, (mx, my, turn) in SONARS.items():
                sx = x + mx * math.cos(yaw) - my * math.sin(yaw)
                sy = y + mx * math.sin(yaw) + my * math.cos(yaw)
                read = reading(chance, sx, sy, yaw + turn)
                if i == 100:
                    read = math.nan
                message = T["sensor_msgs/msg/Range"](
                    header=header(ns, name),
                    radiation_type=0,
                    field_of_view=2 * HALF_CONE,
                    min_range=LEAST,
                    max_range=MOST,
                    range=read,
                )
                yield "/" + name, "sensor_msgs/msg/Range", ns, message


def rosbag(folder, plugin, mode=None):
    writer = Writer(folder, version=8, storage_plugin=plugin)
    if mode is not None:
        writer.set_compression(mode, CompressionFormat.ZSTD)
    with writer:
        connections = {}
        for topic, kind, ns, message in messages():
            if topic not in connections:
                connections[topic] = writer.add_connection(topic, kind, typestore=STORE)
            writer.write(connections[topic], ns, STORE.serialize_cdr(message, kind))


def mcap(file, compression):
    """Small chunks, so that there are several."""
    with open(file, "wb") as stream:
        writer = McapWriter(stream, chunk_size=8192, compression=compression)
        writer.start(profile="ros2", library="")
        schemas, channels = {}, {}
        for topic, kind, ns, message in messages():
            if kind not in schemas:
                schemas[kind] = writer.register_schema(kind, "ros2msg", b"")
            if topic not in channels:
                channels[topic] = writer.register_channel(topic, "cdr", schemas[kind])
            data = bytes(STORE.serialize_cdr(message, kind))
            writer.add_message(channels[topic], log_time=ns, publish_time=ns, data=data)
        writer.finish()


def main(out):
    out = pathlib.Path(out)
    rosbag(out / "post", StoragePlugin.SQLITE3)
    rosbag(out / "post-mcap", StoragePlugin.MCAP)
    rosbag(out / "post-message-zstd", StoragePlugin.SQLITE3, CompressionMode.MESSAGE)
    rosbag(out / "post-file-zstd", StoragePlugin.SQLITE3, CompressionMode.FILE)
    mcap(out / "post-plain.mcap", CompressionType.NONE)
    mcap(out / "post-lz4.mcap", CompressionType.LZ4)
    mcap(out / "post-zstd.mcap", CompressionType.ZSTD)


if __name__ == "__main__":
    main(sys.argv[1])
