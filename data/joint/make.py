"""Makes wheels-too-large, a joint log, and golden-drive: python3 make.py, in this folder.

Shares no code with the program: a robot with two wheels that are 5 % larger than it believes drives
round two posts before a tracker, and four sonars read. golden-drive is a short drive of a robot
that is late and turns by itself, with the forecast of its windows in closed form (held commands
make arcs), as the text that predict has to write but for rounding.
"""
import json
import math
import pathlib
import random

HERE = pathlib.Path(__file__).parent
BASE_M, WHEELS, DT = 0.2, 1.05, 0.005
POSTS = {"thin": (0.0, 0.0, 0.06, 1.6), "thick": (1.5, 0.7, 0.15, 1.7)}
CONE_DEG, NOISE_M, EDGE_M, STEP_M, MISSES = 25.0, 0.004, 0.03, 0.01, 0.01
MOUNTS = {"ahead": (0.07, 0.0, 0.0), "left": (0.0, -0.07, 90.0),
          "back": (-0.07, 0.0, 180.0), "right": (0.0, 0.07, -90.0)}
SIGMA_M, SIGMA_DEG = 0.001, 0.15


def outline(radius):
    """A polygon of 24 corners, as the scene has it."""
    return [(radius * math.cos(2 * math.pi * k / 24), radius * math.sin(2 * math.pi * k / 24)) for k in range(24)]


def points(name):
    x, z, radius, _ = POSTS[name]
    corners = outline(radius)
    for (ax, az), (bx, bz) in zip(corners, corners[1:] + corners[:1]):
        for k in range(10):
            yield x + ax + (bx - ax) * k / 10, z + az + (bz - az) * k / 10


OUTLINES = {name: list(points(name)) for name in POSTS}


def read(x, z, heading, chance):
    """The nearest point in the cone of a post that is near enough to be heard."""
    best = math.inf
    for name, (px, pz, _, reach) in POSTS.items():
        over = (reach - math.hypot(x - px, z - pz)) / EDGE_M
        heard = chance.random() < (1 - MISSES) / (1 + math.exp(-max(-60, min(60, over))))
        if not heard:
            continue
        for qx, qz in OUTLINES[name]:
            off = math.atan2(z - qz, qx - x) - heading
            if abs(math.remainder(off, 2 * math.pi)) <= math.radians(CONE_DEG):
                best = min(best, math.hypot(qx - x, qz - z))
    if not 0.03 <= best <= 4:
        return ""
    return f"{math.floor((best + chance.gauss(0, NOISE_M)) / STEP_M + 1e-9) * STEP_M:.3f}"


def free(x, z, heading, v, w, held):
    for _ in range(int(held / 0.1) + 6):
        heading += 0.1 * w
        x += 0.11 * v * math.cos(heading)
        z -= 0.11 * v * math.sin(heading)
        if max(abs(x), abs(z)) > 1.9 or any(math.hypot(x - p[0], z - p[1]) < 0.3 + p[2] for p in POSTS.values()):
            return False
    return True


def drive(run, seconds, chance, commands, track, readings):
    x, z, heading = -0.8, 0.7, 0.4
    bx, bz, bheading = x, z, heading
    until, v, w = 0.0, 0.0, 0.0
    for i in range(int(seconds / DT)):
        t = i * DT
        if t >= until:
            held = round(0.8 + 1.6 * chance.random(), 2)
            for _ in range(300):
                v, w = round(0.05 + 0.25 * chance.random(), 3), round(1.6 * chance.random() - 0.8, 3)
                if free(x, z, heading, v, w, held):
                    break
            else:
                v, w = 0.0, 0.7
            commands.append(f"{run},{t:.3f},{v - w * BASE_M / 2:.6f},{v + w * BASE_M / 2:.6f}")
            until = t + held
        if i % 20 == 0:
            degrees = math.degrees(math.remainder(heading, 2 * math.pi)) + chance.gauss(0, SIGMA_DEG)
            track.append(f"{run},{t:.3f},{x + chance.gauss(0, SIGMA_M):.5f},"
                         f"{z + chance.gauss(0, SIGMA_M):.5f},{degrees:.4f}")
        if i % 60 == 0:
            for name, (mx, mz, turn) in MOUNTS.items():
                sx = x + mx * math.cos(heading) + mz * math.sin(heading)
                sz = z - mx * math.sin(heading) + mz * math.cos(heading)
                got = read(sx, sz, heading + math.radians(turn), chance)
                degrees = math.degrees(math.remainder(bheading, 2 * math.pi))
                readings.append(f"{run},{name},{t:.3f},{bx:.5f},{bz:.5f},{degrees:.4f},{got}")
        # Where it believes to be, and where it is.
        bx += v * DT * math.cos(bheading + w * DT / 2)
        bz -= v * DT * math.sin(bheading + w * DT / 2)
        bheading += w * DT
        turn = WHEELS * w * DT
        x += WHEELS * v * DT * math.cos(heading + turn / 2)
        z -= WHEELS * v * DT * math.sin(heading + turn / 2)
        heading += turn


def write(folder, name, lines):
    (HERE / folder).mkdir(exist_ok=True)
    (HERE / folder / name).write_text("\n".join(lines) + "\n")


