"""Trains a policy on Reach by the cross-entropy method (Rubinstein 1999) until it succeeds, then tests it on new goals.

    python3 02_learn_to_reach.py

The policy is linear: the motion is a matrix times the state, clipped to -1 to 1. Each generation draws matrices from a
normal distribution, tries each on the same goals, and fits the distribution to the best of them.
"""
import time

import numpy as np
from resect.envs import Reach, VectorEnv

POPULATION, BEST, GOALS, WORKERS = 24, 6, 2, 2


def make():
    return Reach(actions="position", particles=300, max_steps=25)


def features(state):
    """Where the goal is, seen from the tip, in units of 0.1 m; and 1."""
    return np.append(state[..., -3:], np.ones((*state.shape[:-1], 1)), axis=-1)


def returns(envs, policies, seeds):
    """Mean return of each policy over the goals; each worker tries one policy at a time."""
    totals = np.zeros(len(policies))
    for seed in seeds:
        for first in range(0, len(policies), envs.num_envs):
            chosen = policies[first:first + envs.num_envs]
            states, _ = envs.reset(seed=[seed] * envs.num_envs)
            alive = np.ones(envs.num_envs, bool)
            while alive.any():
                actions = np.einsum("nij,nj->ni", chosen, features(states))
                states, rewards, terminated, truncated, _ = envs.step(np.clip(actions, -1, 1))
                totals[first:first + envs.num_envs] += rewards * alive
                alive &= ~(terminated | truncated)
    return totals / len(seeds)


def success(env, policy, seeds):
    reached = 0
    for seed in seeds:
        state, _ = env.reset(seed=seed)
        over = False
        while not over:
            state, _, terminated, truncated, info = env.step(np.clip(policy @ features(state), -1, 1))
            over = terminated or truncated
        reached += info["is_success"]
    return reached / len(seeds)


def main():
    draw = np.random.default_rng(0)
    mean, spread = np.zeros((3, 4)), np.full((3, 4), 4.0)
    test, begin, steps = make(), time.time(), 0
    print(f"before training: {success(test, mean, range(1000, 1010)):.0%} of 10 goals")
    with VectorEnv(make, WORKERS) as envs:
        for generation in range(30):
            policies = mean + spread * draw.standard_normal((POPULATION, *mean.shape))
            score = returns(envs, policies, [GOALS * generation + g for g in range(GOALS)])
            best = policies[np.argsort(score)[-BEST:]]
            mean, spread = best.mean(axis=0), best.std(axis=0) + 0.3 * 0.8**generation
            steps += POPULATION * GOALS
            reached = success(test, mean, range(1000, 1010))
            print(f"generation {generation:2}: return {score.mean():6.1f}, best {score.max():6.1f}, "
                  f"goals reached {reached:.0%}, {time.time() - begin:.0f} s", flush=True)
            if reached == 1:
                break
    final = success(test, mean, range(2000, 2020))
    print(f"{final:.0%} of 20 goals that training never saw, after {steps} episodes")
    assert final >= 0.9


if __name__ == "__main__":
    main()
