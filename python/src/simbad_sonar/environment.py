"""Robots with belts of sonars for learning programs, in Gymnasium's form.

Needs ``pip install simbad-sonar[environment]``. A robot of 2 cm radius has twelve sonars at its
centre and obstacles round it. It is told a speed and a turn rate for 0.05 s at a time. The task is
that of ``simbad run``: go counter-clockwise round an obstacle, where its echo is just lost.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Optional, Union

import gymnasium
import numpy as np
import numpy.typing as npt
from gymnasium import spaces
from gymnasium.vector import AutoresetMode
from gymnasium.vector.utils import batch_space

from ._commands import DATA_FORMAT, PathLike, _obstacle
from ._java import SonarError, java_class

Floats = npt.NDArray[np.floating[Any]]
Bools = npt.NDArray[np.bool_]

#: An obstacle that stands beside the one that is circled: name, x and z in metres, turn in degrees.
Placed = tuple[str, float, float, float]

#: Seconds that a command holds.
STEP_S = 0.05


def _fleet(
    size: int,
    autoreset: AutoresetMode,
    obstacle: str,
    around: Sequence[Placed],
    sensor: str,
    robot: Optional[PathLike],
    sensor_file: Optional[PathLike],
    limits: tuple[int, float, float],
) -> Any:
    """Makes the robots in Java."""
    path = java_class("java.nio.file.Path")
    neighbour = java_class("simbad.experiments.run.Neighbour")
    placement = java_class("simbad.sonar.frame.Placement")
    others = java_class("java.util.ArrayList")()
    for name, x_m, z_m, turn_deg in around:
        place = placement(float(x_m), float(z_m), float(np.deg2rad(turn_deg)))
        others.add(neighbour(_obstacle(name), place))
    try:
        hearing = java_class("simbad.experiments.run.SensorKind").read(sensor)
        if not hearing.isPresent():
            raise SonarError(f"sensor '{sensor}' is not a name that `simbad run --help` lists", 2)
        kind = hearing.get()
        if robot is not None:
            kind = kind.on(java_class("simbad.experiments.run.RobotKind").read(str(robot)))
        if sensor_file is not None:
            spec = java_class("simbad.sonar.format.SensorFile").read(path.of(str(sensor_file)))
        else:
            spec = java_class("simbad.obstacles.Catalogue").srf04()
        heard = kind.model()
        most_m = (heard.get().setup().sensor() if heard.isPresent() else spec).maxRangeM()
        setup = java_class("simbad.experiments.fleet.FleetSetup")(
            _obstacle(obstacle), others, kind, spec, *limits, most_m
        )
        mode = java_class("simbad.experiments.fleet.Autoreset").valueOf(autoreset.name)
        return java_class("simbad.experiments.fleet.Fleet")(setup, int(size), mode)
    except (
        java_class(DATA_FORMAT),
        java_class("java.lang.IllegalArgumentException"),
        java_class("simbad.obstacles.ObstacleOverlapException"),
    ) as error:
        raise SonarError(str(error.getMessage()), 2) from error


class VectorEnv(gymnasium.vector.VectorEnv[Floats, Floats, npt.NDArray[Any]]):
    """Robots that are stepped together, each in a world of its own.

    An action is speed ahead and turn rate counter-clockwise, each from -1 to 1 of the greatest. An
    observation is what
    the twelve sonars read in metres, counter-clockwise from straight ahead; no echo, and what is
    farther than the sensor's greatest range, reads as that range. A step is worth the share of a
    turn round the obstacle that it made counter-clockwise while the robot was within 5 cm of the
    shadow's edge, so that a whole round is worth 1; running into something costs 1 and ends the
    episode. Override :meth:`reward` for another task.

    The arrays lie in memory that Java writes into. With ``copy=False`` they are handed out as they
    are, and the next step changes them.
    """

    def __init__(
        self,
        num_envs: int = 64,
        obstacle: str = "angle",
        around: Sequence[Placed] = (),
        sensor: str = "shadow",
        robot: Optional[PathLike] = None,
        *,
        sensor_file: Optional[PathLike] = None,
        max_steps: int = 2000,
        max_speed_m_per_s: float = 0.2,
        max_turn_rad_per_s: float = 6.0,
        autoreset_mode: Union[str, AutoresetMode] = AutoresetMode.NEXT_STEP,
        copy: bool = True,
    ) -> None:
        """Builds the worlds.

        Args:
            num_envs: how many robots.
            obstacle: the one that is circled, at the origin; as ``simbad run`` names it.
            around: what else stands there.
            sensor: a word of ``simbad run --sensor``, ``diagnosed:DIR`` among them.
            robot: a word of ``simbad run --robot``: ``diagnosed:DIR`` or a robot.json; None for a
                robot that does what it is told.
            sensor_file: figures of the sensor; data/sensors/srf04.json if none is given.
            max_steps: after so many an episode is truncated.
            max_speed_m_per_s: speed of an action of 1; what is beyond -1 and 1 is cut.
            max_turn_rad_per_s: turn rate of an action of 1.
            autoreset_mode: when an ended episode is followed by the next, as Gymnasium has it.
            copy: False hands out the arrays that the next step changes.

        Raises:
            SonarError: for a name or a file that is wrong.
        """
        self.autoreset_mode = AutoresetMode(autoreset_mode)
        self.metadata = {"render_modes": [], "autoreset_mode": self.autoreset_mode}
        self.num_envs = num_envs
        self.copy = copy
        self._fleet = _fleet(
            num_envs,
            self.autoreset_mode,
            obstacle,
            around,
            sensor,
            robot,
            sensor_file,
            (int(max_steps), float(max_speed_m_per_s), float(max_turn_rad_per_s)),
        )

        def shared(buffer: Any, *shape: int) -> Any:
            return np.asarray(memoryview(buffer)).reshape(num_envs, *shape)

        self._commands: Floats = shared(self._fleet.commands(), 2)
        self._read: Floats = shared(self._fleet.readings(), -1)
        self._read_last: Floats = shared(self._fleet.lastReadings(), -1)
        self._gains: Floats = shared(self._fleet.rewards())
        self._poses: Floats = shared(self._fleet.poses(), 4)
        self._poses_last: Floats = shared(self._fleet.lastPoses(), 4)
        self._terminated: Bools = shared(self._fleet.terminated()).view(np.bool_)
        self._truncated: Bools = shared(self._fleet.truncated()).view(np.bool_)
        self.single_action_space = spaces.Box(-1.0, 1.0, (2,), np.float32)
        self.single_observation_space = spaces.Box(
            0.0, self._fleet.noEchoM(), (self._read.shape[1],), np.float32
        )
        self.action_space = batch_space(self.single_action_space, num_envs)
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self._most = np.array([max_speed_m_per_s, max_turn_rad_per_s])
        self._all = np.ones(num_envs, dtype=np.bool_)
        self._all.flags.writeable = False
        self._seeded = False

    @property
    def poses(self) -> Floats:
        """x, z (metres), heading (radians), distance from the shadow's edge (metres), by robot."""
        return self._poses.copy()

    def reward(self) -> Floats:
        """Returns what the latest step was worth; override it for another task."""
        return self._gains.copy() if self.copy else self._gains

    def reset(
        self,
        *,
        seed: Optional[Union[int, Sequence[Optional[int]]]] = None,
        options: Optional[dict[str, Any]] = None,
    ) -> tuple[Floats, dict[str, Any]]:
        """Begins episodes.

        Args:
            seed: of the first robot, the others have the next ones; or one for each. Without one
                each robot's chance goes on.
            options: ``reset_mask`` (bool, a robot each) begins only those; ``poses`` (x, z,
                heading, a row for each robot) places them; else they start by chance.
        """
        chosen = dict(options or {})
        mask = self._mask(chosen.pop("reset_mask", None))
        poses = chosen.pop("poses", None)
        if poses is not None:
            poses = np.asarray(poses, dtype=np.float64).reshape(self.num_envs, 3)
        for robot in np.flatnonzero(mask):
            self._seed(int(robot), self._seed_of(int(robot), seed))
            if poses is None:
                self._fleet.start(int(robot))
            else:
                self._fleet.startAt(int(robot), *(float(number) for number in poses[robot]))
        self._seeded = True
        return self._handed_out(self._read), self._info(mask)

    def _mask(self, mask: Any) -> Bools:
        if mask is None:
            return np.ones(self.num_envs, dtype=np.bool_)
        if not (
            isinstance(mask, np.ndarray)
            and mask.shape == (self.num_envs,)
            and mask.dtype == np.bool_
            and mask.any()
        ):
            raise ValueError(
                f"reset_mask = {mask}, expected a bool array of {self.num_envs} with a True in it"
            )
        return mask

    def _seed_of(
        self, robot: int, seed: Optional[Union[int, Sequence[Optional[int]]]]
    ) -> Optional[int]:
        if seed is None:
            # What was never seeded is seeded by what Gymnasium keeps for that.
            return None if self._seeded else int(self.np_random.integers(2**62))
        if isinstance(seed, (int, np.integer)):
            return int(seed) + robot
        if len(seed) != self.num_envs:
            raise ValueError(f"{len(seed)} seeds, expected one for each of {self.num_envs} robots")
        return seed[robot]

    def _seed(self, robot: int, seed: Optional[int]) -> None:
        if seed is not None:
            self._fleet.seed(robot, seed)

    def step(self, actions: Floats) -> tuple[Floats, Floats, Bools, Bools, dict[str, Any]]:
        """Steps every robot once; see the class and Gymnasium's vector environments."""
        if np.shape(actions) != self._commands.shape:
            raise ValueError(
                f"actions: expected shape {self._commands.shape}, found {np.shape(actions)}"
            )
        if self.autoreset_mode == AutoresetMode.DISABLED and (
            self._terminated.any() or self._truncated.any()
        ):
            raise ValueError("an episode has ended: reset it, with reset_mask in options")
        np.multiply(actions, self._most, out=self._commands)
        self._step()
        infos = self._info(self._all)
        if self.autoreset_mode == AutoresetMode.SAME_STEP:
            infos.update(self._final())
        return (
            self._handed_out(self._read),
            self.reward(),
            self._terminated.copy(),
            self._truncated.copy(),
            infos,
        )

    def _final(self) -> dict[str, Any]:
        """What Gymnasium wants to know of episodes that ended in a step that began the next."""
        ended = self._terminated | self._truncated
        if not ended.any():
            return {}
        last = np.full(self.num_envs, None, dtype=object)
        for robot in np.flatnonzero(ended):
            last[robot] = self._read_last[robot].copy()
        info = {"poses": np.where(ended[:, np.newaxis], self._poses_last, 0.0), "_poses": ended}
        return {"final_obs": last, "_final_obs": ended, "final_info": info, "_final_info": ended}

    def _step(self) -> None:
        try:
            self._fleet.step()
        except java_class("java.lang.IllegalArgumentException") as error:
            raise ValueError(f"actions: {error.getMessage()}") from error

    def _handed_out(self, values: Floats) -> Floats:
        return values.copy() if self.copy else values

    def _info(self, mask: Bools) -> dict[str, Any]:
        return {"poses": self._handed_out(self._poses), "_poses": mask}


class Env(gymnasium.Env[Floats, Floats]):
    """One robot, as :class:`VectorEnv` has many, for programs that step one at a time."""

    metadata = {"render_modes": []}

    def __init__(self, **options: Any) -> None:
        """Builds the world; options as those of :class:`VectorEnv`."""
        self._one = VectorEnv(1, autoreset_mode=AutoresetMode.DISABLED, **options)
        self.observation_space = self._one.single_observation_space
        self.action_space = self._one.single_action_space

    def reset(
        self, *, seed: Optional[int] = None, options: Optional[dict[str, Any]] = None
    ) -> tuple[Floats, dict[str, Any]]:
        """Begins an episode; options may hold ``poses``: x, z and heading."""
        super().reset(seed=seed)
        read, infos = self._one.reset(seed=seed, options=options)
        return read[0], {"poses": infos["poses"][0]}

    def step(self, action: Floats) -> tuple[Floats, float, bool, bool, dict[str, Any]]:
        """Steps once."""
        read, reward, terminated, truncated, infos = self._one.step(np.asarray(action)[np.newaxis])
        return (
            read[0],
            float(reward[0]),
            bool(terminated[0]),
            bool(truncated[0]),
            {"poses": infos["poses"][0]},
        )