def joint():
    chance = random.Random(7)
    commands, track, readings = [], [], []
    for run in ("first", "second", "third"):
        drive(run, 30, chance, commands, track, readings)
    folder = "wheels-too-large"
    write(folder, "commands.csv", ["run,t_s,left_m_s,right_m_s"] + commands)
    write(folder, "track.csv", ["run,t_s,x_m,z_m,heading_deg"] + track)
    write(folder, "readings.csv", ["run,sensor,t_s,x_m,z_m,heading_deg,range_m"] + readings)
    robot = {"format": "motion-gap/1", "kinematics": "differential", "wheel_radius_m": 0.03,
             "wheel_base_m": BASE_M, "track_sigma_m": SIGMA_M, "track_sigma_deg": SIGMA_DEG}
    write(folder, "robot.json", [json.dumps(robot, indent=2)])
    scene = {
        "format": "sonar-gap/2", "no_echo_m": 4.0,
        "sensor": {"name": "sonar", "cone_half_angle_deg": CONE_DEG, "min_range_m": 0.03, "max_range_m": 4.0,
                   "mount_height_m": 0.1, "assumed_sound_speed_m_s": 343.0, "resolution_m": STEP_M,
                   "range_noise_m": NOISE_M, "miss_rate": MISSES, "edge_width_m": EDGE_M, "update_period_s": 0.06},
        "sensors": {name: {"x_m": m[0], "z_m": m[1], "turn_deg": m[2]} for name, m in MOUNTS.items()},
        "obstacles": [{"name": name, "x_m": p[0], "z_m": p[1], "turn_deg": 0.0,
                       "outline_m": [[round(x, 6), round(z, 6)] for x, z in outline(p[2])],
                       "detection": "uniform", "uniform_range_m": p[3]} for name, p in POSTS.items()]}
    write(folder, "scene.json", [json.dumps(scene)])


LATE_S, BIAS = 0.23, 0.013


def state(commands, t):
    """Where a robot is that began to act LATE_S late and turns by BIAS besides: arcs in closed form."""
    x = y = heading = 0.0
    ends = [c[0] + LATE_S for c in commands[1:]] + [math.inf]
    begin = 0.0
    pieces = [(0.0, commands[0][0] + LATE_S, 0.0, 0.0)]
    pieces += [(c[0] + LATE_S, e, c[1], c[2]) for c, e in zip(commands, ends)]
    for begin, end, v, w in pieces:
        held = min(end, t) - begin
        if held <= 0:
            break
        turn = (w + BIAS) * held
        chord = v * held * math.sin(turn / 2) / (turn / 2)
        x += chord * math.cos(heading + turn / 2)
        y += chord * math.sin(heading + turn / 2)
        heading += turn
    return x, y, heading


def golden():
    folder = "golden-drive"
    commands = [(0.0, 0.2, 0.0), (1.5, 0.25, 0.6), (3.1, 0.1, -0.9), (4.4, 0.0, 0.0), (5.2, 0.3, 0.2), (8.0, 0.15, -0.4)]
    write(folder, "commands.csv", ["run,t_s,v_m_s,w_rad_s"] + [f"a,{c[0]},{c[1]},{c[2]}" for c in commands])
    rows = []
    for i in range(101):
        x, y, heading = state(commands, i * 0.1)
        rows.append(f"a,{i * 0.1:.1f},{x:.9f},{-y:.9f},{math.degrees(heading):.9f}")
    write(folder, "track.csv", ["run,t_s,x_m,z_m,heading_deg"] + rows)
    robot = {"format": "motion-gap/1", "kinematics": "unicycle", "track_sigma_m": 0.001, "track_sigma_deg": 0.1}
    write(folder, "robot.json", [json.dumps(robot, indent=2)])
    spread = [round(0.001 * (k - 9), 3) for k in range(19)]
    forms = [{"form": "actuation-latency", "parameters": {"latency_s": LATE_S}},
             {"form": "turn-bias", "parameters": {"bias_rad_s": BIAS}}]
    spreads = [{"horizon_s": h, "exertion_limits_m": [], "along_m": [spread], "across_m": [spread], "turn_rad": [spread]}
               for h in (0.5, 2.0, 5.0)]
    write(folder, "motion.json", [json.dumps({"format": "motion-model/1", "forms": forms, "spread": spreads})])
    names = [f"{c}_q{5 * (k + 1):02d}" for c in ("along_m", "across_m", "turn_deg") for k in range(19)]
    lines = ["run,t_s,horizon_s," + ",".join(names)]
    for i in range(20):
        start = i * 0.5
        for horizon in (0.5, 2.0, 5.0):
            if start + horizon > 10.0:
                continue
            x, y, heading = state(commands, start)
            ex, ey, eheading = state(commands, start + horizon)
            along = (ex - x) * math.cos(heading) + (ey - y) * math.sin(heading)
            across = (ey - y) * math.cos(heading) - (ex - x) * math.sin(heading)
            row = [along + s for s in spread] + [across + s for s in spread]
            row += [math.degrees(eheading - heading + s) for s in spread]
            lines.append(f"a,{start},{horizon}," + ",".join(f"{value:.6f}" for value in row))
    write(folder, "windows.csv", lines)


joint()
golden()
