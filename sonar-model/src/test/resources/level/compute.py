#!/usr/bin/env python3
"""Golden values of the level law, from its formula in the format's description alone.

Writes scenes, rows and values into the folder in which it stands:

    python3 compute.py        (needs SciPy; versions stand in README.md)

The formula, with r the distance to the obstacle's centre, d that to the nearest point of its
outline, phi the off-axis angle of that point (of two equally near points the one nearer the axis),
b the bearing:

    excess = level + strength(b) + beam_two_way(phi) - 20 n log10(r) - 2 a r - receiver(r)
    chance = (1 - miss_rate) Phi(excess / sd), within min and max range
    reading = d + walk(excess) + noise(excess), then the resolution

Several targets: at the moment at which echo k arrives the receiver sees E_k, the sum of the energies
of the echoes that arrived at most a pulse length before it, itself among them. Crossings d_k +
walk(E_k) are taken in their order; nothing is heard up to the k-th with probability
S_k = min(S_(k-1), S_b (1 - (1 - miss_rate) Phi(E_k / sd))), b being the last one before it whose
distance differs by more than a pulse length.

Nothing here was taken from the program that is tested with it.
"""
import csv
import json
import math
import pathlib
import random

from scipy.special import j1
from scipy.stats import norm

HERE = pathlib.Path(__file__).parent
TAU = 2 * math.pi


# ---------------------------------------------------------------- air and beam


def sound_speed(celsius):
    return 331.3 * math.sqrt(1 + celsius / 273.15)


def absorption(hz, celsius, percent):
    """ISO 9613-1:1993, equations 3 to 5 and B.3, one atmosphere: dB per metre."""
    t = celsius + 273.15
    t0 = 293.15
    saturation = 10 ** (-6.8346 * (273.16 / t) ** 1.261 + 4.6151)
    h = percent * saturation
    oxygen = 24 + 4.04e4 * h * (0.02 + h) / (0.391 + h)
    nitrogen = (t / t0) ** -0.5 * (9 + 280 * h * math.exp(-4.170 * ((t / t0) ** (-1 / 3) - 1)))
    return 8.686 * hz**2 * (
        1.84e-11 * (t / t0) ** 0.5
        + (t / t0) ** -2.5
        * (
            0.01275 * math.exp(-2239.1 / t) / (oxygen + hz**2 / oxygen)
            + 0.1068 * math.exp(-3352.0 / t) / (nitrogen + hz**2 / nitrogen)
        )
    )


def curve(points, x):
    if x <= points[0][0]:
        return points[0][1]
    for (x0, y0), (x1, y1) in zip(points, points[1:]):
        if x < x1:
            return y0 + (y1 - y0) * (x - x0) / (x1 - x0)
    return points[-1][1]


