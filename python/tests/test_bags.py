"""rosbags reads what we write, and we read what rosbags writes."""

import math
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from rosbags.highlevel import AnyReader
from rosbags.rosbag2 import CompressionFormat, CompressionMode, StoragePlugin, Writer
from rosbags.typesys import Stores, get_typestore

import simbad_sonar as sonar

PROJECT = Path(__file__).resolve().parents[2]
DATA = PROJECT / "data" / "gap" / "angle-against-uniform"
STORE = get_typestore(Stores.ROS2_HUMBLE)
TYPES = STORE.types


def test_rosbags_reads_our_bag(tmp_path: Path) -> None:
    sonar.command("export", "bag", DATA, "--out", tmp_path / "bag")
    read = pd.read_csv(DATA / "readings.csv")
    with AnyReader([tmp_path / "bag"], default_typestore=STORE) as reader:
        connections = [c for c in reader.connections if c.msgtype == "sensor_msgs/msg/Range"]
        messages = [
            reader.deserialize(raw, connection.msgtype)
            for connection, _, raw in reader.messages(connections)
        ]
    assert len(messages) == len(read)
    ranges = np.array([message.range for message in messages])
    expected = read["range_m"].fillna(math.inf).to_numpy()
    np.testing.assert_allclose(ranges, expected, rtol=1e-6)
    assert messages[0].max_range == 6.0
    assert math.isclose(messages[0].field_of_view, math.radians(55), rel_tol=1e-6)


@pytest.mark.parametrize("plugin", [StoragePlugin.SQLITE3, StoragePlugin.MCAP])
@pytest.mark.parametrize("mode", [None, CompressionMode.FILE, CompressionMode.MESSAGE])
def test_ranges_of_a_bag_of_rosbags(
    tmp_path: Path, plugin: StoragePlugin, mode: CompressionMode | None
) -> None:
    # REP-117: nothing, too near, no number; the sonar 0.1 m ahead of a robot that looks along y.
    said = [1.25, math.inf, -math.inf, math.nan, 0.5]
    start = 1_700_000_000_000_000_000
    writer = Writer(tmp_path / "bag", version=8, storage_plugin=plugin)
    if mode is not None:
        writer.set_compression(mode, CompressionFormat.ZSTD)
    with writer:
        topics = [("/tf_static", "tf2_msgs/msg/TFMessage"), ("/sonar", "sensor_msgs/msg/Range")]
        where, read = [writer.add_connection(*t, typestore=STORE) for t in topics]
        links = [_link(start, "map", "base", 1.0, math.pi / 2), _link(start, "base", "eye", 0.1, 0)]
        message = TYPES[where.msgtype](transforms=links)
        writer.write(where, start, STORE.serialize_cdr(message, where.msgtype))
        for i, metres in enumerate(said):
            ns = start + i * 100_000_000
            message = TYPES[read.msgtype](
                header=_header(ns, "eye"),
                radiation_type=0,
                field_of_view=0.96,
                min_range=0.03,
                max_range=4.0,
                range=metres,
            )
            writer.write(read, ns, STORE.serialize_cdr(message, read.msgtype))
    told = sonar.command(
        "dataset", "bag", tmp_path / "bag", "--target", "round:50mm", "--out", tmp_path / "set"
    )
    assert "1 ranges left out: not a number" in told
    rows = pd.read_csv(tmp_path / "set" / "readings.csv")
    assert rows["range_m"].tolist()[::3] == [1.25, 0.5]
    assert rows["range_m"].isna().tolist() == [False, True, True, False]
    np.testing.assert_allclose(rows[["x_m", "z_m", "heading_deg"]], [[1.0, -0.1, 90.0]] * 4)


def _header(ns: int, frame: str) -> object:
    time = TYPES["builtin_interfaces/msg/Time"](sec=ns // 10**9, nanosec=ns % 10**9)
    return TYPES["std_msgs/msg/Header"](stamp=time, frame_id=frame)


def _link(ns: int, parent: str, child: str, x: float, yaw: float) -> object:
    turn = TYPES["geometry_msgs/msg/Quaternion"](
        x=0.0, y=0.0, z=math.sin(yaw / 2), w=math.cos(yaw / 2)
    )
    return TYPES["geometry_msgs/msg/TransformStamped"](
        header=_header(ns, parent),
        child_frame_id=child,
        transform=TYPES["geometry_msgs/msg/Transform"](
            translation=TYPES["geometry_msgs/msg/Vector3"](x=x, y=0.0, z=0.0), rotation=turn
        ),
    )


def test_motion_of_a_bag_of_rosbags(tmp_path: Path) -> None:
    vector, twist = TYPES["geometry_msgs/msg/Vector3"], TYPES["geometry_msgs/msg/Twist"]
    start = 1_700_000_000_000_000_000
    with Writer(tmp_path / "drive", version=8, storage_plugin=StoragePlugin.MCAP) as writer:
        told = writer.add_connection("/cmd_vel", twist.__msgtype__, typestore=STORE)
        moved = writer.add_connection("/odom", "nav_msgs/msg/Odometry", typestore=STORE)
        for i in range(100):
            ns = start + i * 50_000_000
            speed = vector(x=0.3, y=0.0, z=0.0)
            turn = vector(x=0.0, y=0.0, z=0.2)
            message = twist(linear=speed, angular=turn)
            writer.write(told, ns, STORE.serialize_cdr(message, twist.__msgtype__))
            writer.write(moved, ns, STORE.serialize_cdr(_odometry(ns, i), "nav_msgs/msg/Odometry"))
    folder = tmp_path / "motion"
    said = sonar.command("dataset", "motion", "bag", tmp_path / "drive", "--out", folder)
    assert "they come from odometry" in said
    commands = pd.read_csv(folder / "commands.csv")
    track = pd.read_csv(folder / "track.csv")
    assert len(commands) == len(track) == 100
    assert np.allclose(track["x_m"], 0.015 * np.arange(100), atol=1e-4)
    assert np.allclose(track["z_m"], 0.0, atol=1e-6)


def _odometry(ns: int, i: int) -> object:
    zero = TYPES["geometry_msgs/msg/Vector3"](x=0.0, y=0.0, z=0.0)
    return TYPES["nav_msgs/msg/Odometry"](
        header=_header(ns, "odom"),
        child_frame_id="base_link",
        pose=TYPES["geometry_msgs/msg/PoseWithCovariance"](
            pose=TYPES["geometry_msgs/msg/Pose"](
                position=TYPES["geometry_msgs/msg/Point"](x=0.015 * i, y=0.0, z=0.0),
                orientation=TYPES["geometry_msgs/msg/Quaternion"](x=0.0, y=0.0, z=0.0, w=1.0),
            ),
            covariance=np.zeros(36),
        ),
        twist=TYPES["geometry_msgs/msg/TwistWithCovariance"](
            twist=TYPES["geometry_msgs/msg/Twist"](linear=zero, angular=zero),
            covariance=np.zeros(36),
        ),
    )
