"""Checks that an environment keeps Gymnasium's interface: our own, in the spirit of gymnasium.utils.env_checker."""

import numpy as np

from resect.envs.spaces import Dict


class Broken(AssertionError):
    """An environment that does not keep the interface."""


def _require(condition, sentence):
    if not condition:
        raise Broken(sentence)


def same(a, b):
    """Whether two observations have the same bits."""
    if isinstance(a, dict):
        return a.keys() == b.keys() and all(same(a[name], b[name]) for name in a)
    return a.dtype == b.dtype and a.shape == b.shape and a.tobytes() == b.tobytes()


def _observed(env, observation, after):
    space = env.observation_space
    _require(space.contains(observation), f"what {after} returns is not in observation_space: {space}")
    for array in observation.values() if isinstance(space, Dict) else [observation]:
        _require(np.isfinite(array).all(), f"what {after} returns has numbers that are not finite")


def _run(env, seed, steps):
    env.action_space.seed(seed)
    observation, info = env.reset(seed=seed)
    seen = [observation]
    for _ in range(steps):
        observation, reward, terminated, truncated, info = env.step(env.action_space.sample())
        seen.append(observation)
        seen.append({"reward": np.array([reward])})
        if terminated or truncated:
            observation, info = env.reset()
            seen.append(observation)
    return seen


def check_env(env, steps=15):
    """Raises Broken with one sentence if the environment does not keep the interface.

    Checked: spaces; reset(seed=...) and what it returns; types of all that step() returns; observations in their space
    and finite; the same bits for the same seed and actions, and others for another seed; observations that a caller
    keeps do not change; actions out of shape and steps after the end are refused; render().
    """
    for name in ("observation_space", "action_space", "metadata", "render_mode"):
        _require(hasattr(env, name), f"it has no {name}")
    space = env.action_space
    _require(space.shape and np.isfinite(space.low).all() and np.isfinite(space.high).all(),
             "action_space has no bounds")
    _require(space.contains(space.sample()), "what action_space samples is not in it")
    answer = env.reset(seed=3)
    _require(isinstance(answer, tuple) and len(answer) == 2, "reset() does not return (observation, info)")
    _require(isinstance(answer[1], dict), "the info of reset() is no dictionary")
    _observed(env, answer[0], "reset()")
    answer = env.step(space.sample())
    _require(isinstance(answer, tuple) and len(answer) == 5,
             "step() does not return (observation, reward, terminated, truncated, info)")
    observation, reward, terminated, truncated, info = answer
    _observed(env, observation, "step()")
    _require(isinstance(reward, float) and np.isfinite(reward), "the reward is no finite float")
    _require(isinstance(terminated, bool) and isinstance(truncated, bool), "terminated and truncated are not bool")
    _require(isinstance(info, dict), "the info of step() is no dictionary")

    first, again, other = _run(env, 11, steps), _run(env, 11, steps), _run(env, 12, steps)
    _require(all(same(a, b) for a, b in zip(first, again)), "the same seed and actions give other bits")
    _require(not all(same(a, b) for a, b in zip(first, other)), "another seed gives the same")
    observation, _ = env.reset(seed=5)
    kept = {k: v.copy() for k, v in observation.items()} if isinstance(observation, dict) else observation.copy()
    env.step(space.sample())
    _require(same(kept, observation), "an observation that a caller keeps changes with the next step")
    for wrong in (np.zeros(space.shape[0] + 1, np.float32), np.full(space.shape, np.nan, np.float32)):
        try:
            env.step(wrong)
        except Exception:
            continue
        raise Broken("an action of another shape, or that is not a number, is taken")
    env.reset(seed=1)
    for _ in range(100_000):
        *_, terminated, truncated, _ = env.step(np.zeros(space.shape, np.float32))
        if terminated or truncated:
            break
    else:
        raise Broken("an episode never ends")
    try:
        env.step(space.sample())
    except Exception:
        pass
    else:
        raise Broken("a step after the end of the episode is taken")
    if env.render_mode == "rgb_array":
        env.reset(seed=1)
        picture = env.render()
        _require(isinstance(picture, np.ndarray) and picture.dtype == np.uint8 and picture.ndim == 3 and
                 picture.shape[2] == 3, "render() does not return a picture [height, width, 3] of uint8")