class Law:
    def __init__(self, sensor):
        level = sensor["level"]
        celsius = level.get("temperature_c", 20)
        hz = level.get("frequency_hz", 40000)
        self.sensor = sensor
        self.level = level
        self.speed = sound_speed(celsius)
        self.k = TAU * hz / self.speed
        self.a = level.get("absorption_db_per_m")
        if self.a is None:
            self.a = absorption(hz, celsius, level.get("humidity_percent", 50))
        self.pulse = self.speed * level["pulse_length_s"] / 2

    def beam(self, phi):
        beam = self.level["beam"]
        if "two_way_db" in beam:
            return curve(beam["two_way_db"], math.degrees(phi))
        if phi > math.pi / 2:
            return -math.inf
        x = self.k * beam["aperture_radius_m"] * math.sin(phi)
        return 40 * math.log10(abs(2 * j1(x) / x)) if x else 0.0

    def loss(self, r):
        n = self.level["spreading_exponent"]
        receiver = curve(self.level["receiver_threshold_db"], r)
        return 20 * n * math.log10(r) + 2 * self.a * r + receiver

    def strength(self, obstacle, b):
        """b in degrees, [0, 360)."""
        if obstacle["detection"] == "strength":
            values = obstacle["strength_db"]
            spacing = 360 / len(values)
            i = int(b // spacing)
            share = b / spacing - i
            return values[i] + share * (values[(i + 1) % len(values)] - values[i])
        threshold = obstacle.get("uniform_range_m")
        if threshold is None:
            threshold = polygon_radius(obstacle["thresholds_m"], b)
        if threshold == 0:
            return -math.inf
        return self.loss(threshold) - self.level["level_db"] - self.beam(0)


def polygon_radius(radii, b):
    """Of the polygon whose corners lie at even bearings: a ray cut with its edge."""
    spacing = 360 / len(radii)
    i = int(b // spacing)
    corner = lambda j: (
        radii[j % len(radii)] * math.sin(math.radians(j * spacing)),
        radii[j % len(radii)] * math.cos(math.radians(j * spacing)),
    )
    (x0, z0), (x1, z1) = corner(i), corner(i + 1)
    if radii[i % len(radii)] == 0 or radii[(i + 1) % len(radii)] == 0:
        return 0.0
    dx, dz = math.sin(math.radians(b)), math.cos(math.radians(b))
    # t d = p + u (q - p)
    det = dx * -(z1 - z0) + dz * (x1 - x0)
    return (x0 * -(z1 - z0) + z0 * (x1 - x0)) / det


# ---------------------------------------------------------------- geometry


def world(obstacle):
    a = math.radians(obstacle["turn_deg"])
    for x, z in obstacle["outline_m"]:
        yield (
            x * math.cos(a) + z * math.sin(a) + obstacle["x_m"],
            -x * math.sin(a) + z * math.cos(a) + obstacle["z_m"],
        )


def feet(obstacle, x, z):
    corners = list(world(obstacle))
    for (ax, az), (bx, bz) in zip(corners, corners[1:] + corners[:1]):
        ex, ez = bx - ax, bz - az
        t = ((x - ax) * ex + (z - az) * ez) / (ex * ex + ez * ez)
        t = min(1.0, max(0.0, t))
        yield ax + t * ex, az + t * ez


def sight(law, obstacle, row):
    x, z, heading = row
    points = [(math.hypot(px - x, pz - z), px, pz) for px, pz in feet(obstacle, x, z)]
    d = min(points)[0]

    def off_axis(px, pz):
        off = math.atan2(-(pz - z), px - x) - math.radians(heading)
        return abs((off + math.pi) % TAU - math.pi)

    phi = min(off_axis(px, pz) for distance, px, pz in points if distance <= d * (1 + 1e-9))
    dx, dz = x - obstacle["x_m"], z - obstacle["z_m"]
    r = math.hypot(dx, dz)
    b = (math.degrees(math.atan2(dx, dz)) - obstacle["turn_deg"]) % 360
    excess = (
        law.level["level_db"] + law.strength(obstacle, b) + law.beam(phi) - law.loss(r)
    )
    in_range = law.sensor["min_range_m"] <= d <= law.sensor["max_range_m"]
    p = chance(law, excess) if in_range else 0.0
    return dict(r=r, b=b, d=d, phi=math.degrees(phi), excess=excess, p=p, in_range=in_range)


def chance(law, excess):
    return (1 - law.sensor["miss_rate"]) * float(norm.cdf(excess / law.level["excess_sd_db"]))


# ---------------------------------------------------------------- several targets


def mixture(law, sights):
    """[(mean, deviation, share)] and the probability of no echo."""
    echoes = [s for s in sights if s["in_range"] and s["excess"] > -math.inf]
    for s in echoes:
        energy = sum(
            10 ** (o["excess"] / 10) for o in echoes if 0 <= s["d"] - o["d"] <= law.pulse
        )
        s["total"] = 10 * math.log10(energy)
        s["at"] = s["d"] + curve(law.level["walk_m"], s["total"])
    echoes.sort(key=lambda s: (s["at"], s["d"]))
    silences, parts = [], []
    for i, s in enumerate(echoes):
        before = silences[-1] if silences else 1.0
        apart = 1.0
        for j in range(i - 1, -1, -1):
            if abs(echoes[j]["d"] - s["d"]) > law.pulse:
                apart = silences[j]
                break
        silences.append(min(before, apart * (1 - chance(law, s["total"]))))
        noise = curve(law.level["noise_m"], s["total"])
        parts.append((s["at"], noise, before - silences[-1]))
    return parts, silences[-1] if silences else 1.0


def up_to(law, parts, x):
    """The probability of an echo that reads at most x, x a multiple of the resolution."""
    return sum(
        share * float(norm.cdf((x + law.sensor["resolution_m"] - mean) / sd))
        for mean, sd, share in parts
    )


# ---------------------------------------------------------------- cases


def sensor(**level):
    return {
        "name": "golden",
        "cone_half_angle_deg": 27.5,
        "min_range_m": 0.05,
        "max_range_m": 4.0,
        "mount_height_m": 0.15,
        "assumed_sound_speed_m_s": 343.0,
        "resolution_m": 0.01,
        "range_noise_m": 0.004,
        "miss_rate": 0.02,
        "edge_width_m": 0.02,
        "update_period_s": 0.05,
        "model": "level",
        "level": level,
    }


RECEIVER = [[0, 28], [0.1, 24], [0.3, 17], [0.6, 9], [1, 4], [1.6, 1], [2.5, 0]]
WALK = [[-3, 0.03], [0, 0.024], [6, 0.014], [12, 0.006], [30, 0.0]]
NOISE = [[0, 0.006], [10, 0.003], [25, 0.001]]
ANGLE = [[-0.0125, -0.0125], [0.0125, -0.0125], [0.0125, 0.0125], [0.0105, 0.0125], [0.0105, -0.0105],
         [-0.0125, -0.0105]]
SQUARE = [[-0.05, -0.05], [0.05, -0.05], [0.05, 0.05], [-0.05, 0.05]]


def obstacle(name, x, z, turn, outline, **detection):
    return dict(name=name, x_m=x, z_m=z, turn_deg=turn, outline_m=outline, **detection)


def cases():
    lobes = [round(1.2 + 0.8 * math.cos(math.radians(5 * i * 4)) + 0.3 * math.sin(math.radians(5 * i)), 3)
             for i in range(72)]
    lobes[17] = 0
    piston = dict(frequency_hz=40000, spreading_exponent=1.5, temperature_c=7.5, humidity_percent=80,
                  beam={"aperture_radius_m": 0.0072}, receiver_threshold_db=RECEIVER, excess_sd_db=0.8,
                  walk_m=WALK, noise_m=NOISE, pulse_length_s=0.0002, level_db=33)
    wide = dict(frequency_hz=49400, spreading_exponent=1.9, absorption_db_per_m=0.9,
                beam={"two_way_db": [[0, -1], [10, -3], [25, -14], [60, -40], [180, -70]]},
                receiver_threshold_db=[[0.5, 6], [3, 0]], excess_sd_db=2.5, walk_m=[[0, 0.02], [20, 0]],
                noise_m=[[0, 0.01]], pulse_length_s=0.0005, level_db=10)
    return {
        "table-piston": (sensor(**piston), [
            obstacle("angle", 0.4, -0.2, 33, ANGLE, detection="table", thresholds_m=lobes)]),
        "uniform-curve": (sensor(**wide), [
            obstacle("post", -0.3, 0.1, -80, SQUARE, detection="uniform", uniform_range_m=1.7)]),
        "strength": (sensor(**piston), [
            obstacle("square", 0.1, 0.2, 12, SQUARE, detection="strength",
                     strength_db=[-12, -20, -27, -35, -24, -18, -15, -30.5, -22, -41])]),
        "several": (sensor(**wide), [
            obstacle("left", -0.12, 0.9, 10, SQUARE, detection="uniform", uniform_range_m=1.4),
            obstacle("right", 0.12, 0.92, -15, SQUARE, detection="strength", strength_db=[5]),
            obstacle("behind", 0.05, 1.25, 0, SQUARE, detection="uniform", uniform_range_m=2.2),
            obstacle("side", 0.9, 0.3, 45, SQUARE, detection="uniform", uniform_range_m=1.1)]),
    }


def rows(scene, rng, count=40):
    """Most look roughly at the first obstacle, some anywhere."""
    first = scene["obstacles"][0]
    for i in range(count):
        r = round(rng.uniform(0.12, 2.6), 3)
        b = rng.uniform(0, TAU)
        x, z = round(first["x_m"] + r * math.sin(b), 4), round(first["z_m"] + r * math.cos(b), 4)
        at = math.degrees(math.atan2(-(first["z_m"] - z), first["x_m"] - x))
        off = rng.uniform(-180, 180) if i % 8 == 0 else rng.gauss(0, 12)
        yield x, z, round(at + off, 3)


def main():
    values = csv.writer(open(HERE / "sights.csv", "w", newline=""), lineterminator="\n")
    values.writerow("case,row,obstacle,centre_distance_m,bearing_deg,nearest_m,off_axis_deg,excess_db,p_echo"
                    .split(","))
    mixed = csv.writer(open(HERE / "readings.csv", "w", newline=""), lineterminator="\n")
    mixed.writerow("case,row,p_no_echo,range_m,p_up_to".split(","))
    rng = random.Random(20140617)
    for name, (spec, obstacles) in cases().items():
        scene = dict(format="sonar-gap/2", no_echo_m=4.0, sensor=spec, obstacles=obstacles)
        (HERE / f"{name}.scene.json").write_text(json.dumps(scene, indent=1) + "\n")
        law = Law(spec)
        with open(HERE / f"{name}.rows.csv", "w", newline="") as file:
            out = csv.writer(file, lineterminator="\n")
            out.writerow("run,sensor,t_s,x_m,z_m,heading_deg".split(","))
            for i, row in enumerate(rows(scene, rng)):
                out.writerow(["g", "s0", f"{0.05 * i:.2f}", *row])
                sights = [sight(law, o, row) for o in obstacles]
                for o, s in zip(obstacles, sights):
                    values.writerow([name, i + 1, o["name"], *(f"{s[key]:.9f}" for key in
                                     ("r", "b", "d", "phi", "excess", "p"))])
                parts, silent = mixture(law, sights)
                for mean, _, share in parts:
                    if share > 0.001:
                        x = round(math.floor(mean / 0.01) * 0.01, 2)
                        mixed.writerow([name, i + 1, f"{silent:.9f}", x, f"{up_to(law, parts, x):.9f}"])
                if not any(share > 0.001 for _, _, share in parts):
                    mixed.writerow([name, i + 1, f"{silent:.9f}", 4.0, f"{up_to(law, parts, 4.0):.9f}"])


if __name__ == "__main__":
    main()
