"""Robots in Gymnasium's form."""

import warnings

import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env
from gymnasium.vector import AutoresetMode, SyncVectorEnv
from gymnasium.wrappers.vector import RecordEpisodeStatistics

import simbad_sonar as sonar
from simbad_sonar.environment import Env, VectorEnv

SHORT = {"max_steps": 12, "max_speed_m_per_s": 1.0}


def test_gymnasiums_checker_has_nothing_to_say() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        # About what only gymnasium.make could offer.
        warnings.filterwarnings("ignore", message=".*does not having a spec.*|.*not having a spec.*")
        check_env(Env(sensor="level-noisy"))


@pytest.mark.parametrize("mode", list(AutoresetMode))
def test_vector_is_what_single_robots_are(mode: AutoresetMode) -> None:
    many = VectorEnv(9, sensor="noisy", autoreset_mode=mode, **SHORT)
    single = SyncVectorEnv([lambda: Env(sensor="noisy", **SHORT)] * 9, autoreset_mode=mode)
    assert many.single_observation_space == single.single_observation_space
    np.testing.assert_array_equal(many.reset(seed=5)[0], single.reset(seed=5)[0])
    many.action_space.seed(1)
    ended = 0
    for _ in range(40):
        actions = many.action_space.sample()
        ours, theirs = many.step(actions), single.step(actions)
        for mine, other in zip(ours[:4], theirs[:4]):
            np.testing.assert_array_equal(mine, other)
            assert mine.dtype == other.dtype
        done = ours[2] | ours[3]
        ended += done.sum()
        if mode == AutoresetMode.SAME_STEP and done.any():
            np.testing.assert_array_equal(ours[4]["_final_obs"], theirs[4]["_final_obs"])
            for key in ("poses", "_poses"):
                np.testing.assert_array_equal(
                    ours[4]["final_info"][key], theirs[4]["final_info"][key]
                )
            for robot in np.flatnonzero(done):
                np.testing.assert_array_equal(
                    ours[4]["final_obs"][robot], theirs[4]["final_obs"][robot]
                )
        if mode == AutoresetMode.DISABLED and done.any():
            options = {"reset_mask": done}
            np.testing.assert_array_equal(
                many.reset(options=dict(options))[0], single.reset(options=dict(options))[0]
            )
    assert ended > 9


def test_equal_seeds_give_equal_episodes() -> None:
    def play(seed: int) -> np.ndarray:
        robots = VectorEnv(4, sensor="level-noisy", **SHORT)
        robots.reset(seed=seed)
        actions = np.tile(np.float32([0.2, 1.0]), (4, 1))
        return np.stack([robots.step(actions)[0] for _ in range(30)])

    np.testing.assert_array_equal(play(3), play(3))
    assert not np.array_equal(play(3), play(4))


def test_arrays_are_javas_own_memory_unless_copied() -> None:
    shared, copied = VectorEnv(2, copy=False), VectorEnv(2)
    for robots, same in ((shared, True), (copied, False)):
        first, _ = robots.reset(seed=1)
        second, *_ = robots.step(np.full((2, 2), 0.1, dtype=np.float32))
        assert np.shares_memory(first, second) == same


def test_wrappers_of_gymnasium_fit() -> None:
    robots = RecordEpisodeStatistics(VectorEnv(3, **SHORT))
    robots.reset(seed=0)
    for _ in range(12):
        *_, infos = robots.step(robots.action_space.sample())
    assert "episode" in infos


def test_robots_start_where_they_are_told_and_neighbours_are_heard() -> None:
    robots = VectorEnv(2, around=[("round", 1.0, 0.0, 0.0)], sensor="original")
    read, infos = robots.reset(options={"poses": [[0.5, 0.0, 0.0], [0.5, 0.0, np.pi]]})
    np.testing.assert_allclose(infos["poses"][:, :2], [[0.5, 0.0]] * 2, atol=1e-12)
    assert read[0, 0] < 0.6 and read[1, 0] < 0.6
    assert read.max() <= robots.single_observation_space.high.max()


def test_wrong_words_are_refused() -> None:
    with pytest.raises(sonar.SonarError, match="no-such"):
        VectorEnv(1, sensor="no-such")
    with pytest.raises(sonar.SonarError, match="robot.json"):
        VectorEnv(1, robot="no-such-robot.json")
    with pytest.raises(sonar.SonarError, match="mostSteps = 0"):
        VectorEnv(1, max_steps=0)
    with pytest.raises(ValueError, match="NaN"):
        robots = VectorEnv(1)
        robots.reset(seed=1)
        robots.step(np.full((1, 2), np.nan))
